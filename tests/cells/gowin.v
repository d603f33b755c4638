// Cells of Gowin that Yosys ships without behaviour, after Gowin's "BSRAM & SSRAM User Guide" (UG285) and "DSP User Guide" (UG287): what Yosys makes
// of the emitted text, and nothing else; other settings end the simulation. Compiled with block_memory.v. With OLD_NAMES the memories have the
// names and pins that Yosys before 0.43 gives them. An address counts bits; of words of two or four bytes its lowest bits say which are written.

// The 64 parameters of a memory's initial values, and all of them as one.
`define INITS(BITS) \
  parameter [BITS-1:0] \
    INIT_RAM_00 = 0, INIT_RAM_01 = 0, INIT_RAM_02 = 0, INIT_RAM_03 = 0, \
    INIT_RAM_04 = 0, INIT_RAM_05 = 0, INIT_RAM_06 = 0, INIT_RAM_07 = 0, \
    INIT_RAM_08 = 0, INIT_RAM_09 = 0, INIT_RAM_0A = 0, INIT_RAM_0B = 0, \
    INIT_RAM_0C = 0, INIT_RAM_0D = 0, INIT_RAM_0E = 0, INIT_RAM_0F = 0, \
    INIT_RAM_10 = 0, INIT_RAM_11 = 0, INIT_RAM_12 = 0, INIT_RAM_13 = 0, \
    INIT_RAM_14 = 0, INIT_RAM_15 = 0, INIT_RAM_16 = 0, INIT_RAM_17 = 0, \
    INIT_RAM_18 = 0, INIT_RAM_19 = 0, INIT_RAM_1A = 0, INIT_RAM_1B = 0, \
    INIT_RAM_1C = 0, INIT_RAM_1D = 0, INIT_RAM_1E = 0, INIT_RAM_1F = 0, \
    INIT_RAM_20 = 0, INIT_RAM_21 = 0, INIT_RAM_22 = 0, INIT_RAM_23 = 0, \
    INIT_RAM_24 = 0, INIT_RAM_25 = 0, INIT_RAM_26 = 0, INIT_RAM_27 = 0, \
    INIT_RAM_28 = 0, INIT_RAM_29 = 0, INIT_RAM_2A = 0, INIT_RAM_2B = 0, \
    INIT_RAM_2C = 0, INIT_RAM_2D = 0, INIT_RAM_2E = 0, INIT_RAM_2F = 0, \
    INIT_RAM_30 = 0, INIT_RAM_31 = 0, INIT_RAM_32 = 0, INIT_RAM_33 = 0, \
    INIT_RAM_34 = 0, INIT_RAM_35 = 0, INIT_RAM_36 = 0, INIT_RAM_37 = 0, \
    INIT_RAM_38 = 0, INIT_RAM_39 = 0, INIT_RAM_3A = 0, INIT_RAM_3B = 0, \
    INIT_RAM_3C = 0, INIT_RAM_3D = 0, INIT_RAM_3E = 0, INIT_RAM_3F = 0;
`define INIT_ALL { \
    INIT_RAM_3F, INIT_RAM_3E, INIT_RAM_3D, INIT_RAM_3C, INIT_RAM_3B, INIT_RAM_3A, INIT_RAM_39, INIT_RAM_38, \
    INIT_RAM_37, INIT_RAM_36, INIT_RAM_35, INIT_RAM_34, INIT_RAM_33, INIT_RAM_32, INIT_RAM_31, INIT_RAM_30, \
    INIT_RAM_2F, INIT_RAM_2E, INIT_RAM_2D, INIT_RAM_2C, INIT_RAM_2B, INIT_RAM_2A, INIT_RAM_29, INIT_RAM_28, \
    INIT_RAM_27, INIT_RAM_26, INIT_RAM_25, INIT_RAM_24, INIT_RAM_23, INIT_RAM_22, INIT_RAM_21, INIT_RAM_20, \
    INIT_RAM_1F, INIT_RAM_1E, INIT_RAM_1D, INIT_RAM_1C, INIT_RAM_1B, INIT_RAM_1A, INIT_RAM_19, INIT_RAM_18, \
    INIT_RAM_17, INIT_RAM_16, INIT_RAM_15, INIT_RAM_14, INIT_RAM_13, INIT_RAM_12, INIT_RAM_11, INIT_RAM_10, \
    INIT_RAM_0F, INIT_RAM_0E, INIT_RAM_0D, INIT_RAM_0C, INIT_RAM_0B, INIT_RAM_0A, INIT_RAM_09, INIT_RAM_08, \
    INIT_RAM_07, INIT_RAM_06, INIT_RAM_05, INIT_RAM_04, INIT_RAM_03, INIT_RAM_02, INIT_RAM_01, INIT_RAM_00 }

// One port that writes (A), one that reads (B).
`ifdef OLD_NAMES
module SDP (
  input CLKA, CEA, CLKB, CEB, OCE, RESETA, RESETB, WREA, WREB,
  input [2:0] BLKSEL,
`else
module SDPB (
  input CLKA, CEA, CLKB, CEB, OCE, RESETA, RESETB,
  input [2:0] BLKSELA, BLKSELB,
`endif
  input [13:0] ADA, ADB,
  input [31:0] DI,
  output [31:0] DO
);
  parameter READ_MODE = 1'b0, RESET_MODE = "SYNC";
  parameter integer BIT_WIDTH_0 = 32, BIT_WIDTH_1 = 32;
  parameter [2:0] BLK_SEL = 0, BLK_SEL_0 = 0, BLK_SEL_1 = 0;
  `INITS(256)
  initial if (READ_MODE != 0) begin
    $display("SDP: a setting that has no model");
    $finish;
  end
  always @(RESETB) if (RESET_MODE != "SYNC" && (RESETB !== 0)) begin
    $display("SDP: a reset that has no model");
    $finish;
  end
`ifdef OLD_NAMES
  wire writes = CEA && WREA && BLKSEL == BLK_SEL;
  wire reads = CEB && BLKSEL == BLK_SEL;
`else
  wire writes = CEA && BLKSELA == BLK_SEL_0;
  wire reads = CEB && BLKSELB == BLK_SEL_1;
`endif
  wire [71:0] word;
  assign DO = word[31:0];
  block_memory #(
    .BYTE(8), .WIDTH_A(BIT_WIDTH_0), .WIDTH_B(BIT_WIDTH_1), .INIT(`INIT_ALL)
  ) u_memory (
    .clk_a(CLKA), .en_a(writes), .rst_a(1'b0), .we_a({4'b0, BIT_WIDTH_0 >= 32 ? ADA[3:0] : BIT_WIDTH_0 >= 16 ? {2'b0, ADA[1:0]} : 4'b1}),
    .ad_a({1'b0, ADA}), .di_a({40'b0, DI}), .do_a(),
    .clk_b(CLKB), .en_b(reads), .rst_b(RESETB), .we_b(8'b0), .ad_b({1'b0, ADB}), .di_b(72'b0), .do_b(word)
  );
endmodule

// One port that writes (A), one that reads (B).
`ifdef OLD_NAMES
module SDPX9 (
  input CLKA, CEA, CLKB, CEB, OCE, RESETA, RESETB, WREA, WREB,
  input [2:0] BLKSEL,
`else
module SDPX9B (
  input CLKA, CEA, CLKB, CEB, OCE, RESETA, RESETB,
  input [2:0] BLKSELA, BLKSELB,
`endif
  input [13:0] ADA, ADB,
  input [35:0] DI,
  output [35:0] DO
);
  parameter READ_MODE = 1'b0, RESET_MODE = "SYNC";
  parameter integer BIT_WIDTH_0 = 36, BIT_WIDTH_1 = 36;
  parameter [2:0] BLK_SEL = 0, BLK_SEL_0 = 0, BLK_SEL_1 = 0;
  `INITS(288)
  initial if (READ_MODE != 0) begin
    $display("SDPX9: a setting that has no model");
    $finish;
  end
  always @(RESETB) if (RESET_MODE != "SYNC" && (RESETB !== 0)) begin
    $display("SDPX9: a reset that has no model");
    $finish;
  end
`ifdef OLD_NAMES
  wire writes = CEA && WREA && BLKSEL == BLK_SEL;
  wire reads = CEB && BLKSEL == BLK_SEL;
`else
  wire writes = CEA && BLKSELA == BLK_SEL_0;
  wire reads = CEB && BLKSELB == BLK_SEL_1;
`endif
  wire [71:0] word;
  assign DO = word[35:0];
  block_memory #(
    .BYTE(9), .WIDTH_A(BIT_WIDTH_0), .WIDTH_B(BIT_WIDTH_1), .INIT(`INIT_ALL)
  ) u_memory (
    .clk_a(CLKA), .en_a(writes), .rst_a(1'b0), .we_a({4'b0, BIT_WIDTH_0 >= 36 ? ADA[3:0] : BIT_WIDTH_0 >= 18 ? {2'b0, ADA[1:0]} : 4'b1}),
    .ad_a({1'b0, ADA}), .di_a({36'b0, DI}), .do_a(),
    .clk_b(CLKB), .en_b(reads), .rst_b(RESETB), .we_b(8'b0), .ad_b({1'b0, ADB}), .di_b(72'b0), .do_b(word)
  );
endmodule

// Two ports. What a port reads as it writes: nothing (0), the new word (1), the old one (2).
`ifdef OLD_NAMES
module DP (
  input [2:0] BLKSEL,
`else
module DPB (
  input [2:0] BLKSELA, BLKSELB,
`endif
  input CLKA, CEA, OCEA, RESETA, WREA, CLKB, CEB, OCEB, RESETB, WREB,
  input [13:0] ADA, ADB,
  input [15:0] DIA, DIB,
  output [15:0] DOA, DOB
);
  parameter READ_MODE0 = 1'b0, READ_MODE1 = 1'b0, RESET_MODE = "SYNC";
  parameter integer BIT_WIDTH_0 = 16, BIT_WIDTH_1 = 16, WRITE_MODE0 = 0, WRITE_MODE1 = 0;
  parameter [2:0] BLK_SEL = 0, BLK_SEL_0 = 0, BLK_SEL_1 = 0;
  `INITS(256)
  initial if (READ_MODE0 != 0 || READ_MODE1 != 0) begin
    $display("DP: a setting that has no model");
    $finish;
  end
  always @(RESETA or RESETB) if (RESET_MODE != "SYNC" && (RESETA !== 0 || RESETB !== 0)) begin
    $display("DP: a reset that has no model");
    $finish;
  end
`ifdef OLD_NAMES
  wire [1:0] chosen = {BLKSEL == BLK_SEL, BLKSEL == BLK_SEL};
`else
  wire [1:0] chosen = {BLKSELB == BLK_SEL_1, BLKSELA == BLK_SEL_0};
`endif
  wire [71:0] word_a, word_b;
  assign DOA = word_a[15:0];
  assign DOB = word_b[15:0];
  block_memory #(
    .BYTE(8), .WIDTH_A(BIT_WIDTH_0), .WIDTH_B(BIT_WIDTH_1), .MODE_A(WRITE_MODE0), .MODE_B(WRITE_MODE1), .INIT(`INIT_ALL)
  ) u_memory (
    .clk_a(CLKA), .en_a(CEA && chosen[0]), .rst_a(RESETA), .we_a(WREA ? {6'b0, BIT_WIDTH_0 >= 16 ? ADA[1:0] : 2'b1} : 8'b0),
    .ad_a({1'b0, ADA}), .di_a({56'b0, DIA}), .do_a(word_a),
    .clk_b(CLKB), .en_b(CEB && chosen[1]), .rst_b(RESETB), .we_b(WREB ? {6'b0, BIT_WIDTH_1 >= 16 ? ADB[1:0] : 2'b1} : 8'b0),
    .ad_b({1'b0, ADB}), .di_b({56'b0, DIB}), .do_b(word_b)
  );
endmodule

// Two ports. What a port reads as it writes: nothing (0), the new word (1), the old one (2).
`ifdef OLD_NAMES
module DPX9 (
  input [2:0] BLKSEL,
`else
module DPX9B (
  input [2:0] BLKSELA, BLKSELB,
`endif
  input CLKA, CEA, OCEA, RESETA, WREA, CLKB, CEB, OCEB, RESETB, WREB,
  input [13:0] ADA, ADB,
  input [17:0] DIA, DIB,
  output [17:0] DOA, DOB
);
  parameter READ_MODE0 = 1'b0, READ_MODE1 = 1'b0, RESET_MODE = "SYNC";
  parameter integer BIT_WIDTH_0 = 18, BIT_WIDTH_1 = 18, WRITE_MODE0 = 0, WRITE_MODE1 = 0;
  parameter [2:0] BLK_SEL = 0, BLK_SEL_0 = 0, BLK_SEL_1 = 0;
  `INITS(288)
  initial if (READ_MODE0 != 0 || READ_MODE1 != 0) begin
    $display("DPX9: a setting that has no model");
    $finish;
  end
  always @(RESETA or RESETB) if (RESET_MODE != "SYNC" && (RESETA !== 0 || RESETB !== 0)) begin
    $display("DPX9: a reset that has no model");
    $finish;
  end
`ifdef OLD_NAMES
  wire [1:0] chosen = {BLKSEL == BLK_SEL, BLKSEL == BLK_SEL};
`else
  wire [1:0] chosen = {BLKSELB == BLK_SEL_1, BLKSELA == BLK_SEL_0};
`endif
  wire [71:0] word_a, word_b;
  assign DOA = word_a[17:0];
  assign DOB = word_b[17:0];
  block_memory #(
    .BYTE(9), .WIDTH_A(BIT_WIDTH_0), .WIDTH_B(BIT_WIDTH_1), .MODE_A(WRITE_MODE0), .MODE_B(WRITE_MODE1), .INIT(`INIT_ALL)
  ) u_memory (
    .clk_a(CLKA), .en_a(CEA && chosen[0]), .rst_a(RESETA), .we_a(WREA ? {6'b0, BIT_WIDTH_0 >= 18 ? ADA[1:0] : 2'b1} : 8'b0),
    .ad_a({1'b0, ADA}), .di_a({54'b0, DIA}), .do_a(word_a),
    .clk_b(CLKB), .en_b(CEB && chosen[1]), .rst_b(RESETB), .we_b(WREB ? {6'b0, BIT_WIDTH_1 >= 18 ? ADB[1:0] : 2'b1} : 8'b0),
    .ad_b({1'b0, ADB}), .di_b({54'b0, DIB}), .do_b(word_b)
  );
endmodule

// Products, each side with a sign or without; their registers are not used.
module MULT9X9 (
  input [8:0] A, B, SIA, SIB,
  input ASIGN, BSIGN, ASEL, BSEL, CE, CLK, RESET,
  output [17:0] DOUT
);
  parameter AREG = 1'b0, BREG = 1'b0, PIPE_REG = 1'b0, ASIGN_REG = 1'b0, BSIGN_REG = 1'b0;
  initial if (AREG || BREG || PIPE_REG || ASIGN_REG || BSIGN_REG) begin
    $display("MULT9X9: a setting that has no model");
    $finish;
  end
  wire signed [9:0] wide_a = {ASIGN & A[8], A};
  wire signed [9:0] wide_b = {BSIGN & B[8], B};
  wire signed [19:0] product = wide_a * wide_b;
  assign DOUT = product[17:0];
endmodule

module MULT18X18 (
  input [17:0] A, B, SIA, SIB,
  input ASIGN, BSIGN, ASEL, BSEL, CE, CLK, RESET,
  output [35:0] DOUT
);
  parameter AREG = 1'b0, BREG = 1'b0, PIPE_REG = 1'b0, ASIGN_REG = 1'b0, BSIGN_REG = 1'b0;
  initial if (AREG || BREG || PIPE_REG || ASIGN_REG || BSIGN_REG) begin
    $display("MULT18X18: a setting that has no model");
    $finish;
  end
  wire signed [18:0] wide_a = {ASIGN & A[17], A};
  wire signed [18:0] wide_b = {BSIGN & B[17], B};
  wire signed [37:0] product = wide_a * wide_b;
  assign DOUT = product[35:0];
endmodule

module MULT36X36 (
  input [35:0] A, B,
  input ASIGN, BSIGN, CE, CLK, RESET,
  output [71:0] DOUT
);
  parameter AREG = 1'b0, BREG = 1'b0, PIPE_REG = 1'b0, ASIGN_REG = 1'b0, BSIGN_REG = 1'b0;
  initial if (AREG || BREG || PIPE_REG || ASIGN_REG || BSIGN_REG) begin
    $display("MULT36X36: a setting that has no model");
    $finish;
  end
  wire signed [36:0] wide_a = {ASIGN & A[35], A};
  wire signed [36:0] wide_b = {BSIGN & B[35], B};
  wire signed [73:0] product = wide_a * wide_b;
  assign DOUT = product[71:0];
endmodule
