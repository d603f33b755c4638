relief_fp_to_int.v
relief_lzc.v
relief_fp_add.v
relief_axis_ends.v
