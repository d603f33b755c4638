../rtl/relief_fp_lt.v
relief_tb_fp_lt.v
relief_tb_fp_lt_top.v
