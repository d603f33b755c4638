// Proof harness: {{ claim }}.
//
// Words carry their number, modulo 32: the output word must have the number of the next pop. The script makes registers of the memory and
// connects them, so that the induction can say what each slot holds.
`default_nettype none
module {{ prefix }}fv_fifo (input wire clk);
  (* anyseq *) wire rst;
  (* anyseq *) wire in_valid;
  (* anyseq *) wire out_ready;
  wire in_ready, out_valid;
  wire [4:0] out_data, occupancy;
  reg [4:0] pushes, pops;
  {{ prefix }}fifo{{ terms("fifo", ".W(5), .DEPTH(16)") }} dut (
    .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready), .in_data(pushes), .out_valid(out_valid),
    .out_ready(out_ready), .out_data(out_data), .occupancy(occupancy)
  );

  // The script connects these to registers inside.
  (* keep *) wire [3:0] write_ptr, read_ptr;
  (* keep *) wire [4:0] occupancy_q;
  (* keep *) wire valid_q;
{%- for k in range(16) %}
  (* keep *) wire [4:0] slot_{{ k }};
{%- endfor %}
  wire [4:0] inside = pushes - pops;
  reg [4:0] older, was;
  reg started, was_stalled;
  initial {started, was_stalled} = 0;
  always @(posedge clk) begin
    started <= 1;
    was_stalled <= out_valid && !out_ready && !rst;
    was <= out_data;
    // Words that were pushed before the last clock edge, and are not popped yet.
    older <= rst ? 5'd0 : inside - (out_valid && out_ready);
    pushes <= rst ? 5'd0 : pushes + (in_valid && in_ready);
    pops <= rst ? 5'd0 : pops + (out_valid && out_ready);
  end
  always @* begin
    if (!started) assume (rst);
    if (started) begin
      // The claim: no more words inside than slots, counted right; ready whenever there is room;
      assert (inside <= 16 && occupancy == inside);
      assert (in_ready == (inside != 16));
      // valid two clocks after the push, with the oldest word; stable until it transfers.
      assert (out_valid == (older != 0));
      if (out_valid) assert (out_data == pops);
      if (was_stalled) assert (out_valid && out_data == was);
      // Invariants that make the induction hold.
      assert (older <= inside && inside <= older + 1);
      assert (occupancy_q == inside && valid_q == out_valid);
      assert (write_ptr == pushes[3:0] && read_ptr == pops[3:0]);
{%- for k in range(16) %}
      if (inside > {{ k }}) assert (held({{ k }}) == pops + 5'd{{ k }});
{%- endfor %}
    end
  end

  // The word k places after the oldest.
  function [4:0] held(input [3:0] k);
    reg [3:0] at;
    begin
      at = pops[3:0] + k;
      case (at)
{%- for k in range(16) %}
        4'd{{ k }}: held = slot_{{ k }};
{%- endfor %}
      endcase
    end
  endfunction
endmodule
`default_nettype wire
