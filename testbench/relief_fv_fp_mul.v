// SPDX-License-Identifier: MIT OR Apache-2.0
// Proof harness: the exact product, rounded once (4/3).
//
// The reference multiplies significands as integers, and rounds the product once, with an unbounded exponent.
`default_nettype none
module relief_fv_fp_mul (input wire clk);
  localparam integer E = 4;
  localparam integer M = 3;
  localparam integer BIAS = (1 << (E - 1)) - 1;
  (* anyconst *) wire [7:0] a;
  (* anyconst *) wire [7:0] b;
  wire [7:0] result;
  relief_fp_mul #(.EXP_W(4), .MAN_W(3), .LATENCY(2), .VARIANT(32'h5bd17165)) dut (
    .a(a),
    .b(b),
    .result(result),
    .clk(clk), .ce(1'b1)
  );
  wire [E-1:0] ea = a[E+M-1:M], eb = b[E+M-1:M];
  wire a_nan = &ea && |a[M-1:0], b_nan = &eb && |b[M-1:0], a_inf = &ea && !a_nan, b_inf = &eb && !b_nan;
  wire a_zero = ea == 0, b_zero = eb == 0, sign = a[E+M] ^ b[E+M];
  wire [M:0] ma = {1'b1, a[M-1:0]}, mb = {1'b1, b[M-1:0]};
  wire [2*M+1:0] product = ma * mb;
  wire high = product[2*M+1];
  wire [2*M+1:0] aligned = high ? product : product << 1;
  wire [M:0] low = aligned[M:0];
  reg [M+1:0] kept;
  reg signed [E+2:0] exponent;
  reg [E+M:0] want;
  always @* begin
    kept = aligned[2*M+1:M+1];
    exponent = $signed({3'b000, ea}) + $signed({3'b000, eb}) - BIAS + $signed({1'b0, high});
    if (low[M] && (|low[M-1:0] || kept[0])) kept = kept + 1;
    if (kept[M+1]) begin
      kept = kept >> 1;
      exponent = exponent + 1;
    end
    want = {sign, exponent[E-1:0], kept[M-1:0]};
    if (exponent < 1 || a_zero || b_zero) want = {sign, {(E+M){1'b0}}};
    if ((exponent >= (1 << E) - 1 && !a_zero && !b_zero) || a_inf || b_inf) want = {sign, {E{1'b1}}, {M{1'b0}}};
    if (a_nan || b_nan || (a_inf && b_zero) || (b_inf && a_zero)) want = {1'b0, {E{1'b1}}, 1'b1, {(M-1){1'b0}}};
  end
  reg [7:0] clocks;
  initial clocks = 0;
  always @(posedge clk) clocks <= clocks + 1;
  always @* if (clocks == 2) assert (result == want);
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
