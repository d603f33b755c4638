// Proof harness: {{ claim }}.
`default_nettype none
module {{ prefix }}fv_multi_level_down{% if latency > 0 %} (input wire clk){% endif %};
  localparam integer LEVELS = {{ value("multi_level_down", "LEVELS") }};
  localparam integer MANY = {{ levels_down }};
{{ instance("multi_level_down", "") }}
{%- if levels_down == 1 %}
  wire crossed = 1'b0;
{%- endif %}
{%- if latency > 0 %}
  reg [7:0] clocks;
  initial clocks = 0;
  always @(posedge clk) clocks <= clocks + 1;
{%- endif %}
  always @* begin
    assume (level >= 1 && level <= LEVELS);
    assume ($signed(x_low) <= $signed(x_high) && $signed(y_low) <= $signed(y_high));
{%- if lod %}
    assume (lod < level);
{%- endif %}
    {% if latency > 0 %}if (clocks == {{ latency }}) {% endif %}begin
{%- if lod %}
      assert (level_down == (lod + ((!crossed && level >= MANY) ? MANY : 1) > level ? lod : level - ((!crossed && level >= MANY) ? MANY : 1)));
{%- else %}
      assert (level_down == level - ((!crossed && level >= MANY) ? MANY : 1));
{%- endif %}
      assert (level_down < level);
      assert ($signed(x_low) <= $signed(x_down) && $signed(x_down) <= $signed(x_high));
      assert ($signed(y_low) <= $signed(y_down) && $signed(y_down) <= $signed(y_high));
      if ($signed(x_low) <= $signed(x_hit) && $signed(x_hit) <= $signed(x_high)) assert (x_down == x_hit);
      if ($signed(y_low) <= $signed(y_hit) && $signed(y_hit) <= $signed(y_high)) assert (y_down == y_hit);
      if ($signed(x_hit) < $signed(x_low)) assert (x_down == x_low);
      if ($signed(y_hit) > $signed(y_high)) assert (y_down == y_high);
    end
  end
endmodule
`default_nettype wire
