// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_tb_traverse: loads the pyramid, sends the golden rays, and checks that each ray has
// exactly one result, the expected one.
//   +vectors=DIR   directory with memory.hex, stimulus.hex, expected.hex (default golden/traverse)
//   +gaps          in_valid falls at random         +stalls    out_ready falls at random
//   +flood         fills the pipeline with rays, resets it for one clock, and only then runs the set
//   +reset         resets of one clock while rays are on their way; the set starts again after each
//   +again         the set, and once it has passed, the set again with gaps, stalls, flood, reset, and
//                  a hold: out_ready is 0 until every stage is full, and no result may be lost
//   +patience=N    clocks without a result after which a ray counts as lost (default: four times
//                  what the longest ray sent so far may take)
//   +results=FILE  one line per ray: its number, then its outputs in hex
// The parameter MEM_INIT names a file that fills the memory at power-up; memory.hex is not loaded
// then. Compiled with ITERATIONS defined, it reads nets of the loop, which a netlist does not have:
//   +iterations=FILE  one line per iteration: ray, level, x, y, t in hex, as the ray enters the loop
// Ends with one line, PASS or FAIL, and exit_code: 0 ok, 1 a wrong result, idle or slot_busy, or an
// undefined handshake, 2 unreadable vectors, 5 nothing ran, 6 a result never came, 7 an unexpected
// result.
`default_nettype none
module relief_tb_traverse #(
  parameter integer EXP_W      = 7,      // exponent bits
  parameter integer MAN_W      = 16,     // fraction bits, the hidden one not counted
  parameter integer LEVELS     = 8,      // the map has 2^LEVELS x 2^LEVELS texels
  parameter integer HEIGHT_W   = 8,      // bits of a height code
  parameter integer TILE_W     = 4,      // a ray travels less than 2^TILE_W tiles along each axis
  parameter integer FRAC_W     = 12,     // fraction bits of the hit position
  parameter integer TAG_W      = 8,      // bits of a ray's tag
  parameter integer STEP_LIMIT = 65535,  // iterations after which a ray is given up
  // file for $readmemh with the first words of the memory; "": none
  parameter MEM_INIT = ""
) (
  input  wire       clk,
  output reg        done,
  output reg  [7:0] exit_code
);
  localparam integer WarmUp = 47;  // clocks until the pipeline can be full
  localparam integer Flood = 200;             // clocks of the flood
  localparam integer Resets = 12;             // resets while rays are on their way
  localparam integer TagBits = (TAG_W < 8) ? TAG_W : 8;  // bits of a tag that the bench counts
  localparam integer Tags = 1 << TagBits;     // rays under way, at most
  // Bits of a row, as stated in the head of each file, and words of the pyramid.
  localparam integer InW =
    EXP_W + MAN_W + 1 +  // in_u
    EXP_W + MAN_W + 1 +  // in_v
    EXP_W + MAN_W + 1 +  // in_du
    EXP_W + MAN_W + 1;  // in_dv
  localparam integer OutW =
    LEVELS +  // out_i
    LEVELS +  // out_j
    FRAC_W +  // out_fu
    FRAC_W +  // out_fv
    EXP_W + MAN_W + 1 +  // out_t
    1 +  // out_wall
    1 +  // out_limit
    16 +  // out_steps
    16 +  // out_crossings
    16;  // out_ups
  localparam integer Words = ((1 << (2 * LEVELS + 2)) - 1) / 3;

  reg [8*1000-1:0] dir;   // directory of the vectors
  reg [8*1020-1:0] path;  // file of the results
  integer mem_fd;         // memory.hex
  integer stim_fd;        // stimulus.hex
  integer exp_fd;         // expected.hex
  integer res_fd;         // results, 0: none
  integer stim_bits;      // bits of a row, as the head of the file states them
  integer exp_bits;       // the same of expected.hex
  integer patience;       // clocks without a result until a ray is lost, 0: by the longest ray
  integer k;              // index of a loop
  reg     gaps;           // in_valid falls at random
  reg     stalls;         // out_ready falls at random
  reg     again;          // the set runs once more
  reg     reported;       // the utilization has been printed
  integer resets_left;    // resets to come
  integer until_reset;    // clocks

  // What is left to send and to expect, and what was observed.
  integer words_left;     // words to load into the memory
  integer stim_left;      // rows of stimulus.hex to send
  integer exp_left;       // rows of expected.hex to read
  integer flood_left;     // clocks
  integer flood_rows;     // rays sent in the flood
  integer hold_left;      // clocks
  integer rays;           // accepted
  integer checked;        // results compared
  integer wrong;          // of these, different from what is expected
  integer quiet;          // clocks since the last result
  reg [31:0] longest;     // most iterations of a ray so far
  integer cycles;
  integer first_in;       // clock of the first ray
  integer last_out;       // clock of the last result
  integer after;          // clocks under full load
  integer loaded;         // of these, with a pipeline that can be full
  integer busy;           // of these, with a ray in the slot of stage 0
  reg     false_idle;     // idle was 1 while a ray was inside
  reg     false_busy;     // slot_busy was 1 while no ray was inside
  reg     bad_stim;       // a row of stimulus.hex can't be read
  reg     bad_exp;        // a row of expected.hex can't be read
  reg [31:0] in_slots;    // clocks in which slot_busy was 1
  reg [31:0] needed;      // iterations of the rays sent
  reg [31:0] lfsr;        // random bits

  reg        rst;
  reg        load_en;
  reg [2*LEVELS:0] load_addr;
  reg [HEIGHT_W-1:0] load_data;
  reg        in_valid;
  wire       in_ready;
  reg [TAG_W-1:0] in_tag;
  reg [EXP_W+MAN_W:0] in_u;
  reg [EXP_W+MAN_W:0] in_v;
  reg [EXP_W+MAN_W:0] in_du;
  reg [EXP_W+MAN_W:0] in_dv;
  wire       out_valid;
  reg        out_ready;
  wire [TAG_W-1:0] out_tag;
  wire [LEVELS-1:0] out_i;
  wire [LEVELS-1:0] out_j;
  wire [FRAC_W-1:0] out_fu;
  wire [FRAC_W-1:0] out_fv;
  wire [EXP_W+MAN_W:0] out_t;
  wire out_wall;
  wire out_limit;
  wire [15:0] out_steps;
  wire [15:0] out_crossings;
  wire [15:0] out_ups;
  wire       slot_busy;
  wire       idle;

  // Per tag in flight: its ray, and the result expected of it.
  reg [Tags-1:0] tag_used;              // a result is expected under this tag
  integer    tag_ray [0:Tags-1];        // number of the ray
  reg [TAG_W-1:0] tag_sent [0:Tags-1];  // the whole tag
  reg [LEVELS-1:0] want_out_i [0:Tags-1];
  reg [LEVELS-1:0] want_out_j [0:Tags-1];
  reg [FRAC_W-1:0] want_out_fu [0:Tags-1];
  reg [FRAC_W-1:0] want_out_fv [0:Tags-1];
  reg [EXP_W+MAN_W:0] want_out_t [0:Tags-1];
  reg want_out_wall [0:Tags-1];
  reg want_out_limit [0:Tags-1];
  reg [15:0] want_out_steps [0:Tags-1];
  reg [15:0] want_out_crossings [0:Tags-1];
  reg [15:0] want_out_ups [0:Tags-1];
  wire [TagBits-1:0] slot = out_tag[TagBits-1:0];
  reg [TagBits-1:0] next_tag;  // of the ray on the inputs
  wire       accepted = in_valid & in_ready & ~rst;
  wire       transferred = out_valid & out_ready & ~rst;
  wire       expected = (tag_used[slot] === 1'b1) & (out_tag === tag_sent[slot]);
  // An iteration takes less than WarmUp clocks; the rest of a ray takes no longer than some of them.
  wire [31:0] limit = (patience > 0) ? patience : 4 * WarmUp * (longest + 16);
  wire       all_back = stim_left == 0 && rays == checked && !in_valid;

  relief_traverse #(
    .EXP_W(EXP_W),
    .MAN_W(MAN_W),
    .LEVELS(LEVELS),
    .HEIGHT_W(HEIGHT_W),
    .TILE_W(TILE_W),
    .FRAC_W(FRAC_W),
    .TAG_W(TAG_W),
    .STEP_LIMIT(STEP_LIMIT),
    .MEM_INIT(MEM_INIT),
    .VARIANT(32'h3b71a3f0)
  ) dut (
    .clk(clk),
    .rst(rst),
    .load_en(load_en),
    .load_addr(load_addr),
    .load_data(load_data),
    .in_valid(in_valid),
    .in_ready(in_ready),
    .in_tag(in_tag),
    .in_u(in_u),
    .in_v(in_v),
    .in_du(in_du),
    .in_dv(in_dv),
    .out_valid(out_valid),
    .out_ready(out_ready),
    .out_tag(out_tag),
    .out_i(out_i),
    .out_j(out_j),
    .out_fu(out_fu),
    .out_fv(out_fv),
    .out_t(out_t),
    .out_wall(out_wall),
    .out_limit(out_limit),
    .out_steps(out_steps),
    .out_crossings(out_crossings),
    .out_ups(out_ups),
    .slot_busy(slot_busy),
    .idle(idle)
  );

  // Yosys has no files and no delays: it sees the module under test and its parameters alone.
`ifndef YOSYS
  // Comments at the head of a file, as $readmemh skips them.
  task automatic skip_comments(input integer fd);
    integer c;
    begin
      c = (fd != 0) ? $fgetc(fd) : -1;
      while (c == "/") begin
        while (c != 10 && c >= 0) c = $fgetc(fd);
        c = $fgetc(fd);
      end
      if (c >= 0) c = $ungetc(c, fd);
    end
  endtask

  // The head of a vector file: the number of rows and the bits of a row.
  task automatic read_head(input integer fd, output integer rows, output integer bits);
    integer c;
    begin
      skip_comments(fd);
      rows = 0;
      bits = 0;
      c = $fscanf(fd, "%h %h", rows, bits);
      if (c < 1) rows = 0;
    end
  endtask

  // Ends the bench; the line for the log has been printed.
  task automatic finish(input reg [7:0] code);
    begin
      exit_code <= code;
      done <= 1'b1;
      if (res_fd != 0) $fclose(res_fd);
    end
  endtask

  initial begin
    done = 1'b0;
    exit_code = 8'd0;
    stim_bits = 0;
    exp_bits = 0;
    words_left = 0;
    stim_left = 0;
    exp_left = 0;
    flood_left = 0;
    flood_rows = 0;
    hold_left = 0;
    rays = 0;
    checked = 0;
    wrong = 0;
    quiet = 0;
    longest = 0;
    cycles = 0;
    first_in = 0;
    last_out = 0;
    after = 0;
    loaded = 0;
    busy = 0;
    false_idle = 1'b0;
    false_busy = 1'b0;
    bad_stim = 1'b0;
    bad_exp = 1'b0;
    in_slots = 0;
    needed = 0;
    res_fd = 0;
    lfsr = 32'h2468_ace1;
    rst = 1'b1;
    load_en = 1'b0;
    load_addr = 0;
    load_data = 0;
    in_valid = 1'b0;
    in_tag = 0;
    next_tag = 0;
    out_ready = 1'b0;
    in_u = 0;
    in_v = 0;
    in_du = 0;
    in_dv = 0;
    tag_used = {Tags{1'b0}};
    for (k = 0; k < Tags; k = k + 1) tag_ray[k] = 0;
    gaps = $test$plusargs("gaps") != 0;
    stalls = $test$plusargs("stalls") != 0;
    if ($test$plusargs("flood") != 0) flood_left = Flood;
    again = $test$plusargs("again") != 0;
    resets_left = ($test$plusargs("reset") != 0) ? Resets : 0;
    until_reset = 100;
    reported = 1'b0;
    if ($value$plusargs("patience=%d", patience) == 0) patience = 0;
    if ($value$plusargs("vectors=%s", dir) == 0) dir = "golden/traverse";
    mem_fd = $fopen($sformatf("%0s/memory.hex", dir), "r");
    stim_fd = $fopen($sformatf("%0s/stimulus.hex", dir), "r");
    exp_fd = $fopen($sformatf("%0s/expected.hex", dir), "r");
    if ((mem_fd == 0 && MEM_INIT == "") || stim_fd == 0 || exp_fd == 0) begin
      $display("FAIL tb_traverse: cannot read memory.hex, stimulus.hex, expected.hex in %0s", dir);
      exit_code = 8'd2;
      done = 1'b1;
    end else begin
      if (MEM_INIT == "") begin
        skip_comments(mem_fd);
        words_left = Words;
      end
      read_head(stim_fd, stim_left, stim_bits);
      read_head(exp_fd, exp_left, exp_bits);
      if ((stim_left == 0 && exp_left == 0) || stim_bits == 0 || exp_bits == 0) begin
        $display("FAIL tb_traverse: no rays in %0s, nothing ran", dir);
        exit_code = 8'd5;
        done = 1'b1;
      end else if (stim_bits != InW || exp_bits != OutW) begin
        $display("FAIL tb_traverse: rows of %0d and %0d bits in %0s,", stim_bits, exp_bits, dir,
                 " these parameter values need %0d and %0d", InW, OutW);
        exit_code = 8'd2;
        done = 1'b1;
      end
      if ($value$plusargs("results=%s", path) != 0) res_fd = $fopen($sformatf("%0s", path), "w");
    end
  end

  // Loads the pyramid, one word per clock.
  task automatic load_word;
    integer got;
    reg [63:0] word;
    begin
      rst <= 1'b0;
      got = $fscanf(mem_fd, "%h", word);
      if (got != 1) begin
        $display("FAIL tb_traverse: memory.hex in %0s holds fewer words than the %0d", dir, Words,
                 " of a pyramid of LEVELS = %0d", LEVELS);
        finish(8'd2);
      end else if ((word >> HEIGHT_W) != 0) begin
        $display("FAIL tb_traverse: memory.hex in %0s holds %0h,", dir, word,
                 " more than HEIGHT_W = %0d bits", HEIGHT_W);
        finish(8'd2);
      end
      load_en <= 1'b1;
      load_data <= word[HEIGHT_W-1:0];
      load_addr <= load_en ? load_addr + 1'b1 : load_addr;
      words_left <= words_left - 1;
    end
  endtask

  // The end of a run over rows that can't be read, in the clock after: no other verdict is given.
  task automatic unreadable;
    begin
      if (bad_stim) $display("FAIL tb_traverse: stimulus.hex holds other rows than it announces");
      else $display("FAIL tb_traverse: expected.hex holds other rows than it announces");
      finish(8'd2);
    end
  endtask

  // Drives the next ray of the file. The tag's bits above TagBits are random: they must come back.
  task automatic send_ray(input reg [TagBits-1:0] low);
    integer b;
    integer got;
    reg bad;
    reg [63:0] word;
    begin
      bad = 1'b0;
      in_valid <= 1'b1;
      for (b = 0; b < TAG_W; b = b + 1) in_tag[b] <= (b < TagBits) ? low[b%TagBits] : lfsr[b];
      got = $fscanf(stim_fd, "%h", word);
      if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad = 1'b1;
      in_u <= word[EXP_W+MAN_W:0];
      got = $fscanf(stim_fd, "%h", word);
      if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad = 1'b1;
      in_v <= word[EXP_W+MAN_W:0];
      got = $fscanf(stim_fd, "%h", word);
      if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad = 1'b1;
      in_du <= word[EXP_W+MAN_W:0];
      got = $fscanf(stim_fd, "%h", word);
      if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad = 1'b1;
      in_dv <= word[EXP_W+MAN_W:0];
      if (bad) bad_stim <= 1'b1;
    end
  endtask

  // Starts the files of the set again at their first row.
  task automatic rewind_set;
    integer rows_in;
    integer rows_out;
    begin
      $fclose(stim_fd);
      $fclose(exp_fd);
      stim_fd = $fopen($sformatf("%0s/stimulus.hex", dir), "r");
      exp_fd = $fopen($sformatf("%0s/expected.hex", dir), "r");
      read_head(stim_fd, rows_in, stim_bits);
      read_head(exp_fd, rows_out, exp_bits);
      stim_left <= rows_in;
      exp_left <= rows_out;
      rays <= 0;
      checked <= 0;
      quiet <= 0;
      needed <= 0;
      in_slots <= 0;
      tag_used <= {Tags{1'b0}};
    end
  endtask

  // Rays that a reset discards: none may have a result. A ray that is valid in the clock of the
  // reset has not been sent.
  task automatic flood;
    begin
      load_en <= 1'b0;
      flood_left <= flood_left - 1;
      out_ready <= 1'b0;
      rst <= flood_left == 1;
      if (flood_left == 1) begin
        flood_rows <= 0;
        rewind_set;
      end else if (flood_rows < stim_left) begin
        flood_rows <= flood_rows + 1;
        send_ray(next_tag);
      end
    end
  endtask

  // A reset while rays are in flight.
  task automatic reset_inside;
    begin
      rst <= 1'b1;
      resets_left <= resets_left - 1;
      until_reset <= {24'd0, lfsr[23:16]} + 1;
      rewind_set;
    end
  endtask

  // The set has passed: once more, with all disturbances at input and output.
  task automatic start_again;
    begin
      again <= 1'b0;
      gaps <= 1'b1;
      stalls <= 1'b1;
      flood_left <= Flood;
      hold_left <= Flood;
      resets_left <= Resets;
      until_reset <= 100;
      rewind_set;
    end
  endtask

  // Compares an expected result, field by field.
  task automatic check_result;
    reg row_wrong;
    begin
      row_wrong = 1'b0;
      if (out_i !== want_out_i[slot]) begin
        if (wrong < 10)
          $display("ray %0d, out_i: expected %h, got %h",
                   tag_ray[slot], want_out_i[slot], out_i);
        if (wrong == 0 && !row_wrong)
          $display("@fail unit=traverse row=%0d port=out_i exp=%h got=%h",
                   tag_ray[slot], want_out_i[slot], out_i);
        row_wrong = 1'b1;
      end
      if (out_j !== want_out_j[slot]) begin
        if (wrong < 10)
          $display("ray %0d, out_j: expected %h, got %h",
                   tag_ray[slot], want_out_j[slot], out_j);
        if (wrong == 0 && !row_wrong)
          $display("@fail unit=traverse row=%0d port=out_j exp=%h got=%h",
                   tag_ray[slot], want_out_j[slot], out_j);
        row_wrong = 1'b1;
      end
      if (out_fu !== want_out_fu[slot]) begin
        if (wrong < 10)
          $display("ray %0d, out_fu: expected %h, got %h",
                   tag_ray[slot], want_out_fu[slot], out_fu);
        if (wrong == 0 && !row_wrong)
          $display("@fail unit=traverse row=%0d port=out_fu exp=%h got=%h",
                   tag_ray[slot], want_out_fu[slot], out_fu);
        row_wrong = 1'b1;
      end
      if (out_fv !== want_out_fv[slot]) begin
        if (wrong < 10)
          $display("ray %0d, out_fv: expected %h, got %h",
                   tag_ray[slot], want_out_fv[slot], out_fv);
        if (wrong == 0 && !row_wrong)
          $display("@fail unit=traverse row=%0d port=out_fv exp=%h got=%h",
                   tag_ray[slot], want_out_fv[slot], out_fv);
        row_wrong = 1'b1;
      end
      if (out_t !== want_out_t[slot]) begin
        if (wrong < 10)
          $display("ray %0d, out_t: expected %h, got %h",
                   tag_ray[slot], want_out_t[slot], out_t);
        if (wrong == 0 && !row_wrong)
          $display("@fail unit=traverse row=%0d port=out_t exp=%h got=%h",
                   tag_ray[slot], want_out_t[slot], out_t);
        row_wrong = 1'b1;
      end
      if (out_wall !== want_out_wall[slot]) begin
        if (wrong < 10)
          $display("ray %0d, out_wall: expected %h, got %h",
                   tag_ray[slot], want_out_wall[slot], out_wall);
        if (wrong == 0 && !row_wrong)
          $display("@fail unit=traverse row=%0d port=out_wall exp=%h got=%h",
                   tag_ray[slot], want_out_wall[slot], out_wall);
        row_wrong = 1'b1;
      end
      if (out_limit !== want_out_limit[slot]) begin
        if (wrong < 10)
          $display("ray %0d, out_limit: expected %h, got %h",
                   tag_ray[slot], want_out_limit[slot], out_limit);
        if (wrong == 0 && !row_wrong)
          $display("@fail unit=traverse row=%0d port=out_limit exp=%h got=%h",
                   tag_ray[slot], want_out_limit[slot], out_limit);
        row_wrong = 1'b1;
      end
      if (out_steps !== want_out_steps[slot]) begin
        if (wrong < 10)
          $display("ray %0d, out_steps: expected %h, got %h",
                   tag_ray[slot], want_out_steps[slot], out_steps);
        if (wrong == 0 && !row_wrong)
          $display("@fail unit=traverse row=%0d port=out_steps exp=%h got=%h",
                   tag_ray[slot], want_out_steps[slot], out_steps);
        row_wrong = 1'b1;
      end
      if (out_crossings !== want_out_crossings[slot]) begin
        if (wrong < 10)
          $display("ray %0d, out_crossings: expected %h, got %h",
                   tag_ray[slot], want_out_crossings[slot], out_crossings);
        if (wrong == 0 && !row_wrong)
          $display("@fail unit=traverse row=%0d port=out_crossings exp=%h got=%h",
                   tag_ray[slot], want_out_crossings[slot], out_crossings);
        row_wrong = 1'b1;
      end
      if (out_ups !== want_out_ups[slot]) begin
        if (wrong < 10)
          $display("ray %0d, out_ups: expected %h, got %h",
                   tag_ray[slot], want_out_ups[slot], out_ups);
        if (wrong == 0 && !row_wrong)
          $display("@fail unit=traverse row=%0d port=out_ups exp=%h got=%h",
                   tag_ray[slot], want_out_ups[slot], out_ups);
        row_wrong = 1'b1;
      end
      if (row_wrong) wrong <= wrong + 1;
      checked <= checked + 1;
      last_out <= cycles;
      tag_used[slot] <= 1'b0;
      if (res_fd != 0) begin
        $fwrite(res_fd, "%0d", tag_ray[slot]);
        $fwrite(res_fd, " %h", out_i);
        $fwrite(res_fd, " %h", out_j);
        $fwrite(res_fd, " %h", out_fu);
        $fwrite(res_fd, " %h", out_fv);
        $fwrite(res_fd, " %h", out_t);
        $fwrite(res_fd, " %h", out_wall);
        $fwrite(res_fd, " %h", out_limit);
        $fwrite(res_fd, " %h", out_steps);
        $fwrite(res_fd, " %h", out_crossings);
        $fwrite(res_fd, " %h", out_ups);
        $fwrite(res_fd, "\n");
      end
    end
  endtask

  // Input transfer: from here on the ray's result is expected under its tag.
  task automatic note_ray;
    integer got;
    reg bad;
    reg [63:0] word;
    begin
      bad = 1'b0;
      if (exp_left > 0) begin
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (LEVELS)) != 0) bad = 1'b1;
        want_out_i[in_tag[TagBits-1:0]] <= word[LEVELS-1:0];
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (LEVELS)) != 0) bad = 1'b1;
        want_out_j[in_tag[TagBits-1:0]] <= word[LEVELS-1:0];
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (FRAC_W)) != 0) bad = 1'b1;
        want_out_fu[in_tag[TagBits-1:0]] <= word[FRAC_W-1:0];
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (FRAC_W)) != 0) bad = 1'b1;
        want_out_fv[in_tag[TagBits-1:0]] <= word[FRAC_W-1:0];
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (EXP_W + MAN_W + 1)) != 0) bad = 1'b1;
        want_out_t[in_tag[TagBits-1:0]] <= word[EXP_W+MAN_W:0];
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (1)) != 0) bad = 1'b1;
        want_out_wall[in_tag[TagBits-1:0]] <= word[0];
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (1)) != 0) bad = 1'b1;
        want_out_limit[in_tag[TagBits-1:0]] <= word[0];
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (16)) != 0) bad = 1'b1;
        want_out_steps[in_tag[TagBits-1:0]] <= word[15:0];
        if (word[31:0] > longest) longest <= word[31:0];
        needed <= needed + word[31:0];
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (16)) != 0) bad = 1'b1;
        want_out_crossings[in_tag[TagBits-1:0]] <= word[15:0];
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> (16)) != 0) bad = 1'b1;
        want_out_ups[in_tag[TagBits-1:0]] <= word[15:0];
        exp_left <= exp_left - 1;
      end
      if (bad) bad_exp <= 1'b1;
      tag_used[in_tag[TagBits-1:0]] <= exp_left > 0;
      tag_ray[in_tag[TagBits-1:0]] <= rays;
      tag_sent[in_tag[TagBits-1:0]] <= in_tag;
      if (rays == 0) first_in <= cycles;
      rays <= rays + 1;
    end
  endtask

  // Drives the next ray once the last one has been accepted.
  task automatic drive_ray;
    reg [TagBits-1:0] low;
    begin
      // The tag of a ray that a reset discarded is not used next, so that a stale result shows.
      low = (accepted || rst) ? next_tag + 1'b1 : next_tag;
      if (accepted || !in_valid || rst) begin
        if (stim_left > 0 && !tag_used[low] && !(gaps && lfsr[9] && hold_left == 0)) begin
          send_ray(low);
          stim_left <= stim_left - 1;
        end else begin
          in_valid <= 1'b0;
        end
      end
      next_tag <= low;
    end
  endtask

  // The verdict, once every ray has its result or no more results come.
  task automatic verdict;
    reg [63:0] word;
    integer got_stim;
    integer got_exp;
    integer got_mem;
    begin
      got_stim = $fscanf(stim_fd, "%h", word);
      got_exp = $fscanf(exp_fd, "%h", word);
      got_mem = (MEM_INIT == "") ? $fscanf(mem_fd, "%h", word) : 0;
      if (exp_left > 0) begin
        $display("FAIL tb_traverse: ray %0d was expected and never came", rays);
        finish(8'd6);
      end else if (got_stim == 1 || got_exp == 1 || got_mem == 1) begin
        $display("FAIL tb_traverse: %0s in %0s holds more rows than it announces, with %0h",
                 "stimulus.hex, expected.hex or memory.hex", dir, word);
        finish(8'd2);
      end else if (wrong > 0) begin
        $display("@done unit=traverse checked=%0d wrong=%0d", checked, wrong);
        $display("FAIL tb_traverse: %0d of %0d mismatched", wrong, checked);
        finish(8'd1);
      end else if (false_idle || !idle) begin
        $display("FAIL tb_traverse: idle was %0s, after %0d",
                 idle ? "1 while a ray was inside" : "0 while no ray was inside", checked);
        finish(8'd1);
      end else if (false_busy || in_slots < needed) begin
        // Every iteration of a ray is in its slot for a clock; with none inside no slot is busy.
        $display("FAIL tb_traverse: slot_busy was %0s, after %0d",
                 false_busy ? "1 while no ray was inside" : "0 while a ray was in its slot",
                 checked);
        finish(8'd1);
      end else begin
        if (!reported) begin
          $display("slots busy: %0d of %0d %0s; %0d clocks from first ray to last hit", busy,
                   loaded, (gaps || stalls) ? "with gaps and stalls" : "under full load",
                   last_out - first_in + 1);
        end
        reported <= 1'b1;
        if (again) begin
          start_again;
        end else begin
          $display("@done unit=traverse checked=%0d wrong=0", checked);
          $display("PASS tb_traverse: 0 of %0d mismatched", checked);
          finish(8'd0);
        end
      end
    end
  endtask

  task automatic run;
    begin
      rst <= 1'b0;
      load_en <= 1'b0;
      out_ready <= (~stalls | lfsr[5]) && hold_left == 0;
      if (hold_left > 0) hold_left <= hold_left - 1;
      quiet <= transferred ? 0 : quiet + 1;
      if (slot_busy) in_slots <= in_slots + 1;
      if (resets_left > 0 && until_reset == 0) begin
        reset_inside;
      end else begin
        if (resets_left > 0 && hold_left == 0) until_reset <= until_reset - 1;
        if (idle && rays != checked) false_idle <= 1'b1;
        if (idle && slot_busy) false_busy <= 1'b1;
        if (accepted) note_ray;
        if (transferred && expected) check_result;
        drive_ray;
      end
      // Under full load: from the first ray on, until the last one was accepted.
      if ((stim_left > 0 || in_valid) && (rays > 0 || accepted)) begin
        after <= after + 1;
        if (after >= WarmUp) begin
          loaded <= loaded + 1;
          if (slot_busy) busy <= busy + 1;
        end
      end
      if (!rst && (^{in_ready, out_valid, slot_busy, idle}) === 1'bx) begin
        $display("FAIL tb_traverse: in_ready, out_valid, slot_busy or idle is undefined, after %0d",
                 checked);
        finish(8'd1);
      end else if (transferred && !expected) begin
        $display("FAIL tb_traverse: an unexpected result, with tag %h, after %0d",
                 out_tag, checked);
        finish(8'd7);
      end else if (all_back && quiet > 2 * WarmUp) begin
        verdict;
      end else if (quiet > limit) begin
        $display("FAIL tb_traverse: %0d rays went in and never came out, %0d clocks without any",
                 rays - checked, quiet);
        finish(8'd6);
      end
    end
  endtask

  always @(posedge clk) begin
    if (!done) begin
      cycles <= cycles + 1;
      lfsr <= {lfsr[30:0], lfsr[31] ^ lfsr[21] ^ lfsr[1] ^ lfsr[0]};
      if (cycles < 3) rst <= 1'b1;
      else if (bad_stim || bad_exp) unreadable;
      else if (words_left > 0) load_word;
      else if (flood_left > 0) flood;
      else run;
    end
  end

`ifdef ITERATIONS
  integer it_fd;
  reg [8*1020-1:0] it_path;
  initial begin
    it_fd = 0;
    if ($value$plusargs("iterations=%s", it_path) != 0) begin
      it_fd = $fopen($sformatf("%0s", it_path), "w");
    end
  end
  always @(posedge clk) begin
    if (it_fd != 0 && !done && !rst && dut.s0_to_s18_valid[0] && !dut.s1_done)
      $fwrite(it_fd, "%0d %h %h %h %h\n", tag_ray[dut.s1_tag[TagBits-1:0]],
              dut.s1_level, dut.s1_x, dut.s1_y, dut.s1_t);
  end
`endif
`endif
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
