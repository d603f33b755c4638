../rtl/relief_lzc.v
../rtl/relief_fp_from_fixed.v
relief_tb_fp_from_fixed.v
relief_tb_fp_from_fixed_top.v
