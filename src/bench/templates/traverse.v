// tb_traverse: loads the pyramid, sends the golden rays, and checks that every ray comes back exactly once and right.
//   +vectors=DIR   directory with memory.hex, stimulus.hex, expected.hex (default golden/traverse)
//   +gaps          rays are held back at random      +stalls    results are taken at random
//   +flood         fills the pipeline with rays, resets it, and only then runs the set
//   +patience=N    clocks without a result after which a ray counts as lost (default 2000000)
//   +results=FILE  one line a ray: its number, then its outputs in hex
// Ends with one line, PASS or FAIL, and exit_code: 0 ok, 1 mismatch, 2 unreadable vectors,
// 5 nothing ran, 6 a ray never came back, 7 a result that nobody expected.
`default_nettype none
module tb_traverse #(
{%- for p in params %}
  parameter integer {{ p.name }} = {{ p.default }}{% if not loop.last %},{% endif %}
{%- endfor %}
) (
  input  wire       clk,
  output reg        done,
  output reg  [7:0] exit_code
);
  localparam integer WarmUp = {{ warm_up }};  // clocks until the pipeline can be full
  localparam integer TagBits = (TAG_W < 8) ? TAG_W : 8;
  localparam integer Tags = 1 << TagBits;

  reg [8*200-1:0] dir;
  reg [8*240-1:0] path;
  reg [8*400-1:0] header;
  integer mem_fd;
  integer stim_fd;
  integer exp_fd;
  integer res_fd;
  integer words_left;
  integer stim_left;
  integer exp_left;
  integer checked;
  integer wrong;
  integer outstanding;
  integer quiet;
  integer after;
  integer flood_left;
  integer flood_rows;
  integer patience;
  integer cycles;
  integer loaded;
  integer busy;
  integer rays;
  integer got;
  integer k;
  reg        gaps;
  reg        stalls;
  reg [63:0] word;
  reg        row_wrong;
  reg [31:0] lfsr;

  reg        rst;
  reg        load_en;
  reg [2*LEVELS:0] load_addr;
  reg [HEIGHT_W-1:0] load_data;
  reg        in_valid;
  wire       in_ready;
  reg [TAG_W-1:0] in_tag;
{%- for p in inputs %}
  reg {{ p.range }} {{ p.name }};
{%- endfor %}
  wire       out_valid;
  reg        out_ready;
  wire [TAG_W-1:0] out_tag;
{%- for p in outputs %}
  wire {{ p.range }} {{ p.name }};
{%- endfor %}
  wire       slot_busy;

  // What each tag in flight stands for.
  reg        tag_used [0:Tags-1];
  integer    tag_ray [0:Tags-1];
  reg [TAG_W-1:0] tag_sent [0:Tags-1];
{%- for p in outputs %}
  reg [63:0] want_{{ p.name }} [0:Tags-1];
{%- endfor %}
  wire [TagBits-1:0] slot = out_tag[TagBits-1:0];
  reg [TagBits-1:0] next_tag;
  // The bits above those that tell rays apart travel too.
  reg [31+TagBits:0] tag_word;
  wire       accepted = in_valid & in_ready & ~rst;

  {{ dut }} #(
{%- for p in params %}
    .{{ p.name }}({{ p.name }}){% if not loop.last %},{% endif %}
{%- endfor %}
  ) dut (
    .clk(clk),
    .rst(rst),
    .load_en(load_en),
    .load_addr(load_addr),
    .load_data(load_data),
    .in_valid(in_valid),
    .in_ready(in_ready),
    .in_tag(in_tag),
{%- for p in inputs %}
    .{{ p.name }}({{ p.name }}),
{%- endfor %}
    .out_valid(out_valid),
    .out_ready(out_ready),
    .out_tag(out_tag),
{%- for p in outputs %}
    .{{ p.name }}({{ p.name }}),
{%- endfor %}
    .slot_busy(slot_busy)
  );

  initial begin
    done = 1'b0;
    exit_code = 8'd0;
    checked = 0;
    wrong = 0;
    outstanding = 0;
    quiet = 0;
    after = 0;
    cycles = 0;
    loaded = 0;
    busy = 0;
    rays = 0;
    words_left = 0;
    stim_left = 0;
    exp_left = 0;
    flood_left = 0;
    flood_rows = 0;
    res_fd = 0;
    lfsr = 32'h2468_ace1;
    word = 0;
    row_wrong = 1'b0;
    rst = 1'b1;
    load_en = 1'b0;
    load_addr = 0;
    load_data = 0;
    in_valid = 1'b0;
    in_tag = 0;
    next_tag = 0;
    tag_word = 0;
    out_ready = 1'b0;
{%- for p in inputs %}
    {{ p.name }} = 0;
{%- endfor %}
    for (k = 0; k < Tags; k = k + 1) begin
      tag_used[k] = 1'b0;
      tag_ray[k] = 0;
    end
    gaps = $test$plusargs("gaps") != 0;
    stalls = $test$plusargs("stalls") != 0;
    if ($test$plusargs("flood") != 0) flood_left = 200;
    if ($value$plusargs("patience=%d", patience) == 0) patience = 2000000;
    if ($value$plusargs("vectors=%s", dir) == 0) dir = "golden/traverse";
    $sformat(path, "%0s/memory.hex", dir);
    mem_fd = $fopen(path, "r");
    $sformat(path, "%0s/stimulus.hex", dir);
    stim_fd = $fopen(path, "r");
    $sformat(path, "%0s/expected.hex", dir);
    exp_fd = $fopen(path, "r");
    if (mem_fd == 0 || stim_fd == 0 || exp_fd == 0) begin
      $display("FAIL tb_traverse: cannot read memory.hex, stimulus.hex and expected.hex in %0s", dir);
      exit_code = 8'd2;
      done = 1'b1;
    end else begin
      got = $fgets(header, mem_fd);
      got = $fscanf(mem_fd, "%h", word);
      words_left = (got == 1) ? word[31:0] : 0;
      got = $fgets(header, stim_fd);
      got = $fscanf(stim_fd, "%h", word);
      stim_left = (got == 1) ? word[31:0] : 0;
      got = $fgets(header, exp_fd);
      got = $fscanf(exp_fd, "%h", word);
      exp_left = (got == 1) ? word[31:0] : 0;
      if ($value$plusargs("results=%s", path) != 0) res_fd = $fopen(path, "w");
      if (stim_left == 0 && exp_left == 0) begin
        $display("FAIL tb_traverse: no rays in %0s, nothing ran", dir);
        exit_code = 8'd5;
        done = 1'b1;
      end
    end
  end

  always @(posedge clk) begin
    if (!done) begin
      cycles = cycles + 1;
      lfsr <= {lfsr[30:0], lfsr[31] ^ lfsr[21] ^ lfsr[1] ^ lfsr[0]};
      if (cycles < 4) begin
        rst <= 1'b1;
      end else if (words_left > 0) begin
        // The pyramid, a word a clock.
        rst <= 1'b0;
        got = $fscanf(mem_fd, "%h", word);
        load_en <= 1'b1;
        load_data <= word[HEIGHT_W-1:0];
        load_addr <= load_en ? load_addr + 1'b1 : load_addr;
        words_left = words_left - 1;
      end else if (flood_left > 0) begin
        // Rays that reset throws away; nothing of them may come out afterwards.
        load_en <= 1'b0;
        flood_left = flood_left - 1;
        in_valid <= 1'b1;
        out_ready <= 1'b0;
        rst <= flood_left < 3;
        tag_word = {lfsr, next_tag};
        in_tag <= tag_word[TAG_W-1:0];
        if (flood_rows < stim_left) begin
          flood_rows = flood_rows + 1;
{%- for p in inputs %}
          got = $fscanf(stim_fd, "%h", word);
          {{ p.name }} <= word{{ p.select }};
{%- endfor %}
        end
        if (flood_left == 0) begin
          in_valid <= 1'b0;
          $fclose(stim_fd);
          $sformat(path, "%0s/stimulus.hex", dir);
          stim_fd = $fopen(path, "r");
          got = $fgets(header, stim_fd);
          got = $fscanf(stim_fd, "%h", word);
        end
      end else begin
        rst <= 1'b0;
        load_en <= 1'b0;
        out_ready <= ~stalls | lfsr[5];
        quiet = quiet + 1;
        if (!rst && (^{in_ready, out_valid, slot_busy}) === 1'bx) begin
          $display("FAIL tb_traverse: in_ready, out_valid or slot_busy is undefined, after %0d", checked);
          exit_code <= 8'd1;
          done <= 1'b1;
        end else if (!rst && out_valid && out_ready) begin
          quiet = 0;
          if (tag_used[slot] !== 1'b1 || out_tag !== tag_sent[slot]) begin
            $display("FAIL tb_traverse: a result with tag %h came that nobody expected, after %0d", out_tag, checked);
            exit_code <= 8'd7;
            done <= 1'b1;
          end else begin
            row_wrong = 1'b0;
{%- for p in outputs %}
            word = want_{{ p.name }}[slot];
            if ({{ p.name }} !== word{{ p.select }}) begin
              if (wrong < 10)
                $display("ray %0d, {{ p.name }}: expected %h, got %h", tag_ray[slot], word{{ p.select }}, {{ p.name }});
              row_wrong = 1'b1;
            end
{%- endfor %}
            if (row_wrong) wrong = wrong + 1;
            checked = checked + 1;
            outstanding = outstanding - 1;
            tag_used[slot] = 1'b0;
            if (res_fd != 0)
              $fwrite(res_fd, "%0d{% for p in outputs %} %h{% endfor %}\n", tag_ray[slot]{% for p in outputs %}, {{ p.name }}{% endfor %});
          end
        end
        if (accepted) begin
          // From here on the result is expected under this tag.
          if (exp_left == 0) begin
            tag_used[in_tag[TagBits-1:0]] = 1'b0;
          end else begin
{%- for p in outputs %}
            got = $fscanf(exp_fd, "%h", word);
            want_{{ p.name }}[in_tag[TagBits-1:0]] = word;
{%- endfor %}
            exp_left = exp_left - 1;
            tag_used[in_tag[TagBits-1:0]] = 1'b1;
          end
          tag_ray[in_tag[TagBits-1:0]] = rays;
          tag_sent[in_tag[TagBits-1:0]] = in_tag;
          rays = rays + 1;
          outstanding = outstanding + 1;
          next_tag = next_tag + 1'b1;
        end
        // Under full load: from the first ray on, until the last one has been taken.
        if ((stim_left > 0 || in_valid) && rays > 0) begin
          after = after + 1;
          if (after > WarmUp) begin
            loaded = loaded + 1;
            if (slot_busy) busy = busy + 1;
          end
        end
        if (accepted || !in_valid) begin
{%- if lingers %}
          // A ray that goes round until its limit keeps its tag; the others go on.
          for (k = 0; k < Tags && tag_used[next_tag]; k = k + 1) next_tag = next_tag + 1'b1;
{%- endif %}
          if (stim_left > 0 && !tag_used[next_tag] && !(gaps && lfsr[9])) begin
{%- for p in inputs %}
            got = $fscanf(stim_fd, "%h", word);
            {{ p.name }} <= word{{ p.select }};
{%- endfor %}
            if (got != 1) begin
              $display("FAIL tb_traverse: stimulus.hex ends before the number of rows that it announces");
              exit_code <= 8'd2;
              done <= 1'b1;
            end
            in_valid <= 1'b1;
            tag_word = {lfsr, next_tag};
            in_tag <= tag_word[TAG_W-1:0];
            stim_left = stim_left - 1;
          end else begin
            in_valid <= 1'b0;
          end
        end
        if (stim_left == 0 && outstanding == 0 && !in_valid && !accepted && quiet > 2 * WarmUp && !done) begin
          done <= 1'b1;
          if (exp_left > 0) begin
            $display("FAIL tb_traverse: ray %0d was expected and never came", rays);
            exit_code <= 8'd6;
          end else if (wrong > 0) begin
            $display("FAIL tb_traverse: %0d of %0d mismatched", wrong, checked);
            exit_code <= 8'd1;
          end else begin
            $display("slots busy: %0d of %0d under full load; %0d clocks in all", busy, loaded, cycles);
            $display("PASS tb_traverse: 0 of %0d mismatched", checked);
          end
          if (res_fd != 0) $fclose(res_fd);
        end else if (quiet > patience && !done) begin
          $display("FAIL tb_traverse: %0d rays went in and never came out", outstanding);
          exit_code <= 8'd6;
          done <= 1'b1;
        end
      end
    end
  end
endmodule
`default_nettype wire
