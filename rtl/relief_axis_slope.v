// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_axis_slope: a ray's constants along one axis: slope, its reciprocal, biased entry
// Emitted    by reliefrtl as its unit axis_slope; do not edit
// Chosen     rounding nearest-even, subnormals flush, specials ieee
// Latency    20 clocks
// Throughput one result per clock
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (every NaN
//            result has the same bits); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_axis_slope #(
  parameter integer EXP_W    = 7,   // exponent bits
  parameter integer MAN_W    = 16,  // fraction bits, the hidden one not counted
  parameter integer LEVELS   = 8,   // the map has 2^LEVELS x 2^LEVELS texels
  parameter integer HEIGHT_W = 8,   // bits of a height code
  parameter integer LATENCY  = 20,  // clocks it was generated for; checked
  parameter integer VARIANT  = 32'h054b90fe  // digest of what it was generated for; checked
) (
  input  wire                 clk,     // rising edge
  input  wire                 ce,      // clock enable: registers hold while 0
  input  wire [EXP_W+MAN_W:0] p,       // entry point [float, texels]
  input  wire [EXP_W+MAN_W:0] dn,      // travel down to the bottom plane [float, texels]
  output wire [EXP_W+MAN_W:0] p_back,  // entry point, biased against the direction [float, texels]
  output wire [EXP_W+MAN_W:0] d,       // direction [float, texels per height code]
  output wire [EXP_W+MAN_W:0] r,       // reciprocal direction [float, height codes per texel]
  // the ray does not move along this axis: dn is zero, or M / dn overflows
  output wire                 never
);
  localparam integer FloatW = EXP_W + MAN_W + 1;  // bits of a float: sign, exponent, fraction
  // biased exponent of M = 2^HEIGHT_W - 1
  localparam integer MExp = HEIGHT_W + (1 << (EXP_W - 1)) - 2;
  localparam integer MFrac = (1 << MAN_W) - (1 << (MAN_W - HEIGHT_W + 1));  // fraction field of M
  localparam integer RecipExp = (1 << (EXP_W - 1)) - HEIGHT_W - 1;  // biased exponent of 1 / M
  // significand of 1 / M: 2^(HEIGHT_W + MAN_W) / M, to nearest; never a tie
  localparam [63:0] RecipSig =
      ((64'd1 << HEIGHT_W) +
      (64'd1 << (HEIGHT_W + MAN_W + 1)) - 64'd1) / (64'd2 * (64'd1 << HEIGHT_W) - 64'd2);
  // biased exponent of 2^(LEVELS + 2), four times the side of the map
  localparam integer LeastExp = LEVELS + (1 << (EXP_W - 1)) + 1;
  localparam integer SigW = MAN_W + 1;                                      // bits of a significand

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (EXP_W < 2) begin : gen_illegal_0 EXP_W_must_be_at_least_2 u_illegal (); end
    if (EXP_W > 11) begin : gen_illegal_1 EXP_W_must_be_at_most_11 u_illegal (); end
    if (MAN_W < 16) begin : gen_illegal_2 MAN_W_must_be_at_least_16 u_illegal (); end
    if (MAN_W > 28) begin : gen_illegal_3 MAN_W_must_be_at_most_28 u_illegal (); end
    if (LEVELS < 2) begin : gen_illegal_4 LEVELS_must_be_at_least_2 u_illegal (); end
    if (LEVELS > 12) begin : gen_illegal_5 LEVELS_must_be_at_most_12 u_illegal (); end
    if (HEIGHT_W < 2) begin : gen_illegal_6 HEIGHT_W_must_be_at_least_2 u_illegal (); end
    if (HEIGHT_W > 16) begin : gen_illegal_7 HEIGHT_W_must_be_at_most_16 u_illegal (); end
    if (HEIGHT_W + 2 > (1 << (EXP_W - 1)) - 1) begin : gen_illegal_8
      HEIGHT_W_plus_2_must_be_at_most_the_exponent_bias u_illegal ();
    end
    if (MAN_W > LEVELS + (1 << (EXP_W - 1)) - 1) begin : gen_illegal_9
      MAN_W_must_be_at_most_LEVELS_plus_the_exponent_bias u_illegal ();
    end
    if (LEVELS + 2 > (1 << (EXP_W - 1)) - 1) begin : gen_illegal_10
      LEVELS_plus_2_must_be_at_most_the_exponent_bias u_illegal ();
    end
    if (LATENCY != 20) begin : gen_other_latency
      relief_axis_slope_has_LATENCY_20_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h054b90fe) begin : gen_other_variant
      relief_axis_slope_has_VARIANT_054b90fe_nearest_even_flush_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 0: slope -----------------------------------------------------------------
  // Direction dn * R, with R = 1 / M rounded to a float, and its reciprocal M / dn; M = 2^HEIGHT_W
  // - 1.
  wire [FloatW-1:0] s20_height_per_texel;  // M / dn [float, height codes per texel]
  relief_fp_div #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(20), .VARIANT(32'h168f7dd3)) u_div (
    .clk(clk), .ce(ce), .a({1'b0, MExp[EXP_W-1:0], MFrac[MAN_W-1:0]}), .b(dn),
    .result(s20_height_per_texel)
  );
  wire [FloatW-1:0] s2_direction;  // dn * R, rounded once more [float, texels per height code]
  relief_fp_mul #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(2), .VARIANT(32'h5bd17165)) u_mul (
    .clk(clk), .ce(ce), .a(dn), .b({1'b0, RecipExp[EXP_W-1:0], RecipSig[MAN_W-1:0]}),
    .result(s2_direction)
  );
  wire s0_is_zero = ~(|dn[EXP_W+MAN_W-1:MAN_W]);  // dn is zero

  // ---- stage 0: bias ------------------------------------------------------------------
  // A power of two above the error of an estimated position, applied against the direction.
  wire              s0_neg = dn[FloatW-1];
  // exponent of 2^5 dn
  wire [EXP_W:0]    s0_error_exp = {1'b0, dn[EXP_W+MAN_W-1:MAN_W]} + {{(EXP_W - 2){1'b0}}, 3'd5};
  // the larger of the two exponents
  wire [EXP_W:0]    s0_bias_top = (LeastExp[EXP_W:0] < s0_error_exp) ? s0_error_exp
      : LeastExp[EXP_W:0];
  // exponent of the bias, never negative
  wire [EXP_W:0]    s0_bias_exp = s0_bias_top - SigW[EXP_W:0];
  wire              s0_forward = ~s0_neg;  // sign of the bias: against the direction
  wire [FloatW-1:0] s0_bias = {s0_forward, s0_bias_exp[EXP_W-1:0], {MAN_W{1'b0}}};

  // ---- stage 1: registers -------------------------------------------------------------
  reg [FloatW-1:0] s1_bias;
  reg [FloatW-1:0] s1_p;
  always @(posedge clk) begin
    if (ce) begin
      s1_bias <= s0_bias;
      s1_p    <= p;
    end
  end

  // ---- stage 1: bias ------------------------------------------------------------------
  // A power of two above the error of an estimated position, applied against the direction.
  wire [FloatW-1:0] s4_moved_back;  // p + bias [float]
  relief_fp_add #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(3), .VARIANT(32'h294e5029)) u_back (
    .clk(clk), .ce(ce), .a(s1_p), .b(s1_bias),
    .result(s4_moved_back)
  );

  // ---- stage 20: registers ------------------------------------------------------------
  // Delay of 20 clocks: stage 0 to 20.
  reg        s20_is_zero;
  reg [18:0] s0_to_s20;
  always @(posedge clk) begin
    if (ce) begin
      {s20_is_zero, s0_to_s20} <= {s0_to_s20, s0_is_zero};
    end
  end
  // Delay of 18 clocks: stage 2 to 20.
  reg [FloatW-1:0]    s20_direction;
  reg [17*FloatW-1:0] s2_to_s20;
  always @(posedge clk) begin
    if (ce) begin
      {s20_direction, s2_to_s20} <= {s2_to_s20, s2_direction};
    end
  end
  // Delay of 16 clocks: stage 4 to 20.
  reg [FloatW-1:0]    s20_moved_back;
  reg [15*FloatW-1:0] s4_to_s20;
  always @(posedge clk) begin
    if (ce) begin
      {s20_moved_back, s4_to_s20} <= {s4_to_s20, s4_moved_back};
    end
  end

  // ---- stage 20: slope ----------------------------------------------------------------
  // Direction dn * R, with R = 1 / M rounded to a float, and its reciprocal M / dn; M = 2^HEIGHT_W
  // - 1.
  // dn is zero, or so small that M / dn overflows
  wire s20_never_moves = (&s20_height_per_texel[EXP_W+MAN_W-1:MAN_W]) | s20_is_zero;

  // Nets and bits that nothing reads, at some parameter values or at all, gathered so that the
  // lint for unused bits stays on for all others.
  // verilator lint_off UNUSED
  wire unused_0 = &{1'b0, s0_bias_exp[EXP_W]};
  // verilator lint_on UNUSED

  assign r = s20_height_per_texel;
  assign d = s20_direction;
  assign never = s20_never_moves;
  assign p_back = s20_moved_back;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
