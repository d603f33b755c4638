// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_fp_from_fixed: signed fixed-point number to the nearest floating-point number
// Emitted    by reliefrtl as its unit fp_from_fixed; do not edit
// Chosen     rounding nearest-even, subnormals flush, specials ieee
// Latency    2 clocks
// Throughput one result per clock
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (every NaN
//            result has the same bits); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_fp_from_fixed #(
  parameter integer EXP_W   = 7,   // exponent bits
  parameter integer MAN_W   = 16,  // fraction bits, the hidden one not counted
  parameter integer INT_W   = 26,  // bits of the signed operand
  parameter integer FRAC_W  = 12,  // of these, fraction bits
  parameter integer LATENCY = 2,   // clocks it was generated for; checked
  parameter integer VARIANT = 32'h4b4b87bd  // digest of what it was generated for; checked
) (
  input  wire                 clk,     // rising edge
  input  wire                 ce,      // clock enable: registers hold while 0
  input  wire [INT_W-1:0]     a,       // signed operand [fixed point]
  output wire [EXP_W+MAN_W:0] result   // a, rounded to nearest even [float]
);
  localparam integer FloatW = EXP_W + MAN_W + 1;  // bits of a float: sign, exponent, fraction
  // bits of an exponent, with room for its sign
  localparam integer ExpSumW = ((EXP_W > ($clog2(INT_W + 1))) ? EXP_W : ($clog2(INT_W + 1))) + 2;
  // exponent of an integer whose topmost bit is 1
  localparam integer TopExp = INT_W + (1 << (EXP_W - 1)) - FRAC_W - 2;

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
    if (FRAC_W < 0) begin : gen_illegal_6 FRAC_W_must_be_at_least_0 u_illegal (); end
    if (FRAC_W > INT_W) begin : gen_illegal_7 FRAC_W_must_be_at_most_INT_W u_illegal (); end
    if (LATENCY != 2) begin : gen_other_latency
      relief_fp_from_fixed_has_LATENCY_2_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h4b4b87bd) begin : gen_other_variant
      relief_fp_from_fixed_has_VARIANT_4b4b87bd_nearest_even_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 0: magnitude -------------------------------------------------------------
  wire             s0_minus = a[INT_W-1];
  wire [INT_W-1:0] s0_mag = (a ^ {INT_W{s0_minus}}) + {{(INT_W - 1){1'b0}}, s0_minus};

  // ---- stage 0: count -----------------------------------------------------------------
  wire [$clog2(INT_W+1)-1:0] s0_lz_count;  // zeros above the topmost 1 [bits]
  relief_lzc #(.W(INT_W)) u_lzc (.bits(s0_mag), .count(s0_lz_count));

  // ---- stage 0: normalize -------------------------------------------------------------
  // Zeros below make room for guard and sticky bits whatever INT_W is.
  wire [INT_W+MAN_W+2:0] s0_norm = {s0_mag << s0_lz_count, {(MAN_W + 3){1'b0}}};
  wire                   s0_is_zero = ~s0_norm[INT_W+MAN_W+2];
  wire [ExpSumW-1:0]     s0_norm_exp =
      TopExp[ExpSumW-1:0] - {{(ExpSumW - $clog2(INT_W + 1)){1'b0}}, s0_lz_count};

  // ---- stage 1: registers -------------------------------------------------------------
  reg [INT_W+MAN_W+2:0] s1_norm;
  reg [ExpSumW-1:0]     s1_norm_exp;
  reg                   s1_is_zero;
  reg                   s1_minus;
  always @(posedge clk) begin
    if (ce) begin
      s1_norm     <= s0_norm;
      s1_norm_exp <= s0_norm_exp;
      s1_is_zero  <= s0_is_zero;
      s1_minus    <= s0_minus;
    end
  end

  // ---- stage 1: round -----------------------------------------------------------------
  wire [MAN_W:0]   s1_sig = s1_norm[INT_W+MAN_W+2:INT_W+2];
  wire             s1_round_up = s1_norm[INT_W+1] & ((|s1_norm[INT_W:0]) | s1_sig[0]);
  wire [MAN_W+1:0] s1_rounded = {1'b0, s1_sig} + {{(MAN_W + 1){1'b0}}, s1_round_up};

  // ---- stage 1: select ----------------------------------------------------------------
  wire [MAN_W-1:0]       s1_frac = s1_rounded[MAN_W+1] ? s1_rounded[MAN_W:1]
      : s1_rounded[MAN_W-1:0];
  wire [ExpSumW-1:0]     s1_exp = s1_norm_exp + {{(ExpSumW - 1){1'b0}}, s1_rounded[MAN_W+1]};
  wire                   s1_overflow =
      ~($signed(s1_exp) < $signed({{(ExpSumW - EXP_W){1'b0}}, {EXP_W{1'b1}}}));
  wire                   s1_underflow = $signed(s1_exp) < $signed({{(ExpSumW - 1){1'b0}}, 1'b1});
  wire                   s1_give_inf = s1_overflow & ~s1_is_zero;
  wire                   s1_give_zero = s1_is_zero | s1_underflow;
  wire [EXP_W+MAN_W-1:0] s1_number = {s1_exp[EXP_W-1:0], s1_frac};
  wire [EXP_W+MAN_W-1:0] s1_body = s1_give_inf ? {{EXP_W{1'b1}}, {MAN_W{1'b0}}}
      : (s1_give_zero ? {(EXP_W + MAN_W){1'b0}} : s1_number);
  wire [FloatW-1:0]      s1_value = {s1_minus, s1_body};

  // ---- stage 2: registers -------------------------------------------------------------
  reg [FloatW-1:0] s2_value;
  always @(posedge clk) begin
    if (ce) begin
      s2_value <= s1_value;
    end
  end

  assign result = s2_value;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
