// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_start_level: lowest level at which one node holds both ends of the ray
// Emitted    by reliefrtl as its unit start_level; do not edit
// Latency    none, combinational
`default_nettype none
module relief_start_level #(
  parameter integer LEVELS  = 8,   // the map has 2^LEVELS x 2^LEVELS texels
  parameter integer IDX_W   = 14,  // bits of a signed, unwrapped texel coordinate
  parameter integer LATENCY = 0,   // clocks it was generated for; checked
  parameter integer VARIANT = 32'h4c35fe41  // digest of what it was generated for; checked
) (
  input  wire [IDX_W-1:0]            x,      // u of the entry [texels]
  input  wire [IDX_W-1:0]            y,      // v of the entry [texels]
  input  wire [IDX_W-1:0]            x_end,  // u of the exit [texels]
  input  wire [IDX_W-1:0]            y_end,  // v of the exit [texels]
  // 0: both in one texel; LEVELS: the root (also across tiles) [levels]
  output wire [$clog2(LEVELS+1)-1:0] level
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
      relief_start_level_has_LATENCY_0_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h4c35fe41) begin : gen_other_variant
      relief_start_level_has_VARIANT_4c35fe41_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  wire [IDX_W-1:0]  differ = (x ^ x_end) | (y ^ y_end);
  wire              other_tile = |differ[IDX_W-1:LEVELS];
  wire [LEVELS-1:0] low_part = differ[LEVELS-1:0];
  wire [LevelW-1:0] lz_count;  // zeros above the topmost 1 [bits]
  relief_lzc #(.W(LEVELS)) u_lzc (.bits(low_part), .count(lz_count));
  wire [LevelW-1:0] start = other_tile ? Root[LevelW-1:0] : (Root[LevelW-1:0] - lz_count);

  assign level = start;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
