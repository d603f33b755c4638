relief_lzc.v
relief_fp_from_int.v
relief_fp_lt.v
relief_height_test.v
