// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_word_skid: the two places of a word beside a stream_skid
// Source     src/units/traversal/stream_skid.rs (emitted: do not edit)
// Latency    varies; valid/ready on both sides
// Throughput one result per clock
`default_nettype none
module relief_word_skid #(
  parameter integer W       = 8,  // bits of the word
  parameter integer VARIANT = 32'h25a4b2c2  // digest of what is no parameter
) (
  input  wire         clk,          // rising edge
  input  wire         first_open,   // the first place takes the word
  input  wire         second_open,  // the second place takes the word
  input  wire         turn,         // the second place is offered
  input  wire [W-1:0] in_data,      // the word that comes [bits]
  output wire [W-1:0] out_data      // the word that is offered [bits]
);

  // Illegal parameters end elaboration here: the missing module's name says what must hold.
  generate
    if (1 > W) begin : gen_illegal_0
      must_hold_1_at_most_W u_illegal ();
    end
    if (VARIANT != 32'h25a4b2c2) begin : gen_other_variant
      relief_word_skid_has_VARIANT_25a4b2c2_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- state that comes back from the last stage, and handshakes
  reg [W-1:0] first;
  reg [W-1:0] second;

  wire [W-1:0] first_next = first_open ? in_data : first;
  wire [W-1:0] second_next = second_open ? in_data : second;
  wire [W-1:0] offered = turn ? second : first;

  // ---- back to stage 0
  always @(posedge clk) begin
    first  <= first_next;
    second <= second_next;
  end

  assign out_data = offered;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
