// SPDX-License-Identifier: MIT OR Apache-2.0
// Proof harness: the rule, and never above the root (selective).
`default_nettype none
module relief_fv_level_up;
  localparam integer LEVELS = 8;
  (* anyconst *) wire [3:0] level;
  (* anyconst *) wire [0:0] even;
  (* anyconst *) wire [13:0] x_at;
  (* anyconst *) wire [13:0] x_hit;
  (* anyconst *) wire [13:0] y_at;
  (* anyconst *) wire [13:0] y_hit;
  wire [0:0] up;
  relief_level_up #(.LEVELS(8), .IDX_W(14), .LATENCY(0), .VARIANT(32'h63e9f1ef)) dut (
    .level(level),
    .even(even),
    .x_at(x_at),
    .x_hit(x_hit),
    .y_at(y_at),
    .y_hit(y_hit),
    .up(up)
  );
  localparam integer IDX_W = 14;
  wire signed [IDX_W:0] dx = ($signed(x_hit) >>> level) - ($signed(x_at) >>> level);
  wire signed [IDX_W:0] dy = ($signed(y_hit) >>> level) - ($signed(y_at) >>> level);
  wire [IDX_W:0] ax = dx < 0 ? -dx : dx;
  wire [IDX_W:0] ay = dy < 0 ? -dy : dy;
  wire want = even && !((ax > ay ? ax : ay) == 1);
  always @* begin
    assume (level <= LEVELS);
    // A coordinate keeps a bit of headroom: IDX_W holds any sum of an entry point and a travel.
    assume (x_at[IDX_W-1] == x_at[IDX_W-2] && x_hit[IDX_W-1] == x_hit[IDX_W-2]);
    assume (y_at[IDX_W-1] == y_at[IDX_W-2] && y_hit[IDX_W-1] == y_hit[IDX_W-2]);
    assert (up == (want && level != LEVELS));
  end
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
