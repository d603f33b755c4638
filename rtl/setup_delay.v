// setup_delay: a word and its valid bit, delayed beside a pipeline
// Source     src/units/traversal/stream_delay.rs (emitted: do not edit)
// Config     float 7/16, levels 8, heights 8 bits, start level, 2 down, up selective; clocks add 2
//            mul 1 div 2 compare 1 from_int 1 to_int 1
// Latency    3 clocks
// Throughput one result per clock
`default_nettype none
module setup_delay #(
  parameter integer W = 8   // bits of the word
) (
  input  wire         clk,        // rising edge
  input  wire         ce,         // clock enable: registers hold while 0
  input  wire         rst,        // synchronous, active high; clears valid bits and counts, no data
  input  wire         in_valid,   // the word counts
  output wire         out_valid,  // the delayed word counts
  input  wire [W-1:0] in_data,    // the word [bits]
  output wire [W-1:0] out_data    // the delayed word [bits]
);

  // Illegal parameters end elaboration here: the missing module's name says what must hold.
  generate
    if (1 > W) begin : gen_illegal_0
      must_hold_1_at_most_W u_illegal ();
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

  assign out_valid = s3_valid;
  assign out_data = s3_data;
endmodule
`default_nettype wire
