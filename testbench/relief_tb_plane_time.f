../rtl/relief_lzc.v
../rtl/relief_fp_from_int.v
../rtl/relief_fp_add.v
../rtl/relief_fp_mul.v
../rtl/relief_plane_time.v
relief_tb_plane_time.v
relief_tb_plane_time_top.v
