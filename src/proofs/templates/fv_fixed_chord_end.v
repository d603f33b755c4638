// Proof harness: {{ claim }}.
//
// Setup, a plane's parameter and the chord's end at it. Chords grow with the parameter, so those of later ones end beyond the plane as well.
`default_nettype none
module {{ prefix }}fv_fixed_chord_end (input wire clk);
  localparam integer F = {{ value("plane_time", "FRACTION_W") }};
  localparam integer N = {{ value("plane_time", "LEVELS") }};
  localparam integer T = {{ value("plane_time", "TILE_W") }};
  localparam integer H = {{ value("ray_setup", "HEIGHT_W") }};
  localparam [F+1:0] BOTTOM = ((1 << H) - 1) << (F + 2 - H);
{{ instance("ray_setup", "s_") }}
{{ instance("plane_time", "p_", "p neg r z") }}
  assign {p_p, p_neg, p_r, p_z} = {s_p_x, s_neg_x, s_r_x, s_z_x};
{{ instance("chord_end", "c_", "p s neg t") }}
  assign {c_p, c_s, c_neg, c_t} = {s_p_x, s_s_x, s_neg_x, p_t};
  // A plane ahead of the entry point, or through it; as far as a distance has bits.
  wire signed [F+T+3:0] from = s_u;
  wire signed [F+T+3:0] at = $signed(p_plane) <<< (F - N);
  wire signed [F+T+3:0] away = s_du[F+T] ? from - at : at - from;
  wire passed = p_neg ? $signed(c_bound) < $signed(p_plane) : $signed(c_bound) >= $signed(p_plane);
  wire ended = p_neg ? $signed(s_le_x) < $signed(p_plane) : $signed(s_le_x) >= $signed(p_plane);
  reg [7:0] clocks;
  initial clocks = 0;
  always @(posedge clk) clocks <= clocks + 1;
  always @* begin
    // The most negative word is no travel; the other axis has no part in this.
    assume ((!s_du[F+T] || |s_du[F+T-1:0]) && s_dv == 0);
    assume (away >= 0 && away < (1 << (F + T + 1)));
    if (clocks == {{ latency }} && p_t <= BOTTOM) begin
      assert (passed);
      assert (ended);
    end
  end
endmodule
`default_nettype wire
