// Block memories of Xilinx 7 series after "7 Series FPGAs Memory Resources" (UG473), with one port that writes (B) and one that reads (A) (RAM_MODE
// "SDP"), or two ports that do both at one width each ("TDP"): what Yosys makes of the emitted text, and nothing else; other settings end the
// simulation. Compiled with block_memory.v. An address counts bits; a reset of the output needs the enable.

module RAMB18E1 (
  input CLKARDCLK, CLKBWRCLK, ENARDEN, ENBWREN, REGCEAREGCE, REGCEB, RSTRAMARSTRAM, RSTRAMB, RSTREGARSTREG, RSTREGB,
  input [13:0] ADDRARDADDR, ADDRBWRADDR,
  input [15:0] DIADI, DIBDI,
  input [1:0] DIPADIP, DIPBDIP,
  input [1:0] WEA,
  input [3:0] WEBWE,
  output [15:0] DOADO, DOBDO,
  output [1:0] DOPADOP, DOPBDOP
);
  parameter integer DOA_REG = 0, DOB_REG = 0, READ_WIDTH_A = 0, READ_WIDTH_B = 0, WRITE_WIDTH_A = 0, WRITE_WIDTH_B = 0;
  parameter RAM_MODE = "TDP", WRITE_MODE_A = "WRITE_FIRST", WRITE_MODE_B = "WRITE_FIRST", SIM_DEVICE = "VIRTEX6";
  parameter RAM_EXTENSION_A = "NONE", RAM_EXTENSION_B = "NONE", RDADDR_COLLISION_HWCONFIG = "DELAYED_WRITE";
  parameter [17:0] INIT_A = 0, INIT_B = 0, SRVAL_A = 0, SRVAL_B = 0;
  parameter [0:0] IS_CLKARDCLK_INVERTED = 0, IS_CLKBWRCLK_INVERTED = 0, IS_ENARDEN_INVERTED = 0, IS_ENBWREN_INVERTED = 0;
  parameter [0:0] IS_RSTRAMARSTRAM_INVERTED = 0, IS_RSTRAMB_INVERTED = 0, IS_RSTREGARSTREG_INVERTED = 0, IS_RSTREGB_INVERTED = 0;
  parameter [255:0] INIT_00 = 0, INIT_01 = 0, INIT_02 = 0, INIT_03 = 0, INIT_04 = 0, INIT_05 = 0, INIT_06 = 0, INIT_07 = 0;
  parameter [255:0] INIT_08 = 0, INIT_09 = 0, INIT_0A = 0, INIT_0B = 0, INIT_0C = 0, INIT_0D = 0, INIT_0E = 0, INIT_0F = 0;
  parameter [255:0] INIT_10 = 0, INIT_11 = 0, INIT_12 = 0, INIT_13 = 0, INIT_14 = 0, INIT_15 = 0, INIT_16 = 0, INIT_17 = 0;
  parameter [255:0] INIT_18 = 0, INIT_19 = 0, INIT_1A = 0, INIT_1B = 0, INIT_1C = 0, INIT_1D = 0, INIT_1E = 0, INIT_1F = 0;
  parameter [255:0] INIT_20 = 0, INIT_21 = 0, INIT_22 = 0, INIT_23 = 0, INIT_24 = 0, INIT_25 = 0, INIT_26 = 0, INIT_27 = 0;
  parameter [255:0] INIT_28 = 0, INIT_29 = 0, INIT_2A = 0, INIT_2B = 0, INIT_2C = 0, INIT_2D = 0, INIT_2E = 0, INIT_2F = 0;
  parameter [255:0] INIT_30 = 0, INIT_31 = 0, INIT_32 = 0, INIT_33 = 0, INIT_34 = 0, INIT_35 = 0, INIT_36 = 0, INIT_37 = 0;
  parameter [255:0] INIT_38 = 0, INIT_39 = 0, INIT_3A = 0, INIT_3B = 0, INIT_3C = 0, INIT_3D = 0, INIT_3E = 0, INIT_3F = 0;
  parameter [255:0] INITP_00 = 0, INITP_01 = 0, INITP_02 = 0, INITP_03 = 0, INITP_04 = 0, INITP_05 = 0, INITP_06 = 0, INITP_07 = 0;
  localparam TDP = RAM_MODE == "TDP";
  // A port of two widths, or one that is too wide for one of two ports; outputs that start or are reset differently.
  localparam UNFIT_A = READ_WIDTH_A > 18 || WRITE_WIDTH_A > 18 || READ_WIDTH_A != WRITE_WIDTH_A && READ_WIDTH_A != 0 && WRITE_WIDTH_A != 0;
  localparam UNFIT_B = READ_WIDTH_B > 18 || WRITE_WIDTH_B > 18 || READ_WIDTH_B != WRITE_WIDTH_B && READ_WIDTH_B != 0 && WRITE_WIDTH_B != 0 || READ_WIDTH_A != 0 && READ_WIDTH_B != 0 && (INIT_A != INIT_B || SRVAL_A != SRVAL_B);
  initial if ((TDP ? UNFIT_A || UNFIT_B || DOB_REG != 0 : RAM_MODE != "SDP") || DOA_REG != 0 || IS_CLKARDCLK_INVERTED != 0 || IS_CLKBWRCLK_INVERTED != 0 || RAM_EXTENSION_A != "NONE") begin
    $display("RAMB18E1: a setting that has no model");
    $finish;
  end
  // Bytes of nine bits, the parity on top.
  function [287:0] row(input [255:0] data, input [31:0] parity);
    integer k;
    for (k = 0; k < 32; k = k + 1) row[9*k+:9] = {parity[k], data[8*k+:8]};
  endfunction
  localparam [64*288-1:0] ROWS = {
    row(INIT_3F, INITP_07[224+:32]), row(INIT_3E, INITP_07[192+:32]), row(INIT_3D, INITP_07[160+:32]), row(INIT_3C, INITP_07[128+:32]),
    row(INIT_3B, INITP_07[96+:32]), row(INIT_3A, INITP_07[64+:32]), row(INIT_39, INITP_07[32+:32]), row(INIT_38, INITP_07[0+:32]),
    row(INIT_37, INITP_06[224+:32]), row(INIT_36, INITP_06[192+:32]), row(INIT_35, INITP_06[160+:32]), row(INIT_34, INITP_06[128+:32]),
    row(INIT_33, INITP_06[96+:32]), row(INIT_32, INITP_06[64+:32]), row(INIT_31, INITP_06[32+:32]), row(INIT_30, INITP_06[0+:32]),
    row(INIT_2F, INITP_05[224+:32]), row(INIT_2E, INITP_05[192+:32]), row(INIT_2D, INITP_05[160+:32]), row(INIT_2C, INITP_05[128+:32]),
    row(INIT_2B, INITP_05[96+:32]), row(INIT_2A, INITP_05[64+:32]), row(INIT_29, INITP_05[32+:32]), row(INIT_28, INITP_05[0+:32]),
    row(INIT_27, INITP_04[224+:32]), row(INIT_26, INITP_04[192+:32]), row(INIT_25, INITP_04[160+:32]), row(INIT_24, INITP_04[128+:32]),
    row(INIT_23, INITP_04[96+:32]), row(INIT_22, INITP_04[64+:32]), row(INIT_21, INITP_04[32+:32]), row(INIT_20, INITP_04[0+:32]),
    row(INIT_1F, INITP_03[224+:32]), row(INIT_1E, INITP_03[192+:32]), row(INIT_1D, INITP_03[160+:32]), row(INIT_1C, INITP_03[128+:32]),
    row(INIT_1B, INITP_03[96+:32]), row(INIT_1A, INITP_03[64+:32]), row(INIT_19, INITP_03[32+:32]), row(INIT_18, INITP_03[0+:32]),
    row(INIT_17, INITP_02[224+:32]), row(INIT_16, INITP_02[192+:32]), row(INIT_15, INITP_02[160+:32]), row(INIT_14, INITP_02[128+:32]),
    row(INIT_13, INITP_02[96+:32]), row(INIT_12, INITP_02[64+:32]), row(INIT_11, INITP_02[32+:32]), row(INIT_10, INITP_02[0+:32]),
    row(INIT_0F, INITP_01[224+:32]), row(INIT_0E, INITP_01[192+:32]), row(INIT_0D, INITP_01[160+:32]), row(INIT_0C, INITP_01[128+:32]),
    row(INIT_0B, INITP_01[96+:32]), row(INIT_0A, INITP_01[64+:32]), row(INIT_09, INITP_01[32+:32]), row(INIT_08, INITP_01[0+:32]),
    row(INIT_07, INITP_00[224+:32]), row(INIT_06, INITP_00[192+:32]), row(INIT_05, INITP_00[160+:32]), row(INIT_04, INITP_00[128+:32]),
    row(INIT_03, INITP_00[96+:32]), row(INIT_02, INITP_00[64+:32]), row(INIT_01, INITP_00[32+:32]), row(INIT_00, INITP_00[0+:32])
  };
  function [35:0] word(input [31:0] data, input [3:0] parity);
    integer k;
    for (k = 0; k < 4; k = k + 1) word[9*k+:9] = {parity[k], data[8*k+:8]};
  endfunction
  // A write of the whole width takes its upper half from the data of port B, a narrower one everything.
  wire [35:0] data = WRITE_WIDTH_B == 36 ? word({DIBDI, DIADI}, {DIPBDIP, DIPADIP}) : word({16'b0, DIBDI}, {2'b0, DIPBDIP});
  wire [35:0] data_a = word({16'b0, DIADI}, {2'b0, DIPADIP});
  wire [71:0] out;
  wire [71:0] out_b;
  genvar g;
  generate
    for (g = 0; g < 2; g = g + 1) begin : gen_byte
      assign DOADO[8*g+:8] = out[9*g+:8];
      assign DOPADOP[g] = out[9*g+8];
      assign DOBDO[8*g+:8] = TDP ? out_b[9*g+:8] : out[9*(2+g)+:8];
      assign DOPBDOP[g] = TDP ? out_b[9*g+8] : out[9*(2+g)+8];
    end
  endgenerate
  localparam integer ONE_A = READ_WIDTH_A != 0 ? READ_WIDTH_A : WRITE_WIDTH_A != 0 ? WRITE_WIDTH_A : 9;
  localparam integer ONE_B = READ_WIDTH_B != 0 ? READ_WIDTH_B : WRITE_WIDTH_B != 0 ? WRITE_WIDTH_B : 9;
  localparam integer MODE_A = WRITE_MODE_A == "READ_FIRST" ? 2 : WRITE_MODE_A == "WRITE_FIRST" ? 1 : 0;
  localparam integer MODE_B = WRITE_MODE_B == "READ_FIRST" ? 2 : WRITE_MODE_B == "WRITE_FIRST" ? 1 : 0;
  // Of the modes of writing only READ_FIRST promises the old word to a reader at the same time.
  block_memory #(
    .BYTES(2048), .WIDTH_A(TDP ? ONE_A : READ_WIDTH_A), .WIDTH_B(TDP ? ONE_B : WRITE_WIDTH_B), .INIT(ROWS),
    .OLD(TDP ? (WRITE_WIDTH_A == 0 || MODE_A == 2) && (WRITE_WIDTH_B == 0 || MODE_B == 2) : WRITE_MODE_B == "READ_FIRST"),
    .MODE_A(TDP ? MODE_A : 0), .MODE_B(TDP ? MODE_B : 0), .START(TDP ? (READ_WIDTH_A != 0 ? INIT_A : INIT_B) : {INIT_B, INIT_A}),
    .CLEARED(TDP ? (READ_WIDTH_A != 0 ? SRVAL_A : SRVAL_B) : {SRVAL_B, SRVAL_A})
  ) u_memory (
    .clk_a(CLKARDCLK), .en_a(ENARDEN ^ IS_ENARDEN_INVERTED), .rst_a((ENARDEN ^ IS_ENARDEN_INVERTED) && (RSTRAMARSTRAM ^ IS_RSTRAMARSTRAM_INVERTED)),
    .we_a(TDP && WRITE_WIDTH_A != 0 ? WEA : 8'b0), .ad_a({1'b0, ADDRARDADDR[13:0]}), .di_a(data_a), .do_a(out),
    .clk_b(CLKBWRCLK), .en_b(ENBWREN ^ IS_ENBWREN_INVERTED), .rst_b(TDP && (ENBWREN ^ IS_ENBWREN_INVERTED) && (RSTRAMB ^ IS_RSTRAMB_INVERTED)), .we_b(!TDP ? WEBWE : WRITE_WIDTH_B != 0 ? WEBWE[1:0] : 8'b0),
    .ad_b({1'b0, ADDRBWRADDR[13:0]}), .di_b({36'b0, data}), .do_b(out_b)
  );
endmodule

module RAMB36E1 (
  input CLKARDCLK, CLKBWRCLK, ENARDEN, ENBWREN, REGCEAREGCE, REGCEB, RSTRAMARSTRAM, RSTRAMB, RSTREGARSTREG, RSTREGB,
  input [15:0] ADDRARDADDR, ADDRBWRADDR,
  input [31:0] DIADI, DIBDI,
  input [3:0] DIPADIP, DIPBDIP,
  input [3:0] WEA,
  input [7:0] WEBWE,
  output [31:0] DOADO, DOBDO,
  output [3:0] DOPADOP, DOPBDOP
);
  parameter integer DOA_REG = 0, DOB_REG = 0, READ_WIDTH_A = 0, READ_WIDTH_B = 0, WRITE_WIDTH_A = 0, WRITE_WIDTH_B = 0;
  parameter RAM_MODE = "TDP", WRITE_MODE_A = "WRITE_FIRST", WRITE_MODE_B = "WRITE_FIRST", SIM_DEVICE = "VIRTEX6";
  parameter RAM_EXTENSION_A = "NONE", RAM_EXTENSION_B = "NONE", RDADDR_COLLISION_HWCONFIG = "DELAYED_WRITE";
  parameter [35:0] INIT_A = 0, INIT_B = 0, SRVAL_A = 0, SRVAL_B = 0;
  parameter [0:0] IS_CLKARDCLK_INVERTED = 0, IS_CLKBWRCLK_INVERTED = 0, IS_ENARDEN_INVERTED = 0, IS_ENBWREN_INVERTED = 0;
  parameter [0:0] IS_RSTRAMARSTRAM_INVERTED = 0, IS_RSTRAMB_INVERTED = 0, IS_RSTREGARSTREG_INVERTED = 0, IS_RSTREGB_INVERTED = 0;
  parameter [255:0] INIT_00 = 0, INIT_01 = 0, INIT_02 = 0, INIT_03 = 0, INIT_04 = 0, INIT_05 = 0, INIT_06 = 0, INIT_07 = 0;
  parameter [255:0] INIT_08 = 0, INIT_09 = 0, INIT_0A = 0, INIT_0B = 0, INIT_0C = 0, INIT_0D = 0, INIT_0E = 0, INIT_0F = 0;
  parameter [255:0] INIT_10 = 0, INIT_11 = 0, INIT_12 = 0, INIT_13 = 0, INIT_14 = 0, INIT_15 = 0, INIT_16 = 0, INIT_17 = 0;
  parameter [255:0] INIT_18 = 0, INIT_19 = 0, INIT_1A = 0, INIT_1B = 0, INIT_1C = 0, INIT_1D = 0, INIT_1E = 0, INIT_1F = 0;
  parameter [255:0] INIT_20 = 0, INIT_21 = 0, INIT_22 = 0, INIT_23 = 0, INIT_24 = 0, INIT_25 = 0, INIT_26 = 0, INIT_27 = 0;
  parameter [255:0] INIT_28 = 0, INIT_29 = 0, INIT_2A = 0, INIT_2B = 0, INIT_2C = 0, INIT_2D = 0, INIT_2E = 0, INIT_2F = 0;
  parameter [255:0] INIT_30 = 0, INIT_31 = 0, INIT_32 = 0, INIT_33 = 0, INIT_34 = 0, INIT_35 = 0, INIT_36 = 0, INIT_37 = 0;
  parameter [255:0] INIT_38 = 0, INIT_39 = 0, INIT_3A = 0, INIT_3B = 0, INIT_3C = 0, INIT_3D = 0, INIT_3E = 0, INIT_3F = 0;
  parameter [255:0] INIT_40 = 0, INIT_41 = 0, INIT_42 = 0, INIT_43 = 0, INIT_44 = 0, INIT_45 = 0, INIT_46 = 0, INIT_47 = 0;
  parameter [255:0] INIT_48 = 0, INIT_49 = 0, INIT_4A = 0, INIT_4B = 0, INIT_4C = 0, INIT_4D = 0, INIT_4E = 0, INIT_4F = 0;
  parameter [255:0] INIT_50 = 0, INIT_51 = 0, INIT_52 = 0, INIT_53 = 0, INIT_54 = 0, INIT_55 = 0, INIT_56 = 0, INIT_57 = 0;
  parameter [255:0] INIT_58 = 0, INIT_59 = 0, INIT_5A = 0, INIT_5B = 0, INIT_5C = 0, INIT_5D = 0, INIT_5E = 0, INIT_5F = 0;
  parameter [255:0] INIT_60 = 0, INIT_61 = 0, INIT_62 = 0, INIT_63 = 0, INIT_64 = 0, INIT_65 = 0, INIT_66 = 0, INIT_67 = 0;
  parameter [255:0] INIT_68 = 0, INIT_69 = 0, INIT_6A = 0, INIT_6B = 0, INIT_6C = 0, INIT_6D = 0, INIT_6E = 0, INIT_6F = 0;
  parameter [255:0] INIT_70 = 0, INIT_71 = 0, INIT_72 = 0, INIT_73 = 0, INIT_74 = 0, INIT_75 = 0, INIT_76 = 0, INIT_77 = 0;
  parameter [255:0] INIT_78 = 0, INIT_79 = 0, INIT_7A = 0, INIT_7B = 0, INIT_7C = 0, INIT_7D = 0, INIT_7E = 0, INIT_7F = 0;
  parameter [255:0] INITP_00 = 0, INITP_01 = 0, INITP_02 = 0, INITP_03 = 0, INITP_04 = 0, INITP_05 = 0, INITP_06 = 0, INITP_07 = 0;
  parameter [255:0] INITP_08 = 0, INITP_09 = 0, INITP_0A = 0, INITP_0B = 0, INITP_0C = 0, INITP_0D = 0, INITP_0E = 0, INITP_0F = 0;
  localparam TDP = RAM_MODE == "TDP";
  // A port of two widths, or one that is too wide for one of two ports; outputs that start or are reset differently.
  localparam UNFIT_A = READ_WIDTH_A > 36 || WRITE_WIDTH_A > 36 || READ_WIDTH_A != WRITE_WIDTH_A && READ_WIDTH_A != 0 && WRITE_WIDTH_A != 0;
  localparam UNFIT_B = READ_WIDTH_B > 36 || WRITE_WIDTH_B > 36 || READ_WIDTH_B != WRITE_WIDTH_B && READ_WIDTH_B != 0 && WRITE_WIDTH_B != 0 || READ_WIDTH_A != 0 && READ_WIDTH_B != 0 && (INIT_A != INIT_B || SRVAL_A != SRVAL_B);
  initial if ((TDP ? UNFIT_A || UNFIT_B || DOB_REG != 0 : RAM_MODE != "SDP") || DOA_REG != 0 || IS_CLKARDCLK_INVERTED != 0 || IS_CLKBWRCLK_INVERTED != 0 || RAM_EXTENSION_A != "NONE") begin
    $display("RAMB36E1: a setting that has no model");
    $finish;
  end
  // Bytes of nine bits, the parity on top.
  function [287:0] row(input [255:0] data, input [31:0] parity);
    integer k;
    for (k = 0; k < 32; k = k + 1) row[9*k+:9] = {parity[k], data[8*k+:8]};
  endfunction
  localparam [128*288-1:0] ROWS = {
    row(INIT_7F, INITP_0F[224+:32]), row(INIT_7E, INITP_0F[192+:32]), row(INIT_7D, INITP_0F[160+:32]), row(INIT_7C, INITP_0F[128+:32]),
    row(INIT_7B, INITP_0F[96+:32]), row(INIT_7A, INITP_0F[64+:32]), row(INIT_79, INITP_0F[32+:32]), row(INIT_78, INITP_0F[0+:32]),
    row(INIT_77, INITP_0E[224+:32]), row(INIT_76, INITP_0E[192+:32]), row(INIT_75, INITP_0E[160+:32]), row(INIT_74, INITP_0E[128+:32]),
    row(INIT_73, INITP_0E[96+:32]), row(INIT_72, INITP_0E[64+:32]), row(INIT_71, INITP_0E[32+:32]), row(INIT_70, INITP_0E[0+:32]),
    row(INIT_6F, INITP_0D[224+:32]), row(INIT_6E, INITP_0D[192+:32]), row(INIT_6D, INITP_0D[160+:32]), row(INIT_6C, INITP_0D[128+:32]),
    row(INIT_6B, INITP_0D[96+:32]), row(INIT_6A, INITP_0D[64+:32]), row(INIT_69, INITP_0D[32+:32]), row(INIT_68, INITP_0D[0+:32]),
    row(INIT_67, INITP_0C[224+:32]), row(INIT_66, INITP_0C[192+:32]), row(INIT_65, INITP_0C[160+:32]), row(INIT_64, INITP_0C[128+:32]),
    row(INIT_63, INITP_0C[96+:32]), row(INIT_62, INITP_0C[64+:32]), row(INIT_61, INITP_0C[32+:32]), row(INIT_60, INITP_0C[0+:32]),
    row(INIT_5F, INITP_0B[224+:32]), row(INIT_5E, INITP_0B[192+:32]), row(INIT_5D, INITP_0B[160+:32]), row(INIT_5C, INITP_0B[128+:32]),
    row(INIT_5B, INITP_0B[96+:32]), row(INIT_5A, INITP_0B[64+:32]), row(INIT_59, INITP_0B[32+:32]), row(INIT_58, INITP_0B[0+:32]),
    row(INIT_57, INITP_0A[224+:32]), row(INIT_56, INITP_0A[192+:32]), row(INIT_55, INITP_0A[160+:32]), row(INIT_54, INITP_0A[128+:32]),
    row(INIT_53, INITP_0A[96+:32]), row(INIT_52, INITP_0A[64+:32]), row(INIT_51, INITP_0A[32+:32]), row(INIT_50, INITP_0A[0+:32]),
    row(INIT_4F, INITP_09[224+:32]), row(INIT_4E, INITP_09[192+:32]), row(INIT_4D, INITP_09[160+:32]), row(INIT_4C, INITP_09[128+:32]),
    row(INIT_4B, INITP_09[96+:32]), row(INIT_4A, INITP_09[64+:32]), row(INIT_49, INITP_09[32+:32]), row(INIT_48, INITP_09[0+:32]),
    row(INIT_47, INITP_08[224+:32]), row(INIT_46, INITP_08[192+:32]), row(INIT_45, INITP_08[160+:32]), row(INIT_44, INITP_08[128+:32]),
    row(INIT_43, INITP_08[96+:32]), row(INIT_42, INITP_08[64+:32]), row(INIT_41, INITP_08[32+:32]), row(INIT_40, INITP_08[0+:32]),
    row(INIT_3F, INITP_07[224+:32]), row(INIT_3E, INITP_07[192+:32]), row(INIT_3D, INITP_07[160+:32]), row(INIT_3C, INITP_07[128+:32]),
    row(INIT_3B, INITP_07[96+:32]), row(INIT_3A, INITP_07[64+:32]), row(INIT_39, INITP_07[32+:32]), row(INIT_38, INITP_07[0+:32]),
    row(INIT_37, INITP_06[224+:32]), row(INIT_36, INITP_06[192+:32]), row(INIT_35, INITP_06[160+:32]), row(INIT_34, INITP_06[128+:32]),
    row(INIT_33, INITP_06[96+:32]), row(INIT_32, INITP_06[64+:32]), row(INIT_31, INITP_06[32+:32]), row(INIT_30, INITP_06[0+:32]),
    row(INIT_2F, INITP_05[224+:32]), row(INIT_2E, INITP_05[192+:32]), row(INIT_2D, INITP_05[160+:32]), row(INIT_2C, INITP_05[128+:32]),
    row(INIT_2B, INITP_05[96+:32]), row(INIT_2A, INITP_05[64+:32]), row(INIT_29, INITP_05[32+:32]), row(INIT_28, INITP_05[0+:32]),
    row(INIT_27, INITP_04[224+:32]), row(INIT_26, INITP_04[192+:32]), row(INIT_25, INITP_04[160+:32]), row(INIT_24, INITP_04[128+:32]),
    row(INIT_23, INITP_04[96+:32]), row(INIT_22, INITP_04[64+:32]), row(INIT_21, INITP_04[32+:32]), row(INIT_20, INITP_04[0+:32]),
    row(INIT_1F, INITP_03[224+:32]), row(INIT_1E, INITP_03[192+:32]), row(INIT_1D, INITP_03[160+:32]), row(INIT_1C, INITP_03[128+:32]),
    row(INIT_1B, INITP_03[96+:32]), row(INIT_1A, INITP_03[64+:32]), row(INIT_19, INITP_03[32+:32]), row(INIT_18, INITP_03[0+:32]),
    row(INIT_17, INITP_02[224+:32]), row(INIT_16, INITP_02[192+:32]), row(INIT_15, INITP_02[160+:32]), row(INIT_14, INITP_02[128+:32]),
    row(INIT_13, INITP_02[96+:32]), row(INIT_12, INITP_02[64+:32]), row(INIT_11, INITP_02[32+:32]), row(INIT_10, INITP_02[0+:32]),
    row(INIT_0F, INITP_01[224+:32]), row(INIT_0E, INITP_01[192+:32]), row(INIT_0D, INITP_01[160+:32]), row(INIT_0C, INITP_01[128+:32]),
    row(INIT_0B, INITP_01[96+:32]), row(INIT_0A, INITP_01[64+:32]), row(INIT_09, INITP_01[32+:32]), row(INIT_08, INITP_01[0+:32]),
    row(INIT_07, INITP_00[224+:32]), row(INIT_06, INITP_00[192+:32]), row(INIT_05, INITP_00[160+:32]), row(INIT_04, INITP_00[128+:32]),
    row(INIT_03, INITP_00[96+:32]), row(INIT_02, INITP_00[64+:32]), row(INIT_01, INITP_00[32+:32]), row(INIT_00, INITP_00[0+:32])
  };
  function [71:0] word(input [63:0] data, input [7:0] parity);
    integer k;
    for (k = 0; k < 8; k = k + 1) word[9*k+:9] = {parity[k], data[8*k+:8]};
  endfunction
  // A write of the whole width takes its upper half from the data of port B, a narrower one everything.
  wire [71:0] data = WRITE_WIDTH_B == 72 ? word({DIBDI, DIADI}, {DIPBDIP, DIPADIP}) : word({32'b0, DIBDI}, {4'b0, DIPBDIP});
  wire [71:0] data_a = word({32'b0, DIADI}, {4'b0, DIPADIP});
  wire [71:0] out;
  wire [71:0] out_b;
  genvar g;
  generate
    for (g = 0; g < 4; g = g + 1) begin : gen_byte
      assign DOADO[8*g+:8] = out[9*g+:8];
      assign DOPADOP[g] = out[9*g+8];
      assign DOBDO[8*g+:8] = TDP ? out_b[9*g+:8] : out[9*(4+g)+:8];
      assign DOPBDOP[g] = TDP ? out_b[9*g+8] : out[9*(4+g)+8];
    end
  endgenerate
  localparam integer ONE_A = READ_WIDTH_A != 0 ? READ_WIDTH_A : WRITE_WIDTH_A != 0 ? WRITE_WIDTH_A : 9;
  localparam integer ONE_B = READ_WIDTH_B != 0 ? READ_WIDTH_B : WRITE_WIDTH_B != 0 ? WRITE_WIDTH_B : 9;
  localparam integer MODE_A = WRITE_MODE_A == "READ_FIRST" ? 2 : WRITE_MODE_A == "WRITE_FIRST" ? 1 : 0;
  localparam integer MODE_B = WRITE_MODE_B == "READ_FIRST" ? 2 : WRITE_MODE_B == "WRITE_FIRST" ? 1 : 0;
  // Of the modes of writing only READ_FIRST promises the old word to a reader at the same time.
  block_memory #(
    .BYTES(4096), .WIDTH_A(TDP ? ONE_A : READ_WIDTH_A), .WIDTH_B(TDP ? ONE_B : WRITE_WIDTH_B), .INIT(ROWS),
    .OLD(TDP ? (WRITE_WIDTH_A == 0 || MODE_A == 2) && (WRITE_WIDTH_B == 0 || MODE_B == 2) : WRITE_MODE_B == "READ_FIRST"),
    .MODE_A(TDP ? MODE_A : 0), .MODE_B(TDP ? MODE_B : 0), .START(TDP ? (READ_WIDTH_A != 0 ? INIT_A : INIT_B) : {INIT_B, INIT_A}),
    .CLEARED(TDP ? (READ_WIDTH_A != 0 ? SRVAL_A : SRVAL_B) : {SRVAL_B, SRVAL_A})
  ) u_memory (
    .clk_a(CLKARDCLK), .en_a(ENARDEN ^ IS_ENARDEN_INVERTED), .rst_a((ENARDEN ^ IS_ENARDEN_INVERTED) && (RSTRAMARSTRAM ^ IS_RSTRAMARSTRAM_INVERTED)),
    .we_a(TDP && WRITE_WIDTH_A != 0 ? WEA : 8'b0), .ad_a({ADDRARDADDR[14:0]}), .di_a(data_a), .do_a(out),
    .clk_b(CLKBWRCLK), .en_b(ENBWREN ^ IS_ENBWREN_INVERTED), .rst_b(TDP && (ENBWREN ^ IS_ENBWREN_INVERTED) && (RSTRAMB ^ IS_RSTRAMB_INVERTED)), .we_b(!TDP ? WEBWE : WRITE_WIDTH_B != 0 ? WEBWE[3:0] : 8'b0),
    .ad_b({ADDRBWRADDR[14:0]}), .di_b({data}), .do_b(out_b)
  );
endmodule
