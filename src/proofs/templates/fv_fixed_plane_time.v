// Proof harness: {{ claim }}.
//
// A plane of a ray in either direction. Shifting, a product with a constant and rounding down are monotone, and so is what is cut off at the
// largest word: a later plane never has a smaller parameter. Watertightness stands on this.
`default_nettype none
module {{ prefix }}fv_fixed_plane_time (input wire clk);
  localparam integer F = {{ value("plane_time", "FRACTION_W") }};
  localparam integer W = {{ value("plane_time", "RECIP_W") }};
  localparam integer N = {{ value("plane_time", "LEVELS") }};
  localparam integer T = {{ value("plane_time", "TILE_W") }};
{{ instance("plane_time", "") }}
  // The distance along the ray, wider than any.
  wire signed [F+T+3:0] from = p;
  wire signed [F+T+3:0] at = $signed(plane) <<< (F - N);
  wire signed [F+T+3:0] away = neg ? from - at : at - from;
  // What docs/fixed.md calls t_x.
  wire [2*(F+T+1):0] moved = { {(F+T+2){1'b0}}, away[F+T:0]} << z;
  wire [F+T+W:0] product = moved[F+T:0] * r;
  wire [F+T+W:0] whole = product >> (W + T - 2);
  wire beyond = |(moved >> (F + T + 1)) || |(whole >> (F + 2));
  reg [7:0] clocks;
  initial clocks = 0;
  always @(posedge clk) clocks <= clocks + 1;
  always @* begin
    assume (z <= F + T + 1);
    assume (away >= 0 && away < (1 << (F + T + 1)));
    if (clocks == {{ latency }}) assert (t == (beyond ? {F+2{1'b1}} : whole[F+1:0]));
  end
endmodule
`default_nettype wire
