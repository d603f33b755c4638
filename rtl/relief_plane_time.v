// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_plane_time: ray parameter at which the ray meets a plane: (plane - p) * r
// Emitted    by reliefrtl as its unit plane_time; do not edit
// Chosen     rounding nearest-even, subnormals flush, specials ieee
// Latency    8 clocks
// Throughput one result per clock
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (every NaN
//            result has the same bits); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_plane_time #(
  parameter integer EXP_W   = 7,   // exponent bits
  parameter integer MAN_W   = 16,  // fraction bits, the hidden one not counted
  parameter integer IDX_W   = 14,  // bits of a signed, unwrapped texel coordinate
  parameter integer LATENCY = 8,   // clocks it was generated for; checked
  parameter integer VARIANT = 32'h29588866  // digest of what it was generated for; checked
) (
  input  wire                 clk,    // rising edge
  input  wire                 ce,     // clock enable: registers hold while 0
  input  wire [IDX_W-1:0]     plane,  // coordinate of the plane, signed [texels]
  input  wire [EXP_W+MAN_W:0] p,      // coordinate of the entry point [float, texels]
  input  wire [EXP_W+MAN_W:0] r,      // slope's reciprocal [float, height codes per texel]
  input  wire                 never,  // the ray does not move along this axis
  output wire [EXP_W+MAN_W:0] t       // infinity if never [float, height codes]
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
    if (LATENCY != 8) begin : gen_other_latency
      relief_plane_time_has_LATENCY_8_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h29588866) begin : gen_other_variant
      relief_plane_time_has_VARIANT_29588866_nearest_even_flush_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 0: distance --------------------------------------------------------------
  wire [FloatW-1:0] s2_plane_float;  // the plane [float, texels]
  relief_fp_from_int #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .INT_W(IDX_W), .LATENCY(2), .VARIANT(32'h33bf768e)
  ) u_from_int (
    .clk(clk), .ce(ce), .a(plane),
    .result(s2_plane_float)
  );
  wire [FloatW-1:0] s0_minus_p = {~p[FloatW-1], p[FloatW-2:0]};

  // ---- stage 1: registers -------------------------------------------------------------
  reg [FloatW-1:0] s1_minus_p;
  always @(posedge clk) begin
    if (ce) begin
      s1_minus_p <= s0_minus_p;
    end
  end

  // ---- stage 2: registers -------------------------------------------------------------
  reg [FloatW-1:0] s2_minus_p;
  always @(posedge clk) begin
    if (ce) begin
      s2_minus_p <= s1_minus_p;
    end
  end

  // ---- stage 2: distance --------------------------------------------------------------
  wire [FloatW-1:0] s5_distance;  // plane - p [float, texels]
  relief_fp_add #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(3), .VARIANT(32'h294e5029)) u_sub (
    .clk(clk), .ce(ce), .a(s2_plane_float), .b(s2_minus_p),
    .result(s5_distance)
  );

  // ---- stage 5: registers -------------------------------------------------------------
  // Delay of 5 clocks: stage 0 to 5.
  reg [FloatW-1:0]   s5_r;
  reg [4*FloatW-1:0] s0_to_s5;
  always @(posedge clk) begin
    if (ce) begin
      {s5_r, s0_to_s5} <= {s0_to_s5, r};
    end
  end

  // ---- stage 5: parameter -------------------------------------------------------------
  wire [FloatW-1:0] s7_product;  // distance * r [float, height codes]
  relief_fp_mul #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(2), .VARIANT(32'h5bd17165)) u_mul (
    .clk(clk), .ce(ce), .a(s5_distance), .b(s5_r),
    .result(s7_product)
  );

  // ---- stage 7: registers -------------------------------------------------------------
  // Delay of 7 clocks: stage 0 to 7.
  reg       s7_never;
  reg [5:0] s0_to_s7;
  always @(posedge clk) begin
    if (ce) begin
      {s7_never, s0_to_s7} <= {s0_to_s7, never};
    end
  end

  // ---- stage 7: parameter -------------------------------------------------------------
  wire [FloatW-1:0] s7_plane_parameter = s7_never ? {1'b0, {EXP_W{1'b1}}, {MAN_W{1'b0}}}
      : s7_product;

  // ---- stage 8: registers -------------------------------------------------------------
  reg [FloatW-1:0] s8_plane_parameter;
  always @(posedge clk) begin
    if (ce) begin
      s8_plane_parameter <= s7_plane_parameter;
    end
  end

  assign t = s8_plane_parameter;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
