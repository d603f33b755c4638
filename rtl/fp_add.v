// fp_add: sum of two floating-point numbers, rounded once; flip b's sign to subtract
// Source     src/units/float/add.rs (emitted: do not edit)
// Config     float 7/16, levels 8, heights 8 bits, start level, 2 down, up selective; clocks add 2
//            mul 1 div 2 compare 1 from_int 1 to_int 1
// Latency    2 clocks
// Throughput one result per clock
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (one NaN comes
//            out); nearest, ties to even; x - x is +0.
`default_nettype none
module fp_add #(
  parameter integer EXP_W = 7,   // exponent bits
  parameter integer MAN_W = 16   // fraction bits, the hidden one not counted
) (
  input  wire                 clk,     // rising edge
  input  wire                 ce,      // clock enable: registers hold while 0
  input  wire [EXP_W+MAN_W:0] a,       // first operand [float]
  input  wire [EXP_W+MAN_W:0] b,       // second operand [float]
  output wire [EXP_W+MAN_W:0] result   // a + b [float]
);
  localparam integer FloatW = EXP_W + MAN_W + 1;
  localparam integer SigW = MAN_W + 4;
  localparam integer LzW = $clog2(SigW + 2);
  localparam integer ExpSumW = (EXP_W > LzW ? EXP_W : LzW) + 2;

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
  endgenerate

  // ---- stage 0: order ---------------------------------------------------------- add.rs
  // The operand of larger magnitude comes first, so the difference of the significands is not
  // negative.
  wire             s0_a_sign = a[FloatW-1];
  wire [EXP_W-1:0] s0_a_exp = a[EXP_W+MAN_W-1:MAN_W];
  wire [MAN_W-1:0] s0_a_frac = a[MAN_W-1:0];
  wire             s0_a_is_zero = ~(|s0_a_exp);
  wire             s0_a_exp_ones = &s0_a_exp;
  wire             s0_a_frac_some = |s0_a_frac;
  wire             s0_a_is_inf = s0_a_exp_ones & ~s0_a_frac_some;
  wire             s0_a_is_nan = s0_a_exp_ones & s0_a_frac_some;
  wire             s0_b_sign = b[FloatW-1];
  wire [EXP_W-1:0] s0_b_exp = b[EXP_W+MAN_W-1:MAN_W];
  wire [MAN_W-1:0] s0_b_frac = b[MAN_W-1:0];
  wire             s0_b_is_zero = ~(|s0_b_exp);
  wire             s0_b_exp_ones = &s0_b_exp;
  wire             s0_b_frac_some = |s0_b_frac;
  wire             s0_b_is_inf = s0_b_exp_ones & ~s0_b_frac_some;
  wire             s0_b_is_nan = s0_b_exp_ones & s0_b_frac_some;
  wire [MAN_W:0]   s0_a_sig = {~s0_a_is_zero, s0_a_frac & {MAN_W{~s0_a_is_zero}}};
  wire [MAN_W:0]   s0_b_sig = {~s0_b_is_zero, s0_b_frac & {MAN_W{~s0_b_is_zero}}};
  wire             s0_swap = a[EXP_W+MAN_W-1:0] < b[EXP_W+MAN_W-1:0];
  wire             s0_big_sign = s0_swap ? s0_b_sign : s0_a_sign;
  wire [EXP_W-1:0] s0_big_exp = s0_swap ? s0_b_exp : s0_a_exp;
  wire [EXP_W-1:0] s0_small_exp = s0_swap ? s0_a_exp : s0_b_exp;
  wire [MAN_W:0]   s0_big_sig = s0_swap ? s0_b_sig : s0_a_sig;
  wire [MAN_W:0]   s0_small_sig = s0_swap ? s0_a_sig : s0_b_sig;
  wire             s0_subtract = s0_a_sign ^ s0_b_sign;
  wire             s0_is_nan = s0_a_is_nan | s0_b_is_nan |
      (s0_a_is_inf & s0_b_is_inf & s0_subtract);
  wire             s0_is_inf = s0_a_is_inf | s0_b_is_inf;
  wire             s0_inf_sign = s0_a_is_inf ? s0_a_sign : s0_b_sign;
  wire             s0_both_minus = s0_a_sign & s0_b_sign;

  // ---- stage 0: align ---------------------------------------------------------- add.rs
  // Three bits below the significand, the last one sticky, are enough to round a sum or difference.
  wire [EXP_W-1:0] s0_shift = s0_big_exp - s0_small_exp;
  wire [SigW-1:0]  s0_small_ext = {s0_small_sig, 3'd0};
  wire [SigW-1:0]  s0_shifted = s0_small_ext >> s0_shift;
  wire             s0_lost = |(s0_small_ext & ~({SigW{1'b1}} << s0_shift));
  wire [SigW-1:0]  s0_aligned = {s0_shifted[SigW-1:1], s0_shifted[0] | s0_lost};

  // ---- stage 0: add ------------------------------------------------------------ add.rs
  wire [MAN_W+4:0] s0_augend = {1'b0, s0_big_sig, 3'd0};
  wire [SigW:0]    s0_addend = {1'b0, s0_aligned};
  wire [MAN_W+4:0] s0_sum = s0_subtract ? (s0_augend - s0_addend) : (s0_augend + s0_addend);

  // ---- stage 1: registers ------------------------------------------------------ add.rs
  reg [MAN_W+4:0] s1_sum;
  reg [EXP_W-1:0] s1_big_exp;
  reg             s1_is_inf;
  reg             s1_both_minus;
  reg             s1_big_sign;
  reg             s1_inf_sign;
  reg             s1_is_nan;
  always @(posedge clk) begin
    if (ce) begin
      s1_sum        <= s0_sum;
      s1_big_exp    <= s0_big_exp;
      s1_is_inf     <= s0_is_inf;
      s1_both_minus <= s0_both_minus;
      s1_big_sign   <= s0_big_sign;
      s1_inf_sign   <= s0_inf_sign;
      s1_is_nan     <= s0_is_nan;
    end
  end

  // ---- stage 1: normalize ------------------------------------------------------ add.rs
  wire [LzW-1:0] s1_lead;
  lzc #(.W(MAN_W + 5)) u_lzc (
    .bits (s1_sum),
    .count(s1_lead)
  );
  wire [MAN_W+4:0]   s1_norm = s1_sum << s1_lead;
  wire [ExpSumW-1:0] s1_norm_exp =
      ({{(ExpSumW - EXP_W){1'b0}}, s1_big_exp} +
      {{(ExpSumW - 1){1'b0}}, 1'b1}) - {{(ExpSumW - $clog2(MAN_W + 6)){1'b0}}, s1_lead};
  wire               s1_sum_is_zero = ~s1_norm[MAN_W+4];

  // ---- stage 1: round ---------------------------------------------------------- add.rs
  wire [MAN_W:0]         s1_sig = s1_norm[MAN_W+4:4];
  wire                   s1_round_up = s1_norm[3] & ((|s1_norm[2:0]) | s1_sig[0]);
  wire [MAN_W+1:0]       s1_rounded = {1'b0, s1_sig} + {{(MAN_W + 1){1'b0}}, s1_round_up};
  wire [MAN_W-1:0]       s1_frac = s1_rounded[MAN_W+1] ? s1_rounded[MAN_W:1]
      : s1_rounded[MAN_W-1:0];
  wire [ExpSumW-1:0]     s1_exp = s1_norm_exp + {{(ExpSumW - 1){1'b0}}, s1_rounded[MAN_W+1]};
  wire                   s1_overflow =
      ~($signed(s1_exp) < $signed({{(ExpSumW - EXP_W){1'b0}}, {EXP_W{1'b1}}}));
  wire                   s1_underflow = $signed(s1_exp) < $signed({{(ExpSumW - 1){1'b0}}, 1'b1});
  wire                   s1_give_inf = s1_is_inf | (s1_overflow & ~s1_sum_is_zero);
  wire                   s1_give_zero = s1_sum_is_zero | s1_underflow;
  wire                   s1_sign = s1_is_inf ? s1_inf_sign : s1_sum_is_zero ? s1_both_minus
      : s1_big_sign;
  wire [EXP_W+MAN_W-1:0] s1_number = {s1_exp[EXP_W-1:0], s1_frac};
  wire [EXP_W+MAN_W-1:0] s1_body = s1_give_inf ? {{EXP_W{1'b1}}, {MAN_W{1'b0}}}
      : s1_give_zero ? {(EXP_W + MAN_W){1'b0}} : s1_number;
  wire [FloatW-1:0]      s1_value = s1_is_nan ? {1'b0, {EXP_W{1'b1}}, 1'b1, {(MAN_W - 1){1'b0}}}
      : {s1_sign, s1_body};

  // ---- stage 2: registers ------------------------------------------------------ add.rs
  reg [FloatW-1:0] s2_value;
  always @(posedge clk) begin
    if (ce) begin
      s2_value <= s1_value;
    end
  end

  assign result = s2_value;
endmodule
`default_nettype wire
