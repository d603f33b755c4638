../rtl/relief_fp_to_int.v
relief_tb_fp_to_int.v
relief_tb_fp_to_int_top.v
