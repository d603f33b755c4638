../rtl/relief_div_rows.v
relief_tb_div_rows.v
relief_tb_div_rows_top.v
