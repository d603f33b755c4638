// SPDX-License-Identifier: MIT OR Apache-2.0
// Proof harness: words leave in the order in which they come, none lost and none twice, and an offered one stays, by induction.
//
// Words carry their number, modulo 16: what leaves must have the number of the next one that leaves.
`default_nettype none
module relief_fv_stream_skid (input wire clk);
  (* anyseq *) wire rst;
  (* anyseq *) wire in_valid;
  (* anyseq *) wire out_ready;
  wire in_ready, out_valid, first_open, second_open, turn;
  reg [3:0] come, gone;
  wire [3:0] out_data;
  relief_stream_skid #(.VARIANT(32'h34741979)) dut (
    .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready), .out_valid(out_valid), .out_ready(out_ready),
    .first_open(first_open), .second_open(second_open), .turn(turn)
  );
  relief_word_skid #(.W(4), .VARIANT(32'h25a4b2c2)) word (
    .clk(clk), .first_open(first_open), .second_open(second_open), .turn(turn), .in_data(come), .out_data(out_data)
  );

  // The script connects these to registers inside.
  (* keep *) wire first_valid, second_valid, some_valid, writes_second, reads_second, awake;
  (* keep *) wire [3:0] first_word, second_word;
  wire [3:0] inside = come - gone;
  reg started, was_stalled;
  reg [3:0] was;
  initial {started, was_stalled} = 0;
  always @(posedge clk) begin
    started <= 1;
    was_stalled <= out_valid && !out_ready && !rst;
    was <= out_data;
    come <= rst ? 4'd0 : come + (in_valid && in_ready);
    gone <= rst ? 4'd0 : gone + (out_valid && out_ready);
  end
  always @* begin
    if (!started) assume (rst);
    if (started) begin
      // The claim: as many inside as places are filled, and the one that is offered is the next.
      assert (inside <= 2);
      assert (inside == first_valid + second_valid);
      assert (out_valid == (inside != 0));
      if (out_valid) assert (out_data == gone);
      if (was_stalled) assert (out_valid && out_data == was);
      if (in_ready) assert (inside < 2);
      // What makes it hold in every next clock.
      assert (out_valid == some_valid && turn == reads_second);
      assert ((writes_second ^ reads_second) == (inside == 1));
      assert (inside != 1 || (reads_second ? second_valid : first_valid));
      if (awake) assert (in_ready == (inside < 2) && first_open == !first_valid && second_open == !second_valid);
      if (!awake) assert (inside == 0 && !in_ready && !first_open && !second_open && !writes_second);
      if (first_valid) assert (first_word == (reads_second ? gone + 4'd1 : gone));
      if (second_valid) assert (second_word == (reads_second ? gone : gone + 4'd1));
    end
  end
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
