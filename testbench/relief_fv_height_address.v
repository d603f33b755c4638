// SPDX-License-Identifier: MIT OR Apache-2.0
// Proof harness: inside the memory, and no two nodes share a word.
`default_nettype none
module relief_fv_height_address;
  localparam integer LEVELS = 8;
  localparam [63:0] DEPTH = ((64'd4 << (2 * LEVELS)) - 64'd1) / 64'd3;
  (* anyconst *) wire [3:0] p_level;
  (* anyconst *) wire [7:0] p_i;
  (* anyconst *) wire [7:0] p_j;
  wire [16:0] p_address;
  relief_height_address #(.LEVELS(8), .LATENCY(0), .VARIANT(32'h23add022)) p_dut (
    .level(p_level),
    .i(p_i),
    .j(p_j),
    .address(p_address)
  );
  (* anyconst *) wire [3:0] q_level;
  (* anyconst *) wire [7:0] q_i;
  (* anyconst *) wire [7:0] q_j;
  wire [16:0] q_address;
  relief_height_address #(.LEVELS(8), .LATENCY(0), .VARIANT(32'h23add022)) q_dut (
    .level(q_level),
    .i(q_i),
    .j(q_j),
    .address(q_address)
  );
  wire same = p_level == q_level && (p_i >> p_level) == (q_i >> q_level) && (p_j >> p_level) == (q_j >> q_level);
  always @* begin
    assume (p_level <= LEVELS && q_level <= LEVELS);
    assert (p_address < DEPTH);
    assert ((p_address == q_address) == same);
    if (p_level == 0) assert (p_address < (64'd1 << (2 * LEVELS)));
    if (p_level == LEVELS) assert (p_address == DEPTH - 1);
  end
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
