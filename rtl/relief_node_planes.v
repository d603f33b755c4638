// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_node_planes: extent of a node along one axis, and the plane by which the ray leaves
// Emitted    by reliefrtl as its unit node_planes; do not edit
// Latency    none, combinational
`default_nettype none
module relief_node_planes #(
  parameter integer LEVELS  = 8,   // the map has 2^LEVELS x 2^LEVELS texels
  parameter integer IDX_W   = 14,  // bits of a signed, unwrapped texel coordinate
  parameter integer LATENCY = 0,   // clocks it was generated for; checked
  parameter integer VARIANT = 32'h2afa0fb3  // digest of what it was generated for; checked
) (
  input  wire [$clog2(LEVELS+1)-1:0] level,   // 0 .. LEVELS [levels]
  input  wire [IDX_W-1:0]            x,       // any texel of the node [texels]
  input  wire                        neg,     // the ray runs toward smaller coordinates
  // least texel that a descent may enter: none that the ray has passed [texels]
  output wire [IDX_W-1:0]            low,
  // greatest texel that a descent may enter: none that the ray has passed [texels]
  output wire [IDX_W-1:0]            high,
  output wire [IDX_W-1:0]            plane,   // coordinate of the exit plane [texels]
  output wire [IDX_W-1:0]            beyond,  // the first texel beyond the exit plane [texels]
  output wire                        even     // the plane also bounds the parent node
);

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (LEVELS < 2) begin : gen_illegal_0 LEVELS_must_be_at_least_2 u_illegal (); end
    if (LEVELS > 12) begin : gen_illegal_1 LEVELS_must_be_at_most_12 u_illegal (); end
    if (LEVELS + 2 > IDX_W) begin : gen_illegal_2
      LEVELS_plus_2_must_be_at_most_IDX_W u_illegal ();
    end
    if (IDX_W > 24) begin : gen_illegal_3 IDX_W_must_be_at_most_24 u_illegal (); end
    if (LATENCY != 0) begin : gen_other_latency
      relief_node_planes_has_LATENCY_0_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h2afa0fb3) begin : gen_other_variant
      relief_node_planes_has_VARIANT_2afa0fb3_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  wire [IDX_W-1:0] keep = {IDX_W{1'b1}} << level;
  wire [IDX_W-1:0] first = x & keep;
  wire [IDX_W-1:0] last = x | ~keep;
  wire [IDX_W-1:0] side_length = keep & ~{keep[IDX_W-2:0], 1'b0};
  wire             is_odd = |(first & side_length);
  wire [IDX_W-1:0] side = neg ? first : last;
  wire [IDX_W-1:0] exit_plane = side + {{(IDX_W - 1){1'b0}}, ~neg};
  wire [IDX_W-1:0] next = neg ? (first - {{(IDX_W - 1){1'b0}}, 1'b1}) : exit_plane;

  assign low = neg ? first : x;
  assign high = neg ? x : last;
  assign plane = exit_plane;
  assign beyond = next;
  assign even = is_odd ^ neg;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
