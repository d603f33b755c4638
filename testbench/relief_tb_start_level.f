../rtl/relief_lzc.v
../rtl/relief_start_level.v
relief_tb_start_level.v
relief_tb_start_level_top.v
