# SPDX-License-Identifier: MIT OR Apache-2.0
# relief_traverse out of context in Vivado. From the directory that holds rtl/:
#   vivado -mode batch -source flow/vivado.tcl [-tclargs PART]
# Says the clock that it reached; ends with an error if that is less than 84 MHz, or if the part is too small.
set part [expr {$argc > 0 ? [lindex $argv 0] : "xc7a200tfbg676-2"}]
foreach file {
  rtl/relief_axis_ends.v
  rtl/relief_axis_scale.v
  rtl/relief_axis_slope.v
  rtl/relief_div_rows.v
  rtl/relief_fp_add.v
  rtl/relief_fp_div.v
  rtl/relief_fp_from_fixed.v
  rtl/relief_fp_from_int.v
  rtl/relief_fp_lt.v
  rtl/relief_fp_mul.v
  rtl/relief_fp_to_fixed.v
  rtl/relief_fp_to_int.v
  rtl/relief_height_address.v
  rtl/relief_height_banks.v
  rtl/relief_height_test.v
  rtl/relief_hit_delay.v
  rtl/relief_hit_position.v
  rtl/relief_interleave.v
  rtl/relief_level_decision.v
  rtl/relief_level_up.v
  rtl/relief_lzc.v
  rtl/relief_multi_level_down.v
  rtl/relief_node_crossing.v
  rtl/relief_node_planes.v
  rtl/relief_plane_time.v
  rtl/relief_predicted_hit.v
  rtl/relief_ray_setup.v
  rtl/relief_setup_delay.v
  rtl/relief_spill_register.v
  rtl/relief_start_level.v
  rtl/relief_traverse.v
} {
  read_verilog $file
}
read_xdc -mode out_of_context flow/relief_traverse.xdc
synth_design -top relief_traverse -part $part -mode out_of_context
opt_design
place_design
route_design
file mkdir pnr
report_timing_summary -file pnr/relief_traverse.timing.txt
report_utilization -file pnr/relief_traverse.area.txt
set slack [get_property SLACK [get_timing_paths -max_paths 1 -setup]]
if {$slack eq ""} {
  error "relief_traverse: Vivado found no path that the 84 MHz asked for hold for: pnr/relief_traverse.timing.txt"
}
set mhz [format %.1f [expr {1000.0 / (11.904 - $slack)}]]
if {$slack < 0} {
  error "relief_traverse: $mhz MHz, which misses the 84 MHz asked for: pnr/relief_traverse.timing.txt"
}
puts "relief_traverse: $mhz MHz, 84 MHz asked for: pnr/relief_traverse.timing.txt"
