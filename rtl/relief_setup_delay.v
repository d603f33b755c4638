// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_setup_delay: a word and its valid bit, delayed beside a pipeline
// Source     src/units/traversal/stream_delay.rs (emitted: do not edit)
// Latency    21 clocks
// Throughput one result per clock
`default_nettype none
module relief_setup_delay #(
  parameter integer W       = 8,  // bits of the word
  parameter integer LATENCY = 21,  // clocks that it was generated for
  parameter integer VARIANT = 32'h306304c2  // digest of what is no parameter
) (
  input  wire         clk,        // rising edge
  input  wire         ce,         // clock enable: registers hold while 0
  input  wire         rst,        // synchronous, active high; clears valid bits and counts, no data
  input  wire         in_valid,   // the word counts
  output wire         out_valid,  // the delayed word counts
  input  wire [W-1:0] in_data,    // the word [bits]
  output wire [W-1:0] out_data    // the delayed word [bits]
);

  // Parameter checks: an illegal value ends elaboration, the missing module names the rule.
  generate
    if (W < 1) begin : gen_illegal_0 W_must_be_at_least_1 u_illegal (); end
    if (LATENCY != 21) begin : gen_other_latency
      relief_setup_delay_has_LATENCY_21_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h306304c2) begin : gen_other_variant
      relief_setup_delay_has_VARIANT_306304c2_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 1: registers --------------------------------------------- stream_delay.rs
  reg         s1_valid;
  reg [W-1:0] s1_data;
  always @(posedge clk) begin
    if (ce) begin
      s1_data <= in_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s1_valid <= 1'b0;
    end else if (ce) begin
      s1_valid <= in_valid;
    end
  end

  // ---- stage 2: registers --------------------------------------------- stream_delay.rs
  reg         s2_valid;
  reg [W-1:0] s2_data;
  always @(posedge clk) begin
    if (ce) begin
      s2_data <= s1_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s2_valid <= 1'b0;
    end else if (ce) begin
      s2_valid <= s1_valid;
    end
  end

  // ---- stage 3: registers --------------------------------------------- stream_delay.rs
  reg         s3_valid;
  reg [W-1:0] s3_data;
  always @(posedge clk) begin
    if (ce) begin
      s3_data <= s2_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s3_valid <= 1'b0;
    end else if (ce) begin
      s3_valid <= s2_valid;
    end
  end

  // ---- stage 4: registers --------------------------------------------- stream_delay.rs
  reg         s4_valid;
  reg [W-1:0] s4_data;
  always @(posedge clk) begin
    if (ce) begin
      s4_data <= s3_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s4_valid <= 1'b0;
    end else if (ce) begin
      s4_valid <= s3_valid;
    end
  end

  // ---- stage 5: registers --------------------------------------------- stream_delay.rs
  reg         s5_valid;
  reg [W-1:0] s5_data;
  always @(posedge clk) begin
    if (ce) begin
      s5_data <= s4_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s5_valid <= 1'b0;
    end else if (ce) begin
      s5_valid <= s4_valid;
    end
  end

  // ---- stage 6: registers --------------------------------------------- stream_delay.rs
  reg         s6_valid;
  reg [W-1:0] s6_data;
  always @(posedge clk) begin
    if (ce) begin
      s6_data <= s5_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s6_valid <= 1'b0;
    end else if (ce) begin
      s6_valid <= s5_valid;
    end
  end

  // ---- stage 7: registers --------------------------------------------- stream_delay.rs
  reg         s7_valid;
  reg [W-1:0] s7_data;
  always @(posedge clk) begin
    if (ce) begin
      s7_data <= s6_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s7_valid <= 1'b0;
    end else if (ce) begin
      s7_valid <= s6_valid;
    end
  end

  // ---- stage 8: registers --------------------------------------------- stream_delay.rs
  reg         s8_valid;
  reg [W-1:0] s8_data;
  always @(posedge clk) begin
    if (ce) begin
      s8_data <= s7_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s8_valid <= 1'b0;
    end else if (ce) begin
      s8_valid <= s7_valid;
    end
  end

  // ---- stage 9: registers --------------------------------------------- stream_delay.rs
  reg         s9_valid;
  reg [W-1:0] s9_data;
  always @(posedge clk) begin
    if (ce) begin
      s9_data <= s8_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s9_valid <= 1'b0;
    end else if (ce) begin
      s9_valid <= s8_valid;
    end
  end

  // ---- stage 10: registers -------------------------------------------- stream_delay.rs
  reg         s10_valid;
  reg [W-1:0] s10_data;
  always @(posedge clk) begin
    if (ce) begin
      s10_data <= s9_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s10_valid <= 1'b0;
    end else if (ce) begin
      s10_valid <= s9_valid;
    end
  end

  // ---- stage 11: registers -------------------------------------------- stream_delay.rs
  reg         s11_valid;
  reg [W-1:0] s11_data;
  always @(posedge clk) begin
    if (ce) begin
      s11_data <= s10_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s11_valid <= 1'b0;
    end else if (ce) begin
      s11_valid <= s10_valid;
    end
  end

  // ---- stage 12: registers -------------------------------------------- stream_delay.rs
  reg         s12_valid;
  reg [W-1:0] s12_data;
  always @(posedge clk) begin
    if (ce) begin
      s12_data <= s11_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s12_valid <= 1'b0;
    end else if (ce) begin
      s12_valid <= s11_valid;
    end
  end

  // ---- stage 13: registers -------------------------------------------- stream_delay.rs
  reg         s13_valid;
  reg [W-1:0] s13_data;
  always @(posedge clk) begin
    if (ce) begin
      s13_data <= s12_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s13_valid <= 1'b0;
    end else if (ce) begin
      s13_valid <= s12_valid;
    end
  end

  // ---- stage 14: registers -------------------------------------------- stream_delay.rs
  reg         s14_valid;
  reg [W-1:0] s14_data;
  always @(posedge clk) begin
    if (ce) begin
      s14_data <= s13_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s14_valid <= 1'b0;
    end else if (ce) begin
      s14_valid <= s13_valid;
    end
  end

  // ---- stage 15: registers -------------------------------------------- stream_delay.rs
  reg         s15_valid;
  reg [W-1:0] s15_data;
  always @(posedge clk) begin
    if (ce) begin
      s15_data <= s14_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s15_valid <= 1'b0;
    end else if (ce) begin
      s15_valid <= s14_valid;
    end
  end

  // ---- stage 16: registers -------------------------------------------- stream_delay.rs
  reg         s16_valid;
  reg [W-1:0] s16_data;
  always @(posedge clk) begin
    if (ce) begin
      s16_data <= s15_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s16_valid <= 1'b0;
    end else if (ce) begin
      s16_valid <= s15_valid;
    end
  end

  // ---- stage 17: registers -------------------------------------------- stream_delay.rs
  reg         s17_valid;
  reg [W-1:0] s17_data;
  always @(posedge clk) begin
    if (ce) begin
      s17_data <= s16_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s17_valid <= 1'b0;
    end else if (ce) begin
      s17_valid <= s16_valid;
    end
  end

  // ---- stage 18: registers -------------------------------------------- stream_delay.rs
  reg         s18_valid;
  reg [W-1:0] s18_data;
  always @(posedge clk) begin
    if (ce) begin
      s18_data <= s17_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s18_valid <= 1'b0;
    end else if (ce) begin
      s18_valid <= s17_valid;
    end
  end

  // ---- stage 19: registers -------------------------------------------- stream_delay.rs
  reg         s19_valid;
  reg [W-1:0] s19_data;
  always @(posedge clk) begin
    if (ce) begin
      s19_data <= s18_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s19_valid <= 1'b0;
    end else if (ce) begin
      s19_valid <= s18_valid;
    end
  end

  // ---- stage 20: registers -------------------------------------------- stream_delay.rs
  reg         s20_valid;
  reg [W-1:0] s20_data;
  always @(posedge clk) begin
    if (ce) begin
      s20_data <= s19_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s20_valid <= 1'b0;
    end else if (ce) begin
      s20_valid <= s19_valid;
    end
  end

  // ---- stage 21: registers -------------------------------------------- stream_delay.rs
  reg         s21_valid;
  reg [W-1:0] s21_data;
  always @(posedge clk) begin
    if (ce) begin
      s21_data <= s20_data;
    end
  end
  always @(posedge clk) begin
    if (rst) begin
      s21_valid <= 1'b0;
    end else if (ce) begin
      s21_valid <= s20_valid;
    end
  end

  assign out_valid = s21_valid;
  assign out_data = s21_data;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
