// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_height_banks: on-chip memory in banks, with a write port and two registers a read
// Emitted    by reliefrtl as its unit height_banks; do not edit
// Latency    2 clocks
// Throughput one result per clock
// Note       Preloaded by MEM_INIT, it is one array with two registers: what it does is the same.
// Note       A read of the word that is being written gives any word, in a simulation the old one.
//            Written for block RAM inference.
`default_nettype none
module relief_height_banks #(
  parameter integer ADDR_W = 17,     // address bits
  parameter integer DATA_W = 8,      // bits of a word
  parameter integer DEPTH  = 87381,  // words
  parameter integer BANK_W = 13,     // address bits of a bank
  // file for $readmemh with all words, the first one's first; "": unknown at power-up
  parameter MEM_INIT = ""
) (
  input  wire              clk,         // rising edge
  input  wire              write_en,    // write at the next edge
  input  wire [ADDR_W-1:0] write_addr,  // where [words]
  input  wire [DATA_W-1:0] write_data,  // what [bits]
  input  wire [ADDR_W-1:0] read_addr,   // where to read [words]
  output wire [DATA_W-1:0] read_data    // the word read, two clocks after its address [bits]
);

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (ADDR_W < 2) begin : gen_illegal_0 ADDR_W_must_be_at_least_2 u_illegal (); end
    if (DATA_W < 1) begin : gen_illegal_1 DATA_W_must_be_at_least_1 u_illegal (); end
    if (DEPTH < 1) begin : gen_illegal_2 DEPTH_must_be_at_least_1 u_illegal (); end
    if (BANK_W < 1) begin : gen_illegal_3 BANK_W_must_be_at_least_1 u_illegal (); end
    if (DEPTH > (1 << ADDR_W)) begin : gen_illegal_4
      DEPTH_must_be_at_most_2_to_the_ADDR_W u_illegal ();
    end
  endgenerate

  // address bits inside a bank
  localparam integer WordW = (BANK_W < ADDR_W) ? BANK_W : (ADDR_W - 1);
  // banks, the last one not always full
  localparam integer BankCount = (DEPTH + (1 << WordW) - 1) >> WordW;

  genvar g;
  generate
    if (MEM_INIT != "") begin : gen_preload
      // One file initializes one array; the synthesizer divides it among block memories.
      // Reading the address that is being written is don't-care: no bypass logic.
      (* no_rw_check *)
      reg [DATA_W-1:0] mem [0:DEPTH-1];
      reg [DATA_W-1:0] read_q;
      reg [DATA_W-1:0] out_q;
      initial $readmemh(MEM_INIT, mem);
      always @(posedge clk) begin
        if (write_en) mem[write_addr] <= write_data;
        read_q <= mem[read_addr];
        out_q  <= read_q;
      end
      assign read_data = out_q;
    end else begin : gen_banks
      // Every bank is read. The bank select is decoded beside the read, one-hot, so that the output
      // multiplexer after the registers is one AND-OR.
      for (g = 0; g < BankCount; g = g + 1) begin : gen_bank
        localparam integer Index = g;  // number of the bank
        // Reading the address that is being written is don't-care: no bypass logic.
        (* no_rw_check *)
        reg  [DATA_W-1:0] mem [0:(1<<WordW)-1];
        reg  [DATA_W-1:0] read_q;
        reg  [DATA_W-1:0] out_q;
        reg               select_q;
        reg               select_out_q;
        wire [DATA_W-1:0] lower;
        wire [DATA_W-1:0] merged = lower | ({DATA_W{select_out_q}} & out_q);
        wire              written = write_addr[ADDR_W-1:WordW] == Index[ADDR_W-1-WordW:0];
        always @(posedge clk) begin
          if (write_en && written) mem[write_addr[WordW-1:0]] <= write_data;
          read_q      <= mem[read_addr[WordW-1:0]];
          out_q       <= read_q;
          select_q     <= read_addr[ADDR_W-1:WordW] == Index[ADDR_W-1-WordW:0];
          select_out_q <= select_q;
        end
        if (g == 0) begin : gen_first
          assign lower = {DATA_W{1'b0}};
        end else begin : gen_later
          assign lower = gen_bank[g-1].merged;
        end
        if (g == BankCount - 1) begin : gen_last
          assign read_data = merged;
        end
      end
    end
  endgenerate
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
