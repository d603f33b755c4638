relief_div_rows.v
