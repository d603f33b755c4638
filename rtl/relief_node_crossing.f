relief_fp_lt.v
relief_node_crossing.v
