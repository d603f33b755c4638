../rtl/relief_lzc.v
relief_tb_lzc.v
relief_tb_lzc_top.v
