// The memory inside the block memories of every vendor: what their models beside it have in common. Two ports read and write words of WIDTH_A and
// WIDTH_B bits: 1, 2, 4, or 1 to 8 bytes. An address counts bits as if a byte had 8; it may have 9 (parity), which words below a byte leave out.
// A port's output holds while the port is disabled or reads nothing; the reset of an output needs no enable.
//
// Stricter than any vendor: without initial values (or with zeros alone) the memory starts unknown, and what a port reads of a byte that the other
// port writes at the same time is unknown, unless OLD says that the vendor promises the old one.
module block_memory #(
  parameter integer BYTE = 9,
  parameter integer BYTES = 2048,
  parameter integer WIDTH_A = 9,
  parameter integer WIDTH_B = 9,
  // What a port reads as it writes: nothing (0), the new word (1), the old one (2).
  parameter integer MODE_A = 0,
  parameter integer MODE_B = 0,
  parameter integer OLD = 0,
  parameter [BYTE*BYTES-1:0] INIT = 0,
  parameter [71:0] START = 0,
  parameter [71:0] CLEARED = 0
) (
  input clk_a, en_a, rst_a,
  input [7:0] we_a,
  input [14:0] ad_a,
  input [71:0] di_a,
  output reg [71:0] do_a,
  input clk_b, en_b, rst_b,
  input [7:0] we_b,
  input [14:0] ad_b,
  input [71:0] di_b,
  output reg [71:0] do_b
);
  reg [BYTE-1:0] mem [0:BYTES-1];
  // In rows of 32 bytes: simulators copy a value as a whole to take a part of it.
  localparam KNOWN = |INIT;
  reg [32*BYTE-1:0] row;
  integer i;
  initial begin
    for (i = 0; i < BYTES; i = i + 1) begin
      if (i % 32 == 0) row = KNOWN ? INIT[BYTE*i+:32*BYTE] : {32*BYTE{1'bx}};
      mem[i] = row[BYTE*(i%32)+:BYTE];
    end
    do_a = START;
    do_b = START;
  end

  // Bytes of a word, and the first of them.
  localparam integer BYTES_A = WIDTH_A < BYTE ? 1 : WIDTH_A / BYTE;
  localparam integer BYTES_B = WIDTH_B < BYTE ? 1 : WIDTH_B / BYTE;
  wire [11:0] at_a = ad_a[14:3] & ~(BYTES_A - 1);
  wire [11:0] at_b = ad_b[14:3] & ~(BYTES_B - 1);
  // Of a word below a byte the first bit.
  wire [2:0] bit_a = ad_a[2:0] & ~(WIDTH_A - 1);
  wire [2:0] bit_b = ad_b[2:0] & ~(WIDTH_B - 1);
  function [71:0] word(input integer width, input integer bytes, input [11:0] at, input [2:0] low);
    integer k;
    begin
      word = 0;
      if (width < BYTE) word[BYTE-1:0] = mem[at] >> low;
      else for (k = 0; k < bytes; k = k + 1) word[BYTE*k+:BYTE] = mem[at + k];
    end
  endfunction
  task put(input integer width, input integer bytes, input [11:0] at, input [2:0] low, input [7:0] we, input [71:0] data);
    integer k;
    if (width < BYTE) begin
      for (k = 0; k < width; k = k + 1) if (we[0]) mem[at][low + k] = data[k];
    end else begin
      for (k = 0; k < bytes; k = k + 1) if (we[k]) mem[at + k] = data[BYTE*k+:BYTE];
    end
  endtask
  // A word without the bytes that the other port writes, which start at `there`.
  function [71:0] safe(input [71:0] data, input integer bytes, input [11:0] at, input [11:0] there, input [7:0] we);
    integer k;
    begin
      safe = data;
      if (OLD == 0 && we !== 0)
        for (k = 0; k < bytes; k = k + 1)
          if (at + k >= there && at + k < there + 8 && we[at + k - there] !== 0) safe[BYTE*k+:BYTE] = {BYTE{1'bx}};
    end
  endfunction

  // What a port writes at this time.
  reg [7:0] busy_a = 0;
  reg [7:0] busy_b = 0;
  reg [71:0] old_a;
  reg [71:0] old_b;
  always @(posedge clk_a) if (en_a || rst_a) begin
    old_a = word(WIDTH_A, BYTES_A, at_a, bit_a);
    // Both ports read before either writes, and both know of the other's write before they give what they read.
    #0;
    if (en_a && we_a !== 0) begin
      put(WIDTH_A, BYTES_A, at_a, bit_a, we_a, di_a);
      busy_a = we_a & ~(8'hff << BYTES_A);
    end
    #0;
    if (rst_a) do_a <= CLEARED;
    else if (we_a == 0 || MODE_A == 2) do_a <= safe(old_a, BYTES_A, at_a, at_b, busy_b);
    else if (MODE_A == 1) do_a <= safe(word(WIDTH_A, BYTES_A, at_a, bit_a), BYTES_A, at_a, at_b, busy_b);
    #1 busy_a = 0;
  end
  always @(posedge clk_b) if (en_b || rst_b) begin
    old_b = word(WIDTH_B, BYTES_B, at_b, bit_b);
    #0;
    if (en_b && we_b !== 0) begin
      put(WIDTH_B, BYTES_B, at_b, bit_b, we_b, di_b);
      busy_b = we_b & ~(8'hff << BYTES_B);
    end
    #0;
    if (rst_b) do_b <= CLEARED;
    else if (we_b == 0 || MODE_B == 2) do_b <= safe(old_b, BYTES_B, at_b, at_a, busy_a);
    else if (MODE_B == 1) do_b <= safe(word(WIDTH_B, BYTES_B, at_b, bit_b), BYTES_B, at_b, at_a, busy_a);
    #1 busy_b = 0;
  end
endmodule
