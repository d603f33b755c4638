// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_height_test: parameter at which the ray is in the node and at or below its height
// Emitted    by reliefrtl as its unit height_test; do not edit
// Chosen     rounding nearest-even, subnormals flush, specials ieee
// Latency    4 clocks
// Throughput one result per clock
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (every NaN
//            result has the same bits); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_height_test #(
  parameter integer EXP_W    = 7,   // exponent bits
  parameter integer MAN_W    = 16,  // fraction bits, the hidden one not counted
  parameter integer HEIGHT_W = 8,   // bits of a height code
  parameter integer LATENCY  = 4,   // clocks it was generated for; checked
  parameter integer VARIANT  = 32'h16a2e6ca  // digest of what it was generated for; checked
) (
  input  wire                 clk,     // rising edge
  input  wire                 ce,      // clock enable: registers hold while 0
  input  wire [HEIGHT_W-1:0]  height,  // largest height in the node [height codes]
  input  wire [EXP_W+MAN_W:0] t,       // parameter so far [float, height codes]
  // the larger of t and the height plane's parameter [float, height codes]
  output wire [EXP_W+MAN_W:0] m,
  // the ray is below the node's height already: a hit would be on a wall
  output wire                 below
);
  localparam integer FloatW = EXP_W + MAN_W + 1;  // bits of a float: sign, exponent, fraction

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (EXP_W < 2) begin : gen_illegal_0 EXP_W_must_be_at_least_2 u_illegal (); end
    if (EXP_W > 11) begin : gen_illegal_1 EXP_W_must_be_at_most_11 u_illegal (); end
    if (MAN_W < 2) begin : gen_illegal_2 MAN_W_must_be_at_least_2 u_illegal (); end
    if (MAN_W > 28) begin : gen_illegal_3 MAN_W_must_be_at_most_28 u_illegal (); end
    if (HEIGHT_W < 2) begin : gen_illegal_4 HEIGHT_W_must_be_at_least_2 u_illegal (); end
    if (HEIGHT_W > 16) begin : gen_illegal_5 HEIGHT_W_must_be_at_most_16 u_illegal (); end
    if (LATENCY != 4) begin : gen_other_latency
      relief_height_test_has_LATENCY_4_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h16a2e6ca) begin : gen_other_variant
      relief_height_test_has_VARIANT_16a2e6ca_nearest_even_flush_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 0: depth -----------------------------------------------------------------
  // The complement of a code is its distance from the top plane.
  wire [HEIGHT_W:0] s0_depth = {1'b0, ~height};
  wire [FloatW-1:0] s2_t_v;  // a, rounded to nearest even [float]
  relief_fp_from_int #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .INT_W(HEIGHT_W + 1), .LATENCY(2), .VARIANT(32'h33bf768e)
  ) u_from_int (
    .clk(clk), .ce(ce), .a(s0_depth),
    .result(s2_t_v)
  );

  // ---- stage 1: registers -------------------------------------------------------------
  reg [FloatW-1:0] s1_t;
  always @(posedge clk) begin
    if (ce) begin
      s1_t <= t;
    end
  end

  // ---- stage 2: registers -------------------------------------------------------------
  reg [FloatW-1:0] s2_t;
  always @(posedge clk) begin
    if (ce) begin
      s2_t <= s1_t;
    end
  end

  // ---- stage 2: compare ---------------------------------------------------------------
  wire s3_t_lt_t_v;  // a < b
  relief_fp_lt #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(1), .VARIANT(32'h34d3d038)) u_lt (
    .clk(clk), .ce(ce), .a(s2_t), .b(s2_t_v),
    .result(s3_t_lt_t_v)
  );
  wire s3_is_below;  // a < b
  relief_fp_lt #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(1), .VARIANT(32'h34d3d038)) u_below (
    .clk(clk), .ce(ce), .a(s2_t_v), .b(s2_t),
    .result(s3_is_below)
  );

  // ---- stage 3: registers -------------------------------------------------------------
  reg [FloatW-1:0] s3_t_v;
  reg [FloatW-1:0] s3_t;
  always @(posedge clk) begin
    if (ce) begin
      s3_t_v <= s2_t_v;
      s3_t   <= s2_t;
    end
  end

  // ---- stage 3: compare ---------------------------------------------------------------
  wire [FloatW-1:0] s3_max_parameter = s3_t_lt_t_v ? s3_t_v : s3_t;

  // ---- stage 4: registers -------------------------------------------------------------
  reg [FloatW-1:0] s4_max_parameter;
  reg              s4_is_below;
  always @(posedge clk) begin
    if (ce) begin
      s4_max_parameter <= s3_max_parameter;
      s4_is_below      <= s3_is_below;
    end
  end

  assign m = s4_max_parameter;
  assign below = s4_is_below;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
