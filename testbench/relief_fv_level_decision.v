// SPDX-License-Identifier: MIT OR Apache-2.0
// Proof harness: hit, descent or crossing: every output is that of the case.
`default_nettype none
module relief_fv_level_decision;
  (* anyconst *) wire [0:0] is_inside;
  (* anyconst *) wire [0:0] x_first;
  (* anyconst *) wire [0:0] up;
  (* anyconst *) wire [3:0] level;
  (* anyconst *) wire [3:0] level_down;
  (* anyconst *) wire [23:0] m;
  (* anyconst *) wire [23:0] t_next;
  (* anyconst *) wire [13:0] x_at;
  (* anyconst *) wire [13:0] x_down;
  (* anyconst *) wire [13:0] x_beyond;
  (* anyconst *) wire [13:0] y_at;
  (* anyconst *) wire [13:0] y_down;
  (* anyconst *) wire [13:0] y_beyond;
  wire [0:0] hit;
  wire [0:0] crosses;
  wire [3:0] level_next;
  wire [13:0] x_next;
  wire [13:0] y_next;
  wire [23:0] t_out;
  relief_level_decision #(.EXP_W(7), .MAN_W(16), .LEVELS(8), .IDX_W(14), .LATENCY(0), .VARIANT(32'h4ae3ce84)) dut (
    .is_inside(is_inside),
    .x_first(x_first),
    .up(up),
    .level(level),
    .level_down(level_down),
    .m(m),
    .t_next(t_next),
    .x_at(x_at),
    .x_down(x_down),
    .x_beyond(x_beyond),
    .y_at(y_at),
    .y_down(y_down),
    .y_beyond(y_beyond),
    .hit(hit),
    .crosses(crosses),
    .level_next(level_next),
    .x_next(x_next),
    .y_next(y_next),
    .t_out(t_out)
  );
  always @* begin
    assert (hit == (is_inside && level == 0));
    assert (crosses == !is_inside);
    if (hit) assert (level_next == level && x_next == x_at && y_next == y_at && t_out == m);
    if (is_inside && !hit) assert (level_next == level_down && x_next == x_down && y_next == y_down && t_out == m);
    if (crosses) begin
      assert (t_out == t_next);
      assert (x_next == (x_first ? x_beyond : x_at));
      assert (y_next == (x_first ? y_at : y_beyond));
      if (level != 8) assert (level_next == level + up);
    end
  end
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
