// SPDX-License-Identifier: MIT OR Apache-2.0
// Proof harness: a crossing moves the integer index forward, a descent never back: no ray visits a texel again.
//
// The units of an iteration that handle indices, put together as in traverse. What the arithmetic says (inside or not, which plane comes
// first, the predicted hit, the level-up rule) is left open, so the claim holds whatever it says.
`default_nettype none
module relief_fv_progress;
  localparam integer LEVELS = 8;
  localparam integer IDX_W = 14;
  (* anyconst *) wire [3:0] u_level;
  (* anyconst *) wire [13:0] u_x;
  (* anyconst *) wire [0:0] u_neg;
  wire [13:0] u_low;
  wire [13:0] u_high;
  wire [13:0] u_plane;
  wire [13:0] u_beyond;
  wire [0:0] u_even;
  relief_node_planes #(.LEVELS(8), .IDX_W(14), .LATENCY(0), .VARIANT(32'h2afa0fb3)) u_dut (
    .level(u_level),
    .x(u_x),
    .neg(u_neg),
    .low(u_low),
    .high(u_high),
    .plane(u_plane),
    .beyond(u_beyond),
    .even(u_even)
  );
  wire [3:0] v_level;
  (* anyconst *) wire [13:0] v_x;
  (* anyconst *) wire [0:0] v_neg;
  wire [13:0] v_low;
  wire [13:0] v_high;
  wire [13:0] v_plane;
  wire [13:0] v_beyond;
  wire [0:0] v_even;
  relief_node_planes #(.LEVELS(8), .IDX_W(14), .LATENCY(0), .VARIANT(32'h2afa0fb3)) v_dut (
    .level(v_level),
    .x(v_x),
    .neg(v_neg),
    .low(v_low),
    .high(v_high),
    .plane(v_plane),
    .beyond(v_beyond),
    .even(v_even)
  );
  wire [3:0] d_level;
  (* anyconst *) wire [0:0] d_crossed;
  wire [13:0] d_x_low;
  wire [13:0] d_x_high;
  (* anyconst *) wire [13:0] d_x_hit;
  wire [13:0] d_y_low;
  wire [13:0] d_y_high;
  (* anyconst *) wire [13:0] d_y_hit;
  wire [3:0] d_level_down;
  wire [13:0] d_x_down;
  wire [13:0] d_y_down;
  relief_multi_level_down #(.LEVELS(8), .IDX_W(14), .LATENCY(0), .VARIANT(32'h44b45e20)) d_dut (
    .level(d_level),
    .crossed(d_crossed),
    .x_low(d_x_low),
    .x_high(d_x_high),
    .x_hit(d_x_hit),
    .y_low(d_y_low),
    .y_high(d_y_high),
    .y_hit(d_y_hit),
    .level_down(d_level_down),
    .x_down(d_x_down),
    .y_down(d_y_down)
  );
  (* anyconst *) wire [0:0] k_is_inside;
  (* anyconst *) wire [0:0] k_x_first;
  (* anyconst *) wire [0:0] k_up;
  wire [3:0] k_level;
  wire [3:0] k_level_down;
  (* anyconst *) wire [23:0] k_m;
  (* anyconst *) wire [23:0] k_t_next;
  wire [13:0] k_x_at;
  wire [13:0] k_x_down;
  wire [13:0] k_x_beyond;
  wire [13:0] k_y_at;
  wire [13:0] k_y_down;
  wire [13:0] k_y_beyond;
  wire [0:0] k_hit;
  wire [0:0] k_crosses;
  wire [3:0] k_level_next;
  wire [13:0] k_x_next;
  wire [13:0] k_y_next;
  wire [23:0] k_t_out;
  relief_level_decision #(.EXP_W(7), .MAN_W(16), .LEVELS(8), .IDX_W(14), .LATENCY(0), .VARIANT(32'h4ae3ce84)) k_dut (
    .is_inside(k_is_inside),
    .x_first(k_x_first),
    .up(k_up),
    .level(k_level),
    .level_down(k_level_down),
    .m(k_m),
    .t_next(k_t_next),
    .x_at(k_x_at),
    .x_down(k_x_down),
    .x_beyond(k_x_beyond),
    .y_at(k_y_at),
    .y_down(k_y_down),
    .y_beyond(k_y_beyond),
    .hit(k_hit),
    .crosses(k_crosses),
    .level_next(k_level_next),
    .x_next(k_x_next),
    .y_next(k_y_next),
    .t_out(k_t_out)
  );
  assign v_level = u_level;
  assign k_level = u_level;
  // Where a trim reads a smaller node, this is that node's level, and everything but a descent goes on from the larger one.
  assign d_level = k_level;
  assign k_level_down = d_level_down;
  assign {d_x_low, d_x_high, d_y_low, d_y_high} = {u_low, u_high, v_low, v_high};
  assign {k_x_at, k_x_down, k_x_beyond} = {u_x, d_x_down, u_beyond};
  assign {k_y_at, k_y_down, k_y_beyond} = {v_x, d_y_down, v_beyond};

  // Indices along the ray: they only grow. Not so near the end of their range that they wrap.
  localparam integer FAR = (1 << (IDX_W - 1)) - (1 << LEVELS);
  wire signed [IDX_W:0] x_old = u_neg ? -$signed({u_x[IDX_W-1], u_x}) : $signed({u_x[IDX_W-1], u_x});
  wire signed [IDX_W:0] y_old = v_neg ? -$signed({v_x[IDX_W-1], v_x}) : $signed({v_x[IDX_W-1], v_x});
  wire signed [IDX_W:0] x_new = u_neg ? -$signed({k_x_next[IDX_W-1], k_x_next}) : $signed({k_x_next[IDX_W-1], k_x_next});
  wire signed [IDX_W:0] y_new = v_neg ? -$signed({k_y_next[IDX_W-1], k_y_next}) : $signed({k_y_next[IDX_W-1], k_y_next});
  wire node_left = ($signed(k_x_next) >>> u_level) != ($signed(u_x) >>> u_level)
      || ($signed(k_y_next) >>> u_level) != ($signed(v_x) >>> u_level);
  always @* begin
    assume (u_level <= LEVELS);
    assume (x_old < FAR && x_old > -FAR && y_old < FAR && y_old > -FAR);
    begin
      assert (x_new >= x_old && y_new >= y_old);
      if (k_crosses) begin
        assert (x_new > x_old || y_new > y_old);
        assert (node_left);
      end
      if (!k_crosses) assert (!node_left);
      if (!k_crosses && !k_hit) assert (k_level_next < u_level);
    end
  end
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
