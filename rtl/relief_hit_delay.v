// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_hit_delay: a word, delayed beside a pipeline
// Source     src/units/traversal/stream_delay.rs (emitted: do not edit)
// Latency    7 clocks
// Throughput one result per clock
`default_nettype none
module relief_hit_delay #(
  parameter integer W       = 1,  // bits of the word
  parameter integer LATENCY = 7,  // clocks that it was generated for
  parameter integer VARIANT = 32'h62486e47  // digest of what is no parameter
) (
  input  wire         clk,       // rising edge
  input  wire         ce,        // clock enable: registers hold while 0
  input  wire [W-1:0] in_data,   // the word [bits]
  output wire [W-1:0] out_data   // the delayed word [bits]
);

  // Parameter checks: an illegal value ends elaboration, the missing module names the rule.
  generate
    if (W < 1) begin : gen_illegal_0 W_must_be_at_least_1 u_illegal (); end
    if (LATENCY != 7) begin : gen_other_latency
      relief_hit_delay_has_LATENCY_7_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h62486e47) begin : gen_other_variant
      relief_hit_delay_has_VARIANT_62486e47_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 1: registers --------------------------------------------- stream_delay.rs
  reg [W-1:0] s1_data;
  always @(posedge clk) begin
    if (ce) begin
      s1_data <= in_data;
    end
  end

  // ---- stage 2: registers --------------------------------------------- stream_delay.rs
  reg [W-1:0] s2_data;
  always @(posedge clk) begin
    if (ce) begin
      s2_data <= s1_data;
    end
  end

  // ---- stage 3: registers --------------------------------------------- stream_delay.rs
  reg [W-1:0] s3_data;
  always @(posedge clk) begin
    if (ce) begin
      s3_data <= s2_data;
    end
  end

  // ---- stage 4: registers --------------------------------------------- stream_delay.rs
  reg [W-1:0] s4_data;
  always @(posedge clk) begin
    if (ce) begin
      s4_data <= s3_data;
    end
  end

  // ---- stage 5: registers --------------------------------------------- stream_delay.rs
  reg [W-1:0] s5_data;
  always @(posedge clk) begin
    if (ce) begin
      s5_data <= s4_data;
    end
  end

  // ---- stage 6: registers --------------------------------------------- stream_delay.rs
  reg [W-1:0] s6_data;
  always @(posedge clk) begin
    if (ce) begin
      s6_data <= s5_data;
    end
  end

  // ---- stage 7: registers --------------------------------------------- stream_delay.rs
  reg [W-1:0] s7_data;
  always @(posedge clk) begin
    if (ce) begin
      s7_data <= s6_data;
    end
  end

  assign out_data = s7_data;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
