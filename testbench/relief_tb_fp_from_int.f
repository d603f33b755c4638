../rtl/relief_lzc.v
../rtl/relief_fp_from_int.v
relief_tb_fp_from_int.v
relief_tb_fp_from_int_top.v
