// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_fp_lt: 1 if a < b; 0 when either is NaN; +0 and -0 are equal
// Emitted    by reliefrtl as its unit fp_lt; do not edit
// Chosen     rounding nearest-even, subnormals flush, specials ieee
// Latency    1 clock
// Throughput one result per clock
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (every NaN
//            result has the same bits); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_fp_lt #(
  parameter integer EXP_W   = 7,   // exponent bits
  parameter integer MAN_W   = 16,  // fraction bits, the hidden one not counted
  parameter integer LATENCY = 1,   // clocks it was generated for; checked
  parameter integer VARIANT = 32'h34d3d038  // digest of what it was generated for; checked
) (
  input  wire                 clk,     // rising edge
  input  wire                 ce,      // clock enable: registers hold while 0
  input  wire [EXP_W+MAN_W:0] a,       // left side [float]
  input  wire [EXP_W+MAN_W:0] b,       // right side [float]
  output wire                 result   // a < b
);
  localparam integer FloatW = EXP_W + MAN_W + 1;  // bits of a float: sign, exponent, fraction

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (EXP_W < 2) begin : gen_illegal_0 EXP_W_must_be_at_least_2 u_illegal (); end
    if (EXP_W > 11) begin : gen_illegal_1 EXP_W_must_be_at_most_11 u_illegal (); end
    if (MAN_W < 2) begin : gen_illegal_2 MAN_W_must_be_at_least_2 u_illegal (); end
    if (MAN_W > 28) begin : gen_illegal_3 MAN_W_must_be_at_most_28 u_illegal (); end
    if (LATENCY != 1) begin : gen_other_latency
      relief_fp_lt_has_LATENCY_1_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h34d3d038) begin : gen_other_variant
      relief_fp_lt_has_VARIANT_34d3d038_nearest_even_flush_ieee_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 0: compare ---------------------------------------------------------------
  // Of magnitudes: below, or for a negative a, below or equal. An exponent of 0 is zero whatever
  // its fraction says, but two zeros are detected beside the comparator, not in its carry chain.
  wire                   s0_a_sign = a[FloatW-1];
  wire [EXP_W-1:0]       s0_a_exp = a[EXP_W+MAN_W-1:MAN_W];
  wire [MAN_W-1:0]       s0_a_frac = a[MAN_W-1:0];
  wire                   s0_b_sign = b[FloatW-1];
  wire [EXP_W-1:0]       s0_b_exp = b[EXP_W+MAN_W-1:MAN_W];
  wire [MAN_W-1:0]       s0_b_frac = b[MAN_W-1:0];
  wire [EXP_W+MAN_W-1:0] s0_left = {a[EXP_W+MAN_W-1:1], a[0] & ~s0_a_sign};
  wire [EXP_W+MAN_W-1:0] s0_right = {b[EXP_W+MAN_W-1:1], b[0] | (s0_a_sign & ~a[0])};
  wire                   s0_below = s0_left < s0_right;
  wire                   s0_both_zero = ~(|s0_a_exp) & ~(|s0_b_exp);
  wire                   s0_a_is_nan = (&s0_a_exp) & (|s0_a_frac);
  wire                   s0_b_is_nan = (&s0_b_exp) & (|s0_b_frac);

  // ---- stage 0: decide ----------------------------------------------------------------
  wire s0_ordered = ~(s0_a_is_nan | s0_b_is_nan | s0_both_zero);
  wire s0_less = s0_ordered & (s0_a_sign ? ~(s0_b_sign & s0_below) : (~s0_b_sign & s0_below));

  // ---- stage 1: registers -------------------------------------------------------------
  reg s1_less;
  always @(posedge clk) begin
    if (ce) begin
      s1_less <= s0_less;
    end
  end

  assign result = s1_less;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
