// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_fp_div: quotient of two floating-point numbers, rounded once
// Emitted    by reliefrtl as its unit fp_div; do not edit
// Chosen     divider rows, rounding nearest-even, subnormals flush, specials ieee
// Latency    20 clocks
// Throughput one result per clock
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (every NaN
//            result has the same bits); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_fp_div #(
  parameter integer EXP_W   = 7,   // exponent bits
  parameter integer MAN_W   = 16,  // fraction bits, the hidden one not counted
  parameter integer LATENCY = 20,  // clocks it was generated for; checked
  parameter integer VARIANT = 32'h168f7dd3  // digest of what it was generated for; checked
) (
  input  wire                 clk,     // rising edge
  input  wire                 ce,      // clock enable: registers hold while 0
  input  wire [EXP_W+MAN_W:0] a,       // dividend [float]
  input  wire [EXP_W+MAN_W:0] b,       // divisor [float]
  output wire [EXP_W+MAN_W:0] result   // a / b [float]
);
  localparam integer FloatW = EXP_W + MAN_W + 1;     // bits of a float: sign, exponent, fraction
  localparam integer ExpSumW = EXP_W + 2;  // bits of an exponent difference, with its sign
  localparam integer SigW = MAN_W + 1;  // bits of a significand, the hidden one included
  // bits of a quotient: those of the result, and what its rounding needs
  localparam integer QuotW = SigW + 2;
  localparam integer Bias = (1 << (EXP_W - 1)) - 1;  // the exponent bias

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (EXP_W < 2) begin : gen_illegal_0 EXP_W_must_be_at_least_2 u_illegal (); end
    if (EXP_W > 11) begin : gen_illegal_1 EXP_W_must_be_at_most_11 u_illegal (); end
    if (MAN_W < 16) begin : gen_illegal_2 MAN_W_must_be_at_least_16 u_illegal (); end
    if (MAN_W > 28) begin : gen_illegal_3 MAN_W_must_be_at_most_28 u_illegal (); end
    if (LATENCY != 20) begin : gen_other_latency
      relief_fp_div_has_LATENCY_20_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h168f7dd3) begin : gen_other_variant
      relief_fp_div_has_VARIANT_168f7dd3_rows_nearest_even_flush_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 0: classes ---------------------------------------------------------------
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

  // ---- stage 0: rows 0 ----------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0]         s0_rem_0;     // remainder, doubled once a row [bits]
  wire [(QuotW/19)-1:0] s0_digits_0;  // quotient bits, the first on top [bits]
  relief_div_rows #(.W(SigW), .ROWS(QuotW / 19)) u_rows_0 (
    .rem_in(s0_rem), .div(s0_divisor),
    .rem_out(s0_rem_0), .quot(s0_digits_0)
  );

  // ---- stage 1: registers -------------------------------------------------------------
  reg [SigW:0]         s1_rem_0;
  reg [SigW-1:0]       s1_divisor;
  reg [(QuotW/19)-1:0] s1_digits_0;
  always @(posedge clk) begin
    if (ce) begin
      s1_rem_0    <= s0_rem_0;
      s1_divisor  <= s0_divisor;
      s1_digits_0 <= s0_digits_0;
    end
  end

  // ---- stage 1: rows 1 ----------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s1_rem_1;                            // remainder, doubled once a row [bits]
  wire [((2*QuotW)/19)-(QuotW/19)-1:0] s1_digits_1;  // quotient bits, the first on top [bits]
  relief_div_rows #(.W(SigW), .ROWS(((2 * QuotW) / 19) - (QuotW / 19))) u_rows_1 (
    .rem_in(s1_rem_0), .div(s1_divisor),
    .rem_out(s1_rem_1), .quot(s1_digits_1)
  );
  wire [((2*QuotW)/19)-1:0] s1_quot_1 = {s1_digits_0, s1_digits_1};

  // ---- stage 2: registers -------------------------------------------------------------
  reg [SigW:0]             s2_rem_1;
  reg [SigW-1:0]           s2_divisor;
  reg [((2*QuotW)/19)-1:0] s2_quot_1;
  always @(posedge clk) begin
    if (ce) begin
      s2_rem_1   <= s1_rem_1;
      s2_divisor <= s1_divisor;
      s2_quot_1  <= s1_quot_1;
    end
  end

  // ---- stage 2: rows 2 ----------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s2_rem_2;                                // remainder, doubled once a row [bits]
  wire [((3*QuotW)/19)-((2*QuotW)/19)-1:0] s2_digits_2;  // quotient bits, the first on top [bits]
  relief_div_rows #(.W(SigW), .ROWS(((3 * QuotW) / 19) - ((2 * QuotW) / 19))) u_rows_2 (
    .rem_in(s2_rem_1), .div(s2_divisor),
    .rem_out(s2_rem_2), .quot(s2_digits_2)
  );
  wire [((3*QuotW)/19)-1:0] s2_quot_2 = {s2_quot_1, s2_digits_2};

  // ---- stage 3: registers -------------------------------------------------------------
  reg [SigW:0]             s3_rem_2;
  reg [SigW-1:0]           s3_divisor;
  reg [((3*QuotW)/19)-1:0] s3_quot_2;
  always @(posedge clk) begin
    if (ce) begin
      s3_rem_2   <= s2_rem_2;
      s3_divisor <= s2_divisor;
      s3_quot_2  <= s2_quot_2;
    end
  end

  // ---- stage 3: rows 3 ----------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s3_rem_3;                                // remainder, doubled once a row [bits]
  wire [((4*QuotW)/19)-((3*QuotW)/19)-1:0] s3_digits_3;  // quotient bits, the first on top [bits]
  relief_div_rows #(.W(SigW), .ROWS(((4 * QuotW) / 19) - ((3 * QuotW) / 19))) u_rows_3 (
    .rem_in(s3_rem_2), .div(s3_divisor),
    .rem_out(s3_rem_3), .quot(s3_digits_3)
  );
  wire [((4*QuotW)/19)-1:0] s3_quot_3 = {s3_quot_2, s3_digits_3};

  // ---- stage 4: registers -------------------------------------------------------------
  reg [SigW:0]             s4_rem_3;
  reg [SigW-1:0]           s4_divisor;
  reg [((4*QuotW)/19)-1:0] s4_quot_3;
  always @(posedge clk) begin
    if (ce) begin
      s4_rem_3   <= s3_rem_3;
      s4_divisor <= s3_divisor;
      s4_quot_3  <= s3_quot_3;
    end
  end

  // ---- stage 4: rows 4 ----------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s4_rem_4;                                // remainder, doubled once a row [bits]
  wire [((5*QuotW)/19)-((4*QuotW)/19)-1:0] s4_digits_4;  // quotient bits, the first on top [bits]
  relief_div_rows #(.W(SigW), .ROWS(((5 * QuotW) / 19) - ((4 * QuotW) / 19))) u_rows_4 (
    .rem_in(s4_rem_3), .div(s4_divisor),
    .rem_out(s4_rem_4), .quot(s4_digits_4)
  );
  wire [((5*QuotW)/19)-1:0] s4_quot_4 = {s4_quot_3, s4_digits_4};

  // ---- stage 5: registers -------------------------------------------------------------
  reg [SigW:0]             s5_rem_4;
  reg [SigW-1:0]           s5_divisor;
  reg [((5*QuotW)/19)-1:0] s5_quot_4;
  always @(posedge clk) begin
    if (ce) begin
      s5_rem_4   <= s4_rem_4;
      s5_divisor <= s4_divisor;
      s5_quot_4  <= s4_quot_4;
    end
  end

  // ---- stage 5: rows 5 ----------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s5_rem_5;                                // remainder, doubled once a row [bits]
  wire [((6*QuotW)/19)-((5*QuotW)/19)-1:0] s5_digits_5;  // quotient bits, the first on top [bits]
  relief_div_rows #(.W(SigW), .ROWS(((6 * QuotW) / 19) - ((5 * QuotW) / 19))) u_rows_5 (
    .rem_in(s5_rem_4), .div(s5_divisor),
    .rem_out(s5_rem_5), .quot(s5_digits_5)
  );
  wire [((6*QuotW)/19)-1:0] s5_quot_5 = {s5_quot_4, s5_digits_5};

  // ---- stage 6: registers -------------------------------------------------------------
  reg [SigW:0]             s6_rem_5;
  reg [SigW-1:0]           s6_divisor;
  reg [((6*QuotW)/19)-1:0] s6_quot_5;
  always @(posedge clk) begin
    if (ce) begin
      s6_rem_5   <= s5_rem_5;
      s6_divisor <= s5_divisor;
      s6_quot_5  <= s5_quot_5;
    end
  end

  // ---- stage 6: rows 6 ----------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s6_rem_6;                                // remainder, doubled once a row [bits]
  wire [((7*QuotW)/19)-((6*QuotW)/19)-1:0] s6_digits_6;  // quotient bits, the first on top [bits]
  relief_div_rows #(.W(SigW), .ROWS(((7 * QuotW) / 19) - ((6 * QuotW) / 19))) u_rows_6 (
    .rem_in(s6_rem_5), .div(s6_divisor),
    .rem_out(s6_rem_6), .quot(s6_digits_6)
  );
  wire [((7*QuotW)/19)-1:0] s6_quot_6 = {s6_quot_5, s6_digits_6};

  // ---- stage 7: registers -------------------------------------------------------------
  reg [SigW:0]             s7_rem_6;
  reg [SigW-1:0]           s7_divisor;
  reg [((7*QuotW)/19)-1:0] s7_quot_6;
  always @(posedge clk) begin
    if (ce) begin
      s7_rem_6   <= s6_rem_6;
      s7_divisor <= s6_divisor;
      s7_quot_6  <= s6_quot_6;
    end
  end

  // ---- stage 7: rows 7 ----------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s7_rem_7;                                // remainder, doubled once a row [bits]
  wire [((8*QuotW)/19)-((7*QuotW)/19)-1:0] s7_digits_7;  // quotient bits, the first on top [bits]
  relief_div_rows #(.W(SigW), .ROWS(((8 * QuotW) / 19) - ((7 * QuotW) / 19))) u_rows_7 (
    .rem_in(s7_rem_6), .div(s7_divisor),
    .rem_out(s7_rem_7), .quot(s7_digits_7)
  );
  wire [((8*QuotW)/19)-1:0] s7_quot_7 = {s7_quot_6, s7_digits_7};

  // ---- stage 8: registers -------------------------------------------------------------
  reg [SigW:0]             s8_rem_7;
  reg [SigW-1:0]           s8_divisor;
  reg [((8*QuotW)/19)-1:0] s8_quot_7;
  always @(posedge clk) begin
    if (ce) begin
      s8_rem_7   <= s7_rem_7;
      s8_divisor <= s7_divisor;
      s8_quot_7  <= s7_quot_7;
    end
  end

  // ---- stage 8: rows 8 ----------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s8_rem_8;                                // remainder, doubled once a row [bits]
  wire [((9*QuotW)/19)-((8*QuotW)/19)-1:0] s8_digits_8;  // quotient bits, the first on top [bits]
  relief_div_rows #(.W(SigW), .ROWS(((9 * QuotW) / 19) - ((8 * QuotW) / 19))) u_rows_8 (
    .rem_in(s8_rem_7), .div(s8_divisor),
    .rem_out(s8_rem_8), .quot(s8_digits_8)
  );
  wire [((9*QuotW)/19)-1:0] s8_quot_8 = {s8_quot_7, s8_digits_8};

  // ---- stage 9: registers -------------------------------------------------------------
  reg [SigW:0]             s9_rem_8;
  reg [SigW-1:0]           s9_divisor;
  reg [((9*QuotW)/19)-1:0] s9_quot_8;
  always @(posedge clk) begin
    if (ce) begin
      s9_rem_8   <= s8_rem_8;
      s9_divisor <= s8_divisor;
      s9_quot_8  <= s8_quot_8;
    end
  end

  // ---- stage 9: rows 9 ----------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s9_rem_9;                                 // remainder, doubled once a row [bits]
  wire [((10*QuotW)/19)-((9*QuotW)/19)-1:0] s9_digits_9;  // quotient bits, the first on top [bits]
  relief_div_rows #(.W(SigW), .ROWS(((10 * QuotW) / 19) - ((9 * QuotW) / 19))) u_rows_9 (
    .rem_in(s9_rem_8), .div(s9_divisor),
    .rem_out(s9_rem_9), .quot(s9_digits_9)
  );
  wire [((10*QuotW)/19)-1:0] s9_quot_9 = {s9_quot_8, s9_digits_9};

  // ---- stage 10: registers ------------------------------------------------------------
  reg [SigW:0]              s10_rem_9;
  reg [SigW-1:0]            s10_divisor;
  reg [((10*QuotW)/19)-1:0] s10_quot_9;
  always @(posedge clk) begin
    if (ce) begin
      s10_rem_9   <= s9_rem_9;
      s10_divisor <= s9_divisor;
      s10_quot_9  <= s9_quot_9;
    end
  end

  // ---- stage 10: rows 10 --------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s10_rem_10;  // remainder, doubled once a row [bits]
  // quotient bits, the first on top [bits]
  wire [((11*QuotW)/19)-((10*QuotW)/19)-1:0] s10_digits_10;
  relief_div_rows #(.W(SigW), .ROWS(((11 * QuotW) / 19) - ((10 * QuotW) / 19))) u_rows_10 (
    .rem_in(s10_rem_9), .div(s10_divisor),
    .rem_out(s10_rem_10), .quot(s10_digits_10)
  );
  wire [((11*QuotW)/19)-1:0] s10_quot_10 = {s10_quot_9, s10_digits_10};

  // ---- stage 11: registers ------------------------------------------------------------
  reg [SigW:0]              s11_rem_10;
  reg [SigW-1:0]            s11_divisor;
  reg [((11*QuotW)/19)-1:0] s11_quot_10;
  always @(posedge clk) begin
    if (ce) begin
      s11_rem_10  <= s10_rem_10;
      s11_divisor <= s10_divisor;
      s11_quot_10 <= s10_quot_10;
    end
  end

  // ---- stage 11: rows 11 --------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s11_rem_11;  // remainder, doubled once a row [bits]
  // quotient bits, the first on top [bits]
  wire [((12*QuotW)/19)-((11*QuotW)/19)-1:0] s11_digits_11;
  relief_div_rows #(.W(SigW), .ROWS(((12 * QuotW) / 19) - ((11 * QuotW) / 19))) u_rows_11 (
    .rem_in(s11_rem_10), .div(s11_divisor),
    .rem_out(s11_rem_11), .quot(s11_digits_11)
  );
  wire [((12*QuotW)/19)-1:0] s11_quot_11 = {s11_quot_10, s11_digits_11};

  // ---- stage 12: registers ------------------------------------------------------------
  reg [SigW:0]              s12_rem_11;
  reg [SigW-1:0]            s12_divisor;
  reg [((12*QuotW)/19)-1:0] s12_quot_11;
  always @(posedge clk) begin
    if (ce) begin
      s12_rem_11  <= s11_rem_11;
      s12_divisor <= s11_divisor;
      s12_quot_11 <= s11_quot_11;
    end
  end

  // ---- stage 12: rows 12 --------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s12_rem_12;  // remainder, doubled once a row [bits]
  // quotient bits, the first on top [bits]
  wire [((13*QuotW)/19)-((12*QuotW)/19)-1:0] s12_digits_12;
  relief_div_rows #(.W(SigW), .ROWS(((13 * QuotW) / 19) - ((12 * QuotW) / 19))) u_rows_12 (
    .rem_in(s12_rem_11), .div(s12_divisor),
    .rem_out(s12_rem_12), .quot(s12_digits_12)
  );
  wire [((13*QuotW)/19)-1:0] s12_quot_12 = {s12_quot_11, s12_digits_12};

  // ---- stage 13: registers ------------------------------------------------------------
  reg [SigW:0]              s13_rem_12;
  reg [SigW-1:0]            s13_divisor;
  reg [((13*QuotW)/19)-1:0] s13_quot_12;
  always @(posedge clk) begin
    if (ce) begin
      s13_rem_12  <= s12_rem_12;
      s13_divisor <= s12_divisor;
      s13_quot_12 <= s12_quot_12;
    end
  end

  // ---- stage 13: rows 13 --------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s13_rem_13;  // remainder, doubled once a row [bits]
  // quotient bits, the first on top [bits]
  wire [((14*QuotW)/19)-((13*QuotW)/19)-1:0] s13_digits_13;
  relief_div_rows #(.W(SigW), .ROWS(((14 * QuotW) / 19) - ((13 * QuotW) / 19))) u_rows_13 (
    .rem_in(s13_rem_12), .div(s13_divisor),
    .rem_out(s13_rem_13), .quot(s13_digits_13)
  );
  wire [((14*QuotW)/19)-1:0] s13_quot_13 = {s13_quot_12, s13_digits_13};

  // ---- stage 14: registers ------------------------------------------------------------
  reg [SigW:0]              s14_rem_13;
  reg [SigW-1:0]            s14_divisor;
  reg [((14*QuotW)/19)-1:0] s14_quot_13;
  always @(posedge clk) begin
    if (ce) begin
      s14_rem_13  <= s13_rem_13;
      s14_divisor <= s13_divisor;
      s14_quot_13 <= s13_quot_13;
    end
  end

  // ---- stage 14: rows 14 --------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s14_rem_14;  // remainder, doubled once a row [bits]
  // quotient bits, the first on top [bits]
  wire [((15*QuotW)/19)-((14*QuotW)/19)-1:0] s14_digits_14;
  relief_div_rows #(.W(SigW), .ROWS(((15 * QuotW) / 19) - ((14 * QuotW) / 19))) u_rows_14 (
    .rem_in(s14_rem_13), .div(s14_divisor),
    .rem_out(s14_rem_14), .quot(s14_digits_14)
  );
  wire [((15*QuotW)/19)-1:0] s14_quot_14 = {s14_quot_13, s14_digits_14};

  // ---- stage 15: registers ------------------------------------------------------------
  reg [SigW:0]              s15_rem_14;
  reg [SigW-1:0]            s15_divisor;
  reg [((15*QuotW)/19)-1:0] s15_quot_14;
  always @(posedge clk) begin
    if (ce) begin
      s15_rem_14  <= s14_rem_14;
      s15_divisor <= s14_divisor;
      s15_quot_14 <= s14_quot_14;
    end
  end

  // ---- stage 15: rows 15 --------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s15_rem_15;  // remainder, doubled once a row [bits]
  // quotient bits, the first on top [bits]
  wire [((16*QuotW)/19)-((15*QuotW)/19)-1:0] s15_digits_15;
  relief_div_rows #(.W(SigW), .ROWS(((16 * QuotW) / 19) - ((15 * QuotW) / 19))) u_rows_15 (
    .rem_in(s15_rem_14), .div(s15_divisor),
    .rem_out(s15_rem_15), .quot(s15_digits_15)
  );
  wire [((16*QuotW)/19)-1:0] s15_quot_15 = {s15_quot_14, s15_digits_15};

  // ---- stage 16: registers ------------------------------------------------------------
  reg [SigW:0]              s16_rem_15;
  reg [SigW-1:0]            s16_divisor;
  reg [((16*QuotW)/19)-1:0] s16_quot_15;
  always @(posedge clk) begin
    if (ce) begin
      s16_rem_15  <= s15_rem_15;
      s16_divisor <= s15_divisor;
      s16_quot_15 <= s15_quot_15;
    end
  end

  // ---- stage 16: rows 16 --------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s16_rem_16;  // remainder, doubled once a row [bits]
  // quotient bits, the first on top [bits]
  wire [((17*QuotW)/19)-((16*QuotW)/19)-1:0] s16_digits_16;
  relief_div_rows #(.W(SigW), .ROWS(((17 * QuotW) / 19) - ((16 * QuotW) / 19))) u_rows_16 (
    .rem_in(s16_rem_15), .div(s16_divisor),
    .rem_out(s16_rem_16), .quot(s16_digits_16)
  );
  wire [((17*QuotW)/19)-1:0] s16_quot_16 = {s16_quot_15, s16_digits_16};

  // ---- stage 17: registers ------------------------------------------------------------
  reg [SigW:0]              s17_rem_16;
  reg [SigW-1:0]            s17_divisor;
  reg [((17*QuotW)/19)-1:0] s17_quot_16;
  always @(posedge clk) begin
    if (ce) begin
      s17_rem_16  <= s16_rem_16;
      s17_divisor <= s16_divisor;
      s17_quot_16 <= s16_quot_16;
    end
  end

  // ---- stage 17: rows 17 --------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s17_rem_17;  // remainder, doubled once a row [bits]
  // quotient bits, the first on top [bits]
  wire [((18*QuotW)/19)-((17*QuotW)/19)-1:0] s17_digits_17;
  relief_div_rows #(.W(SigW), .ROWS(((18 * QuotW) / 19) - ((17 * QuotW) / 19))) u_rows_17 (
    .rem_in(s17_rem_16), .div(s17_divisor),
    .rem_out(s17_rem_17), .quot(s17_digits_17)
  );
  wire [((18*QuotW)/19)-1:0] s17_quot_17 = {s17_quot_16, s17_digits_17};

  // ---- stage 18: registers ------------------------------------------------------------
  reg [SigW:0]              s18_rem_17;
  reg [SigW-1:0]            s18_divisor;
  reg [((18*QuotW)/19)-1:0] s18_quot_17;
  always @(posedge clk) begin
    if (ce) begin
      s18_rem_17  <= s17_rem_17;
      s18_divisor <= s17_divisor;
      s18_quot_17 <= s17_quot_17;
    end
  end
  // Delay of 18 clocks: stage 0 to 18.
  reg [ExpSumW-1:0]    s18_quot_exp;
  reg [17*ExpSumW-1:0] s0_to_s18;
  always @(posedge clk) begin
    if (ce) begin
      {s18_quot_exp, s0_to_s18} <= {s0_to_s18, s0_quot_exp};
    end
  end

  // ---- stage 18: rows 18 --------------------------------------------------------------
  // Rows of compare, subtract, double: one quotient bit each, the integer bit first.
  wire [SigW:0] s18_rem_18;                        // remainder, doubled once a row [bits]
  wire [QuotW-((18*QuotW)/19)-1:0] s18_digits_18;  // quotient bits, the first on top [bits]
  relief_div_rows #(.W(SigW), .ROWS(QuotW - ((18 * QuotW) / 19))) u_rows_18 (
    .rem_in(s18_rem_17), .div(s18_divisor),
    .rem_out(s18_rem_18), .quot(s18_digits_18)
  );
  wire [QuotW-1:0] s18_quot_18 = {s18_quot_17, s18_digits_18};

  // ---- stage 18: pick -----------------------------------------------------------------
  // The quotient lies in (1/2, 2): its integer bit selects the bits of the significand.
  wire               s18_top = s18_quot_18[QuotW-1];
  wire [ExpSumW-1:0] s18_norm_exp = s18_quot_exp - {{(ExpSumW - 1){1'b0}}, ~s18_top};
  wire [MAN_W-1:0]   s18_frac = s18_top ? s18_quot_18[MAN_W+1:2] : s18_quot_18[MAN_W:1];
  wire               s18_guard = s18_top ? s18_quot_18[1] : s18_quot_18[0];

  // ---- stage 19: registers ------------------------------------------------------------
  reg [ExpSumW-1:0] s19_norm_exp;
  reg [MAN_W-1:0]   s19_frac;
  reg               s19_guard;
  always @(posedge clk) begin
    if (ce) begin
      s19_norm_exp <= s18_norm_exp;
      s19_frac     <= s18_frac;
      s19_guard    <= s18_guard;
    end
  end
  // Delay of 19 clocks: stage 0 to 19.
  reg        s19_is_nan;
  reg        s19_is_inf;
  reg        s19_is_zero;
  reg        s19_quot_sign;
  reg [71:0] s0_to_s19;
  always @(posedge clk) begin
    if (ce) begin
      {s19_is_nan, s19_is_inf, s19_is_zero, s19_quot_sign, s0_to_s19} <=
          {s0_to_s19, s0_is_nan, s0_is_inf, s0_is_zero, s0_quot_sign};
    end
  end

  // ---- stage 19: round ----------------------------------------------------------------
  // No quotient lies half-way between two numbers, so the guard bit alone rounds.
  wire [EXP_W+MAN_W-1:0] s19_round_sum = {s19_norm_exp[EXP_W-1:0], s19_frac} +
      {{(EXP_W + MAN_W - 1){1'b0}}, s19_guard};
  wire                   s19_round_at_zero = ~(|s19_norm_exp);
  wire                   s19_round_too_low = s19_norm_exp[ExpSumW-1] |
      (s19_round_at_zero & ~s19_round_sum[SigW-1]);
  wire                   s19_round_over = ~s19_norm_exp[ExpSumW-1] &
      (s19_norm_exp[EXP_W] | (&s19_norm_exp[EXP_W-1:0]));

  // ---- stage 19: select ---------------------------------------------------------------
  wire              s19_give_inf = s19_is_nan | s19_is_inf | (s19_round_over & ~s19_is_zero);
  wire              s19_keep = ~(s19_give_inf | s19_is_zero | s19_round_too_low);
  wire              s19_sign = s19_quot_sign & ~s19_is_nan;
  wire [FloatW-1:0] s19_value =
      {s19_sign, (s19_round_sum[EXP_W+MAN_W-1:MAN_W] & {EXP_W{s19_keep}}) | {EXP_W{s19_give_inf}},
      (s19_round_sum[MAN_W-1:0] & {MAN_W{s19_keep}}) | {s19_is_nan, {(MAN_W - 1){1'b0}}}};

  // ---- stage 20: registers ------------------------------------------------------------
  reg [FloatW-1:0] s20_value;
  always @(posedge clk) begin
    if (ce) begin
      s20_value <= s19_value;
    end
  end

  // Nets and bits that nothing reads, at some parameter values or at all, gathered so that the
  // lint for unused bits stays on for all others.
  // verilator lint_off UNUSED
  wire unused_0 = &{1'b0, s18_rem_18};
  // verilator lint_on UNUSED

  assign result = s20_value;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
