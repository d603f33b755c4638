// SPDX-License-Identifier: MIT OR Apache-2.0
// Proof harness: extent, exit plane and the texel beyond it are those of the node.
`default_nettype none
module relief_fv_node_planes;
  localparam integer LEVELS = 8;
  localparam integer IDX_W = 14;
  (* anyconst *) wire [3:0] level;
  (* anyconst *) wire [13:0] x;
  (* anyconst *) wire [0:0] neg;
  wire [13:0] low;
  wire [13:0] high;
  wire [13:0] plane;
  wire [13:0] beyond;
  wire [0:0] even;
  relief_node_planes #(.LEVELS(8), .IDX_W(14), .LATENCY(0), .VARIANT(32'h2afa0fb3)) dut (
    .level(level),
    .x(x),
    .neg(neg),
    .low(low),
    .high(high),
    .plane(plane),
    .beyond(beyond),
    .even(even)
  );
  // One bit more, so that nothing wraps here.
  wire signed [IDX_W+1:0] at = $signed(x);
  wire signed [IDX_W+1:0] size = 1 << level;
  wire signed [IDX_W+1:0] first = (at >>> level) <<< level;
  wire signed [IDX_W+1:0] exit = neg ? first : first + size;
  wire signed [IDX_W+1:0] nodes = exit >>> level;
  always @* begin
    assume (level <= LEVELS);
    assume (at + size < (1 <<< (IDX_W - 1)) && at - size >= -(1 <<< (IDX_W - 1)));
    begin
      assert ($signed(plane) == exit);
      assert ($signed(beyond) == (neg ? first - 1 : first + size));
      assert ($signed(low) == (neg ? first : at));
      assert ($signed(high) == (neg ? at : first + size - 1));
      assert (even == !nodes[0]);
    end
  end
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
