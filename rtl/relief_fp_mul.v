// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_fp_mul: product of two floating-point numbers, rounded once
// Emitted    by reliefrtl as its unit fp_mul; do not edit
// Chosen     rounding nearest-even, subnormals flush, specials ieee
// Latency    2 clocks
// Throughput one result per clock
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (every NaN
//            result has the same bits); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_fp_mul #(
  parameter integer EXP_W   = 7,   // exponent bits
  parameter integer MAN_W   = 16,  // fraction bits, the hidden one not counted
  parameter integer LATENCY = 2,   // clocks it was generated for; checked
  parameter integer VARIANT = 32'h5bd17165  // digest of what it was generated for; checked
) (
  input  wire                 clk,     // rising edge
  input  wire                 ce,      // clock enable: registers hold while 0
  input  wire [EXP_W+MAN_W:0] a,       // first factor [float]
  input  wire [EXP_W+MAN_W:0] b,       // second factor [float]
  output wire [EXP_W+MAN_W:0] result   // a * b [float]
);
  localparam integer FloatW = EXP_W + MAN_W + 1;  // bits of a float: sign, exponent, fraction
  localparam integer ExpSumW = EXP_W + 2;         // bits of an exponent sum, with room for its sign
  localparam integer SigW = MAN_W + 1;            // bits of a significand, the hidden one included

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (EXP_W < 2) begin : gen_illegal_0 EXP_W_must_be_at_least_2 u_illegal (); end
    if (EXP_W > 11) begin : gen_illegal_1 EXP_W_must_be_at_most_11 u_illegal (); end
    if (MAN_W < 2) begin : gen_illegal_2 MAN_W_must_be_at_least_2 u_illegal (); end
    if (MAN_W > 28) begin : gen_illegal_3 MAN_W_must_be_at_most_28 u_illegal (); end
    if (LATENCY != 2) begin : gen_other_latency
      relief_fp_mul_has_LATENCY_2_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h5bd17165) begin : gen_other_variant
      relief_fp_mul_has_VARIANT_5bd17165_nearest_even_flush_ieee_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 0: operands --------------------------------------------------------------
  wire               s0_a_sign = a[FloatW-1];
  wire [EXP_W-1:0]   s0_a_exp = a[EXP_W+MAN_W-1:MAN_W];
  wire [MAN_W-1:0]   s0_a_frac = a[MAN_W-1:0];
  wire               s0_a_is_zero = ~(|s0_a_exp);
  wire               s0_a_exp_ones = &s0_a_exp;
  wire               s0_a_frac_some = |s0_a_frac;
  wire               s0_a_is_inf = s0_a_exp_ones & ~s0_a_frac_some;
  wire               s0_a_is_nan = s0_a_exp_ones & s0_a_frac_some;
  wire               s0_b_sign = b[FloatW-1];
  wire [EXP_W-1:0]   s0_b_exp = b[EXP_W+MAN_W-1:MAN_W];
  wire [MAN_W-1:0]   s0_b_frac = b[MAN_W-1:0];
  wire               s0_b_is_zero = ~(|s0_b_exp);
  wire               s0_b_exp_ones = &s0_b_exp;
  wire               s0_b_frac_some = |s0_b_frac;
  wire               s0_b_is_inf = s0_b_exp_ones & ~s0_b_frac_some;
  wire               s0_b_is_nan = s0_b_exp_ones & s0_b_frac_some;
  wire [ExpSumW:0]   s0_exp_sum = {{{(ExpSumW - EXP_W){1'b0}}, s0_a_exp}, 1'b1} +
      {{{(ExpSumW - EXP_W){1'b0}}, s0_b_exp}, 1'b1};
  wire [2:0]         s0_exp_top = s0_exp_sum[EXP_W+2:EXP_W] - 3'd1;
  wire [ExpSumW-1:0] s0_exp_low = {s0_exp_top, s0_exp_sum[EXP_W-1:1]};

  // ---- stage 0: multiply --------------------------------------------------------------
  // The hidden bit is 1 for every operand: a zero operand overrides the result instead.
  wire [2*MAN_W+1:0] s0_prod =
      {{(MAN_W + 1){1'b0}}, {1'b1, s0_a_frac}} * {{(MAN_W + 1){1'b0}}, {1'b1, s0_b_frac}};
  wire [ExpSumW-1:0] s0_exp_high = s0_exp_low + {{(ExpSumW - 1){1'b0}}, 1'b1};
  wire               s0_is_zero = s0_a_is_zero | s0_b_is_zero;
  wire               s0_is_inf = s0_a_is_inf | s0_b_is_inf;
  wire               s0_is_nan = s0_a_is_nan | s0_b_is_nan | (s0_is_zero & s0_is_inf);
  wire               s0_prod_sign = s0_a_sign ^ s0_b_sign;

  // ---- stage 1: registers -------------------------------------------------------------
  reg [2*MAN_W+1:0] s1_prod;
  reg [ExpSumW-1:0] s1_exp_low;
  reg [ExpSumW-1:0] s1_exp_high;
  reg               s1_is_nan;
  reg               s1_is_inf;
  reg               s1_is_zero;
  reg               s1_prod_sign;
  always @(posedge clk) begin
    if (ce) begin
      s1_prod      <= s0_prod;
      s1_exp_low   <= s0_exp_low;
      s1_exp_high  <= s0_exp_high;
      s1_is_nan    <= s0_is_nan;
      s1_is_inf    <= s0_is_inf;
      s1_is_zero   <= s0_is_zero;
      s1_prod_sign <= s0_prod_sign;
    end
  end

  // ---- stage 1: round -----------------------------------------------------------------
  // A product of two numbers in [1, 2) lies in [1, 4): low below 2, high from 2 on. A carry out of
  // the fraction continues into the exponent, and from the largest number to infinity, by itself.
  wire                   s1_low_guard = s1_prod[SigW-2];
  wire                   s1_low_tie = s1_low_guard & ~(|s1_prod[SigW-3:0]);
  wire [EXP_W+MAN_W-1:0] s1_low_sum = {s1_exp_low[EXP_W-1:0], s1_prod[MAN_W+SigW-2:SigW-1]} +
      {{(EXP_W + MAN_W - 1){1'b0}}, s1_low_guard};
  wire [EXP_W+MAN_W-1:0] s1_low_body = {s1_low_sum[EXP_W+MAN_W-1:1], s1_low_sum[0] & ~s1_low_tie};
  wire                   s1_low_at_zero = ~(|s1_exp_low);
  wire                   s1_low_too_low = s1_exp_low[ExpSumW-1] |
      (s1_low_at_zero & ~s1_low_sum[SigW-1]);
  wire                   s1_low_over = ~s1_exp_low[ExpSumW-1] &
      (s1_exp_low[EXP_W] | (&s1_exp_low[EXP_W-1:0]));
  wire                   s1_high_guard = s1_prod[SigW-1];
  wire                   s1_high_tie = s1_high_guard & ~(|s1_prod[SigW-2:0]);
  wire [EXP_W+MAN_W-1:0] s1_high_sum = {s1_exp_high[EXP_W-1:0], s1_prod[MAN_W+SigW-1:SigW]} +
      {{(EXP_W + MAN_W - 1){1'b0}}, s1_high_guard};
  wire [EXP_W+MAN_W-1:0] s1_high_body =
      {s1_high_sum[EXP_W+MAN_W-1:1], s1_high_sum[0] & ~s1_high_tie};
  wire                   s1_high_at_zero = ~(|s1_exp_high);
  wire                   s1_high_too_low = s1_exp_high[ExpSumW-1] |
      (s1_high_at_zero & ~s1_high_sum[SigW-1]);
  wire                   s1_high_over = ~s1_exp_high[ExpSumW-1] &
      (s1_exp_high[EXP_W] | (&s1_exp_high[EXP_W-1:0]));
  wire                   s1_top = s1_prod[2*MAN_W+1];

  // ---- stage 1: select ----------------------------------------------------------------
  wire [EXP_W+MAN_W-1:0] s1_picked = s1_top ? s1_high_body : s1_low_body;
  wire                   s1_give_inf = s1_is_nan | s1_is_inf |
      ((s1_top ? s1_high_over : s1_low_over) & ~s1_is_zero);
  wire                   s1_keep =
      ~(s1_give_inf | s1_is_zero | (s1_top ? s1_high_too_low : s1_low_too_low));
  wire                   s1_sign = s1_prod_sign & ~s1_is_nan;
  wire [FloatW-1:0]      s1_value =
      {s1_sign, (s1_picked[EXP_W+MAN_W-1:MAN_W] & {EXP_W{s1_keep}}) | {EXP_W{s1_give_inf}},
      (s1_picked[MAN_W-1:0] & {MAN_W{s1_keep}}) | {s1_is_nan, {(MAN_W - 1){1'b0}}}};

  // ---- stage 2: registers -------------------------------------------------------------
  reg [FloatW-1:0] s2_value;
  always @(posedge clk) begin
    if (ce) begin
      s2_value <= s1_value;
    end
  end

  // Nets and bits that nothing reads, at some parameter values or at all, gathered so that the
  // lint for unused bits stays on for all others.
  // verilator lint_off UNUSED
  wire unused_0 = &{1'b0, s0_exp_sum[0]};
  // verilator lint_on UNUSED

  assign result = s2_value;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
