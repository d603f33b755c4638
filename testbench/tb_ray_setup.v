// tb_ray_setup: replays the golden vectors of ray_setup with random clock-enable gaps.
//   +vectors=DIR   directory with stimulus.hex and expected.hex (default golden/ray_setup)
// Ends with one line, PASS or FAIL, and exit_code: 0 ok, 1 mismatch, 2 unreadable vectors,
// 5 nothing ran, 6 a result never came, 7 a result that nobody expected.
`default_nettype none
module tb_ray_setup #(
  parameter integer EXP_W = 7,
  parameter integer MAN_W = 16,
  parameter integer LEVELS = 8,
  parameter integer HEIGHT_W = 8,
  parameter integer TILE_W = 4
) (
  input  wire       clk,
  output reg        done,
  output reg  [7:0] exit_code
);
  localparam integer Latency = 3;

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

  ray_setup #(
    .EXP_W(EXP_W),
    .MAN_W(MAN_W),
    .LEVELS(LEVELS),
    .HEIGHT_W(HEIGHT_W),
    .TILE_W(TILE_W)
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
    in_u = 0;
    in_v = 0;
    in_du = 0;
    in_dv = 0;
    stim_left = 0;
    exp_left = 0;
    if ($value$plusargs("vectors=%s", dir) == 0) dir = "golden/ray_setup";
    $sformat(path, "%0s/stimulus.hex", dir);
    stim_fd = $fopen(path, "r");
    $sformat(path, "%0s/expected.hex", dir);
    exp_fd = $fopen(path, "r");
    if (stim_fd == 0 || exp_fd == 0) begin
      $display("FAIL tb_ray_setup: cannot read stimulus.hex and expected.hex in %0s", dir);
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
        $display("FAIL tb_ray_setup: no vectors in %0s, nothing ran", dir);
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
        travel <= (travel << 1) | (in_valid ? 2 : 0);
        if (out_valid) begin
          if (exp_left == 0) begin
            $display("FAIL tb_ray_setup: a result came that nobody expected, after %0d", checked);
            exit_code <= 8'd7;
            done <= 1'b1;
          end else begin
            row_wrong = 1'b0;
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_ok !== word[0]) begin
              if (wrong < 10)
                $display("vector %0d, ok: expected %h, got %h", checked, word[0], out_ok);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_level !== word[$clog2(LEVELS+1)-1:0]) begin
              if (wrong < 10)
                $display("vector %0d, level: expected %h, got %h", checked, word[$clog2(LEVELS+1)-1:0], out_level);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_p_x !== word[EXP_W+MAN_W:0]) begin
              if (wrong < 10)
                $display("vector %0d, p_x: expected %h, got %h", checked, word[EXP_W+MAN_W:0], out_p_x);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_pb_x !== word[EXP_W+MAN_W:0]) begin
              if (wrong < 10)
                $display("vector %0d, pb_x: expected %h, got %h", checked, word[EXP_W+MAN_W:0], out_pb_x);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_d_x !== word[EXP_W+MAN_W:0]) begin
              if (wrong < 10)
                $display("vector %0d, d_x: expected %h, got %h", checked, word[EXP_W+MAN_W:0], out_d_x);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_r_x !== word[EXP_W+MAN_W:0]) begin
              if (wrong < 10)
                $display("vector %0d, r_x: expected %h, got %h", checked, word[EXP_W+MAN_W:0], out_r_x);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_never_x !== word[0]) begin
              if (wrong < 10)
                $display("vector %0d, never_x: expected %h, got %h", checked, word[0], out_never_x);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_neg_x !== word[0]) begin
              if (wrong < 10)
                $display("vector %0d, neg_x: expected %h, got %h", checked, word[0], out_neg_x);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_first_x !== word[LEVELS+TILE_W+1:0]) begin
              if (wrong < 10)
                $display("vector %0d, first_x: expected %h, got %h", checked, word[LEVELS+TILE_W+1:0], out_first_x);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_p_y !== word[EXP_W+MAN_W:0]) begin
              if (wrong < 10)
                $display("vector %0d, p_y: expected %h, got %h", checked, word[EXP_W+MAN_W:0], out_p_y);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_pb_y !== word[EXP_W+MAN_W:0]) begin
              if (wrong < 10)
                $display("vector %0d, pb_y: expected %h, got %h", checked, word[EXP_W+MAN_W:0], out_pb_y);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_d_y !== word[EXP_W+MAN_W:0]) begin
              if (wrong < 10)
                $display("vector %0d, d_y: expected %h, got %h", checked, word[EXP_W+MAN_W:0], out_d_y);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_r_y !== word[EXP_W+MAN_W:0]) begin
              if (wrong < 10)
                $display("vector %0d, r_y: expected %h, got %h", checked, word[EXP_W+MAN_W:0], out_r_y);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_never_y !== word[0]) begin
              if (wrong < 10)
                $display("vector %0d, never_y: expected %h, got %h", checked, word[0], out_never_y);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_neg_y !== word[0]) begin
              if (wrong < 10)
                $display("vector %0d, neg_y: expected %h, got %h", checked, word[0], out_neg_y);
              row_wrong = 1'b1;
            end
            got = $fscanf(exp_fd, "%h", word);
            if (got != 1 || out_first_y !== word[LEVELS+TILE_W+1:0]) begin
              if (wrong < 10)
                $display("vector %0d, first_y: expected %h, got %h", checked, word[LEVELS+TILE_W+1:0], out_first_y);
              row_wrong = 1'b1;
            end
            checked = checked + 1;
            exp_left = exp_left - 1;
            if (row_wrong) wrong = wrong + 1;
          end
        end
        if (stim_left > 0) begin
          got = $fscanf(stim_fd, "%h", word);
          in_u <= word[EXP_W+MAN_W:0];
          got = $fscanf(stim_fd, "%h", word);
          in_v <= word[EXP_W+MAN_W:0];
          got = $fscanf(stim_fd, "%h", word);
          in_du <= word[EXP_W+MAN_W:0];
          got = $fscanf(stim_fd, "%h", word);
          in_dv <= word[EXP_W+MAN_W:0];
          if (got != 1) begin
            $display("FAIL tb_ray_setup: stimulus.hex ends before the number of rows that it announces");
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
            $display("FAIL tb_ray_setup: vector %0d was expected and never came", checked);
            exit_code <= 8'd6;
          end else if (wrong > 0) begin
            $display("FAIL tb_ray_setup: %0d of %0d mismatched", wrong, checked);
            exit_code <= 8'd1;
          end else begin
            $display("PASS tb_ray_setup: 0 of %0d mismatched", checked);
          end
        end
      end
    end
  end
endmodule
`default_nettype wire
