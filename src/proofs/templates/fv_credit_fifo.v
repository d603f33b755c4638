// Proof harness: {{ claim }}.
//
// The pipeline from issue to the FIFO's input is modelled as a delay of any length that keeps the order. Words are numbered modulo 64; slot k
// holds words whose number ends in k.
`default_nettype none
module {{ prefix }}fv_credit_fifo (input wire clk);
  (* anyseq *) wire rst;
  (* anyseq *) wire wants;
  (* anyseq *) wire arrives;
  (* anyseq *) wire out_ready;
  wire credit, out_valid;
  reg [5:0] issues, pushes, pops;
  wire [5:0] in_flight = issues - pushes;
  wire [5:0] stored = pushes - pops;
  wire issue = wants && credit;
  wire in_valid = arrives && in_flight != 0;
  {{ prefix }}credit_fifo{{ terms("credit_fifo", ".W(6)") }} dut (
    .clk(clk), .rst(rst), .issue(issue), .in_valid(in_valid), .in_data(pushes), .credit(credit), .out_valid(out_valid),
    .out_ready(out_ready)
  );

  // The script connects these to registers inside.
  (* keep *) wire [3:0] write_slot, read_slot;
  (* keep *) wire [4:0] reserved, occupancy;
  (* keep *) wire credit_q, issued, popped, valid_q;
  wire pop = out_valid && out_ready;
  reg started, was_stalled, was_stored;
  reg [3:0] was_read;
  initial {started, was_stalled, was_stored} = 0;
  always @(posedge clk) begin
    started <= 1;
    was_stalled <= out_valid && !out_ready && !rst;
    was_read <= read_slot;
    // The word of the slot that is read was written before.
    was_stored <= stored > popped && !rst;
    issues <= rst ? 6'd0 : issues + issue;
    pushes <= rst ? 6'd0 : pushes + in_valid;
    pops <= rst ? 6'd0 : pops + (pop ? 6'd1 : 6'd0);
  end
  always @* begin
    if (!started) assume (rst);
    if (started) begin
      // The claim. No occupied slot, nor the one that is read, is overwritten:
      assert (in_flight + stored <= 16);
      if (in_valid) assert (stored + popped <= 15);
      // slots are written in order, and a valid output is the oldest word, read the clock before and written before that;
      assert (write_slot == pushes[3:0]);
      if (out_valid) assert (stored != 0 && was_stored && was_read == pops[3:0] && read_slot == pops[3:0]);
      // it is stable until it transfers.
      if (was_stalled) assert (out_valid);
      // Invariants that make the induction hold.
      assert (out_valid == valid_q && credit == credit_q);
      assert (read_slot == pops[3:0] - popped);
      assert (occupancy == stored + popped && stored <= 16);
      assert (reserved + issued == in_flight + occupancy);
      assert (reserved + issued + credit_q <= 16);
      if (popped) assert (!out_valid);
    end
  end
endmodule
`default_nettype wire
