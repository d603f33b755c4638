../rtl/relief_interleave.v
relief_tb_interleave.v
relief_tb_interleave_top.v
