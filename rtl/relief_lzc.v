// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_lzc: number of leading zeros of a word; W when the word is zero
// Emitted    by reliefrtl as its unit lzc; do not edit
// Latency    none, combinational
`default_nettype none
module relief_lzc #(
  parameter integer W = 8   // bits of the word
) (
  input  wire [W-1:0]           bits,   // the word [bits]
  output wire [$clog2(W+1)-1:0] count   // zeros above the topmost 1 [bits]
);
  localparam integer CountW = $clog2(W + 1);  // bits of a count of zeros, 0 to W

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (W < 1) begin : gen_illegal_0 W_must_be_at_least_1 u_illegal (); end
    if (W > 64) begin : gen_illegal_1 W_must_be_at_most_64 u_illegal (); end
  endgenerate

  // Padded with ones below the last bit, so that the count of an all-zero word is W.
  localparam integer PadW = 1 << CountW;  // W, with ones below up to a power of two
  wire [PadW-1:0] padded = {bits, {(PadW - W){1'b1}}};

  // Binary tree. Level s covers groups of 2 << s bits: whether a group is all zeros, and else its
  // leading-zero count, which is that of the upper half, or 2^s plus that of the lower half. The
  // most significant bits of the count have the shortest path.
  genvar s, g;
  generate
    for (s = 0; s < CountW; s = s + 1) begin : gen_level
      localparam integer Groups = PadW >> (s + 1);  // groups of 2^(s+1) bits
      wire [Groups-1:0]         empty;
      wire [Groups*(s+1)-1:0]   lzc;
      for (g = 0; g < Groups; g = g + 1) begin : gen_group
        if (s == 0) begin : gen_first
          assign empty[g] = ~(padded[2*g+1] | padded[2*g]);
          assign lzc[g]   = ~padded[2*g+1];
        end else begin : gen_later
          wire         high_empty = gen_level[s-1].empty[2*g+1];
          wire [s-1:0] high_lzc = gen_level[s-1].lzc[(2*g+1)*s+:s];
          wire [s-1:0] low_lzc = gen_level[s-1].lzc[2*g*s+:s];
          assign empty[g]             = high_empty & gen_level[s-1].empty[2*g];
          assign lzc[g*(s+1)+:(s+1)] = {high_empty, high_empty ? low_lzc : high_lzc};
        end
      end
    end
  endgenerate
  assign count = gen_level[CountW-1].lzc;

  // verilator lint_off UNUSED
  wire unused_last = &{1'b0, gen_level[CountW-1].empty};
  // verilator lint_on UNUSED
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
