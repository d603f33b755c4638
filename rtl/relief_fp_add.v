// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_fp_add: sum of two floating-point numbers, rounded once; flip b's sign to subtract
// Emitted    by reliefrtl as its unit fp_add; do not edit
// Chosen     rounding nearest-even, subnormals flush, specials ieee
// Latency    3 clocks
// Throughput one result per clock
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (every NaN
//            result has the same bits); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_fp_add #(
  parameter integer EXP_W   = 7,   // exponent bits
  parameter integer MAN_W   = 16,  // fraction bits, the hidden one not counted
  parameter integer LATENCY = 3,   // clocks it was generated for; checked
  parameter integer VARIANT = 32'h294e5029  // digest of what it was generated for; checked
) (
  input  wire                 clk,     // rising edge
  input  wire                 ce,      // clock enable: registers hold while 0
  input  wire [EXP_W+MAN_W:0] a,       // first operand [float]
  input  wire [EXP_W+MAN_W:0] b,       // second operand [float]
  output wire [EXP_W+MAN_W:0] result   // a + b [float]
);
  localparam integer FloatW = EXP_W + MAN_W + 1;  // bits of a float: sign, exponent, fraction
  // bits of a cancelling difference: a significand and a guard bit
  localparam integer NearW = MAN_W + 2;
  // bits of the leading zeros of NearW bits; the largest alignment has as many
  localparam integer LzcW = $clog2(NearW + 1);
  // bits of an exponent difference, with one above LzcW that says it is larger
  localparam integer ShiftW = (EXP_W > (LzcW + 1)) ? EXP_W : (LzcW + 1);
  // bits of an exponent, or of the leading zeros that lower it
  localparam integer ExpSumW = (EXP_W > LzcW) ? EXP_W : LzcW;
  // bits of the fine shift, which follows the coarse one
  localparam integer FineW = ($clog2(MAN_W + 3)) / 2;

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (EXP_W < 2) begin : gen_illegal_0 EXP_W_must_be_at_least_2 u_illegal (); end
    if (EXP_W > 11) begin : gen_illegal_1 EXP_W_must_be_at_most_11 u_illegal (); end
    if (MAN_W < 2) begin : gen_illegal_2 MAN_W_must_be_at_least_2 u_illegal (); end
    if (MAN_W > 28) begin : gen_illegal_3 MAN_W_must_be_at_most_28 u_illegal (); end
    if (LATENCY != 3) begin : gen_other_latency
      relief_fp_add_has_LATENCY_3_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h294e5029) begin : gen_other_variant
      relief_fp_add_has_VARIANT_294e5029_nearest_even_flush_ieee_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 0: compare ---------------------------------------------------------------
  // Both exponent differences in parallel with the magnitude comparison; the select follows.
  wire             s0_a_sign = a[FloatW-1];
  wire [EXP_W-1:0] s0_a_exp = a[EXP_W+MAN_W-1:MAN_W];
  wire [MAN_W-1:0] s0_a_frac = a[MAN_W-1:0];
  wire             s0_b_sign = b[FloatW-1];
  wire [EXP_W-1:0] s0_b_exp = b[EXP_W+MAN_W-1:MAN_W];
  wire [MAN_W-1:0] s0_b_frac = b[MAN_W-1:0];
  wire             s0_swap = a[EXP_W+MAN_W-1:0] < b[EXP_W+MAN_W-1:0];  // b is the larger operand
  // exponent of a less that of b
  wire [EXP_W:0]   s0_exp_diff_ab = {1'b0, s0_a_exp} - {1'b0, s0_b_exp};
  wire [EXP_W-1:0] s0_exp_diff_ba = s0_b_exp - s0_a_exp;               // the other way round
  wire             s0_subtract = s0_a_sign ^ s0_b_sign;                // the signs differ
  wire             s0_odd = s0_a_exp[0] ^ s0_b_exp[0];  // the exponents differ by an odd number
  wire             s0_a_is_zero = ~(|s0_a_exp);                        // a is zero
  wire             s0_b_is_zero = ~(|s0_b_exp);                        // b is zero
  wire             s0_a_exp_ones = &s0_a_exp;                          // a is infinity or NaN
  wire             s0_b_exp_ones = &s0_b_exp;                          // b is infinity or NaN

  // ---- stage 0: order -----------------------------------------------------------------
  // Swap so that the operand of larger magnitude comes first: the significand difference is not
  // negative.
  wire             s0_large_sign = s0_swap ? s0_b_sign : s0_a_sign;  // sign of the larger operand
  wire [EXP_W-1:0] s0_large_exp = s0_swap ? s0_b_exp : s0_a_exp;     // its exponent
  wire [MAN_W-1:0] s0_large_frac = s0_swap ? s0_b_frac : s0_a_frac;  // its fraction
  // significand of a, a bit lower if odd
  wire [NearW-1:0] s0_a_sig_prealigned = s0_odd ? {2'd1, s0_a_frac} : {1'b1, s0_a_frac, 1'b0};
  // significand of b, a bit lower if odd
  wire [NearW-1:0] s0_b_sig_prealigned = s0_odd ? {2'd1, s0_b_frac} : {1'b1, s0_b_frac, 1'b0};
  // significand of the smaller operand
  wire [NearW-1:0] s0_sig_small = s0_swap ? s0_a_sig_prealigned : s0_b_sig_prealigned;
  // the smaller operand is zero
  wire             s0_small_is_zero = s0_swap ? s0_a_is_zero : s0_b_is_zero;
  // difference of the exponents [bits]
  wire [EXP_W-1:0] s0_shift = s0_exp_diff_ab[EXP_W] ? s0_exp_diff_ba : s0_exp_diff_ab[EXP_W-1:0];
  wire             s0_both_zero = s0_a_is_zero & s0_b_is_zero;       // both operands are zero
  wire             s0_any_exp_max = s0_a_exp_ones | s0_b_exp_ones;  // an operand is infinity or NaN
  // both are, with different signs
  wire             s0_inf_minus_inf = s0_a_exp_ones & s0_b_exp_ones & s0_subtract;

  // ---- stage 1: registers -------------------------------------------------------------
  reg [EXP_W-1:0] s1_shift;
  reg [NearW-1:0] s1_sig_small;
  reg             s1_small_is_zero;
  reg [MAN_W-1:0] s1_large_frac;
  reg [EXP_W-1:0] s1_large_exp;
  reg             s1_inf_minus_inf;
  reg             s1_any_exp_max;
  reg             s1_subtract;
  always @(posedge clk) begin
    if (ce) begin
      s1_shift         <= s0_shift;
      s1_sig_small     <= s0_sig_small;
      s1_small_is_zero <= s0_small_is_zero;
      s1_large_frac    <= s0_large_frac;
      s1_large_exp     <= s0_large_exp;
      s1_inf_minus_inf <= s0_inf_minus_inf;
      s1_any_exp_max   <= s0_any_exp_max;
      s1_subtract      <= s0_subtract;
    end
  end

  // ---- stage 1: align -----------------------------------------------------------------
  // Guard, round and sticky bits below the significand suffice to round the result.
  // shift, in bits enough for its top bits to say that all is lost
  wire [ShiftW-1:0] s1_wide_shift = {{(ShiftW - EXP_W){1'b0}}, s1_shift};
  wire [LzcW-1:0]   s1_amount = {s1_wide_shift[LzcW-1:1], 1'b0};  // alignment shift, even [bits]
  wire              s1_beyond = |s1_wide_shift[ShiftW-1:LzcW];    // the shift is 2^LzcW or more
  wire [MAN_W+2:0]  s1_sig_small_ext = {s1_sig_small, 1'b0};      // with a guard bit
  // a sticky bit is left of it at most
  wire              s1_small_is_lost = s1_beyond | s1_small_is_zero;
  // difference of significands whose exponents differ by at most 1, exact
  wire [NearW-1:0]  s1_near = {1'b1, s1_large_frac, 1'b0} - s1_sig_small;
  // the top large_exp places: a leading 1 there is a normal result
  wire [NearW-1:0]  s1_normal_mask = ~({NearW{1'b1}} >> s1_large_exp);
  // the exponent is the largest of a finite number
  wire              s1_exp_is_largest = (&s1_large_exp[EXP_W-1:1]) & ~s1_large_exp[0];
  // the exponent is that of the smallest normal number
  wire              s1_exp_is_least = ~(|s1_large_exp[EXP_W-1:1]) & s1_large_exp[0];
  // the result is NaN
  wire              s1_is_nan = s1_any_exp_max & (s1_inf_minus_inf | (|s1_large_frac));
  // the smaller significand at the place of the larger one
  wire [MAN_W+2:0]  s1_aligned = (s1_sig_small_ext >> s1_amount) & {(MAN_W + 3){~s1_small_is_lost}};
  // a 1 was shifted out
  wire              s1_sticky =
      (s1_beyond | (|(s1_sig_small_ext & ~({(MAN_W + 3){1'b1}} << s1_amount)))) & ~s1_small_is_zero;

  // ---- stage 1: add -------------------------------------------------------------------
  // larger significand, with room for carry, guard, round and sticky
  wire [MAN_W+4:0] s1_augend = {2'd1, s1_large_frac, 3'd0};
  wire [MAN_W+4:0] s1_addend = {1'b0, s1_aligned, s1_sticky};  // smaller significand, likewise
  // far sum or difference, not normalized
  wire [MAN_W+4:0] s1_sum = s1_subtract ? (s1_augend - s1_addend) : (s1_augend + s1_addend);
  // exponent after a carry
  wire [EXP_W-1:0] s1_exp_up = s1_large_exp + {{(EXP_W - 1){1'b0}}, 1'b1};
  // exponent after a shift by one bit
  wire [EXP_W-1:0] s1_exp_down = s1_large_exp - {{(EXP_W - 1){1'b0}}, 1'b1};
  wire             s1_near_is_zero = ~(|s1_near);              // the operands cancel
  wire [LzcW-1:0]  s1_lz_count;                                // zeros above the topmost 1 [bits]
  relief_lzc #(.W(NearW)) u_lzc (.bits(s1_near), .count(s1_lz_count));
  wire s1_flush = ~(|(s1_near & s1_normal_mask));  // the difference is below the smallest normal

  // ---- stage 2: registers -------------------------------------------------------------
  reg [MAN_W+4:0] s2_sum;
  reg [EXP_W-1:0] s2_large_exp;
  reg [EXP_W-1:0] s2_exp_down;
  reg [EXP_W-1:0] s2_exp_up;
  reg [LzcW-1:0]  s2_lz_count;
  reg [NearW-1:0] s2_near;
  reg             s2_subtract;
  reg             s2_exp_is_largest;
  reg             s2_any_exp_max;
  reg             s2_exp_is_least;
  reg             s2_near_is_zero;
  reg             s2_is_nan;
  reg             s2_flush;
  always @(posedge clk) begin
    if (ce) begin
      s2_sum            <= s1_sum;
      s2_large_exp      <= s1_large_exp;
      s2_exp_down       <= s1_exp_down;
      s2_exp_up         <= s1_exp_up;
      s2_lz_count       <= s1_lz_count;
      s2_near           <= s1_near;
      s2_subtract       <= s1_subtract;
      s2_exp_is_largest <= s1_exp_is_largest;
      s2_any_exp_max    <= s1_any_exp_max;
      s2_exp_is_least   <= s1_exp_is_least;
      s2_near_is_zero   <= s1_near_is_zero;
      s2_is_nan         <= s1_is_nan;
      s2_flush          <= s1_flush;
    end
  end
  // Delay of 2 clocks: stage 0 to 2.
  reg       s2_both_zero;
  reg       s2_large_sign;
  reg [1:0] s0_to_s2;
  always @(posedge clk) begin
    if (ce) begin
      {s2_both_zero, s2_large_sign, s0_to_s2} <= {s0_to_s2, s0_both_zero, s0_large_sign};
    end
  end

  // ---- stage 2: normalize -------------------------------------------------------------
  // The far sum is normalized by one bit at most; the near difference by a coarse and a fine left
  // shift. The near result is that difference, or zero, infinity or NaN.
  wire               s2_carry = s2_sum[MAN_W+4];                // the sum is 2 or more
  wire               s2_top = s2_sum[MAN_W+3];  // the sum is 1 or more, where it has no carry
  wire               s2_next = s2_sum[MAN_W+2];  // the sum is 1/2 or more, without top and carry
  // fraction of the far result, before rounding
  wire [MAN_W-1:0]   s2_frac = s2_carry ? s2_sum[MAN_W+3:4]
      : (s2_top ? s2_sum[MAN_W+2:3] : s2_sum[MAN_W+1:2]);
  // exponent of the far result
  wire [EXP_W-1:0]   s2_exp = s2_carry ? s2_exp_up : (s2_top ? s2_large_exp : s2_exp_down);
  // the far result is rounded away from zero
  wire               s2_round_up = s2_carry ? (s2_sum[3] & (s2_sum[4] | s2_sum[2] | (|s2_sum[1:0])))
      : (s2_top ? (s2_sum[2] & (s2_sum[3] | (|s2_sum[1:0])))
      : (s2_sum[1] & (s2_sum[2] | s2_sum[0])));
  // near, shifted by the top bits of the count
  wire [NearW-1:0]   s2_near_coarse =
      s2_near << {s2_lz_count[$clog2(MAN_W+3)-1:FineW], {FineW{1'b0}}};
  wire [FineW-1:0]   s2_lzc_fine = s2_lz_count[FineW-1:0];      // the rest of the count [bits]
  // larger exponent less the count; wraps where the result is flushed
  wire [ExpSumW-1:0] s2_exp_less_lzc =
      {{(ExpSumW - EXP_W){1'b0}}, s2_large_exp} - {{(ExpSumW - LzcW){1'b0}}, s2_lz_count};
  wire [EXP_W-1:0]   s2_near_exp = s2_exp_less_lzc[EXP_W-1:0];  // exponent of the near result
  // the near result, if it is selected, is infinity or NaN
  wire               s2_give_inf = s2_any_exp_max | (s2_exp_is_largest & ~s2_subtract);
  // the result is the near one, or a special one
  wire               s2_use_near_result = s2_any_exp_max | s2_both_zero |
      (s2_carry & s2_exp_is_largest) | ~(s2_carry | s2_top | (s2_next & ~s2_exp_is_least));
  // the result is +0 or NaN
  wire               s2_no_sign = s2_is_nan |
      (s2_subtract & ~s2_any_exp_max &
      (s2_both_zero | (s2_near_is_zero & ~(s2_carry | s2_top | s2_next))));

  // ---- stage 2: round -----------------------------------------------------------------
  // The rounding increment may carry into the exponent, and from the largest number to infinity:
  // both give the right encoding.
  wire [EXP_W+MAN_W-1:0] s2_unrounded = {s2_exp, s2_frac};  // far result, exponent and fraction
  // the same, rounded
  wire [EXP_W+MAN_W-1:0] s2_rounded = s2_unrounded + {{(EXP_W + MAN_W - 1){1'b0}}, s2_round_up};
  wire [NearW-1:0]       s2_near_norm = s2_near_coarse << s2_lzc_fine;  // near, normalized
  wire [MAN_W-1:0]       s2_near_frac = s2_near_norm[MAN_W:1];  // fraction of the near result

  // ---- stage 2: select ----------------------------------------------------------------
  // the near result is finite and not zero
  wire                   s2_keep = ~(s2_flush | s2_give_inf);
  // exponent and fraction of the result
  wire [EXP_W+MAN_W-1:0] s2_body =
      s2_use_near_result ?
      {(s2_near_exp & {EXP_W{s2_keep}}) | {EXP_W{s2_give_inf}}, (s2_near_frac & {MAN_W{s2_keep}}) |
      {s2_is_nan, {(MAN_W - 1){1'b0}}}} : s2_rounded;
  wire                   s2_sign = s2_large_sign & ~s2_no_sign;  // sign of the result
  wire [FloatW-1:0]      s2_value = {s2_sign, s2_body};          // the result

  // ---- stage 3: registers -------------------------------------------------------------
  reg [FloatW-1:0] s3_value;
  always @(posedge clk) begin
    if (ce) begin
      s3_value <= s2_value;
    end
  end

  // Nets and bits that nothing reads, at some parameter values or at all, gathered so that the
  // lint for unused bits stays on for all others.
  // verilator lint_off UNUSED
  wire unused_0 = &{1'b0, s1_wide_shift[0]};
  wire unused_1 = &{1'b0, s2_near_norm, s2_exp_less_lzc};
  // verilator lint_on UNUSED

  assign result = s3_value;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
