# {{ top }} out of context in Vivado. From the directory that holds rtl/:
#   vivado -mode batch -source {{ place }}/vivado.tcl [-tclargs PART]
set part [expr {$argc > 0 ? [lindex $argv 0] : "xc7a200tfbg676-2"}]
foreach file [split [string trim [read [open rtl/filelist.f]]]] {
  read_verilog $file
}
read_xdc -mode out_of_context {{ place }}/{{ top }}.xdc
synth_design -top {{ top }} -part $part -mode out_of_context
opt_design
place_design
route_design
file mkdir pnr
report_timing_summary -file pnr/{{ top }}.timing.txt
report_utilization -file pnr/{{ top }}.area.txt
