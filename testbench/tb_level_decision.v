// tb_level_decision: replays the golden vectors of level_decision with random clock-enable gaps.
//   +vectors=DIR   directory with stimulus.hex and expected.hex (default golden/level_decision)
// Ends with one line, PASS or FAIL, and exit_code: 0 ok, 1 mismatch, 2 unreadable vectors,
// 5 nothing ran, 6 a result never came, 7 a result that nobody expected.
`default_nettype none
module tb_level_decision #(
  parameter integer EXP_W = 7,
  parameter integer MAN_W = 16,
  parameter integer LEVELS = 8,
  parameter integer IDX_W = 14
) (
  input  wire       clk,
  output reg        done,
  output reg  [7:0] exit_code
);
  localparam integer Latency = 0;

  reg [8*200-1:0] dir;
  reg [8*240-1:0] path;
  reg [8*400-1:0] header;
  integer stim_fd;
  integer exp_fd;
  integer stim_left;
  integer exp_left;
  integer checked;
  integer wrong;
  integer drain;
  integer got;

  reg [63:0] word;
  reg        row_wrong;
  reg [31:0] lfsr;
  reg        ce;
  reg        in_valid;
  reg [Latency:0] travel;
  reg   in_is_inside;
  reg   in_x_first;
  reg   in_up;
  reg  [$clog2(LEVELS+1)-1:0] in_level;
  reg  [$clog2(LEVELS+1)-1:0] in_level_down;
  reg  [EXP_W+MAN_W:0] in_m;
  reg  [EXP_W+MAN_W:0] in_t_next;
  reg  [IDX_W-1:0] in_x_at;
  reg  [IDX_W-1:0] in_x_down;
  reg  [IDX_W-1:0] in_x_beyond;
  reg  [IDX_W-1:0] in_y_at;
  reg  [IDX_W-1:0] in_y_down;
  reg  [IDX_W-1:0] in_y_beyond;
  wire  out_hit;
  wire  out_crosses;
  wire [$clog2(LEVELS+1)-1:0] out_level_next;
  wire [IDX_W-1:0] out_x_next;
  wire [IDX_W-1:0] out_y_next;
  wire [EXP_W+MAN_W:0] out_t_out;
  wire       out_valid = (Latency == 0) ? in_valid : travel[Latency];

  level_decision #(
    .EXP_W(EXP_W),
    .MAN_W(MAN_W),
    .LEVELS(LEVELS),
    .IDX_W(IDX_W)
  ) dut (
    .is_inside(in_is_inside),
    .x_first(in_x_first),
    .up(in_up),
    .level(in_level),
    .level_down(in_level_down),
    .m(in_m),
    .t_next(in_t_next),
    .x_at(in_x_at),
    .x_down(in_x_down),
    .x_beyond(in_x_beyond),
    .y_at(in_y_at),
    .y_down(in_y_down),
    .y_beyond(in_y_beyond),
    .hit(out_hit),
    .crosses(out_crosses),
    .level_next(out_level_next),
    .x_next(out_x_next),
    .y_next(out_y_next),
    .t_out(out_t_out)
  );

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
    word = 0;
    row_wrong = 1'b0;
    in_is_inside = 0;
    in_x_first = 0;
    in_up = 0;
    in_level = 0;
    in_level_down = 0;
    in_m = 0;
    in_t_next = 0;
    in_x_at = 0;
    in_x_down = 0;
    in_x_beyond = 0;
    in_y_at = 0;
    in_y_down = 0;
    in_y_beyond = 0;
    stim_left = 0;
    exp_left = 0;
    if ($value$plusargs("vectors=%s", dir) == 0) dir = "golden/level_decision";
    $sformat(path, "%0s/stimulus.hex", dir);
    stim_fd = $fopen(path, "r");
    $sformat(path, "%0s/expected.hex", dir);
    exp_fd = $fopen(path, "r");
    if (stim_fd == 0 || exp_fd == 0) begin
      $display("FAIL tb_level_decision: cannot read stimulus.hex and expected.hex in %0s", dir);
      exit_code = 8'd2;
      done = 1'b1;
    end else begin
      got = $fgets(header, stim_fd);
      got = $fscanf(stim_fd, "%h", word);
      stim_left = (got == 1) ? word[31:0] : 0;
      got = $fgets(header, exp_fd);
      got = $fscanf(exp_fd, "%h", word);
      exp_left = (got == 1) ? word[31:0] : 0;
      if (stim_left == 0 && exp_left == 0) begin
        $display("FAIL tb_level_decision: no vectors in %0s, nothing ran", dir);
        exit_code = 8'd5;
        done = 1'b1;
      end
    end
  end

  always @(posedge clk) begin
    if (!done) begin
      lfsr <= {lfsr[30:0], lfsr[31] ^ lfsr[21] ^ lfsr[1] ^ lfsr[0]};
      ce <= lfsr[3] | lfsr[7];
      if (ce) begin
        travel <= (travel << 1) | (in_valid ? 1'b1 : 0);
        if (out_valid) begin
          if (exp_left == 0) begin
            $display("FAIL tb_level_decision: a result came that nobody expected, after %0d", checked);
            exit_code <= 8'd7;
            done <= 1'b1;
          end else begin
            row_wrong = 1'b0;
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_hit !== word[0]) begin
              if (wrong < 10)
                $display("vector %0d, hit: expected %h, got %h", checked, word[0], out_hit);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_crosses !== word[0]) begin
              if (wrong < 10)
                $display("vector %0d, crosses: expected %h, got %h", checked, word[0], out_crosses);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_level_next !== word[$clog2(LEVELS+1)-1:0]) begin
              if (wrong < 10)
                $display("vector %0d, level_next: expected %h, got %h", checked, word[$clog2(LEVELS+1)-1:0], out_level_next);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_x_next !== word[IDX_W-1:0]) begin
              if (wrong < 10)
                $display("vector %0d, x_next: expected %h, got %h", checked, word[IDX_W-1:0], out_x_next);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_y_next !== word[IDX_W-1:0]) begin
              if (wrong < 10)
                $display("vector %0d, y_next: expected %h, got %h", checked, word[IDX_W-1:0], out_y_next);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_t_out !== word[EXP_W+MAN_W:0]) begin
              if (wrong < 10)
                $display("vector %0d, t_out: expected %h, got %h", checked, word[EXP_W+MAN_W:0], out_t_out);
              row_wrong = 1'b1;
            end
            checked = checked + 1;
            exp_left = exp_left - 1;
            if (row_wrong) wrong = wrong + 1;
          end
        end
        if (stim_left > 0) begin
          got = $fscanf(stim_fd, "%h", word);
          in_is_inside <= word[0];
          got = $fscanf(stim_fd, "%h", word);
          in_x_first <= word[0];
          got = $fscanf(stim_fd, "%h", word);
          in_up <= word[0];
          got = $fscanf(stim_fd, "%h", word);
          in_level <= word[$clog2(LEVELS+1)-1:0];
          got = $fscanf(stim_fd, "%h", word);
          in_level_down <= word[$clog2(LEVELS+1)-1:0];
          got = $fscanf(stim_fd, "%h", word);
          in_m <= word[EXP_W+MAN_W:0];
          got = $fscanf(stim_fd, "%h", word);
          in_t_next <= word[EXP_W+MAN_W:0];
          got = $fscanf(stim_fd, "%h", word);
          in_x_at <= word[IDX_W-1:0];
          got = $fscanf(stim_fd, "%h", word);
          in_x_down <= word[IDX_W-1:0];
          got = $fscanf(stim_fd, "%h", word);
          in_x_beyond <= word[IDX_W-1:0];
          got = $fscanf(stim_fd, "%h", word);
          in_y_at <= word[IDX_W-1:0];
          got = $fscanf(stim_fd, "%h", word);
          in_y_down <= word[IDX_W-1:0];
          got = $fscanf(stim_fd, "%h", word);
          in_y_beyond <= word[IDX_W-1:0];
          if (got != 1) begin
            $display("FAIL tb_level_decision: stimulus.hex ends before the number of rows that it announces");
            exit_code <= 8'd2;
            done <= 1'b1;
          end
          in_valid <= 1'b1;
          stim_left = stim_left - 1;
        end else begin
          in_valid <= 1'b0;
          drain = drain + 1;
        end
        if (drain > Latency + 4) begin
          done <= 1'b1;
          if (exp_left > 0) begin
            $display("FAIL tb_level_decision: vector %0d was expected and never came", checked);
            exit_code <= 8'd6;
          end else if (wrong > 0) begin
            $display("FAIL tb_level_decision: %0d of %0d mismatched", wrong, checked);
            exit_code <= 8'd1;
          end else begin
            $display("PASS tb_level_decision: 0 of %0d mismatched", checked);
          end
        end
      end
    end
  end
endmodule
`default_nettype wire
