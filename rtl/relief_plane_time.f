relief_lzc.v
relief_fp_from_int.v
relief_fp_add.v
relief_fp_mul.v
relief_plane_time.v
