relief_fp_lt.v
