relief_lzc.v
relief_fp_from_int.v
