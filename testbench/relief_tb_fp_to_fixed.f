../rtl/relief_fp_to_fixed.v
relief_tb_fp_to_fixed.v
relief_tb_fp_to_fixed_top.v
