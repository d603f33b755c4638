// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_hit_valid_delay: a valid bit, delayed beside a pipeline
// Source     src/units/traversal/stream_delay.rs (emitted: do not edit)
// Latency    7 clocks
// Throughput one result per clock
`default_nettype none
module relief_hit_valid_delay #(
  parameter integer LATENCY = 7,  // clocks that it was generated for
  parameter integer VARIANT = 32'h6f836e41  // digest of what is no parameter
) (
  input  wire  clk,        // rising edge
  input  wire  ce,         // clock enable: registers hold while 0
  input  wire  rst,        // synchronous, active high; clears valid bits and counts, no data
  input  wire  in_valid,   // the word counts
  output wire  out_valid   // the delayed word counts
);

  // Parameter checks: an illegal value ends elaboration, the missing module names the rule.
  generate
    if (LATENCY != 7) begin : gen_other_latency
      relief_hit_valid_delay_has_LATENCY_7_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h6f836e41) begin : gen_other_variant
      relief_hit_valid_delay_has_VARIANT_6f836e41_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 1: registers --------------------------------------------- stream_delay.rs
  reg s1_valid;
  always @(posedge clk) begin
    if (rst) begin
      s1_valid <= 1'b0;
    end else if (ce) begin
      s1_valid <= in_valid;
    end
  end

  // ---- stage 2: registers --------------------------------------------- stream_delay.rs
  reg s2_valid;
  always @(posedge clk) begin
    if (rst) begin
      s2_valid <= 1'b0;
    end else if (ce) begin
      s2_valid <= s1_valid;
    end
  end

  // ---- stage 3: registers --------------------------------------------- stream_delay.rs
  reg s3_valid;
  always @(posedge clk) begin
    if (rst) begin
      s3_valid <= 1'b0;
    end else if (ce) begin
      s3_valid <= s2_valid;
    end
  end

  // ---- stage 4: registers --------------------------------------------- stream_delay.rs
  reg s4_valid;
  always @(posedge clk) begin
    if (rst) begin
      s4_valid <= 1'b0;
    end else if (ce) begin
      s4_valid <= s3_valid;
    end
  end

  // ---- stage 5: registers --------------------------------------------- stream_delay.rs
  reg s5_valid;
  always @(posedge clk) begin
    if (rst) begin
      s5_valid <= 1'b0;
    end else if (ce) begin
      s5_valid <= s4_valid;
    end
  end

  // ---- stage 6: registers --------------------------------------------- stream_delay.rs
  reg s6_valid;
  always @(posedge clk) begin
    if (rst) begin
      s6_valid <= 1'b0;
    end else if (ce) begin
      s6_valid <= s5_valid;
    end
  end

  // ---- stage 7: registers --------------------------------------------- stream_delay.rs
  reg s7_valid;
  always @(posedge clk) begin
    if (rst) begin
      s7_valid <= 1'b0;
    end else if (ce) begin
      s7_valid <= s6_valid;
    end
  end

  assign out_valid = s7_valid;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
