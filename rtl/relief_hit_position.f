relief_fp_mul.v
relief_lzc.v
relief_fp_add.v
relief_fp_to_fixed.v
relief_hit_position.v
