// SPDX-License-Identifier: MIT OR Apache-2.0
// Proof harness: the exact sum, rounded once (4/3).
//
// The reference adds integers in units of the smallest number's last place, and rounds the sum once.
`default_nettype none
module relief_fv_fp_add (input wire clk);
  localparam integer E = 4;
  localparam integer M = 3;
  localparam integer W = (1 << E) + M + 2;
  (* anyconst *) wire [7:0] a;
  (* anyconst *) wire [7:0] b;
  wire [7:0] result;
  relief_fp_add #(.EXP_W(4), .MAN_W(3), .LATENCY(3), .VARIANT(32'h294e5029)) dut (
    .a(a),
    .b(b),
    .result(result),
    .clk(clk), .ce(1'b1)
  );
  wire [E-1:0] ea = a[E+M-1:M], eb = b[E+M-1:M];
  wire a_nan = &ea && |a[M-1:0], b_nan = &eb && |b[M-1:0], a_inf = &ea && !a_nan, b_inf = &eb && !b_nan;
  wire signed [W-1:0] a_size = (ea == 0) ? 0 : ({1'b1, a[M-1:0]} << (ea - 1));
  wire signed [W-1:0] b_size = (eb == 0) ? 0 : ({1'b1, b[M-1:0]} << (eb - 1));
  wire signed [W-1:0] sum = (a[E+M] ? -a_size : a_size) + (b[E+M] ? -b_size : b_size);
  wire [W-1:0] size = sum < 0 ? -sum : sum;
  reg [7:0] top, exponent;
  reg [W-1:0] kept, rest, half;
  reg [E+M:0] want;
  integer k;
  always @* begin
    top = 0;
    for (k = 0; k < W; k = k + 1) if (size[k]) top = k;
    // The number of places that are rounded away; a sum that is that small is exact.
    exponent = top < M ? 0 : top - M + 1;
    kept = top < M ? size : size >> (exponent - 1);
    rest = top < M ? 0 : size - (kept << (exponent - 1));
    half = top <= M ? 1 : {{(W-1){1'b0}}, 1'b1} << (exponent - 2);
    if (top > M && (rest > half || (rest == half && kept[0]))) kept = kept + 1;
    if (kept[M+1]) begin
      kept = kept >> 1;
      exponent = exponent + 1;
    end
    want = {sum < 0, exponent[E-1:0], kept[M-1:0]};
    if (top < M) want = {sum < 0, {(E+M){1'b0}}};
    if (exponent >= (1 << E) - 1) want = {sum < 0, {E{1'b1}}, {M{1'b0}}};
    if (size == 0) want = {a[E+M] && b[E+M] && ea == 0 && eb == 0, {(E+M){1'b0}}};
    if (a_inf) want = a;
    if (b_inf) want = b;
    if (a_nan || b_nan || (a_inf && b_inf && a[E+M] != b[E+M])) want = {1'b0, {E{1'b1}}, 1'b1, {(M-1){1'b0}}};
  end
  reg [7:0] clocks;
  initial clocks = 0;
  always @(posedge clk) clocks <= clocks + 1;
  always @* if (clocks == 3) assert (result == want);
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
