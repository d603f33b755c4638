// SPDX-License-Identifier: MIT OR Apache-2.0
// Proof harness: the lowest level whose node holds both ends of the ray.
`default_nettype none
module relief_fv_start_level;
  localparam integer LEVELS = 8;
  (* anyconst *) wire [13:0] x;
  (* anyconst *) wire [13:0] y;
  (* anyconst *) wire [13:0] x_end;
  (* anyconst *) wire [13:0] y_end;
  wire [3:0] level;
  relief_start_level #(.LEVELS(8), .IDX_W(14), .LATENCY(0), .VARIANT(32'h4c35fe41)) dut (
    .x(x),
    .y(y),
    .x_end(x_end),
    .y_end(y_end),
    .level(level)
  );
  // At level n both ends lie in one node.
  wire [LEVELS:0] together;
  genvar n;
  generate
    for (n = 0; n <= LEVELS; n = n + 1) begin : gen_level
      assign together[n] = ($signed(x) >>> n) == ($signed(x_end) >>> n) && ($signed(y) >>> n) == ($signed(y_end) >>> n);
    end
  endgenerate
  always @* begin
    assert (level <= LEVELS);
    assert (level == LEVELS || together[level]);
    if (level != 0) assert (!together[level-1]);
  end
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
