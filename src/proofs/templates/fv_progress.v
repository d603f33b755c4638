// Proof harness: {{ claim }}.
//
// The units of an iteration that handle indices, put together as in traverse. What the arithmetic says (inside or not, which plane comes
// first, the predicted hit, the level-up rule) is left open, so the claim holds whatever it says.
`default_nettype none
module {{ prefix }}fv_progress{% if latency > 0 %} (input wire clk){% endif %};
  localparam integer LEVELS = {{ value("node_planes", "LEVELS") }};
  localparam integer IDX_W = {{ value("node_planes", "IDX_W") }};
{{ instance("node_planes", "u_") }}
{{ instance("node_planes", "v_", "level") }}
{{ instance("multi_level_down", "d_", "level x_low x_high y_low y_high" ~ (" lod" if lod else "")) }}
{{ instance("level_decision", "k_", ("" if trims else "level ") ~ "level_down x_at x_down x_beyond y_at y_down y_beyond") }}
  assign v_level = u_level;
{%- if not trims %}
  assign k_level = u_level;
{%- endif %}
  // Where a trim reads a smaller node, this is that node's level, and everything but a descent goes on from the larger one.
  assign d_level = k_level;
{%- if lod %}
  assign d_lod = k_lod;
{%- endif %}
  assign k_level_down = d_level_down;
  assign {d_x_low, d_x_high, d_y_low, d_y_high} = {u_low, u_high, v_low, v_high};
  assign {k_x_at, k_x_down, k_x_beyond} = {u_x, d_x_down, u_beyond};
  assign {k_y_at, k_y_down, k_y_beyond} = {v_x, d_y_down, v_beyond};

  // Indices along the ray: they only grow. Not so near the end of their range that they wrap.
  localparam integer FAR = (1 << (IDX_W - 1)) - (1 << LEVELS);
  wire signed [IDX_W:0] x_old = u_neg ? -$signed({u_x[IDX_W-1], u_x}) : $signed({u_x[IDX_W-1], u_x});
  wire signed [IDX_W:0] y_old = v_neg ? -$signed({v_x[IDX_W-1], v_x}) : $signed({v_x[IDX_W-1], v_x});
  wire signed [IDX_W:0] x_new = u_neg ? -$signed({k_x_next[IDX_W-1], k_x_next}) : $signed({k_x_next[IDX_W-1], k_x_next});
  wire signed [IDX_W:0] y_new = v_neg ? -$signed({k_y_next[IDX_W-1], k_y_next}) : $signed({k_y_next[IDX_W-1], k_y_next});
  wire node_left = ($signed(k_x_next) >>> u_level) != ($signed(u_x) >>> u_level)
      || ($signed(k_y_next) >>> u_level) != ($signed(v_x) >>> u_level);
{%- if latency > 0 %}
  reg [7:0] clocks;
  initial clocks = 0;
  always @(posedge clk) clocks <= clocks + 1;
{%- endif %}
  always @* begin
    assume (u_level <= LEVELS);
{%- if trims %}
    assume (k_level <= u_level);
{%- endif %}
{%- if lod %}
    assume (k_lod <= k_level);
{%- endif %}
    assume (x_old < FAR && x_old > -FAR && y_old < FAR && y_old > -FAR);
    {% if latency > 0 %}if (clocks == {{ latency }}) {% endif %}begin
      assert (x_new >= x_old && y_new >= y_old);
      if (k_crosses) begin
        assert (x_new > x_old || y_new > y_old);
        assert (node_left);
      end
      if (!k_crosses) assert (!node_left);
      if (!k_crosses && !k_hit) assert (k_level_next < u_level);
    end
  end
endmodule
`default_nettype wire
