// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_hit_position: position of the hit inside its texel: p + d * t - x, kept in [0, 1)
// Emitted    by reliefrtl as its unit hit_position; do not edit
// Chosen     rounding nearest-even, subnormals flush, specials ieee
// Latency    7 clocks
// Throughput one result per clock
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (every NaN
//            result has the same bits); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_hit_position #(
  parameter integer EXP_W   = 7,   // exponent bits
  parameter integer MAN_W   = 16,  // fraction bits, the hidden one not counted
  parameter integer IDX_W   = 14,  // bits of a signed, unwrapped texel coordinate
  parameter integer FRAC_W  = 12,  // fraction bits of the position
  parameter integer LATENCY = 7,   // clocks it was generated for; checked
  parameter integer VARIANT = 32'h2a9130b2  // digest of what it was generated for; checked
) (
  input  wire                 clk,       // rising edge
  input  wire                 ce,        // clock enable: registers hold while 0
  input  wire [EXP_W+MAN_W:0] p,         // entry point [float, texels]
  input  wire [EXP_W+MAN_W:0] d,         // direction [float, texels per height code]
  input  wire [EXP_W+MAN_W:0] t,         // parameter of the hit [float, height codes]
  input  wire [IDX_W-1:0]     x,         // hit texel, unwrapped [texels]
  output wire [FRAC_W-1:0]    fraction   // position inside the texel [1/2^FRAC_W texel]
);
  localparam integer FloatW = EXP_W + MAN_W + 1;  // bits of a float: sign, exponent, fraction

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (EXP_W < 2) begin : gen_illegal_0 EXP_W_must_be_at_least_2 u_illegal (); end
    if (EXP_W > 11) begin : gen_illegal_1 EXP_W_must_be_at_most_11 u_illegal (); end
    if (MAN_W < 2) begin : gen_illegal_2 MAN_W_must_be_at_least_2 u_illegal (); end
    if (MAN_W > 28) begin : gen_illegal_3 MAN_W_must_be_at_most_28 u_illegal (); end
    if (IDX_W > 24) begin : gen_illegal_4 IDX_W_must_be_at_most_24 u_illegal (); end
    if (FRAC_W < 1) begin : gen_illegal_5 FRAC_W_must_be_at_least_1 u_illegal (); end
    if (FRAC_W > 16) begin : gen_illegal_6 FRAC_W_must_be_at_most_16 u_illegal (); end
    if (IDX_W < 2) begin : gen_illegal_7 IDX_W_must_be_at_least_2 u_illegal (); end
    if (FRAC_W + IDX_W + MAN_W > 60) begin : gen_illegal_8
      FRAC_W_plus_IDX_W_plus_MAN_W_must_be_at_most_60 u_illegal ();
    end
    if (LATENCY != 7) begin : gen_other_latency
      relief_hit_position_has_LATENCY_7_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h2a9130b2) begin : gen_other_variant
      relief_hit_position_has_VARIANT_2a9130b2_nearest_even_ieee_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 0: position --------------------------------------------------------------
  wire [FloatW-1:0] s2_displacement;  // a * b [float]
  relief_fp_mul #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(2), .VARIANT(32'h5bd17165)) u_mul (
    .clk(clk), .ce(ce), .a(d), .b(t),
    .result(s2_displacement)
  );

  // ---- stage 1: registers -------------------------------------------------------------
  reg [FloatW-1:0] s1_p;
  always @(posedge clk) begin
    if (ce) begin
      s1_p <= p;
    end
  end

  // ---- stage 2: registers -------------------------------------------------------------
  reg [FloatW-1:0] s2_p;
  always @(posedge clk) begin
    if (ce) begin
      s2_p <= s1_p;
    end
  end

  // ---- stage 2: position --------------------------------------------------------------
  wire [FloatW-1:0] s5_position;  // a + b [float]
  relief_fp_add #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(3), .VARIANT(32'h294e5029)) u_add (
    .clk(clk), .ce(ce), .a(s2_p), .b(s2_displacement),
    .result(s5_position)
  );

  // ---- stage 5: position --------------------------------------------------------------
  wire [FRAC_W+IDX_W-1:0] s7_fixed;  // floor of a, saturated [fixed point]
  relief_fp_to_fixed #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .INT_W(FRAC_W + IDX_W), .FRAC_W(FRAC_W), .LATENCY(2),
    .VARIANT(32'h0ffbb2f7)
  ) u_to_fixed (
    .clk(clk), .ce(ce), .a(s5_position),
    .result(s7_fixed)
  );

  // ---- stage 7: registers -------------------------------------------------------------
  // Delay of 7 clocks: stage 0 to 7.
  reg [IDX_W-1:0]   s7_x;
  reg [6*IDX_W-1:0] s0_to_s7;
  always @(posedge clk) begin
    if (ce) begin
      {s7_x, s0_to_s7} <= {s0_to_s7, x};
    end
  end

  // ---- stage 7: clamp -----------------------------------------------------------------
  // A hit on a wall lies exactly on a border: the integer texel decides, the fraction follows.
  wire [FRAC_W+IDX_W-1:0] s7_corner = {s7_x, {FRAC_W{1'b0}}};
  wire [FRAC_W+IDX_W:0]   s7_offset =
      {{1{s7_fixed[FRAC_W+IDX_W-1]}}, s7_fixed} - {{1{s7_corner[FRAC_W+IDX_W-1]}}, s7_corner};
  wire                    s7_past = |s7_offset[FRAC_W+IDX_W:FRAC_W];
  wire [FRAC_W-1:0]       s7_low_part = s7_offset[FRAC_W-1:0];
  wire [FRAC_W-1:0]       s7_kept = s7_offset[FRAC_W+IDX_W] ? {FRAC_W{1'b0}}
      : (s7_past ? {FRAC_W{1'b1}} : s7_low_part);

  assign fraction = s7_kept;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
