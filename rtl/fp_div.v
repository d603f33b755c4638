// fp_div: quotient of two floating-point numbers, rounded once
// Source     src/units/float/div.rs (emitted: do not edit)
// Config     float 7/16, levels 8, heights 8 bits, start level, 2 down, up selective; clocks add 2
//            mul 1 div 2 compare 1 from_int 1 to_int 1
// Latency    2 clocks
// Throughput one result per clock
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (one NaN comes
//            out); nearest, ties to even; x - x is +0.
`default_nettype none
module fp_div #(
  parameter integer EXP_W = 7,   // exponent bits
  parameter integer MAN_W = 16   // fraction bits, the hidden one not counted
) (
  input  wire                 clk,     // rising edge
  input  wire                 ce,      // clock enable: registers hold while 0
  input  wire [EXP_W+MAN_W:0] a,       // dividend [float]
  input  wire [EXP_W+MAN_W:0] b,       // divisor [float]
  output wire [EXP_W+MAN_W:0] result   // a / b [float]
);
  localparam integer FloatW = EXP_W + MAN_W + 1;
  localparam integer ExpSumW = EXP_W + 2;
  localparam integer SigW = MAN_W + 1;
  localparam integer QuotW = SigW + 2;
  localparam integer Bias = (1 << (EXP_W - 1)) - 1;

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

  // ---- stage 0: classes -------------------------------------------------------- div.rs
  // The hidden bit is 1 for every operand: a zero operand overrides the result instead.
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
  wire               s0_quot_sign = s0_a_sign ^ s0_b_sign;
  wire [ExpSumW-1:0] s0_quot_exp =
      ({{(ExpSumW - EXP_W){1'b0}}, s0_a_exp} - {{(ExpSumW - EXP_W){1'b0}}, s0_b_exp}) +
      Bias[ExpSumW-1:0];
  wire               s0_is_inf = (s0_a_is_inf | s0_b_is_zero) & ~s0_b_is_inf & ~s0_a_is_zero;
  wire               s0_is_zero = (s0_a_is_zero | s0_b_is_inf) & ~s0_a_is_inf & ~s0_b_is_zero;
  wire               s0_is_nan = s0_a_is_nan | s0_b_is_nan | (s0_a_is_zero & s0_b_is_zero) |
      (s0_a_is_inf & s0_b_is_inf);
  wire [SigW-1:0]    s0_divisor = {1'b1, s0_b_frac};
  wire [MAN_W+1:0]   s0_rem = {2'd1, s0_a_frac};

  // ---- stage 0: rows 0 --------------------------------------------------------- div.rs
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0]              s0_rem_0;
  wire [((10*QuotW)/19)-1:0] s0_digits_0;
  div_rows #(.W(SigW), .ROWS((10 * QuotW) / 19)) u_rows_0 (
    .rem_in (s0_rem),
    .div    (s0_divisor),
    .rem_out(s0_rem_0),
    .quot   (s0_digits_0)
  );

  // ---- stage 1: registers ------------------------------------------------------ div.rs
  reg [SigW:0]              s1_rem_0;
  reg [SigW-1:0]            s1_divisor;
  reg [((10*QuotW)/19)-1:0] s1_digits_0;
  reg [ExpSumW-1:0]         s1_quot_exp;
  reg                       s1_is_nan;
  reg                       s1_is_inf;
  reg                       s1_is_zero;
  reg                       s1_quot_sign;
  always @(posedge clk) begin
    if (ce) begin
      s1_rem_0     <= s0_rem_0;
      s1_divisor   <= s0_divisor;
      s1_digits_0  <= s0_digits_0;
      s1_quot_exp  <= s0_quot_exp;
      s1_is_nan    <= s0_is_nan;
      s1_is_inf    <= s0_is_inf;
      s1_is_zero   <= s0_is_zero;
      s1_quot_sign <= s0_quot_sign;
    end
  end

  // ---- stage 1: rows 1 --------------------------------------------------------- div.rs
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s1_rem_1;
  wire [QuotW-((10*QuotW)/19)-1:0] s1_digits_1;
  div_rows #(.W(SigW), .ROWS(QuotW - ((10 * QuotW) / 19))) u_rows_1 (
    .rem_in (s1_rem_0),
    .div    (s1_divisor),
    .rem_out(s1_rem_1),
    .quot   (s1_digits_1)
  );
  wire [QuotW-1:0] s1_quot_1 = {s1_digits_0, s1_digits_1};

  // ---- stage 1: pick ----------------------------------------------------------- div.rs
  // The quotient lies in (1/2, 2): its integer bit says where the significand stands.
  wire               s1_top = s1_quot_1[QuotW-1];
  wire [ExpSumW-1:0] s1_norm_exp = s1_quot_exp - {{(ExpSumW - 1){1'b0}}, ~s1_top};
  wire [MAN_W-1:0]   s1_frac = s1_top ? s1_quot_1[MAN_W+1:2] : s1_quot_1[MAN_W:1];
  wire               s1_guard = s1_top ? s1_quot_1[1] : s1_quot_1[0];

  // ---- stage 1: round ---------------------------------------------------------- div.rs
  // No quotient lies half-way between two numbers, so the guard bit alone rounds.
  wire [EXP_W+MAN_W-1:0] s1_round_sum = {s1_norm_exp[EXP_W-1:0], s1_frac} +
      {{(EXP_W + MAN_W - 1){1'b0}}, s1_guard};
  wire                   s1_round_at_zero = ~(|s1_norm_exp);
  wire                   s1_round_too_low = s1_norm_exp[ExpSumW-1] |
      (s1_round_at_zero & ~s1_round_sum[MAN_W]);
  wire                   s1_round_over = ~s1_norm_exp[ExpSumW-1] &
      (s1_norm_exp[EXP_W] | (&s1_norm_exp[EXP_W-1:0]));

  // ---- stage 1: select --------------------------------------------------------- div.rs
  wire              s1_give_inf = s1_is_nan | s1_is_inf | (s1_round_over & ~s1_is_zero);
  wire              s1_keep = ~(s1_give_inf | s1_is_zero | s1_round_too_low);
  wire              s1_sign = s1_quot_sign & ~s1_is_nan;
  wire [FloatW-1:0] s1_value =
      {s1_sign, (s1_round_sum[EXP_W+MAN_W-1:MAN_W] & {EXP_W{s1_keep}}) | {EXP_W{s1_give_inf}},
      (s1_round_sum[MAN_W-1:0] & {MAN_W{s1_keep}}) | {s1_is_nan, {(MAN_W - 1){1'b0}}}};

  // ---- stage 2: registers ------------------------------------------------------ div.rs
  reg [FloatW-1:0] s2_value;
  always @(posedge clk) begin
    if (ce) begin
      s2_value <= s1_value;
    end
  end

  // Bits that nothing needs, named so that no lint has to be switched off for the rest.
  // verilator lint_off UNUSED
  wire unused_0 = &{1'b0, s1_rem_1};
  // verilator lint_on UNUSED

  assign result = s2_value;
endmodule
`default_nettype wire
