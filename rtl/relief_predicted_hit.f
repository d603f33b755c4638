relief_fp_mul.v
relief_lzc.v
relief_fp_add.v
relief_fp_to_int.v
relief_predicted_hit.v
