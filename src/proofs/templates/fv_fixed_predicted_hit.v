// Proof harness: {{ claim }}.
//
// Setup, a plane's parameter and the estimate just before it. Estimates grow with the parameter, so none before passes the plane either.
`default_nettype none
module {{ prefix }}fv_fixed_predicted_hit (input wire clk);
  localparam integer F = {{ value("plane_time", "FRACTION_W") }};
  localparam integer N = {{ value("plane_time", "LEVELS") }};
  localparam integer T = {{ value("plane_time", "TILE_W") }};
  localparam integer H = {{ value("ray_setup", "HEIGHT_W") }};
  localparam [F+1:0] BOTTOM = ((1 << H) - 1) << (F + 2 - H);
{{ instance("ray_setup", "s_") }}
{{ instance("plane_time", "p_", "p neg r z") }}
  assign {p_p, p_neg, p_r, p_z} = {s_p_x, s_neg_x, s_r_x, s_z_x};
{{ instance("predicted_hit", "e_", "p s neg m") }}
  assign {e_p, e_s, e_neg} = {s_p_x, s_s_x, s_neg_x};
  assign e_m = p_t > BOTTOM ? BOTTOM : p_t - 1'b1;
  // A plane ahead of the entry point, or through it; as far as a distance has bits.
  wire signed [F+T+3:0] from = s_u;
  wire signed [F+T+3:0] at = $signed(p_plane) <<< (F - N);
  wire signed [F+T+3:0] away = s_du[F+T] ? from - at : at - from;
  wire [F+T:0] travel = s_du[F+T] ? -s_du : s_du;
  wire passed = p_neg ? $signed(e_e) < $signed(p_plane) : $signed(e_e) >= $signed(p_plane);
  reg [7:0] clocks;
  initial clocks = 0;
  always @(posedge clk) clocks <= clocks + 1;
  always @* begin
    // The most negative word is no travel; the other axis has no part in this.
    assume ((!s_du[F+T] || |s_du[F+T-1:0]) && s_dv == 0);
    // A plane through the entry point is met at once, and one further off than this lies beyond others that no estimate passes.
    assume (away > 0 && away <= travel + (travel >> 4) + 2);
    if (clocks == {{ latency }} && p_t != 0) assert (!passed);
  end
endmodule
`default_nettype wire
