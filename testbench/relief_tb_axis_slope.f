../rtl/relief_div_rows.v
../rtl/relief_fp_div.v
../rtl/relief_fp_mul.v
../rtl/relief_lzc.v
../rtl/relief_fp_add.v
../rtl/relief_axis_slope.v
relief_tb_axis_slope.v
relief_tb_axis_slope_top.v
