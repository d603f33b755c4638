// height_memory: on-chip memory with a write port and a registered read
// Source     src/units/traversal/height_memory.rs (emitted: do not edit)
// Config     float 7/16, levels 8, heights 8 bits, start level, 2 down, up selective; clocks add 2
//            mul 1 div 2 compare 1 from_int 1 to_int 1
// Latency    1 clock
// Throughput one result per clock
// Note       A read of the word that is being written gives the old word. Written for block RAM
//            inference.
`default_nettype none
module height_memory #(
  parameter integer ADDR_W = 17,     // address bits
  parameter integer DATA_W = 8,      // bits of a word
  parameter integer DEPTH  = 87381   // words
) (
  input  wire              clk,         // rising edge
  input  wire              write_en,    // write at the next edge
  input  wire [ADDR_W-1:0] write_addr,  // where [words]
  input  wire [DATA_W-1:0] write_data,  // what [bits]
  input  wire [ADDR_W-1:0] read_addr,   // where to read [words]
  output wire [DATA_W-1:0] read_data    // the word, one clock later [bits]
);

  // Illegal parameters end elaboration here: the missing module's name says what must hold.
  generate
    if (1 > ADDR_W) begin : gen_illegal_0
      must_hold_1_at_most_ADDR_W u_illegal ();
    end
    if (1 > DATA_W) begin : gen_illegal_1
      must_hold_1_at_most_DATA_W u_illegal ();
    end
    if (1 > DEPTH) begin : gen_illegal_2
      must_hold_1_at_most_DEPTH u_illegal ();
    end
    if (DEPTH > (1 << ADDR_W)) begin : gen_illegal_3
      must_hold_DEPTH_at_most_2_to_the_ADDR_W u_illegal ();
    end
  endgenerate

  reg [DATA_W-1:0] mem [0:DEPTH-1];
  reg [DATA_W-1:0] read_q;

  always @(posedge clk) begin
    if (write_en) mem[write_addr] <= write_data;
    read_q <= mem[read_addr];
  end

  assign read_data = read_q;
endmodule
`default_nettype wire
