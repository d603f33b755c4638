// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_setup_delay: a word and its valid bit, delayed beside a pipeline
// Emitted    by reliefrtl as its unit setup_delay; do not edit
// Latency    21 clocks
// Throughput one result per clock
`default_nettype none
module relief_setup_delay #(
  parameter integer W       = 8,  // bits of the word
  parameter integer LATENCY = 21,  // clocks it was generated for; checked
  parameter integer VARIANT = 32'h306304c2  // digest of what it was generated for; checked
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
    if (LATENCY != 21) begin : gen_other_latency
      relief_setup_delay_has_LATENCY_21_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h306304c2) begin : gen_other_variant
      relief_setup_delay_has_VARIANT_306304c2_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 21: registers ------------------------------------------------------------
  // Delay of 21 clocks: stage 0 to 21.
  reg [W-1:0]    s21_data;
  reg [20*W-1:0] s0_to_s21;
  always @(posedge clk) begin
    if (ce) begin
      {s21_data, s0_to_s21} <= {s0_to_s21, in_data};
    end
  end
  // Delay of 21 clocks: stage 0 to 21.
  reg        s21_valid;
  reg [19:0] s0_to_s21_valid;
  always @(posedge clk) begin
    if (rst) begin
      {s21_valid, s0_to_s21_valid} <= 21'd0;
    end else if (ce) begin
      {s21_valid, s0_to_s21_valid} <= {s0_to_s21_valid, in_valid};
    end
  end

  assign out_valid = s21_valid;
  assign out_data = s21_data;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
