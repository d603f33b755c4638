# {{ top }} out of context in Vivado. From the directory that holds rtl/:
#   vivado -mode batch -source {{ place }}/vivado.tcl [-tclargs PART]
# Says the clock that it reached; ends with an error if that is less than {{ mhz }} MHz, or if the part is too small.
set part [expr {$argc > 0 ? [lindex $argv 0] : "xc7a200tfbg676-2"}]
foreach file {
{%- for f in files %}
  {{ f }}
{%- endfor %}
} {
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
set slack [get_property SLACK [get_timing_paths -max_paths 1 -setup]]
if {$slack eq ""} {
  error "{{ top }}: Vivado found no path that the {{ mhz }} MHz asked for hold for: pnr/{{ top }}.timing.txt"
}
set mhz [format %.1f [expr {1000.0 / ({{ ns }} - $slack)}]]
if {$slack < 0} {
  error "{{ top }}: $mhz MHz, which misses the {{ mhz }} MHz asked for: pnr/{{ top }}.timing.txt"
}
puts "{{ top }}: $mhz MHz, {{ mhz }} MHz asked for: pnr/{{ top }}.timing.txt"
