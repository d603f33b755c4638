relief_div_rows.v
relief_fp_div.v
relief_fp_mul.v
relief_lzc.v
relief_fp_add.v
relief_fp_to_int.v
relief_start_level.v
relief_ray_setup.v
