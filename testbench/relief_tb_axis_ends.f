../rtl/relief_fp_to_int.v
../rtl/relief_lzc.v
../rtl/relief_fp_add.v
../rtl/relief_axis_ends.v
relief_tb_axis_ends.v
relief_tb_axis_ends_top.v
