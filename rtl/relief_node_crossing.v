// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_node_crossing: node crossing test: hit inside the node, or exit plane and parameter
// Emitted    by reliefrtl as its unit node_crossing; do not edit
// Chosen     rounding nearest-even, subnormals flush, specials ieee
// Latency    2 clocks
// Throughput one result per clock
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (every NaN
//            result has the same bits); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_node_crossing #(
  parameter integer EXP_W   = 7,   // exponent bits
  parameter integer MAN_W   = 16,  // fraction bits, the hidden one not counted
  parameter integer LATENCY = 2,   // clocks it was generated for; checked
  parameter integer VARIANT = 32'h243bf875  // digest of what it was generated for; checked
) (
  input  wire                 clk,        // rising edge
  input  wire                 ce,         // clock enable: registers hold while 0
  input  wire [EXP_W+MAN_W:0] t,          // parameter so far [float, height codes]
  // parameter at which the node's height is met [float, height codes]
  input  wire [EXP_W+MAN_W:0] m,
  input  wire [EXP_W+MAN_W:0] t_x,        // parameter of the x exit plane [float, height codes]
  input  wire [EXP_W+MAN_W:0] t_y,        // parameter of the y exit plane [float, height codes]
  output wire                 is_inside,  // the height is met before the ray leaves
  output wire                 x_first,    // the x plane comes first, or both at once
  // parameter after a crossing: that of the exit plane, at least t [float, height codes]
  output wire [EXP_W+MAN_W:0] t_next
);
  localparam integer FloatW = EXP_W + MAN_W + 1;  // bits of a float: sign, exponent, fraction

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (EXP_W < 2) begin : gen_illegal_0 EXP_W_must_be_at_least_2 u_illegal (); end
    if (EXP_W > 11) begin : gen_illegal_1 EXP_W_must_be_at_most_11 u_illegal (); end
    if (MAN_W < 2) begin : gen_illegal_2 MAN_W_must_be_at_least_2 u_illegal (); end
    if (MAN_W > 28) begin : gen_illegal_3 MAN_W_must_be_at_most_28 u_illegal (); end
    if (LATENCY != 2) begin : gen_other_latency
      relief_node_crossing_has_LATENCY_2_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h243bf875) begin : gen_other_variant
      relief_node_crossing_has_VARIANT_243bf875_nearest_even_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 0: compare ---------------------------------------------------------------
  // All five comparisons at once; the selects follow.
  wire s1_m_lt_x;  // a < b
  relief_fp_lt #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(1), .VARIANT(32'h34d3d038)) u_m_tx (
    .clk(clk), .ce(ce), .a(m), .b(t_x),
    .result(s1_m_lt_x)
  );
  wire s1_m_lt_y;  // a < b
  relief_fp_lt #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(1), .VARIANT(32'h34d3d038)) u_m_ty (
    .clk(clk), .ce(ce), .a(m), .b(t_y),
    .result(s1_m_lt_y)
  );
  wire s1_y_lt_x;  // a < b
  relief_fp_lt #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(1), .VARIANT(32'h34d3d038)) u_ty_tx (
    .clk(clk), .ce(ce), .a(t_y), .b(t_x),
    .result(s1_y_lt_x)
  );
  wire s1_t_lt_x;  // a < b
  relief_fp_lt #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(1), .VARIANT(32'h34d3d038)) u_t_tx (
    .clk(clk), .ce(ce), .a(t), .b(t_x),
    .result(s1_t_lt_x)
  );
  wire s1_t_lt_y;  // a < b
  relief_fp_lt #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(1), .VARIANT(32'h34d3d038)) u_t_ty (
    .clk(clk), .ce(ce), .a(t), .b(t_y),
    .result(s1_t_lt_y)
  );

  // ---- stage 1: registers -------------------------------------------------------------
  reg [FloatW-1:0] s1_t_y;
  reg [FloatW-1:0] s1_t_x;
  reg [FloatW-1:0] s1_t;
  always @(posedge clk) begin
    if (ce) begin
      s1_t_y <= t_y;
      s1_t_x <= t_x;
      s1_t   <= t;
    end
  end

  // ---- stage 1: select ----------------------------------------------------------------
  wire [FloatW-1:0] s1_t_exit = s1_y_lt_x ? s1_t_y : s1_t_x;
  wire              s1_t_advances = s1_y_lt_x ? s1_t_lt_y : s1_t_lt_x;
  wire [FloatW-1:0] s1_t_after = s1_t_advances ? s1_t_exit : s1_t;
  wire              s1_in_both = s1_m_lt_x & s1_m_lt_y;
  wire              s1_x_exits_first = ~s1_y_lt_x;

  // ---- stage 2: registers -------------------------------------------------------------
  reg              s2_in_both;
  reg              s2_x_exits_first;
  reg [FloatW-1:0] s2_t_after;
  always @(posedge clk) begin
    if (ce) begin
      s2_in_both       <= s1_in_both;
      s2_x_exits_first <= s1_x_exits_first;
      s2_t_after       <= s1_t_after;
    end
  end

  assign is_inside = s2_in_both;
  assign x_first = s2_x_exits_first;
  assign t_next = s2_t_after;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
