../rtl/relief_lzc.v
../rtl/relief_fp_add.v
relief_tb_fp_add.v
relief_tb_fp_add_top.v
