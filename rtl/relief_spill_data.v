// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_spill_data: two slots of one word, controlled by a spill_register
// Emitted    by reliefrtl as its unit spill_data; do not edit
// Latency    varies; valid/ready on both sides
// Throughput one result per clock
`default_nettype none
module relief_spill_data #(
  parameter integer W       = 8,  // bits of a word
  parameter integer VARIANT = 32'h299460a6  // digest of what is no parameter
) (
  input  wire         clk,          // rising edge
  input  wire         load_first,   // load enable of the first slot
  input  wire         load_second,  // load enable of the second slot
  input  wire         rd_sel,       // read select: 0 the first slot, 1 the second
  input  wire [W-1:0] in_data,      // input word [bits]
  output wire [W-1:0] out_data      // output word [bits]
);

  // Parameter checks: an illegal value ends elaboration, the missing module names the rule.
  generate
    if (W < 1) begin : gen_illegal_0 W_must_be_at_least_1 u_illegal (); end
    if (VARIANT != 32'h299460a6) begin : gen_other_variant
      relief_spill_data_has_VARIANT_299460a6_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- state that comes back from the last stage, and handshakes
  reg [W-1:0] first;   // word of the slot [bits]
  reg [W-1:0] second;  // word of the slot [bits]

  wire [W-1:0] first_next = load_first ? in_data : first;
  wire [W-1:0] second_next = load_second ? in_data : second;
  wire [W-1:0] selected = rd_sel ? second : first;

  // ---- back to stage 0
  always @(posedge clk) begin
    first  <= first_next;
    second <= second_next;
  end

  assign out_data = selected;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
