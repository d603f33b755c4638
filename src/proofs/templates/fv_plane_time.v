// Proof harness: {{ claim }}.
//
// Two planes of one ray that runs toward larger coordinates. Watertightness stands on this.
`default_nettype none
module {{ prefix }}fv_plane_time (input wire clk);
  localparam integer E = {{ value("plane_time", "EXP_W") }};
  localparam integer M = {{ value("plane_time", "MAN_W") }};
  localparam integer IDX_W = {{ value("plane_time", "IDX_W") }};
{{ instance("plane_time", "near_") }}
{{ instance("plane_time", "far_", "p r never") }}
  assign {far_p, far_r, far_never} = {near_p, near_r, near_never};
  // Both parameters as integers in the order of the numbers.
  wire signed [E+M+1:0] near_size = (near_t[E+M-1:M] == 0) ? 0 : {2'b00, near_t[E+M-1:0]};
  wire signed [E+M+1:0] far_size = (far_t[E+M-1:M] == 0) ? 0 : {2'b00, far_t[E+M-1:0]};
  wire signed [E+M+1:0] near_value = near_t[E+M] ? -near_size : near_size;
  wire signed [E+M+1:0] far_value = far_t[E+M] ? -far_size : far_size;
  reg [7:0] clocks;
  initial clocks = 0;
  always @(posedge clk) clocks <= clocks + 1;
  always @* begin
    // An entry point among the coordinates; a reciprocal that is a positive number.
    assume (!near_p[E+M] && near_p[E+M-1:M] < (1 << (E - 1)) - 2 + IDX_W);
    assume (!near_r[E+M] && !(&near_r[E+M-1:M]) && |near_r[E+M-1:M]);
    assume ($signed(near_plane) <= $signed(far_plane));
    if (clocks == {{ latency }}) assert (near_value <= far_value);
  end
endmodule
`default_nettype wire
