// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_predicted_hit: texel coordinate reached at parameter m: floor(p_back + d * m)
// Emitted    by reliefrtl as its unit predicted_hit; do not edit
// Chosen     rounding nearest-even, subnormals flush, specials ieee
// Latency    7 clocks
// Throughput one result per clock
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (every NaN
//            result has the same bits); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_predicted_hit #(
  parameter integer EXP_W   = 7,   // exponent bits
  parameter integer MAN_W   = 16,  // fraction bits, the hidden one not counted
  parameter integer IDX_W   = 14,  // bits of a signed, unwrapped texel coordinate
  parameter integer LATENCY = 7,   // clocks it was generated for; checked
  parameter integer VARIANT = 32'h2e32196a  // digest of what it was generated for; checked
) (
  input  wire                 clk,     // rising edge
  input  wire                 ce,      // clock enable: registers hold while 0
  input  wire [EXP_W+MAN_W:0] p_back,  // entry point, biased backwards [float, texels]
  input  wire [EXP_W+MAN_W:0] d,       // direction [float, texels per height code]
  input  wire [EXP_W+MAN_W:0] m,       // parameter [float, height codes]
  output wire [IDX_W-1:0]     e        // signed coordinate [texels]
);
  localparam integer FloatW = EXP_W + MAN_W + 1;  // bits of a float: sign, exponent, fraction

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (EXP_W < 2) begin : gen_illegal_0 EXP_W_must_be_at_least_2 u_illegal (); end
    if (EXP_W > 11) begin : gen_illegal_1 EXP_W_must_be_at_most_11 u_illegal (); end
    if (MAN_W < 2) begin : gen_illegal_2 MAN_W_must_be_at_least_2 u_illegal (); end
    if (MAN_W > 28) begin : gen_illegal_3 MAN_W_must_be_at_most_28 u_illegal (); end
    if (IDX_W > 24) begin : gen_illegal_4 IDX_W_must_be_at_most_24 u_illegal (); end
    if (IDX_W < 2) begin : gen_illegal_5 IDX_W_must_be_at_least_2 u_illegal (); end
    if (LATENCY != 7) begin : gen_other_latency
      relief_predicted_hit_has_LATENCY_7_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h2e32196a) begin : gen_other_variant
      relief_predicted_hit_has_VARIANT_2e32196a_nearest_even_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 0: displacement ----------------------------------------------------------
  // The position is rounded down to its texel; the bias keeps it from lying ahead of the ray.
  wire [FloatW-1:0] s2_displacement;  // a * b [float]
  relief_fp_mul #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(2), .VARIANT(32'h5bd17165)) u_mul (
    .clk(clk), .ce(ce), .a(d), .b(m),
    .result(s2_displacement)
  );

  // ---- stage 1: registers -------------------------------------------------------------
  reg [FloatW-1:0] s1_p_back;
  always @(posedge clk) begin
    if (ce) begin
      s1_p_back <= p_back;
    end
  end

  // ---- stage 2: registers -------------------------------------------------------------
  reg [FloatW-1:0] s2_p_back;
  always @(posedge clk) begin
    if (ce) begin
      s2_p_back <= s1_p_back;
    end
  end

  // ---- stage 2: displacement ----------------------------------------------------------
  // The position is rounded down to its texel; the bias keeps it from lying ahead of the ray.
  wire [FloatW-1:0] s5_position;  // a + b [float]
  relief_fp_add #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(3), .VARIANT(32'h294e5029)) u_add (
    .clk(clk), .ce(ce), .a(s2_p_back), .b(s2_displacement),
    .result(s5_position)
  );

  // ---- stage 5: displacement ----------------------------------------------------------
  // The position is rounded down to its texel; the bias keeps it from lying ahead of the ray.
  wire [IDX_W-1:0] s7_texel;  // floor of a, saturated [integer]
  relief_fp_to_int #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .INT_W(IDX_W), .LATENCY(2), .VARIANT(32'h58cfbe4c)
  ) u_to_int (
    .clk(clk), .ce(ce), .a(s5_position),
    .result(s7_texel)
  );

  assign e = s7_texel;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
