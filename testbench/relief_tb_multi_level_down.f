../rtl/relief_multi_level_down.v
relief_tb_multi_level_down.v
relief_tb_multi_level_down_top.v
