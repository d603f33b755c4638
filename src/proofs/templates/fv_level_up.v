// Proof harness: {{ claim }} ({{ rule }}).
`default_nettype none
module {{ prefix }}fv_level_up{% if latency > 0 %} (input wire clk){% endif %};
  localparam integer LEVELS = {{ value("level_up", "LEVELS") }};
{{ instance("level_up", "") }}
{%- if rule == "selective" %}
  localparam integer IDX_W = {{ value("level_up", "IDX_W") }};
  wire signed [IDX_W:0] dx = ($signed(x_hit) >>> level) - ($signed(x_at) >>> level);
  wire signed [IDX_W:0] dy = ($signed(y_hit) >>> level) - ($signed(y_at) >>> level);
  wire [IDX_W:0] ax = dx < 0 ? -dx : dx;
  wire [IDX_W:0] ay = dy < 0 ? -dy : dy;
  wire want = even && !((ax > ay ? ax : ay) == 1);
{%- elif rule == "tevs" %}
  wire want = even;
{%- elif rule == "coherent" %}
  wire want = prev_crossed;
{%- elif rule == "always" %}
  wire want = 1'b1;
{%- endif %}
{%- if latency > 0 %}
  reg [7:0] clocks;
  initial clocks = 0;
  always @(posedge clk) clocks <= clocks + 1;
{%- endif %}
  always @* begin
    assume (level <= LEVELS);
{%- if rule == "selective" %}
    // A coordinate keeps a bit of headroom: IDX_W holds any sum of an entry point and a travel.
    assume (x_at[IDX_W-1] == x_at[IDX_W-2] && x_hit[IDX_W-1] == x_hit[IDX_W-2]);
    assume (y_at[IDX_W-1] == y_at[IDX_W-2] && y_hit[IDX_W-1] == y_hit[IDX_W-2]);
{%- endif %}
    {% if latency > 0 %}if (clocks == {{ latency }}) {% endif %}assert (up == (want && level != LEVELS));
  end
endmodule
`default_nettype wire
