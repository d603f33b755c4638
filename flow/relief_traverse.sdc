# SPDX-License-Identifier: MIT OR Apache-2.0
# relief_traverse: 84 MHz.
create_clock -name clk -period 11.904 [get_ports clk]
# What stands around the unit is taken to end in registers: replace the zeros by your own delays.
set_input_delay -clock clk 0.0 [get_ports {load_en load_addr load_data in_valid in_tag in_u in_v in_du in_dv out_ready}]
set_output_delay -clock clk 0.0 [all_outputs]
