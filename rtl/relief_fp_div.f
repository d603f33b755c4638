relief_div_rows.v
relief_fp_div.v
