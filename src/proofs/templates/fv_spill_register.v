// Proof harness: {{ claim }}.
//
// Words carry their number, modulo 16: the output word must have the number of the next pop.
`default_nettype none
module {{ prefix }}fv_spill_register (input wire clk);
  (* anyseq *) wire rst;
  (* anyseq *) wire in_valid;
  (* anyseq *) wire out_ready;
  wire in_ready, out_valid;
  reg [3:0] pushes, pops;
  wire [3:0] out_data;
  {{ prefix }}spill_register{{ terms("spill_register", ".W(4)") }} dut (
    .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready), .in_data(pushes), .out_valid(out_valid),
    .out_ready(out_ready), .out_data(out_data)
  );

  // The script connects these to registers inside.
  (* keep *) wire first_valid, second_valid, valid_q, wr_sel_q, rd_sel_q, load_first_q, load_second_q, out_of_reset;
  (* keep *) wire [3:0] first_word, second_word;
  wire [3:0] inside = pushes - pops;
  reg started, was_stalled;
  reg [3:0] was;
  initial {started, was_stalled} = 0;
  always @(posedge clk) begin
    started <= 1;
    was_stalled <= out_valid && !out_ready && !rst;
    was <= out_data;
    pushes <= rst ? 4'd0 : pushes + (in_valid && in_ready);
    pops <= rst ? 4'd0 : pops + (out_valid && out_ready);
  end
  always @* begin
    if (!started) assume (rst);
    if (started) begin
      // The claim: as many words inside as slots are valid, and the output is the oldest.
      assert (inside <= 2);
      assert (inside == first_valid + second_valid);
      assert (out_valid == (inside != 0));
      if (out_valid) assert (out_data == pops);
      if (was_stalled) assert (out_valid && out_data == was);
      if (in_ready) assert (inside < 2);
      // Invariants that make the induction hold.
      assert (out_valid == valid_q);
      assert ((wr_sel_q ^ rd_sel_q) == (inside == 1));
      assert (inside != 1 || (rd_sel_q ? second_valid : first_valid));
      if (out_of_reset) assert (in_ready == (inside < 2) && load_first_q == !first_valid && load_second_q == !second_valid);
      if (!out_of_reset) assert (inside == 0 && !in_ready && !load_first_q && !load_second_q && !wr_sel_q);
      if (first_valid) assert (first_word == (rd_sel_q ? pops + 4'd1 : pops));
      if (second_valid) assert (second_word == (rd_sel_q ? pops : pops + 4'd1));
    end
  end
endmodule
`default_nettype wire
