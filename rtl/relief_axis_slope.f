relief_div_rows.v
relief_fp_div.v
relief_fp_mul.v
relief_lzc.v
relief_fp_add.v
relief_axis_slope.v
