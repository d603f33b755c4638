../rtl/relief_axis_scale.v
relief_tb_axis_scale.v
relief_tb_axis_scale_top.v
