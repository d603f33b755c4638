// Proof harness: {{ claim }}.
`default_nettype none
module {{ prefix }}fv_node_planes{% if latency > 0 %} (input wire clk){% endif %};
  localparam integer LEVELS = {{ value("node_planes", "LEVELS") }};
  localparam integer IDX_W = {{ value("node_planes", "IDX_W") }};
{{ instance("node_planes", "") }}
  // One bit more, so that nothing wraps here.
  wire signed [IDX_W+1:0] at = $signed(x);
  wire signed [IDX_W+1:0] size = 1 << level;
  wire signed [IDX_W+1:0] first = (at >>> level) <<< level;
  wire signed [IDX_W+1:0] exit = neg ? first : first + size;
  wire signed [IDX_W+1:0] nodes = exit >>> level;
{%- if latency > 0 %}
  reg [7:0] clocks;
  initial clocks = 0;
  always @(posedge clk) clocks <= clocks + 1;
{%- endif %}
  always @* begin
    assume (level <= LEVELS);
    assume (at + size < (1 <<< (IDX_W - 1)) && at - size >= -(1 <<< (IDX_W - 1)));
    {% if latency > 0 %}if (clocks == {{ latency }}) {% endif %}begin
      assert ($signed(plane) == exit);
      assert ($signed(beyond) == (neg ? first - 1 : first + size));
      assert ($signed(low) == (neg ? first : at));
      assert ($signed(high) == (neg ? at : first + size - 1));
{%- if parity %}
      assert (even == !nodes[0]);
{%- endif %}
    end
  end
endmodule
`default_nettype wire
