// {{ prefix }}tb_traverse: loads {% if sizes %}the windows{% else %}the pyramid{% endif %}, sends the golden rays, and checks that each ray has
// exactly one result, the expected one.
//   +vectors=DIR   directory with memory.hex{% if sizes %}.0 and on{% endif %}, stimulus.hex, expected.hex (default golden/traverse)
//   +gaps          in_valid falls at random         +stalls    out_ready falls at random
//   +flood         fills the pipeline with rays, resets it for one clock, and only then runs the set
//   +reset         resets of one clock while rays are on their way; the set starts again after each
//   +again         the set, and once it has passed, the set again with gaps, stalls, flood, reset, and
//                  a hold: out_ready is 0 until every stage is full, and no result may be lost
//   +patience=N    clocks without a result after which a ray counts as lost (default: four times
//                  what the longest ray {% if counted %}sent so far{% else %}of the set{% endif %} may take)
//   +results=FILE  one line per ray: its number, then its outputs in hex
// The parameter MEM_INIT names a file that fills the memory at power-up; memory.hex is not loaded
// then. Compiled with ITERATIONS defined, it reads nets of the loop, which a netlist does not have:
//   +iterations=FILE  one line per iteration: ray, level, x, y, t in hex, as the ray enters the loop
// Ends with one line, PASS or FAIL, and exit_code: 0 ok, 1 a wrong result, idle or slot_busy, or an
// undefined handshake, 2 unreadable vectors, 5 nothing ran, 6 a result never came, 7 an unexpected
// result.
`default_nettype none
module {{ prefix }}tb_traverse #(
{%- for p in params %}
  {{ p.declared }}
{%- endfor %}
{%- for f in files %}
  // file for $readmemh with the first words of the memory; "": none
  parameter {{ f }} = ""{% if not loop.last %},{% endif %}
{%- endfor %}
) (
  input  wire       clk,
  output reg        done,
  output reg  [7:0] exit_code
);
  localparam integer WarmUp = {{ warm_up }};  // clocks until the pipeline can be full
  localparam integer Flood = 200;             // clocks of the flood
  localparam integer Resets = 12;             // resets while rays are on their way
  localparam integer TagBits = (TAG_W < 8) ? TAG_W : 8;  // bits of a tag that the bench counts
  localparam integer Tags = 1 << TagBits;     // rays under way, at most
  // Bits of a row, as stated in the head of each file{% if not sizes %}, and words of the pyramid{% endif %}.
  localparam integer InW =
{%- for p in inputs %}
    {{ p.width }}{% if not loop.last %} +{% else %};{% endif %}  // {{ p.name }}
{%- endfor %}
  localparam integer OutW =
{%- for p in outputs %}
    {{ p.width }}{% if not loop.last %} +{% else %};{% endif %}  // {{ p.name }}
{%- endfor %}
{%- if sizes %}
  localparam integer Sizes = {{ sizes | length }};  // sizes of windows, each with a memory
{%- else %}
  localparam integer Words = ((1 << (2 * LEVELS + 2)) - 1) / 3;
{%- endif %}

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
  reg [31:0] longest;     // most iterations of a ray {% if counted %}so far{% else %}of the set{% endif %}
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
  reg [31:0] needed;      // iterations of the rays {% if counted %}sent{% else %}of the set{% endif %}
  reg [31:0] lfsr;        // random bits

  reg        rst;
  reg        load_en;
  reg [2*LEVELS:0] load_addr;
  reg [HEIGHT_W-1:0] load_data;
{%- if sizes %}
  integer    load_size;  // the memory that the word is for
  integer    file_size;  // the memory whose file is open
{%- endif %}
  reg        in_valid;
  wire       in_ready;
  reg [TAG_W-1:0] in_tag;
{%- for p in inputs %}
  reg {% if p.range %}{{ p.range }} {% endif %}{{ p.name }};
{%- endfor %}
  wire       out_valid;
  reg        out_ready;
  wire [TAG_W-1:0] out_tag;
{%- for p in outputs %}
  wire {% if p.range %}{{ p.range }} {% endif %}{{ p.name }};
{%- endfor %}
  wire       slot_busy;
  wire       idle;

  // Per tag in flight: its ray, and the result expected of it.
  reg [Tags-1:0] tag_used;              // a result is expected under this tag
  integer    tag_ray [0:Tags-1];        // number of the ray
  reg [TAG_W-1:0] tag_sent [0:Tags-1];  // the whole tag
{%- for p in outputs %}
  reg {% if p.range %}{{ p.range }} {% endif %}want_{{ p.name }} [0:Tags-1];
{%- endfor %}
  wire [TagBits-1:0] slot = out_tag[TagBits-1:0];
  reg [TagBits-1:0] next_tag;  // of the ray on the inputs
  wire       accepted = in_valid & in_ready & ~rst;
  wire       transferred = out_valid & out_ready & ~rst;
  wire       expected = (tag_used[slot] === 1'b1) & (out_tag === tag_sent[slot]);
  // An iteration takes less than WarmUp clocks; the rest of a ray takes no longer than some of them.
  wire [31:0] limit = (patience > 0) ? patience : 4 * WarmUp * (longest + 16);
  wire       all_back = stim_left == 0 && rays == checked && !in_valid;

  {{ dut }} #(
{%- for p in params %}
    .{{ p.name }}({{ p.name }}),
{%- endfor %}
{%- for f in files %}
    .{{ f }}({{ f }}),
{%- endfor %}
{%- for t in terms %}
    .{{ t.name }}({{ t.value }}){% if not loop.last %},{% endif %}
{%- endfor %}
  ) dut (
    .clk(clk),
    .rst(rst),
{%- for s in sizes %}
    .load_en_{{ loop.index0 }}(load_en && load_size == {{ loop.index0 }}),
    .load_addr_{{ loop.index0 }}(load_addr[{{ s.addr }}-1:0]),
    .load_data_{{ loop.index0 }}(load_data),
{%- else %}
    .load_en(load_en),
    .load_addr(load_addr),
    .load_data(load_data),
{%- endfor %}
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

{%- if sizes %}

  // Words of the memory of a size.
  function automatic integer words_of(input integer size);
    begin
      case (size)
{%- for s in sizes %}
        {{ loop.index0 }}: words_of = {{ s.words }};
{%- endfor %}
        default: words_of = 0;
      endcase
    end
  endfunction
{%- endif %}

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

{%- if not counted %}

  // What follows in the head of expected.hex, as no result says it: iterations of the longest ray
  // of the set, and of all its rays.
  task automatic read_iterations(output integer found);
    found = $fscanf(exp_fd, "%h %h", longest, needed);
  endtask
{%- endif %}

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
{%- if sizes %}
    load_size = 0;
    file_size = 0;
{%- endif %}
    in_valid = 1'b0;
    in_tag = 0;
    next_tag = 0;
    out_ready = 1'b0;
{%- for p in inputs %}
    {{ p.name }} = 0;
{%- endfor %}
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
    mem_fd = $fopen($sformatf("%0s/memory.hex{% if sizes %}.0{% endif %}", dir), "r");
    stim_fd = $fopen($sformatf("%0s/stimulus.hex", dir), "r");
    exp_fd = $fopen($sformatf("%0s/expected.hex", dir), "r");
    if ((mem_fd == 0 && MEM_INIT == "") || stim_fd == 0 || exp_fd == 0) begin
      $display("FAIL tb_traverse: cannot read memory.hex{% if sizes %}.0{% endif %}, stimulus.hex, expected.hex in %0s", dir);
      exit_code = 8'd2;
      done = 1'b1;
    end else begin
      if (MEM_INIT == "") begin
        skip_comments(mem_fd);
        words_left = {% if sizes %}words_of(0){% else %}Words{% endif %};
      end
      read_head(stim_fd, stim_left, stim_bits);
      read_head(exp_fd, exp_left, exp_bits);
{%- if not counted %}
      if (exp_bits != 0) begin
        read_iterations(k);
        if (k != 2) exp_bits = 0;
      end
{%- endif %}
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

  // Loads {% if sizes %}the windows{% else %}the pyramid{% endif %}, one word per clock.
  task automatic load_word;
    integer got;
    reg [63:0] word;
    begin
      rst <= 1'b0;
      got = $fscanf(mem_fd, "%h", word);
      if (got != 1) begin
{%- if sizes %}
        $display("FAIL tb_traverse: memory.hex.%0d in %0s holds fewer words than the %0d",
                 file_size, dir, words_of(file_size), " of a map of LEVELS = %0d", LEVELS);
{%- else %}
        $display("FAIL tb_traverse: memory.hex in %0s holds fewer words than the %0d", dir, Words,
                 " of a pyramid of LEVELS = %0d", LEVELS);
{%- endif %}
        finish(8'd2);
      end else if ((word >> HEIGHT_W) != 0) begin
        $display("FAIL tb_traverse: memory.hex in %0s holds %0h,", dir, word,
                 " more than HEIGHT_W = %0d bits", HEIGHT_W);
        finish(8'd2);
      end
      load_en <= 1'b1;
      load_data <= word[HEIGHT_W-1:0];
{%- if sizes %}
      load_addr <= (words_left == words_of(file_size)) ? 0 : load_addr + 1'b1;
      load_size <= file_size;
      words_left <= words_left - 1;
      // The next size has a file of its own.
      if (words_left == 1 && file_size + 1 < Sizes) begin
        got = $fscanf(mem_fd, "%h", word);
        if (got == 1) begin
          $display("FAIL tb_traverse: memory.hex.%0d in %0s holds more than %0d words", file_size,
                   dir, words_of(file_size));
          finish(8'd2);
        end
        $fclose(mem_fd);
        mem_fd = $fopen($sformatf("%0s/memory.hex.%0d", dir, file_size + 1), "r");
        if (mem_fd == 0) begin
          $display("FAIL tb_traverse: cannot read memory.hex.%0d in %0s", file_size + 1, dir);
          finish(8'd2);
        end else begin
          skip_comments(mem_fd);
          words_left <= words_of(file_size + 1);
        end
        file_size <= file_size + 1;
      end
{%- else %}
      load_addr <= load_en ? load_addr + 1'b1 : load_addr;
      words_left <= words_left - 1;
{%- endif %}
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
{%- for p in inputs %}
      got = $fscanf(stim_fd, "%h", word);
      if (got != 1 || (word >> ({{ p.width }})) != 0) bad = 1'b1;
      {{ p.name }} <= word{{ p.select }};
{%- endfor %}
      if (bad) bad_stim <= 1'b1;
    end
  endtask

  // Starts the files of the set again at their first row.
  task automatic rewind_set;
    integer rows_in;
    integer rows_out;
{%- if not counted %}
    integer found;
{%- endif %}
    begin
      $fclose(stim_fd);
      $fclose(exp_fd);
      stim_fd = $fopen($sformatf("%0s/stimulus.hex", dir), "r");
      exp_fd = $fopen($sformatf("%0s/expected.hex", dir), "r");
      read_head(stim_fd, rows_in, stim_bits);
      read_head(exp_fd, rows_out, exp_bits);
{%- if not counted %}
      read_iterations(found);
      if (found != 2) bad_exp <= 1'b1;
{%- endif %}
      stim_left <= rows_in;
      exp_left <= rows_out;
      rays <= 0;
      checked <= 0;
      quiet <= 0;
{%- if counted %}
      needed <= 0;
{%- endif %}
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
{%- for p in outputs %}
      if ({{ p.name }} !== want_{{ p.name }}[slot]) begin
        if (wrong < 10)
          $display("ray %0d, {{ p.name }}: expected %h, got %h",
                   tag_ray[slot], want_{{ p.name }}[slot], {{ p.name }});
        if (wrong == 0 && !row_wrong)
          $display("@fail unit=traverse row=%0d port={{ p.name }} exp=%h got=%h",
                   tag_ray[slot], want_{{ p.name }}[slot], {{ p.name }});
        row_wrong = 1'b1;
      end
{%- endfor %}
      if (row_wrong) wrong <= wrong + 1;
      checked <= checked + 1;
      last_out <= cycles;
      tag_used[slot] <= 1'b0;
      if (res_fd != 0) begin
        $fwrite(res_fd, "%0d", tag_ray[slot]);
{%- for p in outputs %}
        $fwrite(res_fd, " %h", {{ p.name }});
{%- endfor %}
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
{%- for p in outputs %}
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> ({{ p.width }})) != 0) bad = 1'b1;
        want_{{ p.name }}[in_tag[TagBits-1:0]] <= word{{ p.select }};
{%- if p.name == "out_steps" %}
        if (word[31:0] > longest) longest <= word[31:0];
        needed <= needed + word[31:0];
{%- endif %}
{%- endfor %}
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
{%- if lingers %}
    integer b;
{%- endif %}
    begin
      // The tag of a ray that a reset discarded is not used next, so that a stale result shows.
      low = (accepted || rst) ? next_tag + 1'b1 : next_tag;
      if (accepted || !in_valid || rst) begin
{%- if lingers %}
        // A ray that recirculates until its limit keeps its tag; the others go on.
        for (b = 0; b < Tags; b = b + 1) if (tag_used[low]) low = low + 1'b1;
{%- endif %}
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
{%- if not sizes %}

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
    if (it_fd != 0 && !done && !rst && dut.{{ valid }} && !dut.s{{ enters }}_done)
      $fwrite(it_fd, "%0d %h %h %h %h\n", tag_ray[dut.s{{ enters }}_tag[TagBits-1:0]],
              dut.s{{ enters }}_level, dut.s{{ enters }}_x, dut.s{{ enters }}_y, dut.s{{ enters }}_t);
  end
`endif
{%- endif %}
`endif
endmodule
`default_nettype wire
