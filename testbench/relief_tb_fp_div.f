../rtl/relief_div_rows.v
../rtl/relief_fp_div.v
relief_tb_fp_div.v
relief_tb_fp_div_top.v
