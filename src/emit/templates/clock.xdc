# {{ top }}: {{ mhz }} MHz.
{%- if clocked %}
create_clock -name clk -period {{ ns }} [get_ports clk]
{%- else %}
set_max_delay {{ ns }} -from [all_inputs] -to [all_outputs]
{%- endif %}
