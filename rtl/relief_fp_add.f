relief_lzc.v
relief_fp_add.v
