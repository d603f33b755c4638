// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_level_decision: hit, descend or cross: the next node, level and parameter
// Emitted    by reliefrtl as its unit level_decision; do not edit
// Chosen     rounding nearest-even, subnormals flush, specials ieee
// Latency    none, combinational
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (every NaN
//            result has the same bits); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_level_decision #(
  parameter integer EXP_W   = 7,   // exponent bits
  parameter integer MAN_W   = 16,  // fraction bits, the hidden one not counted
  parameter integer LEVELS  = 8,   // the map has 2^LEVELS x 2^LEVELS texels
  parameter integer IDX_W   = 14,  // bits of a signed, unwrapped texel coordinate
  parameter integer LATENCY = 0,   // clocks it was generated for; checked
  parameter integer VARIANT = 32'h4ae3ce84  // digest of what it was generated for; checked
) (
  input  wire                        is_inside,   // the node's height is met before the ray leaves
  input  wire                        x_first,     // it leaves by the u plane
  input  wire                        up,          // a crossing goes one level up
  input  wire [$clog2(LEVELS+1)-1:0] level,       // level of this node [levels]
  input  wire [$clog2(LEVELS+1)-1:0] level_down,  // level of a descent [levels]
  // parameter of a hit or a descent [float, height codes]
  input  wire [EXP_W+MAN_W:0]        m,
  input  wire [EXP_W+MAN_W:0]        t_next,      // parameter of a crossing [float, height codes]
  input  wire [IDX_W-1:0]            x_at,        // a texel of this node [texels]
  input  wire [IDX_W-1:0]            x_down,      // texel of the child [texels]
  input  wire [IDX_W-1:0]            x_beyond,    // first texel beyond the exit plane [texels]
  input  wire [IDX_W-1:0]            y_at,        // a texel of this node [texels]
  input  wire [IDX_W-1:0]            y_down,      // texel of the child [texels]
  input  wire [IDX_W-1:0]            y_beyond,    // first texel beyond the exit plane [texels]
  output wire                        hit,         // the ray ends here
  output wire                        crosses,     // the ray goes to the neighbour
  output wire [$clog2(LEVELS+1)-1:0] level_next,  // level of the next iteration [levels]
  output wire [IDX_W-1:0]            x_next,      // texel of the next node [texels]
  output wire [IDX_W-1:0]            y_next,      // texel of the next node [texels]
  // parameter of the next iteration, or of the hit [float, height codes]
  output wire [EXP_W+MAN_W:0]        t_out
);
  localparam integer LevelW = $clog2(LEVELS + 1);  // bits of a level

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (EXP_W < 2) begin : gen_illegal_0 EXP_W_must_be_at_least_2 u_illegal (); end
    if (EXP_W > 11) begin : gen_illegal_1 EXP_W_must_be_at_most_11 u_illegal (); end
    if (MAN_W < 2) begin : gen_illegal_2 MAN_W_must_be_at_least_2 u_illegal (); end
    if (MAN_W > 28) begin : gen_illegal_3 MAN_W_must_be_at_most_28 u_illegal (); end
    if (LEVELS < 2) begin : gen_illegal_4 LEVELS_must_be_at_least_2 u_illegal (); end
    if (LEVELS > 12) begin : gen_illegal_5 LEVELS_must_be_at_most_12 u_illegal (); end
    if (LEVELS + 2 > IDX_W) begin : gen_illegal_6
      LEVELS_plus_2_must_be_at_most_IDX_W u_illegal ();
    end
    if (IDX_W > 24) begin : gen_illegal_7 IDX_W_must_be_at_most_24 u_illegal (); end
    if (LATENCY != 0) begin : gen_other_latency
      relief_level_decision_has_LATENCY_0_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h4ae3ce84) begin : gen_other_variant
      relief_level_decision_has_VARIANT_4ae3ce84_nearest_even_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  wire              is_hit = is_inside & ~(|level);
  wire [LevelW-1:0] risen = level + {{(LevelW - 1){1'b0}}, up};
  wire [LevelW-1:0] level_chosen = is_inside ? (is_hit ? level : level_down) : risen;
  wire              keep_x = ~x_first;
  wire [IDX_W-1:0]  x_chosen = is_inside ? (is_hit ? x_at : x_down) : (keep_x ? x_at : x_beyond);
  wire [IDX_W-1:0]  y_chosen = is_inside ? (is_hit ? y_at : y_down) : (x_first ? y_at : y_beyond);

  assign hit = is_hit;
  assign crosses = ~is_inside;
  assign level_next = level_chosen;
  assign x_next = x_chosen;
  assign y_next = y_chosen;
  assign t_out = is_inside ? m : t_next;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
