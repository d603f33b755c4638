// SPDX-License-Identifier: MIT OR Apache-2.0
// Proof harness: no ray is lost or duplicated, and a valid result is stable until it transfers, by induction.
//
// Rays are counted at input, output and inside. That each keeps its words is the claim of the elastic boundaries' own proofs, together with
// data and valid bits having the same delay. Which iteration finishes a ray is left open.
`default_nettype none
module relief_fv_traverse (input wire clk);
  (* anyseq *) wire rst;
  (* anyseq *) wire in_valid;
  (* anyseq *) wire out_ready;
  wire in_ready, out_valid;
  relief_traverse #(.VARIANT(32'h3b71a3f0)) dut (
    .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready), .out_valid(out_valid), .out_ready(out_ready)
  );

  // The script connects these to valid bits and registers inside.
  (* keep *) wire setup_0;
  (* keep *) wire setup_1;
  (* keep *) wire setup_2;
  (* keep *) wire setup_3;
  (* keep *) wire setup_4;
  (* keep *) wire setup_5;
  (* keep *) wire setup_6;
  (* keep *) wire setup_7;
  (* keep *) wire setup_8;
  (* keep *) wire setup_9;
  (* keep *) wire setup_10;
  (* keep *) wire setup_11;
  (* keep *) wire setup_12;
  (* keep *) wire setup_13;
  (* keep *) wire setup_14;
  (* keep *) wire setup_15;
  (* keep *) wire setup_16;
  (* keep *) wire setup_17;
  (* keep *) wire setup_18;
  (* keep *) wire setup_19;
  (* keep *) wire setup_20;
  (* keep *) wire setup_21;
  (* keep *) wire setup_22;
  (* keep *) wire loop_0;
  (* keep *) wire loop_1;
  (* keep *) wire loop_2;
  (* keep *) wire loop_3;
  (* keep *) wire loop_4;
  (* keep *) wire loop_5;
  (* keep *) wire loop_6;
  (* keep *) wire loop_7;
  (* keep *) wire loop_8;
  (* keep *) wire loop_9;
  (* keep *) wire loop_10;
  (* keep *) wire loop_11;
  (* keep *) wire loop_12;
  (* keep *) wire loop_13;
  (* keep *) wire loop_14;
  (* keep *) wire loop_15;
  (* keep *) wire loop_16;
  (* keep *) wire loop_17;
  (* keep *) wire loop_18;
  (* keep *) wire hit_0;
  (* keep *) wire hit_1;
  (* keep *) wire hit_2;
  (* keep *) wire hit_3;
  (* keep *) wire hit_4;
  (* keep *) wire hit_5;
  (* keep *) wire hit_6;
  (* keep *) wire hit_7;
  (* keep *) wire hit_8;
  (* keep *) wire retire;
  (* keep *) wire setup_ready_q, setup_valid_q, setup_out_of_reset, setup_wr_sel_q, setup_rd_sel_q;
  (* keep *) wire hit_ready_q, hit_valid_q, hit_out_of_reset, hit_wr_sel_q, hit_rd_sel_q;

  // The slot in stage 0 holds a ray: the one that recirculates, or a new one.
  wire slot_busy = (loop_0 && !retire) || setup_valid_q;
  reg started, was_stalled;
  initial {started, was_stalled} = 0;

  // Rays in a row of valid bits from stage k to its end: one two-operand sum for each k, so that no solver has to add a whole row.
  reg [7:0] from_setup_0;
  always @(posedge clk) from_setup_0 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_0 :
    from_setup_0 + {7'd0, (in_valid && in_ready)} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_0 == {7'd0, setup_0} + from_setup_1);
  reg [7:0] from_setup_1;
  always @(posedge clk) from_setup_1 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_1 :
    from_setup_1 + {7'd0, setup_0} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_1 == {7'd0, setup_1} + from_setup_2);
  reg [7:0] from_setup_2;
  always @(posedge clk) from_setup_2 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_2 :
    from_setup_2 + {7'd0, setup_1} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_2 == {7'd0, setup_2} + from_setup_3);
  reg [7:0] from_setup_3;
  always @(posedge clk) from_setup_3 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_3 :
    from_setup_3 + {7'd0, setup_2} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_3 == {7'd0, setup_3} + from_setup_4);
  reg [7:0] from_setup_4;
  always @(posedge clk) from_setup_4 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_4 :
    from_setup_4 + {7'd0, setup_3} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_4 == {7'd0, setup_4} + from_setup_5);
  reg [7:0] from_setup_5;
  always @(posedge clk) from_setup_5 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_5 :
    from_setup_5 + {7'd0, setup_4} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_5 == {7'd0, setup_5} + from_setup_6);
  reg [7:0] from_setup_6;
  always @(posedge clk) from_setup_6 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_6 :
    from_setup_6 + {7'd0, setup_5} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_6 == {7'd0, setup_6} + from_setup_7);
  reg [7:0] from_setup_7;
  always @(posedge clk) from_setup_7 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_7 :
    from_setup_7 + {7'd0, setup_6} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_7 == {7'd0, setup_7} + from_setup_8);
  reg [7:0] from_setup_8;
  always @(posedge clk) from_setup_8 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_8 :
    from_setup_8 + {7'd0, setup_7} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_8 == {7'd0, setup_8} + from_setup_9);
  reg [7:0] from_setup_9;
  always @(posedge clk) from_setup_9 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_9 :
    from_setup_9 + {7'd0, setup_8} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_9 == {7'd0, setup_9} + from_setup_10);
  reg [7:0] from_setup_10;
  always @(posedge clk) from_setup_10 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_10 :
    from_setup_10 + {7'd0, setup_9} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_10 == {7'd0, setup_10} + from_setup_11);
  reg [7:0] from_setup_11;
  always @(posedge clk) from_setup_11 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_11 :
    from_setup_11 + {7'd0, setup_10} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_11 == {7'd0, setup_11} + from_setup_12);
  reg [7:0] from_setup_12;
  always @(posedge clk) from_setup_12 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_12 :
    from_setup_12 + {7'd0, setup_11} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_12 == {7'd0, setup_12} + from_setup_13);
  reg [7:0] from_setup_13;
  always @(posedge clk) from_setup_13 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_13 :
    from_setup_13 + {7'd0, setup_12} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_13 == {7'd0, setup_13} + from_setup_14);
  reg [7:0] from_setup_14;
  always @(posedge clk) from_setup_14 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_14 :
    from_setup_14 + {7'd0, setup_13} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_14 == {7'd0, setup_14} + from_setup_15);
  reg [7:0] from_setup_15;
  always @(posedge clk) from_setup_15 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_15 :
    from_setup_15 + {7'd0, setup_14} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_15 == {7'd0, setup_15} + from_setup_16);
  reg [7:0] from_setup_16;
  always @(posedge clk) from_setup_16 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_16 :
    from_setup_16 + {7'd0, setup_15} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_16 == {7'd0, setup_16} + from_setup_17);
  reg [7:0] from_setup_17;
  always @(posedge clk) from_setup_17 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_17 :
    from_setup_17 + {7'd0, setup_16} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_17 == {7'd0, setup_17} + from_setup_18);
  reg [7:0] from_setup_18;
  always @(posedge clk) from_setup_18 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_18 :
    from_setup_18 + {7'd0, setup_17} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_18 == {7'd0, setup_18} + from_setup_19);
  reg [7:0] from_setup_19;
  always @(posedge clk) from_setup_19 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_19 :
    from_setup_19 + {7'd0, setup_18} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_19 == {7'd0, setup_19} + from_setup_20);
  reg [7:0] from_setup_20;
  always @(posedge clk) from_setup_20 <= rst ? 8'd0 : !(setup_ready_q) ? from_setup_20 :
    from_setup_20 + {7'd0, setup_19} - {7'd0, setup_20};
  always @* if (started) assert (from_setup_20 == {7'd0, setup_20});
  wire [7:0] in_setup = from_setup_0;
  reg [7:0] from_loop_1;
  always @(posedge clk) from_loop_1 <= rst ? 8'd0 : !(1'b1) ? from_loop_1 :
    from_loop_1 + {7'd0, slot_busy} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_1 == {7'd0, loop_1} + from_loop_2);
  reg [7:0] from_loop_2;
  always @(posedge clk) from_loop_2 <= rst ? 8'd0 : !(1'b1) ? from_loop_2 :
    from_loop_2 + {7'd0, loop_1} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_2 == {7'd0, loop_2} + from_loop_3);
  reg [7:0] from_loop_3;
  always @(posedge clk) from_loop_3 <= rst ? 8'd0 : !(1'b1) ? from_loop_3 :
    from_loop_3 + {7'd0, loop_2} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_3 == {7'd0, loop_3} + from_loop_4);
  reg [7:0] from_loop_4;
  always @(posedge clk) from_loop_4 <= rst ? 8'd0 : !(1'b1) ? from_loop_4 :
    from_loop_4 + {7'd0, loop_3} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_4 == {7'd0, loop_4} + from_loop_5);
  reg [7:0] from_loop_5;
  always @(posedge clk) from_loop_5 <= rst ? 8'd0 : !(1'b1) ? from_loop_5 :
    from_loop_5 + {7'd0, loop_4} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_5 == {7'd0, loop_5} + from_loop_6);
  reg [7:0] from_loop_6;
  always @(posedge clk) from_loop_6 <= rst ? 8'd0 : !(1'b1) ? from_loop_6 :
    from_loop_6 + {7'd0, loop_5} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_6 == {7'd0, loop_6} + from_loop_7);
  reg [7:0] from_loop_7;
  always @(posedge clk) from_loop_7 <= rst ? 8'd0 : !(1'b1) ? from_loop_7 :
    from_loop_7 + {7'd0, loop_6} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_7 == {7'd0, loop_7} + from_loop_8);
  reg [7:0] from_loop_8;
  always @(posedge clk) from_loop_8 <= rst ? 8'd0 : !(1'b1) ? from_loop_8 :
    from_loop_8 + {7'd0, loop_7} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_8 == {7'd0, loop_8} + from_loop_9);
  reg [7:0] from_loop_9;
  always @(posedge clk) from_loop_9 <= rst ? 8'd0 : !(1'b1) ? from_loop_9 :
    from_loop_9 + {7'd0, loop_8} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_9 == {7'd0, loop_9} + from_loop_10);
  reg [7:0] from_loop_10;
  always @(posedge clk) from_loop_10 <= rst ? 8'd0 : !(1'b1) ? from_loop_10 :
    from_loop_10 + {7'd0, loop_9} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_10 == {7'd0, loop_10} + from_loop_11);
  reg [7:0] from_loop_11;
  always @(posedge clk) from_loop_11 <= rst ? 8'd0 : !(1'b1) ? from_loop_11 :
    from_loop_11 + {7'd0, loop_10} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_11 == {7'd0, loop_11} + from_loop_12);
  reg [7:0] from_loop_12;
  always @(posedge clk) from_loop_12 <= rst ? 8'd0 : !(1'b1) ? from_loop_12 :
    from_loop_12 + {7'd0, loop_11} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_12 == {7'd0, loop_12} + from_loop_13);
  reg [7:0] from_loop_13;
  always @(posedge clk) from_loop_13 <= rst ? 8'd0 : !(1'b1) ? from_loop_13 :
    from_loop_13 + {7'd0, loop_12} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_13 == {7'd0, loop_13} + from_loop_14);
  reg [7:0] from_loop_14;
  always @(posedge clk) from_loop_14 <= rst ? 8'd0 : !(1'b1) ? from_loop_14 :
    from_loop_14 + {7'd0, loop_13} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_14 == {7'd0, loop_14} + from_loop_15);
  reg [7:0] from_loop_15;
  always @(posedge clk) from_loop_15 <= rst ? 8'd0 : !(1'b1) ? from_loop_15 :
    from_loop_15 + {7'd0, loop_14} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_15 == {7'd0, loop_15} + from_loop_16);
  reg [7:0] from_loop_16;
  always @(posedge clk) from_loop_16 <= rst ? 8'd0 : !(1'b1) ? from_loop_16 :
    from_loop_16 + {7'd0, loop_15} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_16 == {7'd0, loop_16} + from_loop_17);
  reg [7:0] from_loop_17;
  always @(posedge clk) from_loop_17 <= rst ? 8'd0 : !(1'b1) ? from_loop_17 :
    from_loop_17 + {7'd0, loop_16} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_17 == {7'd0, loop_17} + from_loop_18);
  reg [7:0] from_loop_18;
  always @(posedge clk) from_loop_18 <= rst ? 8'd0 : !(1'b1) ? from_loop_18 :
    from_loop_18 + {7'd0, loop_17} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_18 == {7'd0, loop_18} + from_loop_0);
  reg [7:0] from_loop_0;
  always @(posedge clk) from_loop_0 <= rst ? 8'd0 : !(1'b1) ? from_loop_0 :
    from_loop_0 + {7'd0, loop_18} - {7'd0, loop_0};
  always @* if (started) assert (from_loop_0 == {7'd0, loop_0});
  wire [7:0] in_loop = from_loop_1;
  reg [7:0] from_hit_0;
  always @(posedge clk) from_hit_0 <= rst ? 8'd0 : !(hit_ready_q) ? from_hit_0 :
    from_hit_0 + {7'd0, retire} - {7'd0, hit_6};
  always @* if (started) assert (from_hit_0 == {7'd0, hit_0} + from_hit_1);
  reg [7:0] from_hit_1;
  always @(posedge clk) from_hit_1 <= rst ? 8'd0 : !(hit_ready_q) ? from_hit_1 :
    from_hit_1 + {7'd0, hit_0} - {7'd0, hit_6};
  always @* if (started) assert (from_hit_1 == {7'd0, hit_1} + from_hit_2);
  reg [7:0] from_hit_2;
  always @(posedge clk) from_hit_2 <= rst ? 8'd0 : !(hit_ready_q) ? from_hit_2 :
    from_hit_2 + {7'd0, hit_1} - {7'd0, hit_6};
  always @* if (started) assert (from_hit_2 == {7'd0, hit_2} + from_hit_3);
  reg [7:0] from_hit_3;
  always @(posedge clk) from_hit_3 <= rst ? 8'd0 : !(hit_ready_q) ? from_hit_3 :
    from_hit_3 + {7'd0, hit_2} - {7'd0, hit_6};
  always @* if (started) assert (from_hit_3 == {7'd0, hit_3} + from_hit_4);
  reg [7:0] from_hit_4;
  always @(posedge clk) from_hit_4 <= rst ? 8'd0 : !(hit_ready_q) ? from_hit_4 :
    from_hit_4 + {7'd0, hit_3} - {7'd0, hit_6};
  always @* if (started) assert (from_hit_4 == {7'd0, hit_4} + from_hit_5);
  reg [7:0] from_hit_5;
  always @(posedge clk) from_hit_5 <= rst ? 8'd0 : !(hit_ready_q) ? from_hit_5 :
    from_hit_5 + {7'd0, hit_4} - {7'd0, hit_6};
  always @* if (started) assert (from_hit_5 == {7'd0, hit_5} + from_hit_6);
  reg [7:0] from_hit_6;
  always @(posedge clk) from_hit_6 <= rst ? 8'd0 : !(hit_ready_q) ? from_hit_6 :
    from_hit_6 + {7'd0, hit_5} - {7'd0, hit_6};
  always @* if (started) assert (from_hit_6 == {7'd0, hit_6});
  wire [7:0] in_hit = from_hit_0;
  wire [7:0] setup_waiting = {7'd0, setup_21} + {7'd0, setup_22};
  wire [7:0] hit_waiting = {7'd0, hit_7} + {7'd0, hit_8};
  wire [7:0] inside = in_setup + in_loop + in_hit + setup_waiting + hit_waiting;
  reg [7:0] held;
  always @(posedge clk) begin
    started <= 1;
    was_stalled <= out_valid && !out_ready && !rst;
    if (rst) held <= 0;
    else held <= held + {7'd0, in_valid && in_ready} - {7'd0, out_valid && out_ready};
  end
  always @* begin
    if (!started) assume (rst);
    if (started) begin
      // The claim.
      assert (held == inside);
      if (was_stalled) assert (out_valid);
      // Invariants that make the induction hold.
      if (retire) assert (loop_0);
      // The slots of the spill register are the last two.
      assert (setup_valid_q == (setup_21 || setup_22));
      assert (setup_ready_q == (setup_out_of_reset && !(setup_21 && setup_22)));
      assert (setup_out_of_reset || !(setup_21 || setup_22 || setup_wr_sel_q));
      assert ((setup_wr_sel_q ^ setup_rd_sel_q) == (setup_21 ^ setup_22));
      assert (!(setup_21 ^ setup_22) || (setup_rd_sel_q ? setup_22 : setup_21));
      // The slots of the spill register are the last two.
      assert (hit_valid_q == (hit_7 || hit_8));
      assert (hit_ready_q == (hit_out_of_reset && !(hit_7 && hit_8)));
      assert (hit_out_of_reset || !(hit_7 || hit_8 || hit_wr_sel_q));
      assert ((hit_wr_sel_q ^ hit_rd_sel_q) == (hit_7 ^ hit_8));
      assert (!(hit_7 ^ hit_8) || (hit_rd_sel_q ? hit_8 : hit_7));
    end
  end
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
