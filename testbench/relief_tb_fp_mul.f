../rtl/relief_fp_mul.v
relief_tb_fp_mul.v
relief_tb_fp_mul_top.v
