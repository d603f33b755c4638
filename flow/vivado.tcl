# SPDX-License-Identifier: MIT OR Apache-2.0
# relief_traverse out of context in Vivado. From the directory that holds rtl/:
#   vivado -mode batch -source flow/vivado.tcl [-tclargs PART]
set part [expr {$argc > 0 ? [lindex $argv 0] : "xc7a200tfbg676-2"}]
foreach file [split [string trim [read [open rtl/filelist.f]]]] {
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
