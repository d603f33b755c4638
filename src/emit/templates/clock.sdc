# {{ top }}: {{ mhz }} MHz.
{%- if clocked %}
create_clock -name clk -period {{ ns }} [get_ports clk]
# What stands around the unit is taken to end in registers: replace the zeros by your own delays.
{%- if inputs %}
set_input_delay -clock clk 0.0 [get_ports {
{%- for p in inputs %}{{ p }}{% if not loop.last %} {% endif %}{% endfor -%}
}]
{%- endif %}
set_output_delay -clock clk 0.0 [all_outputs]
{%- else %}
# The unit has no register.
set_max_delay {{ ns }} -from [all_inputs] -to [all_outputs]
{%- endif %}
