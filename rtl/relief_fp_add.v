// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_fp_add: sum of two floating-point numbers, rounded once; flip b's sign to subtract
// Source     src/units/float/add.rs (emitted: do not edit)
// Chosen     rounding nearest-even, subnormals flush, specials ieee
// Latency    3 clocks
// Throughput one result per clock
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (one NaN comes
//            out); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_fp_add #(
  parameter integer EXP_W   = 7,   // exponent bits
  parameter integer MAN_W   = 16,  // fraction bits, the hidden one not counted
  parameter integer LATENCY = 3,   // clocks that it was generated for
  parameter integer VARIANT = 32'h3711d0be  // digest of what is no parameter
) (
  input  wire                 clk,     // rising edge
  input  wire                 ce,      // clock enable: registers hold while 0
  input  wire [EXP_W+MAN_W:0] a,       // first operand [float]
  input  wire [EXP_W+MAN_W:0] b,       // second operand [float]
  output wire [EXP_W+MAN_W:0] result   // a + b [float]
);
  localparam integer FloatW = EXP_W + MAN_W + 1;
  localparam integer NearW = MAN_W + 2;
  localparam integer LeadW = $clog2(NearW + 1);
  localparam integer AmountW = $clog2(MAN_W + 3);
  localparam integer ShiftW = (EXP_W > (AmountW + 1) ? EXP_W : (AmountW + 1));
  localparam integer ExpSumW = (EXP_W > LeadW ? EXP_W : LeadW);
  localparam integer FineW = (LeadW / 2);

  // Illegal parameters end elaboration here: the missing module's name says what must hold.
  generate
    if (2 > EXP_W) begin : gen_illegal_0
      must_hold_2_at_most_EXP_W u_illegal ();
    end
    if (EXP_W > 11) begin : gen_illegal_1
      must_hold_EXP_W_at_most_11 u_illegal ();
    end
    if (2 > MAN_W) begin : gen_illegal_2
      must_hold_2_at_most_MAN_W u_illegal ();
    end
    if (MAN_W > 28) begin : gen_illegal_3
      must_hold_MAN_W_at_most_28 u_illegal ();
    end
    if (LATENCY != 3) begin : gen_other_latency
      relief_fp_add_has_LATENCY_3_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h3711d0be) begin : gen_other_variant
      relief_fp_add_has_VARIANT_3711d0be_nearest_even_flush_ieee_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 0: compare -------------------------------------------------------- add.rs
  // Both differences of the exponents, so that neither waits for which operand is larger.
  wire             s0_a_sign = a[FloatW-1];
  wire [EXP_W-1:0] s0_a_exp = a[EXP_W+MAN_W-1:MAN_W];
  wire [MAN_W-1:0] s0_a_frac = a[MAN_W-1:0];
  wire             s0_b_sign = b[FloatW-1];
  wire [EXP_W-1:0] s0_b_exp = b[EXP_W+MAN_W-1:MAN_W];
  wire [MAN_W-1:0] s0_b_frac = b[MAN_W-1:0];
  wire             s0_swap = a[EXP_W+MAN_W-1:0] < b[EXP_W+MAN_W-1:0];
  wire [EXP_W:0]   s0_a_above = {1'b0, s0_a_exp} - {1'b0, s0_b_exp};
  wire [EXP_W-1:0] s0_b_above = s0_b_exp - s0_a_exp;
  wire             s0_subtract = s0_a_sign ^ s0_b_sign;
  wire             s0_odd = s0_a_exp[0] ^ s0_b_exp[0];
  wire             s0_a_is_zero = ~(|s0_a_exp);
  wire             s0_b_is_zero = ~(|s0_b_exp);
  wire             s0_a_exp_ones = &s0_a_exp;
  wire             s0_b_exp_ones = &s0_b_exp;

  // ---- stage 0: order ---------------------------------------------------------- add.rs
  // The operand of larger magnitude comes first, so the difference of the significands is not
  // negative.
  wire             s0_big_sign = s0_swap ? s0_b_sign : s0_a_sign;
  wire [EXP_W-1:0] s0_big_exp = s0_swap ? s0_b_exp : s0_a_exp;
  wire [MAN_W-1:0] s0_big_frac = s0_swap ? s0_b_frac : s0_a_frac;
  wire [NearW-1:0] s0_a_halved = s0_odd ? {2'd1, s0_a_frac} : {1'b1, s0_a_frac, 1'b0};
  wire [NearW-1:0] s0_b_halved = s0_odd ? {2'd1, s0_b_frac} : {1'b1, s0_b_frac, 1'b0};
  wire [NearW-1:0] s0_lower = s0_swap ? s0_a_halved : s0_b_halved;
  wire             s0_small_is_zero = s0_swap ? s0_a_is_zero : s0_b_is_zero;
  wire [EXP_W-1:0] s0_shift = s0_a_above[EXP_W] ? s0_b_above : s0_a_above[EXP_W-1:0];
  wire             s0_both_zero = s0_a_is_zero & s0_b_is_zero;
  wire             s0_huge = s0_a_exp_ones | s0_b_exp_ones;
  wire             s0_inf_minus_inf = s0_a_exp_ones & s0_b_exp_ones & s0_subtract;

  // ---- stage 1: registers ------------------------------------------------------ add.rs
  reg [EXP_W-1:0] s1_shift;
  reg [NearW-1:0] s1_lower;
  reg             s1_small_is_zero;
  reg [MAN_W-1:0] s1_big_frac;
  reg [EXP_W-1:0] s1_big_exp;
  reg             s1_inf_minus_inf;
  reg             s1_huge;
  reg             s1_subtract;
  reg             s1_both_zero;
  reg             s1_big_sign;
  always @(posedge clk) begin
    if (ce) begin
      s1_shift         <= s0_shift;
      s1_lower         <= s0_lower;
      s1_small_is_zero <= s0_small_is_zero;
      s1_big_frac      <= s0_big_frac;
      s1_big_exp       <= s0_big_exp;
      s1_inf_minus_inf <= s0_inf_minus_inf;
      s1_huge          <= s0_huge;
      s1_subtract      <= s0_subtract;
      s1_both_zero     <= s0_both_zero;
      s1_big_sign      <= s0_big_sign;
    end
  end

  // ---- stage 1: align ---------------------------------------------------------- add.rs
  // Three bits below the significand, the last one sticky, are enough to round a sum or difference.
  wire [ShiftW-1:0]  s1_wide_shift = {{(ShiftW - EXP_W){1'b0}}, s1_shift};
  wire [AmountW-1:0] s1_amount = {s1_wide_shift[AmountW-1:1], 1'b0};
  wire               s1_beyond = |s1_wide_shift[ShiftW-1:AmountW];
  wire [MAN_W+2:0]   s1_small_sig = {s1_lower, 1'b0};
  wire               s1_kill = s1_beyond | s1_small_is_zero;
  wire [NearW-1:0]   s1_near = {1'b1, s1_big_frac, 1'b0} - s1_lower;
  wire [NearW-1:0]   s1_reach = ~({NearW{1'b1}} >> s1_big_exp);
  wire               s1_near_max = (&s1_big_exp[EXP_W-1:1]) & ~s1_big_exp[0];
  wire               s1_bottom = ~(|s1_big_exp[EXP_W-1:1]) & s1_big_exp[0];
  wire               s1_is_nan = s1_huge & (s1_inf_minus_inf | (|s1_big_frac));
  wire [MAN_W+2:0]   s1_aligned = (s1_small_sig >> s1_amount) & {(MAN_W + 3){~s1_kill}};
  wire               s1_sticky =
      (s1_beyond | (|(s1_small_sig & ~({(MAN_W + 3){1'b1}} << s1_amount)))) & ~s1_small_is_zero;

  // ---- stage 1: add ------------------------------------------------------------ add.rs
  wire [MAN_W+4:0] s1_augend = {2'd1, s1_big_frac, 3'd0};
  wire [MAN_W+4:0] s1_addend = {1'b0, s1_aligned, s1_sticky};
  wire [MAN_W+4:0] s1_sum = s1_subtract ? (s1_augend - s1_addend) : (s1_augend + s1_addend);
  wire [EXP_W-1:0] s1_exp_up = s1_big_exp + {{(EXP_W - 1){1'b0}}, 1'b1};
  wire [EXP_W-1:0] s1_exp_down = s1_big_exp - {{(EXP_W - 1){1'b0}}, 1'b1};
  wire             s1_near_zero = ~(|s1_near);
  wire [LeadW-1:0] s1_lead;
  relief_lzc #(.W(MAN_W + 2)) u_lzc (
    .bits (s1_near),
    .count(s1_lead)
  );
  wire s1_flush = ~(|(s1_near & s1_reach));

  // ---- stage 2: registers ------------------------------------------------------ add.rs
  reg [MAN_W+4:0] s2_sum;
  reg [EXP_W-1:0] s2_big_exp;
  reg [EXP_W-1:0] s2_exp_down;
  reg [EXP_W-1:0] s2_exp_up;
  reg [LeadW-1:0] s2_lead;
  reg [NearW-1:0] s2_near;
  reg             s2_subtract;
  reg             s2_near_max;
  reg             s2_huge;
  reg             s2_both_zero;
  reg             s2_bottom;
  reg             s2_near_zero;
  reg             s2_is_nan;
  reg             s2_flush;
  reg             s2_big_sign;
  always @(posedge clk) begin
    if (ce) begin
      s2_sum       <= s1_sum;
      s2_big_exp   <= s1_big_exp;
      s2_exp_down  <= s1_exp_down;
      s2_exp_up    <= s1_exp_up;
      s2_lead      <= s1_lead;
      s2_near      <= s1_near;
      s2_subtract  <= s1_subtract;
      s2_near_max  <= s1_near_max;
      s2_huge      <= s1_huge;
      s2_both_zero <= s1_both_zero;
      s2_bottom    <= s1_bottom;
      s2_near_zero <= s1_near_zero;
      s2_is_nan    <= s1_is_nan;
      s2_flush     <= s1_flush;
      s2_big_sign  <= s1_big_sign;
    end
  end

  // ---- stage 2: normalize ------------------------------------------------------ add.rs
  // The far sum moves by one place at most; the near difference goes up, the coarse steps first.
  // The leg is the near difference, or zero, infinity or NaN in its place.
  wire               s2_carry = s2_sum[MAN_W+4];
  wire               s2_top = s2_sum[MAN_W+3];
  wire               s2_next = s2_sum[MAN_W+2];
  wire [MAN_W-1:0]   s2_frac = s2_carry ? s2_sum[MAN_W+3:4] : s2_top ? s2_sum[MAN_W+2:3]
      : s2_sum[MAN_W+1:2];
  wire [EXP_W-1:0]   s2_exp = s2_carry ? s2_exp_up : s2_top ? s2_big_exp : s2_exp_down;
  wire               s2_round_up = s2_carry ? (s2_sum[3] & (s2_sum[4] | s2_sum[2] | (|s2_sum[1:0])))
      : s2_top ? (s2_sum[2] & (s2_sum[3] | (|s2_sum[1:0]))) : (s2_sum[1] & (s2_sum[2] | s2_sum[0]));
  wire [NearW-1:0]   s2_near_coarse = s2_near << {s2_lead[LeadW-1:FineW], {FineW{1'b0}}};
  wire [FineW-1:0]   s2_lead_fine = s2_lead[FineW-1:0];
  wire [ExpSumW-1:0] s2_exp_less_lead =
      {{(ExpSumW - EXP_W){1'b0}}, s2_big_exp} - {{(ExpSumW - $clog2(MAN_W + 3)){1'b0}}, s2_lead};
  wire [EXP_W-1:0]   s2_near_exp = s2_exp_less_lead[EXP_W-1:0];
  wire               s2_give_inf = s2_huge | (s2_near_max & ~s2_subtract);
  wire               s2_use_leg = s2_huge | s2_both_zero | (s2_carry & s2_near_max) |
      ~(s2_carry | s2_top | (s2_next & ~s2_bottom));
  wire               s2_no_sign = s2_is_nan |
      (s2_subtract & ~s2_huge & (s2_both_zero | (s2_near_zero & ~(s2_carry | s2_top | s2_next))));

  // ---- stage 2: round ---------------------------------------------------------- add.rs
  // One place up can carry into the exponent, and from the largest number to infinity, by itself.
  wire [EXP_W+MAN_W-1:0] s2_unrounded = {s2_exp, s2_frac};
  wire [EXP_W+MAN_W-1:0] s2_rounded = s2_unrounded + {{(EXP_W + MAN_W - 1){1'b0}}, s2_round_up};
  wire [NearW-1:0]       s2_near_norm = s2_near_coarse << s2_lead_fine;
  wire [MAN_W-1:0]       s2_near_frac = s2_near_norm[MAN_W:1];

  // ---- stage 2: select --------------------------------------------------------- add.rs
  wire                   s2_keep = ~(s2_flush | s2_give_inf);
  wire [EXP_W+MAN_W-1:0] s2_body =
      s2_use_leg ?
      {(s2_near_exp & {EXP_W{s2_keep}}) | {EXP_W{s2_give_inf}}, (s2_near_frac & {MAN_W{s2_keep}}) |
      {s2_is_nan, {(MAN_W - 1){1'b0}}}} : s2_rounded;
  wire                   s2_sign = s2_big_sign & ~s2_no_sign;
  wire [FloatW-1:0]      s2_value = {s2_sign, s2_body};

  // ---- stage 3: registers ------------------------------------------------------ add.rs
  reg [FloatW-1:0] s3_value;
  always @(posedge clk) begin
    if (ce) begin
      s3_value <= s2_value;
    end
  end

  // Bits that nothing needs, named so that no lint has to be switched off for the rest.
  // verilator lint_off UNUSED
  wire unused_0 = &{1'b0, s1_wide_shift[0]};
  wire unused_1 = &{1'b0, {s2_near_norm, s2_exp_less_lead}};
  // verilator lint_on UNUSED

  assign result = s3_value;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
