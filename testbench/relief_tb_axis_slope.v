// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_tb_axis_slope: replays the golden vectors of axis_slope with random clock-enable gaps.
//   +vectors=DIR   directory with stimulus.hex and expected.hex (default golden/axis_slope)
// Ends with one line, PASS or FAIL, and exit_code: 0 ok, 1 mismatch, 2 unreadable vectors,
// 5 nothing ran, 6 a result never came, 7 an unexpected result.
`default_nettype none
module relief_tb_axis_slope #(
  parameter integer EXP_W    = 7,   // exponent bits
  parameter integer MAN_W    = 16,  // fraction bits, the hidden one not counted
  parameter integer LEVELS   = 8,   // the map has 2^LEVELS x 2^LEVELS texels
  parameter integer HEIGHT_W = 8    // bits of a height code
) (
  input  wire       clk,
  output reg        done,
  output reg  [7:0] exit_code
);
  localparam integer Latency = 20;  // clocks from operands to results
  // Bits of a row, as the files announce them.
  localparam integer InW =
    EXP_W + MAN_W + 1 +  // p
    EXP_W + MAN_W + 1;  // dn
  localparam integer OutW =
    EXP_W + MAN_W + 1 +  // p_back
    EXP_W + MAN_W + 1 +  // d
    EXP_W + MAN_W + 1 +  // r
    1;  // never

  reg [8*1000-1:0] dir;
  integer stim_fd;
  integer exp_fd;
  integer stim_left;
  integer exp_left;
  integer stim_bits;
  integer exp_bits;
  integer checked;
  integer wrong;
  integer drain;
  reg [31:0] lfsr;

  reg        ce;
  reg        in_valid;
  reg [Latency:0] travel;
  reg  [EXP_W+MAN_W:0] in_p;
  reg  [EXP_W+MAN_W:0] in_dn;
  wire [EXP_W+MAN_W:0] out_p_back;
  wire [EXP_W+MAN_W:0] out_d;
  wire [EXP_W+MAN_W:0] out_r;
  wire  out_never;
  wire       out_valid = (Latency == 0) ? in_valid : travel[Latency];

  relief_axis_slope #(
    .EXP_W(EXP_W),
    .MAN_W(MAN_W),
    .LEVELS(LEVELS),
    .HEIGHT_W(HEIGHT_W),
    .LATENCY(20),
    .VARIANT(32'h054b90fe)
  ) dut (
    .clk(clk),
    .ce(ce),
    .p(in_p),
    .dn(in_dn),
    .p_back(out_p_back),
    .d(out_d),
    .r(out_r),
    .never(out_never)
  );

  // Yosys has no files and no delays: it sees the module under test and its parameters alone.
`ifndef YOSYS
  // The head of a file: a comment, then the number of rows and the bits of a row.
  task automatic read_head(input integer fd, output integer rows, output integer bits);
    integer c;
    begin
      c = $fgetc(fd);
      while (c != 10 && c >= 0) c = $fgetc(fd);
      rows = 0;
      bits = 0;
      if (fd != 0) c = $fscanf(fd, "%h %h", rows, bits);
      if (c != 2) rows = 0;
    end
  endtask

  initial begin
    done = 1'b0;
    exit_code = 8'd0;
    checked = 0;
    wrong = 0;
    drain = 0;
    lfsr = 32'h1234_5678;
    ce = 1'b0;
    in_valid = 1'b0;
    travel = 0;
    in_p = 0;
    in_dn = 0;
    stim_left = 0;
    exp_left = 0;
    if ($value$plusargs("vectors=%s", dir) == 0) dir = "golden/axis_slope";
    stim_fd = $fopen($sformatf("%0s/stimulus.hex", dir), "r");
    exp_fd = $fopen($sformatf("%0s/expected.hex", dir), "r");
    if (stim_fd == 0 || exp_fd == 0) begin
      $display("FAIL tb_axis_slope: %0s in %0s",
               "cannot read stimulus.hex and expected.hex", dir);
      exit_code = 8'd2;
      done = 1'b1;
    end else begin
      read_head(stim_fd, stim_left, stim_bits);
      read_head(exp_fd, exp_left, exp_bits);
      if ((stim_left == 0 && exp_left == 0) || stim_bits == 0 || exp_bits == 0) begin
        $display("FAIL tb_axis_slope: no vectors in %0s, nothing ran", dir);
        exit_code = 8'd5;
        done = 1'b1;
      end else if (stim_bits != InW || exp_bits != OutW) begin
        $display("FAIL tb_axis_slope: rows of %0d and %0d bits in %0s,",
                 stim_bits, exp_bits, dir, " these parameter values need %0d and %0d", InW, OutW);
        exit_code = 8'd2;
        done = 1'b1;
      end
    end
  end

  // One clock. What is needed within the clock alone is local to the task.
  task automatic step;
    integer got;
    integer got_exp;
    reg [63:0] word;
    reg bad_in;
    reg bad_out;
    reg row_wrong;
    begin
      bad_in = 1'b0;
      bad_out = 1'b0;
      row_wrong = 1'b0;
      travel <= (travel << 1) | (in_valid ? 2 : 0);
      if (out_valid && exp_left != 0) begin
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad_out = 1'b1;
        if (out_p_back !== word[EXP_W+MAN_W:0]) begin
          if (wrong < 10)
            $display("vector %0d, p_back: expected %h, got %h",
                     checked, word[EXP_W+MAN_W:0], out_p_back);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=axis_slope row=%0d port=p_back exp=%h got=%h",
                     checked, word[EXP_W+MAN_W:0], out_p_back);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad_out = 1'b1;
        if (out_d !== word[EXP_W+MAN_W:0]) begin
          if (wrong < 10)
            $display("vector %0d, d: expected %h, got %h",
                     checked, word[EXP_W+MAN_W:0], out_d);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=axis_slope row=%0d port=d exp=%h got=%h",
                     checked, word[EXP_W+MAN_W:0], out_d);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad_out = 1'b1;
        if (out_r !== word[EXP_W+MAN_W:0]) begin
          if (wrong < 10)
            $display("vector %0d, r: expected %h, got %h",
                     checked, word[EXP_W+MAN_W:0], out_r);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=axis_slope row=%0d port=r exp=%h got=%h",
                     checked, word[EXP_W+MAN_W:0], out_r);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (1)) != 0) bad_out = 1'b1;
        if (out_never !== word[0]) begin
          if (wrong < 10)
            $display("vector %0d, never: expected %h, got %h",
                     checked, word[0], out_never);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=axis_slope row=%0d port=never exp=%h got=%h",
                     checked, word[0], out_never);
          row_wrong = 1'b1;
        end
        checked <= checked + 1;
        exp_left <= exp_left - 1;
        if (row_wrong) wrong <= wrong + 1;
      end
      if (stim_left > 0) begin
        got = $fscanf(stim_fd, "%h", word);
        if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad_in = 1'b1;
        in_p <= word[EXP_W+MAN_W:0];
        got = $fscanf(stim_fd, "%h", word);
        if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad_in = 1'b1;
        in_dn <= word[EXP_W+MAN_W:0];
        in_valid <= 1'b1;
        stim_left <= stim_left - 1;
      end else begin
        in_valid <= 1'b0;
        drain <= drain + 1;
      end
      if (bad_in || bad_out) begin
        $display("FAIL tb_axis_slope: %0s.hex holds other rows than it announces",
                 bad_in ? "stimulus" : "expected");
        exit_code <= 8'd2;
        done <= 1'b1;
      end else if (out_valid && exp_left == 0) begin
        $display("FAIL tb_axis_slope: %0s, after %0d",
                 "an unexpected result", checked);
        exit_code <= 8'd7;
        done <= 1'b1;
      end else if (drain > Latency + 4) begin
        done <= 1'b1;
        got = $fscanf(stim_fd, "%h", word);
        got_exp = $fscanf(exp_fd, "%h", word);
        if (exp_left > 0) begin
          $display("FAIL tb_axis_slope: vector %0d was expected and never came", checked);
          exit_code <= 8'd6;
        end else if (got == 1 || got_exp == 1) begin
          $display("FAIL tb_axis_slope: %0s in %0s holds more rows than it announces",
                   "stimulus.hex or expected.hex", dir);
          exit_code <= 8'd2;
        end else if (wrong > 0) begin
          $display("@done unit=axis_slope checked=%0d wrong=%0d", checked, wrong);
          $display("FAIL tb_axis_slope: %0d of %0d mismatched", wrong, checked);
          exit_code <= 8'd1;
        end else begin
          $display("@done unit=axis_slope checked=%0d wrong=0", checked);
          $display("PASS tb_axis_slope: 0 of %0d mismatched", checked);
        end
      end
    end
  endtask

  always @(posedge clk) begin
    if (!done) begin
      lfsr <= {lfsr[30:0], lfsr[31] ^ lfsr[21] ^ lfsr[1] ^ lfsr[0]};
      ce <= lfsr[3] | lfsr[7];
      if (ce) step;
    end
  end
`endif
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
