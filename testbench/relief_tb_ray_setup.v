// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_tb_ray_setup: replays the golden vectors of ray_setup with random clock-enable gaps.
//   +vectors=DIR   directory with stimulus.hex and expected.hex (default golden/ray_setup)
// Ends with one line, PASS or FAIL, and exit_code: 0 ok, 1 mismatch, 2 unreadable vectors,
// 5 nothing ran, 6 a result never came, 7 an unexpected result.
`default_nettype none
module relief_tb_ray_setup #(
  parameter integer EXP_W    = 7,   // exponent bits
  parameter integer MAN_W    = 16,  // fraction bits, the hidden one not counted
  parameter integer LEVELS   = 8,   // the map has 2^LEVELS x 2^LEVELS texels
  parameter integer HEIGHT_W = 8,   // bits of a height code
  parameter integer TILE_W   = 4    // a ray travels less than 2^TILE_W tiles along each axis
) (
  input  wire       clk,
  output reg        done,
  output reg  [7:0] exit_code
);
  localparam integer Latency = 21;  // clocks from operands to results
  // Bits of a row, as the files announce them.
  localparam integer InW =
    EXP_W + MAN_W + 1 +  // u
    EXP_W + MAN_W + 1 +  // v
    EXP_W + MAN_W + 1 +  // du
    EXP_W + MAN_W + 1;  // dv
  localparam integer OutW =
    1 +  // ok
    $clog2(LEVELS + 1) +  // level
    EXP_W + MAN_W + 1 +  // p_x
    EXP_W + MAN_W + 1 +  // pb_x
    EXP_W + MAN_W + 1 +  // d_x
    EXP_W + MAN_W + 1 +  // r_x
    1 +  // never_x
    1 +  // neg_x
    LEVELS + TILE_W + 2 +  // first_x
    EXP_W + MAN_W + 1 +  // p_y
    EXP_W + MAN_W + 1 +  // pb_y
    EXP_W + MAN_W + 1 +  // d_y
    EXP_W + MAN_W + 1 +  // r_y
    1 +  // never_y
    1 +  // neg_y
    LEVELS + TILE_W + 2;  // first_y

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
  reg  [EXP_W+MAN_W:0] in_u;
  reg  [EXP_W+MAN_W:0] in_v;
  reg  [EXP_W+MAN_W:0] in_du;
  reg  [EXP_W+MAN_W:0] in_dv;
  wire  out_ok;
  wire [$clog2(LEVELS+1)-1:0] out_level;
  wire [EXP_W+MAN_W:0] out_p_x;
  wire [EXP_W+MAN_W:0] out_pb_x;
  wire [EXP_W+MAN_W:0] out_d_x;
  wire [EXP_W+MAN_W:0] out_r_x;
  wire  out_never_x;
  wire  out_neg_x;
  wire [LEVELS+TILE_W+1:0] out_first_x;
  wire [EXP_W+MAN_W:0] out_p_y;
  wire [EXP_W+MAN_W:0] out_pb_y;
  wire [EXP_W+MAN_W:0] out_d_y;
  wire [EXP_W+MAN_W:0] out_r_y;
  wire  out_never_y;
  wire  out_neg_y;
  wire [LEVELS+TILE_W+1:0] out_first_y;
  wire       out_valid = (Latency == 0) ? in_valid : travel[Latency];

  relief_ray_setup #(
    .EXP_W(EXP_W),
    .MAN_W(MAN_W),
    .LEVELS(LEVELS),
    .HEIGHT_W(HEIGHT_W),
    .TILE_W(TILE_W),
    .LATENCY(21),
    .VARIANT(32'h39c47949)
  ) dut (
    .clk(clk),
    .ce(ce),
    .u(in_u),
    .v(in_v),
    .du(in_du),
    .dv(in_dv),
    .ok(out_ok),
    .level(out_level),
    .p_x(out_p_x),
    .pb_x(out_pb_x),
    .d_x(out_d_x),
    .r_x(out_r_x),
    .never_x(out_never_x),
    .neg_x(out_neg_x),
    .first_x(out_first_x),
    .p_y(out_p_y),
    .pb_y(out_pb_y),
    .d_y(out_d_y),
    .r_y(out_r_y),
    .never_y(out_never_y),
    .neg_y(out_neg_y),
    .first_y(out_first_y)
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
    in_u = 0;
    in_v = 0;
    in_du = 0;
    in_dv = 0;
    stim_left = 0;
    exp_left = 0;
    if ($value$plusargs("vectors=%s", dir) == 0) dir = "golden/ray_setup";
    stim_fd = $fopen($sformatf("%0s/stimulus.hex", dir), "r");
    exp_fd = $fopen($sformatf("%0s/expected.hex", dir), "r");
    if (stim_fd == 0 || exp_fd == 0) begin
      $display("FAIL tb_ray_setup: %0s in %0s",
               "cannot read stimulus.hex and expected.hex", dir);
      exit_code = 8'd2;
      done = 1'b1;
    end else begin
      read_head(stim_fd, stim_left, stim_bits);
      read_head(exp_fd, exp_left, exp_bits);
      if ((stim_left == 0 && exp_left == 0) || stim_bits == 0 || exp_bits == 0) begin
        $display("FAIL tb_ray_setup: no vectors in %0s, nothing ran", dir);
        exit_code = 8'd5;
        done = 1'b1;
      end else if (stim_bits != InW || exp_bits != OutW) begin
        $display("FAIL tb_ray_setup: rows of %0d and %0d bits in %0s,",
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
        if (got != 1 || (word >> (1)) != 0) bad_out = 1'b1;
        if (out_ok !== word[0]) begin
          if (wrong < 10)
            $display("vector %0d, ok: expected %h, got %h",
                     checked, word[0], out_ok);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=ray_setup row=%0d port=ok exp=%h got=%h",
                     checked, word[0], out_ok);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> ($clog2(LEVELS + 1))) != 0) bad_out = 1'b1;
        if (out_level !== word[$clog2(LEVELS+1)-1:0]) begin
          if (wrong < 10)
            $display("vector %0d, level: expected %h, got %h",
                     checked, word[$clog2(LEVELS+1)-1:0], out_level);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=ray_setup row=%0d port=level exp=%h got=%h",
                     checked, word[$clog2(LEVELS+1)-1:0], out_level);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad_out = 1'b1;
        if (out_p_x !== word[EXP_W+MAN_W:0]) begin
          if (wrong < 10)
            $display("vector %0d, p_x: expected %h, got %h",
                     checked, word[EXP_W+MAN_W:0], out_p_x);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=ray_setup row=%0d port=p_x exp=%h got=%h",
                     checked, word[EXP_W+MAN_W:0], out_p_x);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad_out = 1'b1;
        if (out_pb_x !== word[EXP_W+MAN_W:0]) begin
          if (wrong < 10)
            $display("vector %0d, pb_x: expected %h, got %h",
                     checked, word[EXP_W+MAN_W:0], out_pb_x);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=ray_setup row=%0d port=pb_x exp=%h got=%h",
                     checked, word[EXP_W+MAN_W:0], out_pb_x);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad_out = 1'b1;
        if (out_d_x !== word[EXP_W+MAN_W:0]) begin
          if (wrong < 10)
            $display("vector %0d, d_x: expected %h, got %h",
                     checked, word[EXP_W+MAN_W:0], out_d_x);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=ray_setup row=%0d port=d_x exp=%h got=%h",
                     checked, word[EXP_W+MAN_W:0], out_d_x);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad_out = 1'b1;
        if (out_r_x !== word[EXP_W+MAN_W:0]) begin
          if (wrong < 10)
            $display("vector %0d, r_x: expected %h, got %h",
                     checked, word[EXP_W+MAN_W:0], out_r_x);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=ray_setup row=%0d port=r_x exp=%h got=%h",
                     checked, word[EXP_W+MAN_W:0], out_r_x);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (1)) != 0) bad_out = 1'b1;
        if (out_never_x !== word[0]) begin
          if (wrong < 10)
            $display("vector %0d, never_x: expected %h, got %h",
                     checked, word[0], out_never_x);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=ray_setup row=%0d port=never_x exp=%h got=%h",
                     checked, word[0], out_never_x);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (1)) != 0) bad_out = 1'b1;
        if (out_neg_x !== word[0]) begin
          if (wrong < 10)
            $display("vector %0d, neg_x: expected %h, got %h",
                     checked, word[0], out_neg_x);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=ray_setup row=%0d port=neg_x exp=%h got=%h",
                     checked, word[0], out_neg_x);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (LEVELS + TILE_W + 2)) != 0) bad_out = 1'b1;
        if (out_first_x !== word[LEVELS+TILE_W+1:0]) begin
          if (wrong < 10)
            $display("vector %0d, first_x: expected %h, got %h",
                     checked, word[LEVELS+TILE_W+1:0], out_first_x);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=ray_setup row=%0d port=first_x exp=%h got=%h",
                     checked, word[LEVELS+TILE_W+1:0], out_first_x);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad_out = 1'b1;
        if (out_p_y !== word[EXP_W+MAN_W:0]) begin
          if (wrong < 10)
            $display("vector %0d, p_y: expected %h, got %h",
                     checked, word[EXP_W+MAN_W:0], out_p_y);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=ray_setup row=%0d port=p_y exp=%h got=%h",
                     checked, word[EXP_W+MAN_W:0], out_p_y);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad_out = 1'b1;
        if (out_pb_y !== word[EXP_W+MAN_W:0]) begin
          if (wrong < 10)
            $display("vector %0d, pb_y: expected %h, got %h",
                     checked, word[EXP_W+MAN_W:0], out_pb_y);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=ray_setup row=%0d port=pb_y exp=%h got=%h",
                     checked, word[EXP_W+MAN_W:0], out_pb_y);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad_out = 1'b1;
        if (out_d_y !== word[EXP_W+MAN_W:0]) begin
          if (wrong < 10)
            $display("vector %0d, d_y: expected %h, got %h",
                     checked, word[EXP_W+MAN_W:0], out_d_y);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=ray_setup row=%0d port=d_y exp=%h got=%h",
                     checked, word[EXP_W+MAN_W:0], out_d_y);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad_out = 1'b1;
        if (out_r_y !== word[EXP_W+MAN_W:0]) begin
          if (wrong < 10)
            $display("vector %0d, r_y: expected %h, got %h",
                     checked, word[EXP_W+MAN_W:0], out_r_y);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=ray_setup row=%0d port=r_y exp=%h got=%h",
                     checked, word[EXP_W+MAN_W:0], out_r_y);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (1)) != 0) bad_out = 1'b1;
        if (out_never_y !== word[0]) begin
          if (wrong < 10)
            $display("vector %0d, never_y: expected %h, got %h",
                     checked, word[0], out_never_y);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=ray_setup row=%0d port=never_y exp=%h got=%h",
                     checked, word[0], out_never_y);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (1)) != 0) bad_out = 1'b1;
        if (out_neg_y !== word[0]) begin
          if (wrong < 10)
            $display("vector %0d, neg_y: expected %h, got %h",
                     checked, word[0], out_neg_y);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=ray_setup row=%0d port=neg_y exp=%h got=%h",
                     checked, word[0], out_neg_y);
          row_wrong = 1'b1;
        end
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (LEVELS + TILE_W + 2)) != 0) bad_out = 1'b1;
        if (out_first_y !== word[LEVELS+TILE_W+1:0]) begin
          if (wrong < 10)
            $display("vector %0d, first_y: expected %h, got %h",
                     checked, word[LEVELS+TILE_W+1:0], out_first_y);
          if (wrong == 0 && !row_wrong)
            $display("@fail unit=ray_setup row=%0d port=first_y exp=%h got=%h",
                     checked, word[LEVELS+TILE_W+1:0], out_first_y);
          row_wrong = 1'b1;
        end
        checked <= checked + 1;
        exp_left <= exp_left - 1;
        if (row_wrong) wrong <= wrong + 1;
      end
      if (stim_left > 0) begin
        got = $fscanf(stim_fd, "%h", word);
        if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad_in = 1'b1;
        in_u <= word[EXP_W+MAN_W:0];
        got = $fscanf(stim_fd, "%h", word);
        if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad_in = 1'b1;
        in_v <= word[EXP_W+MAN_W:0];
        got = $fscanf(stim_fd, "%h", word);
        if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad_in = 1'b1;
        in_du <= word[EXP_W+MAN_W:0];
        got = $fscanf(stim_fd, "%h", word);
        if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad_in = 1'b1;
        in_dv <= word[EXP_W+MAN_W:0];
        in_valid <= 1'b1;
        stim_left <= stim_left - 1;
      end else begin
        in_valid <= 1'b0;
        drain <= drain + 1;
      end
      if (bad_in || bad_out) begin
        $display("FAIL tb_ray_setup: %0s.hex holds other rows than it announces",
                 bad_in ? "stimulus" : "expected");
        exit_code <= 8'd2;
        done <= 1'b1;
      end else if (out_valid && exp_left == 0) begin
        $display("FAIL tb_ray_setup: %0s, after %0d",
                 "an unexpected result", checked);
        exit_code <= 8'd7;
        done <= 1'b1;
      end else if (drain > Latency + 4) begin
        done <= 1'b1;
        got = $fscanf(stim_fd, "%h", word);
        got_exp = $fscanf(exp_fd, "%h", word);
        if (exp_left > 0) begin
          $display("FAIL tb_ray_setup: vector %0d was expected and never came", checked);
          exit_code <= 8'd6;
        end else if (got == 1 || got_exp == 1) begin
          $display("FAIL tb_ray_setup: %0s in %0s holds more rows than it announces",
                   "stimulus.hex or expected.hex", dir);
          exit_code <= 8'd2;
        end else if (wrong > 0) begin
          $display("@done unit=ray_setup checked=%0d wrong=%0d", checked, wrong);
          $display("FAIL tb_ray_setup: %0d of %0d mismatched", wrong, checked);
          exit_code <= 8'd1;
        end else begin
          $display("@done unit=ray_setup checked=%0d wrong=0", checked);
          $display("PASS tb_ray_setup: 0 of %0d mismatched", checked);
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
