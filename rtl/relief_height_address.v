// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_height_address: address of a node's height in the pyramid memory
// Emitted    by reliefrtl as its unit height_address; do not edit
// Latency    none, combinational
`default_nettype none
module relief_height_address #(
  parameter integer LEVELS  = 8,  // the map has 2^LEVELS x 2^LEVELS texels
  parameter integer LATENCY = 0,  // clocks it was generated for; checked
  parameter integer VARIANT = 32'h23add022  // digest of what it was generated for; checked
) (
  input  wire [$clog2(LEVELS+1)-1:0] level,    // 0 .. LEVELS [levels]
  input  wire [LEVELS-1:0]           i,        // u of a texel in the node [texels]
  input  wire [LEVELS-1:0]           j,        // v of a texel in the node [texels]
  output wire [2*LEVELS:0]           address   // level 0 first, the root last [words]
);
  localparam integer LevelW = $clog2(LEVELS + 1);  // bits of a level
  localparam integer Root = LEVELS;                // the root's level

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (LEVELS < 2) begin : gen_illegal_0 LEVELS_must_be_at_least_2 u_illegal (); end
    if (LEVELS > 12) begin : gen_illegal_1 LEVELS_must_be_at_most_12 u_illegal (); end
    if (LATENCY != 0) begin : gen_other_latency
      relief_height_address_has_LATENCY_0_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h23add022) begin : gen_other_variant
      relief_height_address_has_VARIANT_23add022_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  wire [LevelW-1:0]   index_bits = Root[LevelW-1:0] - level;
  wire [LEVELS:0]     base = {{LEVELS{1'b1}} << index_bits, 1'b0};
  wire [LEVELS:0]     even = {1'b0, i >> level} | base;
  wire [LEVELS:0]     odd = {1'b0, j >> level};
  wire [2*LEVELS+1:0] morton;  // b[W-1] a[W-1] .. b[0] a[0] [bits]
  relief_interleave #(.W(LEVELS + 1)) u_morton (.a(even), .b(odd), .result(morton));

  // Nets and bits that nothing reads, at some parameter values or at all, gathered so that the
  // lint for unused bits stays on for all others.
  // verilator lint_off UNUSED
  wire unused_0 = &{1'b0, morton[2*LEVELS+1]};
  // verilator lint_on UNUSED

  assign address = morton[2*LEVELS:0];
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
