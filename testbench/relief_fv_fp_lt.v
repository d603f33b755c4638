// SPDX-License-Identifier: MIT OR Apache-2.0
// Proof harness: the order of the numbers, at full width.
`default_nettype none
module relief_fv_fp_lt (input wire clk);
  localparam integer E = 7;
  localparam integer M = 16;
  (* anyconst *) wire [23:0] a;
  (* anyconst *) wire [23:0] b;
  wire [0:0] result;
  relief_fp_lt #(.EXP_W(7), .MAN_W(16), .LATENCY(1), .VARIANT(32'h34d3d038)) dut (
    .a(a),
    .b(b),
    .result(result),
    .clk(clk), .ce(1'b1)
  );
  // Sign and magnitude as one signed integer; an exponent of 0 is a zero.
  wire signed [E+M+1:0] a_size = (a[E+M-1:M] == 0) ? 0 : {2'b00, a[E+M-1:0]};
  wire signed [E+M+1:0] b_size = (b[E+M-1:M] == 0) ? 0 : {2'b00, b[E+M-1:0]};
  wire signed [E+M+1:0] a_value = a[E+M] ? -a_size : a_size;
  wire signed [E+M+1:0] b_value = b[E+M] ? -b_size : b_size;
  wire is_nan = (&a[E+M-1:M] && |a[M-1:0]) || (&b[E+M-1:M] && |b[M-1:0]);
  reg [7:0] clocks;
  initial clocks = 0;
  always @(posedge clk) clocks <= clocks + 1;
  always @* if (clocks == 1) assert (result == (!is_nan && a_value < b_value));
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
