relief_fp_mul.v
