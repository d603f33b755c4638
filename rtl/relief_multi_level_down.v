// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_multi_level_down: level and child of a descent: 2 levels until the first crossing, then
//                          one
// Emitted    by reliefrtl as its unit multi_level_down; do not edit
// Chosen     levels_down 2
// Latency    none, combinational
`default_nettype none
module relief_multi_level_down #(
  parameter integer LEVELS  = 8,   // the map has 2^LEVELS x 2^LEVELS texels
  parameter integer IDX_W   = 14,  // bits of a signed, unwrapped texel coordinate
  parameter integer LATENCY = 0,   // clocks it was generated for; checked
  parameter integer VARIANT = 32'h44b45e20  // digest of what it was generated for; checked
) (
  // 1 .. LEVELS (the result is not used at 0) [levels]
  input  wire [$clog2(LEVELS+1)-1:0] level,
  input  wire                        crossed,     // the ray has crossed a node boundary already
  // least texel of the node that the ray has not passed [texels]
  input  wire [IDX_W-1:0]            x_low,
  // greatest texel of the node that the ray has not passed [texels]
  input  wire [IDX_W-1:0]            x_high,
  input  wire [IDX_W-1:0]            x_hit,       // predicted hit [texels]
  // least texel of the node that the ray has not passed [texels]
  input  wire [IDX_W-1:0]            y_low,
  // greatest texel of the node that the ray has not passed [texels]
  input  wire [IDX_W-1:0]            y_high,
  input  wire [IDX_W-1:0]            y_hit,       // predicted hit [texels]
  output wire [$clog2(LEVELS+1)-1:0] level_down,  // level after the descent [levels]
  // predicted hit, kept between low and high [texels]
  output wire [IDX_W-1:0]            x_down,
  // predicted hit, kept between low and high [texels]
  output wire [IDX_W-1:0]            y_down
);
  localparam integer LevelW = $clog2(LEVELS + 1);  // bits of a level

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (LEVELS < 2) begin : gen_illegal_0 LEVELS_must_be_at_least_2 u_illegal (); end
    if (LEVELS > 12) begin : gen_illegal_1 LEVELS_must_be_at_most_12 u_illegal (); end
    if (LEVELS + 2 > IDX_W) begin : gen_illegal_2
      LEVELS_plus_2_must_be_at_most_IDX_W u_illegal ();
    end
    if (IDX_W > 24) begin : gen_illegal_3 IDX_W_must_be_at_most_24 u_illegal (); end
    if (LATENCY != 0) begin : gen_other_latency
      relief_multi_level_down_has_LATENCY_0_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h44b45e20) begin : gen_other_variant
      relief_multi_level_down_has_VARIANT_44b45e20_levels_down_2_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  wire              jump = ~crossed & ~({3'd0, level} < {{(LevelW + 1){1'b0}}, 2'd2});
  wire [LevelW+2:0] jumped = {3'd0, level} - {{(LevelW + 1){1'b0}}, 2'd2};
  wire [LevelW-1:0] next_level = jump ? jumped[LevelW-1:0] : (level - {{(LevelW - 1){1'b0}}, 1'b1});
  wire              x_is_below = $signed(x_hit) < $signed(x_low);
  wire              x_is_above = $signed(x_high) < $signed(x_hit);
  wire [IDX_W-1:0]  x_child = x_is_below ? x_low : (x_is_above ? x_high : x_hit);
  wire              y_is_below = $signed(y_hit) < $signed(y_low);
  wire              y_is_above = $signed(y_high) < $signed(y_hit);
  wire [IDX_W-1:0]  y_child = y_is_below ? y_low : (y_is_above ? y_high : y_hit);

  // Nets and bits that nothing reads, at some parameter values or at all, gathered so that the
  // lint for unused bits stays on for all others.
  // verilator lint_off UNUSED
  wire unused_0 = &{1'b0, jumped[LevelW+2:LevelW]};
  // verilator lint_on UNUSED

  assign level_down = next_level;
  assign x_down = x_child;
  assign y_down = y_child;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
