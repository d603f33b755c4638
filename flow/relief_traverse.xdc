# SPDX-License-Identifier: MIT OR Apache-2.0
# relief_traverse: 84 MHz.
create_clock -name clk -period 11.904 [get_ports clk]
