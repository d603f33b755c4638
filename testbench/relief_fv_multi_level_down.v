// SPDX-License-Identifier: MIT OR Apache-2.0
// Proof harness: a descent goes at least one level down, stays in its bounds, and obeys the mode.
`default_nettype none
module relief_fv_multi_level_down;
  localparam integer LEVELS = 8;
  localparam integer MANY = 2;
  (* anyconst *) wire [3:0] level;
  (* anyconst *) wire [0:0] crossed;
  (* anyconst *) wire [13:0] x_low;
  (* anyconst *) wire [13:0] x_high;
  (* anyconst *) wire [13:0] x_hit;
  (* anyconst *) wire [13:0] y_low;
  (* anyconst *) wire [13:0] y_high;
  (* anyconst *) wire [13:0] y_hit;
  wire [3:0] level_down;
  wire [13:0] x_down;
  wire [13:0] y_down;
  relief_multi_level_down #(.LEVELS(8), .IDX_W(14), .LATENCY(0), .VARIANT(32'h44b45e20)) dut (
    .level(level),
    .crossed(crossed),
    .x_low(x_low),
    .x_high(x_high),
    .x_hit(x_hit),
    .y_low(y_low),
    .y_high(y_high),
    .y_hit(y_hit),
    .level_down(level_down),
    .x_down(x_down),
    .y_down(y_down)
  );
  always @* begin
    assume (level >= 1 && level <= LEVELS);
    assume ($signed(x_low) <= $signed(x_high) && $signed(y_low) <= $signed(y_high));
    begin
      assert (level_down == level - ((!crossed && level >= MANY) ? MANY : 1));
      assert (level_down < level);
      assert ($signed(x_low) <= $signed(x_down) && $signed(x_down) <= $signed(x_high));
      assert ($signed(y_low) <= $signed(y_down) && $signed(y_down) <= $signed(y_high));
      if ($signed(x_low) <= $signed(x_hit) && $signed(x_hit) <= $signed(x_high)) assert (x_down == x_hit);
      if ($signed(y_low) <= $signed(y_hit) && $signed(y_hit) <= $signed(y_high)) assert (y_down == y_hit);
      if ($signed(x_hit) < $signed(x_low)) assert (x_down == x_low);
      if ($signed(y_hit) > $signed(y_high)) assert (y_down == y_high);
    end
  end
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
