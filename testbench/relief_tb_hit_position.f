../rtl/relief_fp_mul.v
../rtl/relief_lzc.v
../rtl/relief_fp_add.v
../rtl/relief_fp_to_fixed.v
../rtl/relief_hit_position.v
relief_tb_hit_position.v
relief_tb_hit_position_top.v
