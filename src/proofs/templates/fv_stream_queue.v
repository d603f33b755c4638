// Proof harness: {{ claim }}.
//
// A pipeline of any length stands between setting out and arriving: what has set out arrives whenever it likes, in order. Words are
// numbered modulo 64; place k holds words whose number ends in k.
`default_nettype none
module {{ prefix }}fv_stream_queue (input wire clk);
  (* anyseq *) wire rst;
  (* anyseq *) wire offers;
  (* anyseq *) wire arrives;
  (* anyseq *) wire out_ready;
  wire room, out_valid;
  wire [3:0] write_place, read_place;
  reg [5:0] set_out, arrived, gone;
  wire [5:0] under_way = set_out - arrived;
  wire [5:0] stored = arrived - gone;
  wire sets_out = offers && room;
  wire in_valid = arrives && under_way != 0;
  {{ prefix }}stream_queue{{ terms("stream_queue", "") }} dut (
    .clk(clk), .rst(rst), .sets_out(sets_out), .in_valid(in_valid), .room(room), .out_valid(out_valid),
    .out_ready(out_ready), .write_place(write_place), .read_place(read_place)
  );

  // The script connects these to registers inside.
  (* keep *) wire [4:0] taken, held;
  (* keep *) wire has_room, has_set_out, has_gone, is_offered;
  wire goes = out_valid && out_ready;
  reg started, was_offered, was_held;
  reg [3:0] was_read;
  reg was_stored;
  initial {started, was_offered, was_stored} = 0;
  always @(posedge clk) begin
    started <= 1;
    was_offered <= out_valid && !out_ready && !rst;
    was_read <= read_place;
    // The word of the place that is read stands in its memory.
    was_stored <= stored > has_gone && !rst;
    set_out <= rst ? 6'd0 : set_out + sets_out;
    arrived <= rst ? 6'd0 : arrived + in_valid;
    gone <= rst ? 6'd0 : gone + (goes ? 6'd1 : 6'd0);
  end
  always @* begin
    if (!started) assume (rst);
    if (started) begin
      // The claim. Nothing is written where a word waits or is just read:
      assert (under_way + stored <= 16);
      if (in_valid) assert (stored + has_gone <= 15);
      // words are written in turn, and the one that is offered is the next, was read the clock before, and had been written before that;
      assert (write_place == arrived[3:0]);
      if (out_valid) assert (stored != 0 && was_stored && was_read == gone[3:0] && read_place == gone[3:0]);
      // it stays until it is taken.
      if (was_offered) assert (out_valid);
      // What makes it hold in every next clock.
      assert (out_valid == is_offered && room == has_room);
      assert (read_place == gone[3:0] - has_gone);
      assert (held == stored + has_gone && stored <= 16);
      assert (taken + has_set_out == under_way + held);
      assert (taken + has_set_out + has_room <= 16);
      if (has_gone) assert (!out_valid);
    end
  end
endmodule
`default_nettype wire
