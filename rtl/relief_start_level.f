relief_lzc.v
relief_start_level.v
