relief_lzc.v
