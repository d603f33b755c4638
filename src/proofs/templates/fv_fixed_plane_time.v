// Proof harness: {{ claim }}.
//
// Two planes of one ray, in either direction. Watertightness stands on this.
`default_nettype none
module fv_fixed_plane_time (input wire clk);
  localparam integer F = {{ value("plane_time", "FRACTION_W") }};
  localparam integer W = {{ value("plane_time", "RECIP_W") }};
  localparam integer N = {{ value("plane_time", "LEVELS") }};
  localparam integer T = {{ value("plane_time", "TILE_W") }};
{{ instance("plane_time", "near_") }}
{{ instance("plane_time", "far_", "p neg r z") }}
  assign {far_p, far_neg, far_r, far_z} = {near_p, near_neg, near_r, near_z};
  // Distances along the ray, wider than any.
  wire signed [F+T+3:0] at = near_p;
  wire signed [F+T+3:0] near_at = $signed(near_plane) <<< (F - N);
  wire signed [F+T+3:0] far_at = $signed(far_plane) <<< (F - N);
  wire signed [F+T+3:0] near_away = near_neg ? at - near_at : near_at - at;
  wire signed [F+T+3:0] far_away = near_neg ? at - far_at : far_at - at;
  // What docs/fixed.md calls t_x.
  wire [2*(F+T+1)+1:0] moved = near_away[F+T:0] << near_z;
  wire [2*(F+T+1)+W+1:0] product = (moved * near_r) >> (W + T - 2);
  wire beyond = |(moved >> (F + T + 1)) || |(product >> (F + 2));
  reg [7:0] clocks;
  initial clocks = 0;
  always @(posedge clk) clocks <= clocks + 1;
  always @* begin
    assume (near_z <= F + T + 1);
    assume (near_away >= 0 && near_away <= far_away && far_away < (1 << (F + T + 1)));
    if (clocks == {{ latency }}) begin
      assert (near_t <= far_t);
      assert (near_t == (beyond ? {F+2{1'b1}} : product[F+1:0]));
    end
  end
endmodule
`default_nettype wire
