../rtl/relief_interleave.v
../rtl/relief_height_address.v
relief_tb_height_address.v
relief_tb_height_address_top.v
