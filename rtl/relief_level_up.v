// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_level_up: level-up test: the crossing leaves the parent, and the predicted hit is no
//                  neighbour
// Emitted    by reliefrtl as its unit level_up; do not edit
// Chosen     level_up selective
// Latency    none, combinational
`default_nettype none
module relief_level_up #(
  parameter integer LEVELS  = 8,   // the map has 2^LEVELS x 2^LEVELS texels
  parameter integer IDX_W   = 14,  // bits of a signed, unwrapped texel coordinate
  parameter integer LATENCY = 0,   // clocks it was generated for; checked
  parameter integer VARIANT = 32'h63e9f1ef  // digest of what it was generated for; checked
) (
  input  wire [$clog2(LEVELS+1)-1:0] level,  // level of the crossed node [levels]
  input  wire                        even,   // the crossed plane also bounds the parent
  input  wire [IDX_W-1:0]            x_at,   // a texel of the node [texels]
  input  wire [IDX_W-1:0]            x_hit,  // predicted hit [texels]
  input  wire [IDX_W-1:0]            y_at,   // a texel of the node [texels]
  input  wire [IDX_W-1:0]            y_hit,  // predicted hit [texels]
  output wire                        up      // one level up; never at the root
);
  localparam integer LevelW = $clog2(LEVELS + 1);  // bits of a level
  localparam integer Root = LEVELS;                // the root's level

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (LEVELS < 2) begin : gen_illegal_0 LEVELS_must_be_at_least_2 u_illegal (); end
    if (LEVELS > 12) begin : gen_illegal_1 LEVELS_must_be_at_most_12 u_illegal (); end
    if (LEVELS + 2 > IDX_W) begin : gen_illegal_2
      LEVELS_plus_2_must_be_at_most_IDX_W u_illegal ();
    end
    if (IDX_W > 24) begin : gen_illegal_3 IDX_W_must_be_at_most_24 u_illegal (); end
    if (LATENCY != 0) begin : gen_other_latency
      relief_level_up_has_LATENCY_0_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h63e9f1ef) begin : gen_other_variant
      relief_level_up_has_VARIANT_63e9f1ef_selective_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  wire           below_root = ~(level == Root[LevelW-1:0]);
  wire [IDX_W:0] x_keep = {(IDX_W + 1){1'b1}} << level;
  wire [IDX_W:0] x_hit_corner = {{1{x_hit[IDX_W-1]}}, x_hit} & x_keep;
  wire [IDX_W:0] x_corner = {{1{x_at[IDX_W-1]}}, x_at} & x_keep;
  wire [IDX_W:0] x_diff = x_hit_corner - x_corner;
  wire [IDX_W:0] x_side = x_keep & ~{x_keep[IDX_W-1:0], 1'b0};
  wire           x_same = ~(|x_diff);
  wire           x_near = x_same | (x_diff == x_side) | (x_diff == x_keep);
  wire [IDX_W:0] y_keep = {(IDX_W + 1){1'b1}} << level;
  wire [IDX_W:0] y_hit_corner = {{1{y_hit[IDX_W-1]}}, y_hit} & y_keep;
  wire [IDX_W:0] y_corner = {{1{y_at[IDX_W-1]}}, y_at} & y_keep;
  wire [IDX_W:0] y_diff = y_hit_corner - y_corner;
  wire [IDX_W:0] y_side = y_keep & ~{y_keep[IDX_W-1:0], 1'b0};
  wire           y_same = ~(|y_diff);
  wire           y_near = y_same | (y_diff == y_side) | (y_diff == y_keep);
  wire           is_neighbour = x_near & y_near & ~(x_same & y_same);

  assign up = even & ~is_neighbour & below_root;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
