// Cells of Lattice ECP5 that Yosys ships without behaviour, after Lattice's "ECP5 and ECP5-5G Memory User Guide" (FPGA-TN-02204) and "sysDSP
// User Guide" (FPGA-TN-02205): what Yosys makes of the emitted text, and nothing else; other settings end the simulation. Compiled with block_memory.v.

// 18 kbit with two ports. An address counts bits; a word of 9 bits or more has its parity bits on top of each 8, narrower words have none.
// Of a word of 18 bits the lowest two address bits say which half is written. While its reset is held, a port does not write.
module DP16KD (
  input DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11, DIA10, DIA9, DIA8, DIA7, DIA6, DIA5, DIA4, DIA3, DIA2, DIA1, DIA0,
  input ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5, ADA4, ADA3, ADA2, ADA1, ADA0,
  input CEA, OCEA, CLKA, WEA, RSTA, CSA2, CSA1, CSA0,
  output DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9, DOA8, DOA7, DOA6, DOA5, DOA4, DOA3, DOA2, DOA1, DOA0,
  input DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9, DIB8, DIB7, DIB6, DIB5, DIB4, DIB3, DIB2, DIB1, DIB0,
  input ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5, ADB4, ADB3, ADB2, ADB1, ADB0,
  input CEB, OCEB, CLKB, WEB, RSTB, CSB2, CSB1, CSB0,
  output DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9, DOB8, DOB7, DOB6, DOB5, DOB4, DOB3, DOB2, DOB1, DOB0
);
  parameter integer DATA_WIDTH_A = 18, DATA_WIDTH_B = 18;
  parameter REGMODE_A = "NOREG", REGMODE_B = "NOREG", RESETMODE = "SYNC", ASYNC_RESET_RELEASE = "SYNC";
  parameter CSDECODE_A = "0b000", CSDECODE_B = "0b000", WRITEMODE_A = "NORMAL", WRITEMODE_B = "NORMAL";
  parameter CLKAMUX = "CLKA", CLKBMUX = "CLKB", GSR = "DISABLED", INIT_DATA = "STATIC", WID = 0;
  parameter [319:0] INITVAL_00 = 0, INITVAL_01 = 0, INITVAL_02 = 0, INITVAL_03 = 0;
  parameter [319:0] INITVAL_04 = 0, INITVAL_05 = 0, INITVAL_06 = 0, INITVAL_07 = 0;
  parameter [319:0] INITVAL_08 = 0, INITVAL_09 = 0, INITVAL_0A = 0, INITVAL_0B = 0;
  parameter [319:0] INITVAL_0C = 0, INITVAL_0D = 0, INITVAL_0E = 0, INITVAL_0F = 0;
  parameter [319:0] INITVAL_10 = 0, INITVAL_11 = 0, INITVAL_12 = 0, INITVAL_13 = 0;
  parameter [319:0] INITVAL_14 = 0, INITVAL_15 = 0, INITVAL_16 = 0, INITVAL_17 = 0;
  parameter [319:0] INITVAL_18 = 0, INITVAL_19 = 0, INITVAL_1A = 0, INITVAL_1B = 0;
  parameter [319:0] INITVAL_1C = 0, INITVAL_1D = 0, INITVAL_1E = 0, INITVAL_1F = 0;
  parameter [319:0] INITVAL_20 = 0, INITVAL_21 = 0, INITVAL_22 = 0, INITVAL_23 = 0;
  parameter [319:0] INITVAL_24 = 0, INITVAL_25 = 0, INITVAL_26 = 0, INITVAL_27 = 0;
  parameter [319:0] INITVAL_28 = 0, INITVAL_29 = 0, INITVAL_2A = 0, INITVAL_2B = 0;
  parameter [319:0] INITVAL_2C = 0, INITVAL_2D = 0, INITVAL_2E = 0, INITVAL_2F = 0;
  parameter [319:0] INITVAL_30 = 0, INITVAL_31 = 0, INITVAL_32 = 0, INITVAL_33 = 0;
  parameter [319:0] INITVAL_34 = 0, INITVAL_35 = 0, INITVAL_36 = 0, INITVAL_37 = 0;
  parameter [319:0] INITVAL_38 = 0, INITVAL_39 = 0, INITVAL_3A = 0, INITVAL_3B = 0;
  parameter [319:0] INITVAL_3C = 0, INITVAL_3D = 0, INITVAL_3E = 0, INITVAL_3F = 0;
  initial if (REGMODE_A != "NOREG" || REGMODE_B != "NOREG" || CLKAMUX != "CLKA" || CLKBMUX != "CLKB"
      || CSDECODE_A != "0b000" || CSDECODE_B != "0b000") begin
    $display("DP16KD: a setting that has no model");
    $finish;
  end
  // Yosys gives a port without a reset any mode of it.
  always @(RSTA or RSTB) if (RESETMODE != "SYNC" && (RSTA !== 0 || RSTB !== 0)) begin
    $display("DP16KD: a reset that has no model");
    $finish;
  end
  // Words of 18 bits stand one in 20.
  function [287:0] row(input [319:0] padded);
    integer k;
    for (k = 0; k < 16; k = k + 1) row[18*k+:18] = padded[20*k+:18];
  endfunction
  localparam [64*288-1:0] INITVALS = {
    row(INITVAL_3F), row(INITVAL_3E), row(INITVAL_3D), row(INITVAL_3C), row(INITVAL_3B), row(INITVAL_3A),
    row(INITVAL_39), row(INITVAL_38), row(INITVAL_37), row(INITVAL_36), row(INITVAL_35), row(INITVAL_34),
    row(INITVAL_33), row(INITVAL_32), row(INITVAL_31), row(INITVAL_30), row(INITVAL_2F), row(INITVAL_2E),
    row(INITVAL_2D), row(INITVAL_2C), row(INITVAL_2B), row(INITVAL_2A), row(INITVAL_29), row(INITVAL_28),
    row(INITVAL_27), row(INITVAL_26), row(INITVAL_25), row(INITVAL_24), row(INITVAL_23), row(INITVAL_22),
    row(INITVAL_21), row(INITVAL_20), row(INITVAL_1F), row(INITVAL_1E), row(INITVAL_1D), row(INITVAL_1C),
    row(INITVAL_1B), row(INITVAL_1A), row(INITVAL_19), row(INITVAL_18), row(INITVAL_17), row(INITVAL_16),
    row(INITVAL_15), row(INITVAL_14), row(INITVAL_13), row(INITVAL_12), row(INITVAL_11), row(INITVAL_10),
    row(INITVAL_0F), row(INITVAL_0E), row(INITVAL_0D), row(INITVAL_0C), row(INITVAL_0B), row(INITVAL_0A),
    row(INITVAL_09), row(INITVAL_08), row(INITVAL_07), row(INITVAL_06), row(INITVAL_05), row(INITVAL_04),
    row(INITVAL_03), row(INITVAL_02), row(INITVAL_01), row(INITVAL_00)
  };
  function integer mode(input [8*15-1:0] name);
    mode = name == "WRITETHROUGH" ? 1 : name == "READBEFOREWRITE" ? 2 : 0;
  endfunction
  wire [13:0] ada = {ADA13, ADA12, ADA11, ADA10, ADA9, ADA8, ADA7, ADA6, ADA5, ADA4, ADA3, ADA2, ADA1, ADA0};
  wire [17:0] dia = {DIA17, DIA16, DIA15, DIA14, DIA13, DIA12, DIA11, DIA10, DIA9, DIA8, DIA7, DIA6, DIA5, DIA4, DIA3, DIA2, DIA1, DIA0};
  wire [71:0] doa;
  assign {DOA17, DOA16, DOA15, DOA14, DOA13, DOA12, DOA11, DOA10, DOA9, DOA8, DOA7, DOA6, DOA5, DOA4, DOA3, DOA2, DOA1, DOA0} = doa[17:0];
  wire [13:0] adb = {ADB13, ADB12, ADB11, ADB10, ADB9, ADB8, ADB7, ADB6, ADB5, ADB4, ADB3, ADB2, ADB1, ADB0};
  wire [17:0] dib = {DIB17, DIB16, DIB15, DIB14, DIB13, DIB12, DIB11, DIB10, DIB9, DIB8, DIB7, DIB6, DIB5, DIB4, DIB3, DIB2, DIB1, DIB0};
  wire [71:0] dob;
  assign {DOB17, DOB16, DOB15, DOB14, DOB13, DOB12, DOB11, DOB10, DOB9, DOB8, DOB7, DOB6, DOB5, DOB4, DOB3, DOB2, DOB1, DOB0} = dob[17:0];
  block_memory #(
    .WIDTH_A(DATA_WIDTH_A), .WIDTH_B(DATA_WIDTH_B), .MODE_A(mode(WRITEMODE_A)), .MODE_B(mode(WRITEMODE_B)), .INIT(INITVALS)
  ) u_memory (
    .clk_a(CLKA), .en_a(CEA && {CSA2, CSA1, CSA0} == 0 && !RSTA), .rst_a(RSTA),
    .we_a(WEA ? {6'b0, DATA_WIDTH_A == 18 ? ada[1:0] : 2'b01} : 8'b0), .ad_a({1'b0, ada}), .di_a({54'b0, dia}), .do_a(doa),
    .clk_b(CLKB), .en_b(CEB && {CSB2, CSB1, CSB0} == 0 && !RSTB), .rst_b(RSTB),
    .we_b(WEB ? {6'b0, DATA_WIDTH_B == 18 ? adb[1:0] : 2'b01} : 8'b0), .ad_b({1'b0, adb}), .di_b({54'b0, dib}), .do_b(dob)
  );
endmodule

// 18 x 18 bits, each side with a sign or without; its registers are not used.
module MULT18X18D (
  input A17, A16, A15, A14, A13, A12, A11, A10, A9, A8, A7, A6, A5, A4, A3, A2, A1, A0,
  input B17, B16, B15, B14, B13, B12, B11, B10, B9, B8, B7, B6, B5, B4, B3, B2, B1, B0,
  input C17, C16, C15, C14, C13, C12, C11, C10, C9, C8, C7, C6, C5, C4, C3, C2, C1, C0,
  input SIGNEDA, SIGNEDB, SOURCEA, SOURCEB, CLK0, CLK1, CLK2, CLK3, CE0, CE1, CE2, CE3, RST0, RST1, RST2, RST3,
  output P35, P34, P33, P32, P31, P30, P29, P28, P27, P26, P25, P24, P23, P22, P21, P20, P19, P18, P17, P16, P15, P14, P13, P12, P11, P10, P9, P8, P7, P6, P5, P4, P3, P2, P1, P0
);
  parameter REG_INPUTA_CLK = "NONE", REG_INPUTB_CLK = "NONE", REG_PIPELINE_CLK = "NONE", REG_OUTPUT_CLK = "NONE";
  initial if (REG_INPUTA_CLK != "NONE" || REG_INPUTB_CLK != "NONE" || REG_PIPELINE_CLK != "NONE" || REG_OUTPUT_CLK != "NONE") begin
    $display("MULT18X18D: a setting that has no model");
    $finish;
  end
  wire [17:0] a = {A17, A16, A15, A14, A13, A12, A11, A10, A9, A8, A7, A6, A5, A4, A3, A2, A1, A0};
  wire [17:0] b = {B17, B16, B15, B14, B13, B12, B11, B10, B9, B8, B7, B6, B5, B4, B3, B2, B1, B0};
  wire signed [18:0] wide_a = {SIGNEDA & a[17], a};
  wire signed [18:0] wide_b = {SIGNEDB & b[17], b};
  wire signed [37:0] product = wide_a * wide_b;
  assign {P35, P34, P33, P32, P31, P30, P29, P28, P27, P26, P25, P24, P23, P22, P21, P20, P19, P18, P17, P16, P15, P14, P13, P12, P11, P10, P9, P8, P7, P6, P5, P4, P3, P2, P1, P0} = product[35:0];
endmodule
