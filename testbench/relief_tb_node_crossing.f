../rtl/relief_fp_lt.v
../rtl/relief_node_crossing.v
relief_tb_node_crossing.v
relief_tb_node_crossing_top.v
