../rtl/relief_level_up.v
relief_tb_level_up.v
relief_tb_level_up_top.v
