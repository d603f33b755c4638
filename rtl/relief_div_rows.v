// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_div_rows: rows of restoring division: compare, subtract, double; one quotient bit each
// Emitted    by reliefrtl as its unit div_rows; do not edit
// Latency    none, combinational
// Note       rem_in must be less than twice div.
`default_nettype none
module relief_div_rows #(
  parameter integer W    = 17,  // bits of the divisor
  parameter integer ROWS = 19   // quotient bits
) (
  input  wire [W:0]      rem_in,   // dividend, or the remainder that the rows before left [bits]
  input  wire [W-1:0]    div,      // divisor [bits]
  output wire [W:0]      rem_out,  // remainder, doubled once a row [bits]
  output wire [ROWS-1:0] quot      // quotient bits, the first on top [bits]
);

  // Parameter checks: an illegal value ends elaboration at a missing module, whose name is the rule.
  generate
    if (W < 2) begin : gen_illegal_0 W_must_be_at_least_2 u_illegal (); end
    if (W > 62) begin : gen_illegal_1 W_must_be_at_most_62 u_illegal (); end
    if (ROWS < 1) begin : gen_illegal_2 ROWS_must_be_at_least_1 u_illegal (); end
    if (ROWS > 64) begin : gen_illegal_3 ROWS_must_be_at_most_64 u_illegal (); end
  endgenerate

  // Restoring division, one quotient bit per row: subtract if the divisor fits, then shift left.
  genvar r;
  generate
    for (r = 0; r < ROWS; r = r + 1) begin : gen_row
      wire [W:0]   here;
      wire [W+1:0] diff = {1'b0, here} - {2'b00, div};
      wire         fits = ~diff[W+1];
      wire [W:0]   next = {fits ? diff[W-1:0] : here[W-1:0], 1'b0};
      if (r == 0) begin : gen_first
        assign here = rem_in;
      end else begin : gen_later
        assign here = gen_row[r-1].next;
      end
      assign quot[ROWS-1-r] = fits;
      // verilator lint_off UNUSED
      wire unused_top = &{1'b0, diff[W]};
      // verilator lint_on UNUSED
    end
  endgenerate
  assign rem_out = gen_row[ROWS-1].next;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
