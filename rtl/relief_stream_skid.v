// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_stream_skid: handshake of a stream's two places: ready is a register
// Source     src/units/traversal/stream_skid.rs (emitted: do not edit)
// Latency    varies; valid/ready on both sides
// Throughput one result per clock
// Note       Words leave in the order in which they come; none is lost and none comes twice. Not
//            ready in the first clock behind reset.
`default_nettype none
module relief_stream_skid #(
  parameter integer VARIANT = 32'h34741979  // digest of what is no parameter
) (
  input  wire  clk,          // rising edge
  input  wire  rst,          // synchronous, active high; clears valid bits and counts, no data
  input  wire  in_valid,     // a word is offered
  output wire  in_ready,     // it is taken at the next edge
  output wire  out_valid,    // a word is offered
  input  wire  out_ready,    // it is taken at the next edge
  output wire  first_open,   // the first place takes what comes
  output wire  second_open,  // the second place takes what comes
  output wire  turn          // the second place is offered
);

  // Illegal parameters end elaboration here: the missing module's name says what must hold.
  generate
    if (VARIANT != 32'h34741979) begin : gen_other_variant
      relief_stream_skid_has_VARIANT_34741979_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- state that comes back from the last stage, and handshakes
  reg first_valid;
  reg second_valid;
  reg some_valid;
  reg writes_second;
  reg reads_second;
  reg awake;
  reg is_ready;
  reg first_takes;
  reg second_takes;

  // ---- take ------------------------------------------------------------ stream_skid.rs
  // A place that is not filled takes whatever comes; it counts once it was the place's turn.
  wire comes = in_valid & awake & ~(first_valid & second_valid);
  wire goes = some_valid & out_ready;
  wire fills_first = comes & ~writes_second;
  wire fills_second = comes & writes_second;
  wire leaves_first = goes & ~reads_second;
  wire leaves_second = goes & reads_second;
  wire first_filled = fills_first | (first_valid & ~leaves_first);
  wire second_filled = fills_second | (second_valid & ~leaves_second);

  // ---- registers ------------------------------------------------------- stream_skid.rs
  // What others wait for has registers of its own, beside the places' bits.
  wire some_filled = first_filled | second_filled;
  wire writes_next = writes_second ^ comes;
  wire reads_next = reads_second ^ goes;
  wire ready_next = ~(first_filled & second_filled);
  wire first_opens = ~first_filled;
  wire second_opens = ~second_filled;

  // ---- back to stage 0
  always @(posedge clk) begin
    if (rst) begin
      first_valid   <= 1'b0;
      second_valid  <= 1'b0;
      some_valid    <= 1'b0;
      writes_second <= 1'b0;
      reads_second  <= 1'b0;
      awake         <= 1'b0;
      is_ready      <= 1'b0;
      first_takes   <= 1'b0;
      second_takes  <= 1'b0;
    end else begin
      first_valid   <= first_filled;
      second_valid  <= second_filled;
      some_valid    <= some_filled;
      writes_second <= writes_next;
      reads_second  <= reads_next;
      awake         <= 1'b1;
      is_ready      <= ready_next;
      first_takes   <= first_opens;
      second_takes  <= second_opens;
    end
  end

  assign in_ready = is_ready;
  assign out_valid = some_valid;
  assign first_open = first_takes;
  assign second_open = second_takes;
  assign turn = reads_second;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
