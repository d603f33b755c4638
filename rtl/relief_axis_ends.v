// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_axis_ends: texels of a ray's entry and end along one axis: floor(p), floor(p + d)
// Emitted    by reliefrtl as its unit axis_ends; do not edit
// Chosen     rounding nearest-even, subnormals flush, specials ieee
// Latency    5 clocks
// Throughput one result per clock
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (every NaN
//            result has the same bits); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_axis_ends #(
  parameter integer EXP_W   = 7,   // exponent bits
  parameter integer MAN_W   = 16,  // fraction bits, the hidden one not counted
  parameter integer IDX_W   = 14,  // bits of a signed, unwrapped texel coordinate
  parameter integer LATENCY = 5,   // clocks it was generated for; checked
  parameter integer VARIANT = 32'h4fde34f4  // digest of what it was generated for; checked
) (
  input  wire                 clk,    // rising edge
  input  wire                 ce,     // clock enable: registers hold while 0
  input  wire [EXP_W+MAN_W:0] p,      // entry point [float, texels]
  input  wire [EXP_W+MAN_W:0] dn,     // travel down to the bottom plane [float, texels]
  output wire [IDX_W-1:0]     first,  // texel of the entry point [texels]
  output wire [IDX_W-1:0]     last    // texel of the rounded end point p + dn [texels]
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
    if (LATENCY != 5) begin : gen_other_latency
      relief_axis_ends_has_LATENCY_5_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h4fde34f4) begin : gen_other_variant
      relief_axis_ends_has_VARIANT_4fde34f4_nearest_even_flush_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 0: texels ----------------------------------------------------------------
  wire [IDX_W-1:0] s2_entry_texel;  // floor of p [texels]
  relief_fp_to_int #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .INT_W(IDX_W), .LATENCY(2), .VARIANT(32'h58cfbe4c)
  ) u_first (
    .clk(clk), .ce(ce), .a(p),
    .result(s2_entry_texel)
  );
  wire [FloatW-1:0] s3_end_point;  // p + dn [float, texels]
  relief_fp_add #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(3), .VARIANT(32'h294e5029)) u_end (
    .clk(clk), .ce(ce), .a(p), .b(dn),
    .result(s3_end_point)
  );

  // ---- stage 3: registers -------------------------------------------------------------
  reg [IDX_W-1:0] s3_entry_texel;
  always @(posedge clk) begin
    if (ce) begin
      s3_entry_texel <= s2_entry_texel;
    end
  end

  // ---- stage 3: texels ----------------------------------------------------------------
  wire [IDX_W-1:0] s5_end_texel;  // floor of end_point [texels]
  relief_fp_to_int #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .INT_W(IDX_W), .LATENCY(2), .VARIANT(32'h58cfbe4c)
  ) u_last (
    .clk(clk), .ce(ce), .a(s3_end_point),
    .result(s5_end_texel)
  );

  // ---- stage 4: registers -------------------------------------------------------------
  reg [IDX_W-1:0] s4_entry_texel;
  always @(posedge clk) begin
    if (ce) begin
      s4_entry_texel <= s3_entry_texel;
    end
  end

  // ---- stage 5: registers -------------------------------------------------------------
  reg [IDX_W-1:0] s5_entry_texel;
  always @(posedge clk) begin
    if (ce) begin
      s5_entry_texel <= s4_entry_texel;
    end
  end

  assign first = s5_entry_texel;
  assign last = s5_end_texel;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
