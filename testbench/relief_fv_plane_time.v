// SPDX-License-Identifier: MIT OR Apache-2.0
// Proof harness: a later plane never has a smaller parameter (4/2).
//
// Two planes of one ray that runs toward larger coordinates. Watertightness stands on this.
`default_nettype none
module relief_fv_plane_time (input wire clk);
  localparam integer E = 4;
  localparam integer M = 2;
  localparam integer IDX_W = 5;
  (* anyconst *) wire [4:0] near_plane;
  (* anyconst *) wire [6:0] near_p;
  (* anyconst *) wire [6:0] near_r;
  (* anyconst *) wire [0:0] near_never;
  wire [6:0] near_t;
  relief_plane_time #(.EXP_W(4), .MAN_W(2), .IDX_W(5), .LATENCY(8), .VARIANT(32'h29588866)) near_dut (
    .plane(near_plane),
    .p(near_p),
    .r(near_r),
    .never(near_never),
    .t(near_t),
    .clk(clk), .ce(1'b1)
  );
  (* anyconst *) wire [4:0] far_plane;
  wire [6:0] far_p;
  wire [6:0] far_r;
  wire [0:0] far_never;
  wire [6:0] far_t;
  relief_plane_time #(.EXP_W(4), .MAN_W(2), .IDX_W(5), .LATENCY(8), .VARIANT(32'h29588866)) far_dut (
    .plane(far_plane),
    .p(far_p),
    .r(far_r),
    .never(far_never),
    .t(far_t),
    .clk(clk), .ce(1'b1)
  );
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
    if (clocks == 8) assert (near_value <= far_value);
  end
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
