../rtl/relief_lzc.v
../rtl/relief_fp_from_int.v
../rtl/relief_fp_lt.v
../rtl/relief_height_test.v
relief_tb_height_test.v
relief_tb_height_test_top.v
