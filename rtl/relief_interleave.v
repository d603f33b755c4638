// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_interleave: two words in Morton order: a in the even bits, b in the odd ones
// Emitted    by reliefrtl as its unit interleave; do not edit
// Latency    none, combinational
`default_nettype none
module relief_interleave #(
  parameter integer W = 9   // bits of each word
) (
  input  wire [W-1:0]   a,       // word for the even bits [bits]
  input  wire [W-1:0]   b,       // word for the odd bits [bits]
  output wire [2*W-1:0] result   // b[W-1] a[W-1] .. b[0] a[0] [bits]
);

  // Parameter checks: an illegal value ends elaboration at a missing module, whose name is the rule.
  generate
    if (W < 1) begin : gen_illegal_0 W_must_be_at_least_1 u_illegal (); end
    if (W > 32) begin : gen_illegal_1 W_must_be_at_most_32 u_illegal (); end
  endgenerate

  genvar i;
  generate
    for (i = 0; i < W; i = i + 1) begin : gen_bit
      assign result[2*i]   = a[i];
      assign result[2*i+1] = b[i];
    end
  endgenerate
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
