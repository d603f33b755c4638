../rtl/relief_fp_mul.v
../rtl/relief_lzc.v
../rtl/relief_fp_add.v
../rtl/relief_fp_to_int.v
../rtl/relief_predicted_hit.v
relief_tb_predicted_hit.v
relief_tb_predicted_hit_top.v
