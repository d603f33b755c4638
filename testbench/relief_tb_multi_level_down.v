// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_tb_multi_level_down: replays the golden vectors of multi_level_down with random clock-enable gaps.
//   +vectors=DIR   directory with stimulus.hex and expected.hex (default golden/multi_level_down)
// Ends with one line, PASS or FAIL, and exit_code: 0 ok, 1 mismatch, 2 unreadable vectors,
// 5 nothing ran, 6 a result never came, 7 an unexpected result.
`default_nettype none
module relief_tb_multi_level_down #(
  parameter integer LEVELS = 8,  // the map has 2^LEVELS x 2^LEVELS texels
  parameter integer IDX_W  = 14  // bits of a signed, unwrapped texel coordinate
) (
  input  wire       clk,
  output reg        done,
  output reg  [7:0] exit_code
);
  localparam integer Latency = 0;  // clocks from operands to results
  // Bits of a row, as the files announce them.
  localparam integer InW =
    $clog2(LEVELS + 1) +  // level
    1 +  // crossed
    IDX_W +  // x_low
    IDX_W +  // x_high
    IDX_W +  // x_hit
    IDX_W +  // y_low
    IDX_W +  // y_high
    IDX_W;  // y_hit
  localparam integer OutW =
    $clog2(LEVELS + 1) +  // level_down
    IDX_W +  // x_down
    IDX_W;  // y_down

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
  reg  [$clog2(LEVELS+1)-1:0] in_level;
  reg   in_crossed;
  reg  [IDX_W-1:0] in_x_low;
  reg  [IDX_W-1:0] in_x_high;
  reg  [IDX_W-1:0] in_x_hit;
  reg  [IDX_W-1:0] in_y_low;
  reg  [IDX_W-1:0] in_y_high;
  reg  [IDX_W-1:0] in_y_hit;
  wire [$clog2(LEVELS+1)-1:0] out_level_down;
  wire [IDX_W-1:0] out_x_down;
  wire [IDX_W-1:0] out_y_down;
  wire       out_valid = (Latency == 0) ? in_valid : travel[Latency];

  relief_multi_level_down #(
    .LEVELS(LEVELS),
    .IDX_W(IDX_W),
    .LATENCY(0),
    .VARIANT(32'h44b45e20)
  ) dut (
    .level(in_level),
    .crossed(in_crossed),
    .x_low(in_x_low),
    .x_high(in_x_high),
    .x_hit(in_x_hit),
    .y_low(in_y_low),
    .y_high(in_y_high),
    .y_hit(in_y_hit),
    .level_down(out_level_down),
    .x_down(out_x_down),
    .y_down(out_y_down)
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
    in_level = 0;
    in_crossed = 0;
    in_x_low = 0;
    in_x_high = 0;
    in_x_hit = 0;
    in_y_low = 0;
    in_y_high = 0;
    in_y_hit = 0;
    stim_left = 0;
    exp_left = 0;
    if ($value$plusargs("vectors=%s", dir) == 0) dir = "golden/multi_level_down";
    stim_fd = $fopen($sformatf("%0s/stimulus.hex", dir), "r");
    exp_fd = $fopen($sformatf("%0s/expected.hex", dir), "r");
    if (stim_fd == 0 || exp_fd == 0) begin
      $display("FAIL tb_multi_level_down: %0s in %0s",
               "cannot read stimulus.hex and expected.hex", dir);
      exit_code = 8'd2;
      done = 1'b1;
    end else begin
      read_head(stim_fd, stim_left, stim_bits);
      read_head(exp_fd, exp_left, exp_bits);
      if ((stim_left == 0 && exp_left == 0) || stim_bits == 0 || exp_bits == 0) begin
        $display("FAIL tb_multi_level_down: no vectors in %0s, nothing ran", dir);
        exit_code = 8'd5;
        done = 1'b1;
      end else if (stim_bits != InW || exp_bits != OutW) begin
        $display("FAIL tb_multi_level_down: rows of %0d and %0d bits in %0s,",
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
      travel <= (travel << 1) | (in_valid ? 1'b1 : 0);
      if (out_valid && exp_left != 0) begin
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> ($clog2(LEVELS + 1))) != 0) bad_out = 1'b1;
        if (out_level_down !== word[$clog2(LEVELS+1)-1:0]) begin
          if (wrong < 10)
            $display("vector %0d, level_down: expected %h, got %h",
                     checked, word[$clog2(LEVELS+1)-1:0], out_level_down);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=multi_level_down row=%0d port=level_down exp=%h got=%h",
                     checked, word[$clog2(LEVELS+1)-1:0], out_level_down);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (IDX_W)) != 0) bad_out = 1'b1;
        if (out_x_down !== word[IDX_W-1:0]) begin
          if (wrong < 10)
            $display("vector %0d, x_down: expected %h, got %h",
                     checked, word[IDX_W-1:0], out_x_down);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=multi_level_down row=%0d port=x_down exp=%h got=%h",
                     checked, word[IDX_W-1:0], out_x_down);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (IDX_W)) != 0) bad_out = 1'b1;
        if (out_y_down !== word[IDX_W-1:0]) begin
          if (wrong < 10)
            $display("vector %0d, y_down: expected %h, got %h",
                     checked, word[IDX_W-1:0], out_y_down);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=multi_level_down row=%0d port=y_down exp=%h got=%h",
                     checked, word[IDX_W-1:0], out_y_down);
          row_wrong = 1'b1;
        end
        checked <= checked + 1;
        exp_left <= exp_left - 1;
        if (row_wrong) wrong <= wrong + 1;
      end
      if (stim_left > 0) begin
        got = $fscanf(stim_fd, "%h", word);
        if (got != 1 || (word >> ($clog2(LEVELS + 1))) != 0) bad_in = 1'b1;
        in_level <= word[$clog2(LEVELS+1)-1:0];
        got = $fscanf(stim_fd, "%h", word);
        if (got != 1 || (word >> (1)) != 0) bad_in = 1'b1;
        in_crossed <= word[0];
        got = $fscanf(stim_fd, "%h", word);
        if (got != 1 || (word >> (IDX_W)) != 0) bad_in = 1'b1;
        in_x_low <= word[IDX_W-1:0];
        got = $fscanf(stim_fd, "%h", word);
        if (got != 1 || (word >> (IDX_W)) != 0) bad_in = 1'b1;
        in_x_high <= word[IDX_W-1:0];
        got = $fscanf(stim_fd, "%h", word);
        if (got != 1 || (word >> (IDX_W)) != 0) bad_in = 1'b1;
        in_x_hit <= word[IDX_W-1:0];
        got = $fscanf(stim_fd, "%h", word);
        if (got != 1 || (word >> (IDX_W)) != 0) bad_in = 1'b1;
        in_y_low <= word[IDX_W-1:0];
        got = $fscanf(stim_fd, "%h", word);
        if (got != 1 || (word >> (IDX_W)) != 0) bad_in = 1'b1;
        in_y_high <= word[IDX_W-1:0];
        got = $fscanf(stim_fd, "%h", word);
        if (got != 1 || (word >> (IDX_W)) != 0) bad_in = 1'b1;
        in_y_hit <= word[IDX_W-1:0];
        in_valid <= 1'b1;
        stim_left <= stim_left - 1;
      end else begin
        in_valid <= 1'b0;
        drain <= drain + 1;
      end
      if (bad_in || bad_out) begin
        $display("FAIL tb_multi_level_down: %0s.hex holds other rows than it announces",
                 bad_in ? "stimulus" : "expected");
        exit_code <= 8'd2;
        done <= 1'b1;
      end else if (out_valid && exp_left == 0) begin
        $display("FAIL tb_multi_level_down: %0s, after %0d",
                 "an unexpected result", checked);
        exit_code <= 8'd7;
        done <= 1'b1;
      end else if (drain > Latency + 4) begin
        done <= 1'b1;
        got = $fscanf(stim_fd, "%h", word);
        got_exp = $fscanf(exp_fd, "%h", word);
        if (exp_left > 0) begin
          $display("FAIL tb_multi_level_down: vector %0d was expected and never came", checked);
          exit_code <= 8'd6;
        end else if (got == 1 || got_exp == 1) begin
          $display("FAIL tb_multi_level_down: %0s in %0s holds more rows than it announces",
                   "stimulus.hex or expected.hex", dir);
          exit_code <= 8'd2;
        end else if (wrong > 0) begin
          $display("@done unit=multi_level_down checked=%0d wrong=%0d", checked, wrong);
          $display("FAIL tb_multi_level_down: %0d of %0d mismatched", wrong, checked);
          exit_code <= 8'd1;
        end else begin
          $display("@done unit=multi_level_down checked=%0d wrong=0", checked);
          $display("PASS tb_multi_level_down: 0 of %0d mismatched", checked);
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
