// As gowin.v, under the names that newer Yosys use, and the multipliers ("DSP User Guide", UG287): their registers are not used.

module SDPB (
  input CLKA, CEA, CLKB, CEB, OCE, RESETA, RESETB,
  input [2:0] BLKSELA, BLKSELB,
  input [13:0] ADA, ADB,
  input [31:0] DI,
  output [31:0] DO
);
  parameter READ_MODE = 1'b0, RESET_MODE = "SYNC";
  parameter integer BIT_WIDTH_0 = 32, BIT_WIDTH_1 = 32;
  parameter [2:0] BLK_SEL_0 = 0, BLK_SEL_1 = 0;
  parameter [255:0] INIT_RAM_00 = 0, INIT_RAM_01 = 0, INIT_RAM_02 = 0, INIT_RAM_03 = 0;
  parameter [255:0] INIT_RAM_04 = 0, INIT_RAM_05 = 0, INIT_RAM_06 = 0, INIT_RAM_07 = 0;
  parameter [255:0] INIT_RAM_08 = 0, INIT_RAM_09 = 0, INIT_RAM_0A = 0, INIT_RAM_0B = 0;
  parameter [255:0] INIT_RAM_0C = 0, INIT_RAM_0D = 0, INIT_RAM_0E = 0, INIT_RAM_0F = 0;
  parameter [255:0] INIT_RAM_10 = 0, INIT_RAM_11 = 0, INIT_RAM_12 = 0, INIT_RAM_13 = 0;
  parameter [255:0] INIT_RAM_14 = 0, INIT_RAM_15 = 0, INIT_RAM_16 = 0, INIT_RAM_17 = 0;
  parameter [255:0] INIT_RAM_18 = 0, INIT_RAM_19 = 0, INIT_RAM_1A = 0, INIT_RAM_1B = 0;
  parameter [255:0] INIT_RAM_1C = 0, INIT_RAM_1D = 0, INIT_RAM_1E = 0, INIT_RAM_1F = 0;
  parameter [255:0] INIT_RAM_20 = 0, INIT_RAM_21 = 0, INIT_RAM_22 = 0, INIT_RAM_23 = 0;
  parameter [255:0] INIT_RAM_24 = 0, INIT_RAM_25 = 0, INIT_RAM_26 = 0, INIT_RAM_27 = 0;
  parameter [255:0] INIT_RAM_28 = 0, INIT_RAM_29 = 0, INIT_RAM_2A = 0, INIT_RAM_2B = 0;
  parameter [255:0] INIT_RAM_2C = 0, INIT_RAM_2D = 0, INIT_RAM_2E = 0, INIT_RAM_2F = 0;
  parameter [255:0] INIT_RAM_30 = 0, INIT_RAM_31 = 0, INIT_RAM_32 = 0, INIT_RAM_33 = 0;
  parameter [255:0] INIT_RAM_34 = 0, INIT_RAM_35 = 0, INIT_RAM_36 = 0, INIT_RAM_37 = 0;
  parameter [255:0] INIT_RAM_38 = 0, INIT_RAM_39 = 0, INIT_RAM_3A = 0, INIT_RAM_3B = 0;
  parameter [255:0] INIT_RAM_3C = 0, INIT_RAM_3D = 0, INIT_RAM_3E = 0, INIT_RAM_3F = 0;
  wire [64*256-1:0] init = {
    INIT_RAM_3F, INIT_RAM_3E, INIT_RAM_3D, INIT_RAM_3C, INIT_RAM_3B, INIT_RAM_3A, INIT_RAM_39, INIT_RAM_38,
    INIT_RAM_37, INIT_RAM_36, INIT_RAM_35, INIT_RAM_34, INIT_RAM_33, INIT_RAM_32, INIT_RAM_31, INIT_RAM_30,
    INIT_RAM_2F, INIT_RAM_2E, INIT_RAM_2D, INIT_RAM_2C, INIT_RAM_2B, INIT_RAM_2A, INIT_RAM_29, INIT_RAM_28,
    INIT_RAM_27, INIT_RAM_26, INIT_RAM_25, INIT_RAM_24, INIT_RAM_23, INIT_RAM_22, INIT_RAM_21, INIT_RAM_20,
    INIT_RAM_1F, INIT_RAM_1E, INIT_RAM_1D, INIT_RAM_1C, INIT_RAM_1B, INIT_RAM_1A, INIT_RAM_19, INIT_RAM_18,
    INIT_RAM_17, INIT_RAM_16, INIT_RAM_15, INIT_RAM_14, INIT_RAM_13, INIT_RAM_12, INIT_RAM_11, INIT_RAM_10,
    INIT_RAM_0F, INIT_RAM_0E, INIT_RAM_0D, INIT_RAM_0C, INIT_RAM_0B, INIT_RAM_0A, INIT_RAM_09, INIT_RAM_08,
    INIT_RAM_07, INIT_RAM_06, INIT_RAM_05, INIT_RAM_04, INIT_RAM_03, INIT_RAM_02, INIT_RAM_01, INIT_RAM_00
  };
  reg [7:0] mem [0:2047];
  integer k;
  initial begin
    for (k = 0; k < 2048; k = k + 1) mem[k] = |init ? init[8*k+:8] : 8'bx;
    if (READ_MODE != 0) begin
      $display("SDPB: a setting that has no model");
      $finish;
    end
  end
  reg [31:0] do_q = 0;
  assign DO = do_q;
  function [31:0] word(input integer width, input [13:0] at);
    case (width)
      1: word = mem[at[13:3]][1*at[2:0]+:1];
      2: word = mem[at[13:3]][2*at[2:1]+:2];
      4: word = mem[at[13:3]][4*at[2:2]+:4];
      8: word = mem[at[13:3]];
      16: word = {mem[{at[13:4], 1'b1}], mem[{at[13:4], 1'b0}]};
      default: word = {mem[{at[13:5], 2'd3}], mem[{at[13:5], 2'd2}], mem[{at[13:5], 2'd1}], mem[{at[13:5], 2'd0}]};
    endcase
  endfunction
  task put(input integer width, input [13:0] at, input [31:0] data);
    case (width)
      1: mem[at[13:3]][1*at[2:0]+:1] = data[0:0];
      2: mem[at[13:3]][2*at[2:1]+:2] = data[1:0];
      4: mem[at[13:3]][4*at[2:2]+:4] = data[3:0];
      8: mem[at[13:3]] = data[7:0];
      16: begin
        if (at[0]) mem[{at[13:4], 1'b0}] = data[7:0];
        if (at[1]) mem[{at[13:4], 1'b1}] = data[15:8];
      end
      default: begin
        if (at[0]) mem[{at[13:5], 2'd0}] = data[7:0];
        if (at[1]) mem[{at[13:5], 2'd1}] = data[15:8];
        if (at[2]) mem[{at[13:5], 2'd2}] = data[23:16];
        if (at[3]) mem[{at[13:5], 2'd3}] = data[31:24];
      end
    endcase
  endtask
  always @(posedge CLKA) if (CEA && BLKSELA == BLK_SEL_0) #0 put(BIT_WIDTH_0, ADA, DI);
  always @(posedge CLKB) if (RESETB) do_q <= 0;
    else if (CEB && BLKSELB == BLK_SEL_1) do_q <= word(BIT_WIDTH_1, ADB);
endmodule

module SDPX9B (
  input CLKA, CEA, CLKB, CEB, OCE, RESETA, RESETB,
  input [2:0] BLKSELA, BLKSELB,
  input [13:0] ADA, ADB,
  input [35:0] DI,
  output [35:0] DO
);
  parameter READ_MODE = 1'b0, RESET_MODE = "SYNC";
  parameter integer BIT_WIDTH_0 = 36, BIT_WIDTH_1 = 36;
  parameter [2:0] BLK_SEL_0 = 0, BLK_SEL_1 = 0;
  parameter [287:0] INIT_RAM_00 = 0, INIT_RAM_01 = 0, INIT_RAM_02 = 0, INIT_RAM_03 = 0;
  parameter [287:0] INIT_RAM_04 = 0, INIT_RAM_05 = 0, INIT_RAM_06 = 0, INIT_RAM_07 = 0;
  parameter [287:0] INIT_RAM_08 = 0, INIT_RAM_09 = 0, INIT_RAM_0A = 0, INIT_RAM_0B = 0;
  parameter [287:0] INIT_RAM_0C = 0, INIT_RAM_0D = 0, INIT_RAM_0E = 0, INIT_RAM_0F = 0;
  parameter [287:0] INIT_RAM_10 = 0, INIT_RAM_11 = 0, INIT_RAM_12 = 0, INIT_RAM_13 = 0;
  parameter [287:0] INIT_RAM_14 = 0, INIT_RAM_15 = 0, INIT_RAM_16 = 0, INIT_RAM_17 = 0;
  parameter [287:0] INIT_RAM_18 = 0, INIT_RAM_19 = 0, INIT_RAM_1A = 0, INIT_RAM_1B = 0;
  parameter [287:0] INIT_RAM_1C = 0, INIT_RAM_1D = 0, INIT_RAM_1E = 0, INIT_RAM_1F = 0;
  parameter [287:0] INIT_RAM_20 = 0, INIT_RAM_21 = 0, INIT_RAM_22 = 0, INIT_RAM_23 = 0;
  parameter [287:0] INIT_RAM_24 = 0, INIT_RAM_25 = 0, INIT_RAM_26 = 0, INIT_RAM_27 = 0;
  parameter [287:0] INIT_RAM_28 = 0, INIT_RAM_29 = 0, INIT_RAM_2A = 0, INIT_RAM_2B = 0;
  parameter [287:0] INIT_RAM_2C = 0, INIT_RAM_2D = 0, INIT_RAM_2E = 0, INIT_RAM_2F = 0;
  parameter [287:0] INIT_RAM_30 = 0, INIT_RAM_31 = 0, INIT_RAM_32 = 0, INIT_RAM_33 = 0;
  parameter [287:0] INIT_RAM_34 = 0, INIT_RAM_35 = 0, INIT_RAM_36 = 0, INIT_RAM_37 = 0;
  parameter [287:0] INIT_RAM_38 = 0, INIT_RAM_39 = 0, INIT_RAM_3A = 0, INIT_RAM_3B = 0;
  parameter [287:0] INIT_RAM_3C = 0, INIT_RAM_3D = 0, INIT_RAM_3E = 0, INIT_RAM_3F = 0;
  wire [64*288-1:0] init = {
    INIT_RAM_3F, INIT_RAM_3E, INIT_RAM_3D, INIT_RAM_3C, INIT_RAM_3B, INIT_RAM_3A, INIT_RAM_39, INIT_RAM_38,
    INIT_RAM_37, INIT_RAM_36, INIT_RAM_35, INIT_RAM_34, INIT_RAM_33, INIT_RAM_32, INIT_RAM_31, INIT_RAM_30,
    INIT_RAM_2F, INIT_RAM_2E, INIT_RAM_2D, INIT_RAM_2C, INIT_RAM_2B, INIT_RAM_2A, INIT_RAM_29, INIT_RAM_28,
    INIT_RAM_27, INIT_RAM_26, INIT_RAM_25, INIT_RAM_24, INIT_RAM_23, INIT_RAM_22, INIT_RAM_21, INIT_RAM_20,
    INIT_RAM_1F, INIT_RAM_1E, INIT_RAM_1D, INIT_RAM_1C, INIT_RAM_1B, INIT_RAM_1A, INIT_RAM_19, INIT_RAM_18,
    INIT_RAM_17, INIT_RAM_16, INIT_RAM_15, INIT_RAM_14, INIT_RAM_13, INIT_RAM_12, INIT_RAM_11, INIT_RAM_10,
    INIT_RAM_0F, INIT_RAM_0E, INIT_RAM_0D, INIT_RAM_0C, INIT_RAM_0B, INIT_RAM_0A, INIT_RAM_09, INIT_RAM_08,
    INIT_RAM_07, INIT_RAM_06, INIT_RAM_05, INIT_RAM_04, INIT_RAM_03, INIT_RAM_02, INIT_RAM_01, INIT_RAM_00
  };
  reg [8:0] mem [0:2047];
  integer k;
  initial begin
    for (k = 0; k < 2048; k = k + 1) mem[k] = |init ? init[9*k+:9] : 9'bx;
    if (READ_MODE != 0) begin
      $display("SDPX9B: a setting that has no model");
      $finish;
    end
  end
  reg [35:0] do_q = 0;
  assign DO = do_q;
  function [35:0] word(input integer width, input [13:0] at);
    case (width)
      9: word = mem[at[13:3]];
      18: word = {mem[{at[13:4], 1'b1}], mem[{at[13:4], 1'b0}]};
      default: word = {mem[{at[13:5], 2'd3}], mem[{at[13:5], 2'd2}], mem[{at[13:5], 2'd1}], mem[{at[13:5], 2'd0}]};
    endcase
  endfunction
  task put(input integer width, input [13:0] at, input [35:0] data);
    case (width)
      9: mem[at[13:3]] = data[8:0];
      18: begin
        if (at[0]) mem[{at[13:4], 1'b0}] = data[8:0];
        if (at[1]) mem[{at[13:4], 1'b1}] = data[17:9];
      end
      default: begin
        if (at[0]) mem[{at[13:5], 2'd0}] = data[8:0];
        if (at[1]) mem[{at[13:5], 2'd1}] = data[17:9];
        if (at[2]) mem[{at[13:5], 2'd2}] = data[26:18];
        if (at[3]) mem[{at[13:5], 2'd3}] = data[35:27];
      end
    endcase
  endtask
  always @(posedge CLKA) if (CEA && BLKSELA == BLK_SEL_0) #0 put(BIT_WIDTH_0, ADA, DI);
  always @(posedge CLKB) if (RESETB) do_q <= 0;
    else if (CEB && BLKSELB == BLK_SEL_1) do_q <= word(BIT_WIDTH_1, ADB);
endmodule

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

// A sum, difference or comparison of one bit: the carry goes on where the bit says so. Yosys ships its behaviour in a block that waits for a
// change, which constants never make.
module ALU (
  output SUM, COUT,
  input I0, I1, I3, CIN
);
  parameter integer ALU_MODE = 0;
  initial if (ALU_MODE > 5) begin
    $display("ALU: a setting that has no model");
    $finish;
  end
  wire subtracts = ALU_MODE == 1 || ALU_MODE == 3 || ALU_MODE == 4 || (ALU_MODE == 2 && !I3);
  wire s = ALU_MODE == 5 ? ~I0 ^ I1 : I0 ^ I1 ^ subtracts;
  wire c = ALU_MODE == 3 ? 1'b1 : ALU_MODE == 5 ? I1 : I0;
  assign SUM  = s ^ CIN;
  assign COUT = s ? CIN : c;
endmodule

// Two ports. What a port reads as it writes: nothing (0), the new word (1), the old one (2).
module DPB (
  input CLKA, CEA, OCEA, RESETA, WREA, CLKB, CEB, OCEB, RESETB, WREB,
  input [2:0] BLKSELA, BLKSELB,
  input [13:0] ADA, ADB,
  input [15:0] DIA, DIB,
  output reg [15:0] DOA, DOB
);
  parameter READ_MODE0 = 1'b0, READ_MODE1 = 1'b0, RESET_MODE = "SYNC";
  parameter integer BIT_WIDTH_0 = 16, BIT_WIDTH_1 = 16, WRITE_MODE0 = 0, WRITE_MODE1 = 0;
  parameter [2:0] BLK_SEL_0 = 0, BLK_SEL_1 = 0;
  parameter [255:0] INIT_RAM_00 = 0, INIT_RAM_01 = 0, INIT_RAM_02 = 0, INIT_RAM_03 = 0;
  parameter [255:0] INIT_RAM_04 = 0, INIT_RAM_05 = 0, INIT_RAM_06 = 0, INIT_RAM_07 = 0;
  parameter [255:0] INIT_RAM_08 = 0, INIT_RAM_09 = 0, INIT_RAM_0A = 0, INIT_RAM_0B = 0;
  parameter [255:0] INIT_RAM_0C = 0, INIT_RAM_0D = 0, INIT_RAM_0E = 0, INIT_RAM_0F = 0;
  parameter [255:0] INIT_RAM_10 = 0, INIT_RAM_11 = 0, INIT_RAM_12 = 0, INIT_RAM_13 = 0;
  parameter [255:0] INIT_RAM_14 = 0, INIT_RAM_15 = 0, INIT_RAM_16 = 0, INIT_RAM_17 = 0;
  parameter [255:0] INIT_RAM_18 = 0, INIT_RAM_19 = 0, INIT_RAM_1A = 0, INIT_RAM_1B = 0;
  parameter [255:0] INIT_RAM_1C = 0, INIT_RAM_1D = 0, INIT_RAM_1E = 0, INIT_RAM_1F = 0;
  parameter [255:0] INIT_RAM_20 = 0, INIT_RAM_21 = 0, INIT_RAM_22 = 0, INIT_RAM_23 = 0;
  parameter [255:0] INIT_RAM_24 = 0, INIT_RAM_25 = 0, INIT_RAM_26 = 0, INIT_RAM_27 = 0;
  parameter [255:0] INIT_RAM_28 = 0, INIT_RAM_29 = 0, INIT_RAM_2A = 0, INIT_RAM_2B = 0;
  parameter [255:0] INIT_RAM_2C = 0, INIT_RAM_2D = 0, INIT_RAM_2E = 0, INIT_RAM_2F = 0;
  parameter [255:0] INIT_RAM_30 = 0, INIT_RAM_31 = 0, INIT_RAM_32 = 0, INIT_RAM_33 = 0;
  parameter [255:0] INIT_RAM_34 = 0, INIT_RAM_35 = 0, INIT_RAM_36 = 0, INIT_RAM_37 = 0;
  parameter [255:0] INIT_RAM_38 = 0, INIT_RAM_39 = 0, INIT_RAM_3A = 0, INIT_RAM_3B = 0;
  parameter [255:0] INIT_RAM_3C = 0, INIT_RAM_3D = 0, INIT_RAM_3E = 0, INIT_RAM_3F = 0;
  wire [64*256-1:0] init = {
    INIT_RAM_3F, INIT_RAM_3E, INIT_RAM_3D, INIT_RAM_3C, INIT_RAM_3B, INIT_RAM_3A, INIT_RAM_39, INIT_RAM_38,
    INIT_RAM_37, INIT_RAM_36, INIT_RAM_35, INIT_RAM_34, INIT_RAM_33, INIT_RAM_32, INIT_RAM_31, INIT_RAM_30,
    INIT_RAM_2F, INIT_RAM_2E, INIT_RAM_2D, INIT_RAM_2C, INIT_RAM_2B, INIT_RAM_2A, INIT_RAM_29, INIT_RAM_28,
    INIT_RAM_27, INIT_RAM_26, INIT_RAM_25, INIT_RAM_24, INIT_RAM_23, INIT_RAM_22, INIT_RAM_21, INIT_RAM_20,
    INIT_RAM_1F, INIT_RAM_1E, INIT_RAM_1D, INIT_RAM_1C, INIT_RAM_1B, INIT_RAM_1A, INIT_RAM_19, INIT_RAM_18,
    INIT_RAM_17, INIT_RAM_16, INIT_RAM_15, INIT_RAM_14, INIT_RAM_13, INIT_RAM_12, INIT_RAM_11, INIT_RAM_10,
    INIT_RAM_0F, INIT_RAM_0E, INIT_RAM_0D, INIT_RAM_0C, INIT_RAM_0B, INIT_RAM_0A, INIT_RAM_09, INIT_RAM_08,
    INIT_RAM_07, INIT_RAM_06, INIT_RAM_05, INIT_RAM_04, INIT_RAM_03, INIT_RAM_02, INIT_RAM_01, INIT_RAM_00
  };
  reg [7:0] mem [0:2047];
  integer k;
  initial begin
    for (k = 0; k < 2048; k = k + 1) mem[k] = |init ? init[8*k+:8] : 8'bx;
    if (READ_MODE0 != 0 || READ_MODE1 != 0) begin
      $display("DPB: a setting that has no model");
      $finish;
    end
  end
  function [15:0] word(input integer width, input [13:0] at);
    case (width)
      1: word = mem[at[13:3]][at[2:0]+:1];
      2: word = mem[at[13:3]][2*at[2:1]+:2];
      4: word = mem[at[13:3]][4*at[2]+:4];
      8: word = mem[at[13:3]];
      default: word = {mem[{at[13:4], 1'b1}], mem[{at[13:4], 1'b0}]};
    endcase
  endfunction
  task put(input integer width, input [13:0] at, input [15:0] data);
    case (width)
      1: mem[at[13:3]][at[2:0]+:1] = data[0:0];
      2: mem[at[13:3]][2*at[2:1]+:2] = data[1:0];
      4: mem[at[13:3]][4*at[2]+:4] = data[3:0];
      8: mem[at[13:3]] = data[7:0];
      default: begin
        if (at[0]) mem[{at[13:4], 1'b0}] = data[7:0];
        if (at[1]) mem[{at[13:4], 1'b1}] = data[15:8];
      end
    endcase
  endtask
  reg [15:0] old_a;
  reg [15:0] old_b;
  always @(posedge CLKA) if (CEA && BLKSELA == BLK_SEL_0) begin
    old_a = word(BIT_WIDTH_0, ADA);
    #0 if (WREA) put(BIT_WIDTH_0, ADA, DIA);
    if (RESETA) DOA <= 0;
    else if (!WREA || WRITE_MODE0 == 2) DOA <= old_a;
    else if (WRITE_MODE0 == 1) DOA <= word(BIT_WIDTH_0, ADA);
  end
  always @(posedge CLKB) if (CEB && BLKSELB == BLK_SEL_1) begin
    old_b = word(BIT_WIDTH_1, ADB);
    #0 if (WREB) put(BIT_WIDTH_1, ADB, DIB);
    if (RESETB) DOB <= 0;
    else if (!WREB || WRITE_MODE1 == 2) DOB <= old_b;
    else if (WRITE_MODE1 == 1) DOB <= word(BIT_WIDTH_1, ADB);
  end
endmodule

// Two ports. What a port reads as it writes: nothing (0), the new word (1), the old one (2).
module DPX9B (
  input CLKA, CEA, OCEA, RESETA, WREA, CLKB, CEB, OCEB, RESETB, WREB,
  input [2:0] BLKSELA, BLKSELB,
  input [13:0] ADA, ADB,
  input [17:0] DIA, DIB,
  output reg [17:0] DOA, DOB
);
  parameter READ_MODE0 = 1'b0, READ_MODE1 = 1'b0, RESET_MODE = "SYNC";
  parameter integer BIT_WIDTH_0 = 18, BIT_WIDTH_1 = 18, WRITE_MODE0 = 0, WRITE_MODE1 = 0;
  parameter [2:0] BLK_SEL_0 = 0, BLK_SEL_1 = 0;
  parameter [287:0] INIT_RAM_00 = 0, INIT_RAM_01 = 0, INIT_RAM_02 = 0, INIT_RAM_03 = 0;
  parameter [287:0] INIT_RAM_04 = 0, INIT_RAM_05 = 0, INIT_RAM_06 = 0, INIT_RAM_07 = 0;
  parameter [287:0] INIT_RAM_08 = 0, INIT_RAM_09 = 0, INIT_RAM_0A = 0, INIT_RAM_0B = 0;
  parameter [287:0] INIT_RAM_0C = 0, INIT_RAM_0D = 0, INIT_RAM_0E = 0, INIT_RAM_0F = 0;
  parameter [287:0] INIT_RAM_10 = 0, INIT_RAM_11 = 0, INIT_RAM_12 = 0, INIT_RAM_13 = 0;
  parameter [287:0] INIT_RAM_14 = 0, INIT_RAM_15 = 0, INIT_RAM_16 = 0, INIT_RAM_17 = 0;
  parameter [287:0] INIT_RAM_18 = 0, INIT_RAM_19 = 0, INIT_RAM_1A = 0, INIT_RAM_1B = 0;
  parameter [287:0] INIT_RAM_1C = 0, INIT_RAM_1D = 0, INIT_RAM_1E = 0, INIT_RAM_1F = 0;
  parameter [287:0] INIT_RAM_20 = 0, INIT_RAM_21 = 0, INIT_RAM_22 = 0, INIT_RAM_23 = 0;
  parameter [287:0] INIT_RAM_24 = 0, INIT_RAM_25 = 0, INIT_RAM_26 = 0, INIT_RAM_27 = 0;
  parameter [287:0] INIT_RAM_28 = 0, INIT_RAM_29 = 0, INIT_RAM_2A = 0, INIT_RAM_2B = 0;
  parameter [287:0] INIT_RAM_2C = 0, INIT_RAM_2D = 0, INIT_RAM_2E = 0, INIT_RAM_2F = 0;
  parameter [287:0] INIT_RAM_30 = 0, INIT_RAM_31 = 0, INIT_RAM_32 = 0, INIT_RAM_33 = 0;
  parameter [287:0] INIT_RAM_34 = 0, INIT_RAM_35 = 0, INIT_RAM_36 = 0, INIT_RAM_37 = 0;
  parameter [287:0] INIT_RAM_38 = 0, INIT_RAM_39 = 0, INIT_RAM_3A = 0, INIT_RAM_3B = 0;
  parameter [287:0] INIT_RAM_3C = 0, INIT_RAM_3D = 0, INIT_RAM_3E = 0, INIT_RAM_3F = 0;
  wire [64*288-1:0] init = {
    INIT_RAM_3F, INIT_RAM_3E, INIT_RAM_3D, INIT_RAM_3C, INIT_RAM_3B, INIT_RAM_3A, INIT_RAM_39, INIT_RAM_38,
    INIT_RAM_37, INIT_RAM_36, INIT_RAM_35, INIT_RAM_34, INIT_RAM_33, INIT_RAM_32, INIT_RAM_31, INIT_RAM_30,
    INIT_RAM_2F, INIT_RAM_2E, INIT_RAM_2D, INIT_RAM_2C, INIT_RAM_2B, INIT_RAM_2A, INIT_RAM_29, INIT_RAM_28,
    INIT_RAM_27, INIT_RAM_26, INIT_RAM_25, INIT_RAM_24, INIT_RAM_23, INIT_RAM_22, INIT_RAM_21, INIT_RAM_20,
    INIT_RAM_1F, INIT_RAM_1E, INIT_RAM_1D, INIT_RAM_1C, INIT_RAM_1B, INIT_RAM_1A, INIT_RAM_19, INIT_RAM_18,
    INIT_RAM_17, INIT_RAM_16, INIT_RAM_15, INIT_RAM_14, INIT_RAM_13, INIT_RAM_12, INIT_RAM_11, INIT_RAM_10,
    INIT_RAM_0F, INIT_RAM_0E, INIT_RAM_0D, INIT_RAM_0C, INIT_RAM_0B, INIT_RAM_0A, INIT_RAM_09, INIT_RAM_08,
    INIT_RAM_07, INIT_RAM_06, INIT_RAM_05, INIT_RAM_04, INIT_RAM_03, INIT_RAM_02, INIT_RAM_01, INIT_RAM_00
  };
  reg [8:0] mem [0:2047];
  integer k;
  initial begin
    for (k = 0; k < 2048; k = k + 1) mem[k] = |init ? init[9*k+:9] : 9'bx;
    if (READ_MODE0 != 0 || READ_MODE1 != 0) begin
      $display("DPX9B: a setting that has no model");
      $finish;
    end
  end
  function [17:0] word(input integer width, input [13:0] at);
    case (width)
      9: word = mem[at[13:3]];
      default: word = {mem[{at[13:4], 1'b1}], mem[{at[13:4], 1'b0}]};
    endcase
  endfunction
  task put(input integer width, input [13:0] at, input [17:0] data);
    case (width)
      9: mem[at[13:3]] = data[8:0];
      default: begin
        if (at[0]) mem[{at[13:4], 1'b0}] = data[8:0];
        if (at[1]) mem[{at[13:4], 1'b1}] = data[17:9];
      end
    endcase
  endtask
  reg [17:0] old_a;
  reg [17:0] old_b;
  always @(posedge CLKA) if (CEA && BLKSELA == BLK_SEL_0) begin
    old_a = word(BIT_WIDTH_0, ADA);
    #0 if (WREA) put(BIT_WIDTH_0, ADA, DIA);
    if (RESETA) DOA <= 0;
    else if (!WREA || WRITE_MODE0 == 2) DOA <= old_a;
    else if (WRITE_MODE0 == 1) DOA <= word(BIT_WIDTH_0, ADA);
  end
  always @(posedge CLKB) if (CEB && BLKSELB == BLK_SEL_1) begin
    old_b = word(BIT_WIDTH_1, ADB);
    #0 if (WREB) put(BIT_WIDTH_1, ADB, DIB);
    if (RESETB) DOB <= 0;
    else if (!WREB || WRITE_MODE1 == 2) DOB <= old_b;
    else if (WRITE_MODE1 == 1) DOB <= word(BIT_WIDTH_1, ADB);
  end
endmodule
