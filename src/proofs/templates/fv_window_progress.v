// Proof harness: {{ claim }}.
//
// The units of an iteration that say how far a ray goes, put together as in traverse. What the arithmetic says (exits, depths, which
// windows can hold the hit, the estimate) is left open, so the claim holds whatever it says.
`default_nettype none
module {{ prefix }}fv_window_progress{% if latency > 0 %} (input wire clk){% endif %};
  localparam integer COUNT_W = {{ width("window_index", "k") }};
{{ instance("window_choice", "c_") }}
{{ instance("window_advance", "a_", "exit fraction depth takes_exit takes_depth x_first crosses past_x past_y") }}
{{ instance("window_index", "x_", "passed") }}
{{ instance("window_index", "y_", "passed") }}
  assign {a_exit, a_fraction, a_depth, a_takes_exit, a_takes_depth} = {c_exit, c_fraction, c_depth, c_takes_exit, c_takes_depth};
  assign {a_x_first, a_crosses, a_past_x, a_past_y} = {c_x_first, c_crosses, c_past_x, c_past_y};
  assign {x_passed, y_passed} = {a_passed_x, a_passed_y};
  // A window ends at most 78 texels beyond this one, and a ray does not come that near the end of the count.
  localparam [COUNT_W-1:0] FAR = {COUNT_W{1'b1}} - 79;
{%- if latency > 0 %}
  reg [7:0] clocks;
  initial clocks = 0;
  always @(posedge clk) clocks <= clocks + 1;
{%- endif %}
  always @* begin
    assume (a_k_x < FAR && a_k_y < FAR);
    {% if latency > 0 %}if (clocks == {{ latency }}) {% endif %}begin
      assert (x_k >= a_k_x && y_k >= a_k_y);
      assert (a_m >= a_t);
      if (!c_stays && !c_hit) assert (x_k > a_k_x || y_k > a_k_y);
      if (c_stays) assert (!c_hit && a_m == a_t && a_passed_x == a_k_x && a_passed_y == a_k_y);
    end
  end
endmodule
`default_nettype wire
