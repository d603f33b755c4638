// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_fp_to_int: floating-point number to a signed integer, toward minus infinity, saturating
// Emitted    by reliefrtl as its unit fp_to_int; do not edit
// Chosen     rounding nearest-even, subnormals flush, specials ieee
// Latency    2 clocks
// Throughput one result per clock
// Note       Infinities saturate; NaN gives 0.
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (every NaN
//            result has the same bits); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_fp_to_int #(
  parameter integer EXP_W   = 7,   // exponent bits
  parameter integer MAN_W   = 16,  // fraction bits, the hidden one not counted
  parameter integer INT_W   = 14,  // bits of the signed result
  parameter integer LATENCY = 2,   // clocks it was generated for; checked
  parameter integer VARIANT = 32'h58cfbe4c  // digest of what it was generated for; checked
) (
  input  wire                 clk,     // rising edge
  input  wire                 ce,      // clock enable: registers hold while 0
  input  wire [EXP_W+MAN_W:0] a,       // operand [float]
  output wire [INT_W-1:0]     result   // floor of a, saturated [integer]
);
  localparam integer FloatW = EXP_W + MAN_W + 1;  // bits of a float: sign, exponent, fraction
  // bits of a shift to the right, with room for its sign
  localparam integer RightW =
      ((EXP_W > ($clog2(INT_W + MAN_W + 1))) ? EXP_W : ($clog2(INT_W + MAN_W + 1))) + 3;
  localparam integer WideW = INT_W + MAN_W + 1;   // bits of an integer with a significand below it
  // biased exponent of a number that need not be moved
  localparam integer Full = INT_W + MAN_W + (1 << (EXP_W - 1)) - 1;
  localparam integer Least = MAN_W + 2;           // least shift of a number that fits

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (EXP_W < 2) begin : gen_illegal_0 EXP_W_must_be_at_least_2 u_illegal (); end
    if (EXP_W > 11) begin : gen_illegal_1 EXP_W_must_be_at_most_11 u_illegal (); end
    if (MAN_W < 2) begin : gen_illegal_2 MAN_W_must_be_at_least_2 u_illegal (); end
    if (MAN_W > 28) begin : gen_illegal_3 MAN_W_must_be_at_most_28 u_illegal (); end
    if (INT_W < 2) begin : gen_illegal_4 INT_W_must_be_at_least_2 u_illegal (); end
    if (INT_W + MAN_W + 3 > 64) begin : gen_illegal_5
      INT_W_plus_MAN_W_plus_3_must_be_at_most_64 u_illegal ();
    end
    if (LATENCY != 2) begin : gen_other_latency
      relief_fp_to_int_has_LATENCY_2_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h58cfbe4c) begin : gen_other_variant
      relief_fp_to_int_has_VARIANT_58cfbe4c_nearest_even_flush_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 0: distance --------------------------------------------------------------
  // The significand starts above INT_W zeros and moves right by what the exponent lacks.
  wire              s0_a_sign = a[FloatW-1];
  wire [EXP_W-1:0]  s0_a_exp = a[EXP_W+MAN_W-1:MAN_W];
  wire [MAN_W-1:0]  s0_a_frac = a[MAN_W-1:0];
  wire              s0_a_is_zero = ~(|s0_a_exp);
  wire              s0_a_exp_ones = &s0_a_exp;
  wire              s0_a_frac_some = |s0_a_frac;
  wire              s0_a_is_inf = s0_a_exp_ones & ~s0_a_frac_some;
  wire              s0_a_is_nan = s0_a_exp_ones & s0_a_frac_some;
  wire [MAN_W:0]    s0_a_sig = {~s0_a_is_zero, s0_a_frac & {MAN_W{~s0_a_is_zero}}};
  wire [RightW-1:0] s0_right = Full[RightW-1:0] - {{(RightW - EXP_W){1'b0}}, s0_a_exp};
  wire              s0_too_big = ($signed(s0_right) < $signed(Least[RightW-1:0])) | s0_a_is_inf;

  // ---- stage 0: shift -----------------------------------------------------------------
  // By multiples of four first; what each step shifts out is lost.
  wire [WideW-1:0]  s0_unshifted = {s0_a_sig, {INT_W{1'b0}}};
  wire [RightW-1:0] s0_coarse = {s0_right[RightW-1:2], 2'd0};
  wire [WideW-1:0]  s0_coarse_shifted = s0_unshifted >> s0_coarse;
  wire [1:0]        s0_fine = s0_right[1:0];
  wire              s0_lost_coarse = |(s0_unshifted & ~({WideW{1'b1}} << s0_coarse));

  // ---- stage 1: registers -------------------------------------------------------------
  reg [WideW-1:0] s1_coarse_shifted;
  reg [1:0]       s1_fine;
  reg             s1_lost_coarse;
  reg             s1_a_sign;
  reg             s1_too_big;
  reg             s1_a_is_nan;
  always @(posedge clk) begin
    if (ce) begin
      s1_coarse_shifted <= s0_coarse_shifted;
      s1_fine           <= s0_fine;
      s1_lost_coarse    <= s0_lost_coarse;
      s1_a_sign         <= s0_a_sign;
      s1_too_big        <= s0_too_big;
      s1_a_is_nan       <= s0_a_is_nan;
    end
  end

  // ---- stage 1: fine shift ------------------------------------------------------------
  wire [WideW-1:0] s1_shifted = s1_coarse_shifted >> s1_fine;
  wire             s1_lost = s1_lost_coarse | (|(s1_coarse_shifted[2:0] & ~({3{1'b1}} << s1_fine)));
  wire [INT_W-1:0] s1_mag = s1_shifted[INT_W-1:0];

  // ---- stage 1: floor -----------------------------------------------------------------
  // A negative number with bits shifted out lies below its truncated magnitude.
  wire [INT_W-1:0] s1_floor = (s1_mag ^ {INT_W{s1_a_sign}}) +
      {{(INT_W - 1){1'b0}}, s1_a_sign & ~s1_lost};

  // ---- stage 1: saturate --------------------------------------------------------------
  wire [INT_W-1:0] s1_limit = {s1_a_sign, {(INT_W - 1){~s1_a_sign}}};
  wire [INT_W-1:0] s1_result_value = s1_a_is_nan ? {INT_W{1'b0}}
      : (s1_too_big ? s1_limit : s1_floor);

  // ---- stage 2: registers -------------------------------------------------------------
  reg [INT_W-1:0] s2_result_value;
  always @(posedge clk) begin
    if (ce) begin
      s2_result_value <= s1_result_value;
    end
  end

  // Nets and bits that nothing reads, at some parameter values or at all, gathered so that the
  // lint for unused bits stays on for all others.
  // verilator lint_off UNUSED
  wire unused_0 = &{1'b0, s1_shifted[INT_W+MAN_W:INT_W]};
  // verilator lint_on UNUSED

  assign result = s2_result_value;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
