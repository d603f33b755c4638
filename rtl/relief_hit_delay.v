// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_hit_delay: a word and its valid bit, delayed beside a pipeline
// Emitted    by reliefrtl as its unit hit_delay; do not edit
// Latency    7 clocks
// Throughput one result per clock
`default_nettype none
module relief_hit_delay #(
  parameter integer W       = 8,  // bits of the word
  parameter integer LATENCY = 7,  // clocks it was generated for; checked
  parameter integer VARIANT = 32'h0069384e  // digest of what it was generated for; checked
) (
  input  wire         clk,        // rising edge
  input  wire         ce,         // clock enable: registers hold while 0
  input  wire         rst,        // synchronous, active high; clears valid bits and counts, no data
  input  wire         in_valid,   // the word is valid
  output wire         out_valid,  // the delayed word is valid
  input  wire [W-1:0] in_data,    // the word [bits]
  output wire [W-1:0] out_data    // the delayed word [bits]
);

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (W < 1) begin : gen_illegal_0 W_must_be_at_least_1 u_illegal (); end
    if (LATENCY != 7) begin : gen_other_latency
      relief_hit_delay_has_LATENCY_7_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h0069384e) begin : gen_other_variant
      relief_hit_delay_has_VARIANT_0069384e_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 7: registers -------------------------------------------------------------
  // Delay of 7 clocks: stage 0 to 7.
  reg [W-1:0]   s7_data;
  reg [6*W-1:0] s0_to_s7;
  always @(posedge clk) begin
    if (ce) begin
      {s7_data, s0_to_s7} <= {s0_to_s7, in_data};
    end
  end
  // Delay of 7 clocks: stage 0 to 7.
  reg       s7_valid;
  reg [5:0] s0_to_s7_valid;
  always @(posedge clk) begin
    if (rst) begin
      {s7_valid, s0_to_s7_valid} <= 7'd0;
    end else if (ce) begin
      {s7_valid, s0_to_s7_valid} <= {s0_to_s7_valid, in_valid};
    end
  end

  assign out_valid = s7_valid;
  assign out_data = s7_data;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
