../rtl/relief_node_planes.v
relief_tb_node_planes.v
relief_tb_node_planes_top.v
