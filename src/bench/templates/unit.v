// {{ prefix }}tb_{{ unit }}: replays the golden vectors of {{ unit }}{% if has_state %}, a row a clock from reset on{% else %} with random clock-enable gaps{% endif %}.
//   +vectors=DIR   directory with stimulus.hex and expected.hex (default golden/{{ unit }})
// Ends with one line, PASS or FAIL, and exit_code: 0 ok, 1 mismatch, 2 unreadable vectors,
// 5 nothing ran, 6 a result never came, 7 an unexpected result.
`default_nettype none
module {{ prefix }}tb_{{ unit }}{% if params %} #(
{%- for p in params %}
  {{ p.declared }}
{%- endfor %}
){% endif %} (
  input  wire       clk,
  output reg        done,
  output reg  [7:0] exit_code
);
  localparam integer Latency = {{ latency }};  // clocks from operands to results
  // Bits of a row, as the files announce them.
  localparam integer InW =
{%- for p in inputs %}
    {{ p.width }}{% if not loop.last %} +{% else %};{% endif %}  // {{ p.name }}
{%- endfor %}
  localparam integer OutW =
{%- for p in outputs %}
    {{ p.width }}{% if not loop.last %} +{% else %};{% endif %}  // {{ p.name }}
{%- endfor %}

  reg [8*1000-1:0] dir;
  integer stim_fd;
  integer exp_fd;
  integer stim_left;
  integer exp_left;
  integer stim_bits;
  integer exp_bits;
  integer checked;
  integer wrong;
  integer drain;{% if not has_state %}
  reg [31:0] lfsr;{% endif %}

{% if has_state %}  reg  [1:0] resets;
  wire       rst = resets != 0;{% else %}  reg        ce;{% endif %}
  reg        in_valid;
  reg [Latency:0] travel;
{%- for p in inputs %}
  reg  {{ p.range }} in_{{ p.name }};
{%- endfor %}
{%- for p in outputs %}
  wire {{ p.range }} out_{{ p.name }};
{%- endfor %}
  wire       out_valid = (Latency == 0) ? in_valid : travel[Latency];

  {{ dut }}{% if params or terms %} #(
{%- for p in params %}
    .{{ p.name }}({{ p.name }}){% if terms or not loop.last %},{% endif %}
{%- endfor %}
{%- for t in terms %}
    .{{ t.name }}({{ t.value }}){% if not loop.last %},{% endif %}
{%- endfor %}
  ){% endif %} dut (
{%- if has_state %}
    .clk(clk),
    .rst(rst),
{%- elif clocked %}
    .clk(clk),
    .ce(ce),
{%- endif %}
{%- for p in inputs %}
    .{{ p.name }}(in_{{ p.name }}),
{%- endfor %}
{%- for p in outputs %}
    .{{ p.name }}(out_{{ p.name }}){% if not loop.last %},{% endif %}
{%- endfor %}
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
{% if has_state %}    resets = 2'd2;{% else %}    lfsr = 32'h1234_5678;
    ce = 1'b0;{% endif %}
    in_valid = 1'b0;
    travel = 0;
{%- for p in inputs %}
    in_{{ p.name }} = 0;
{%- endfor %}
    stim_left = 0;
    exp_left = 0;
    if ($value$plusargs("vectors=%s", dir) == 0) dir = "golden/{{ unit }}";
    stim_fd = $fopen($sformatf("%0s/stimulus.hex", dir), "r");
    exp_fd = $fopen($sformatf("%0s/expected.hex", dir), "r");
    if (stim_fd == 0 || exp_fd == 0) begin
      $display("FAIL tb_{{ unit }}: %0s in %0s",
               "cannot read stimulus.hex and expected.hex", dir);
      exit_code = 8'd2;
      done = 1'b1;
    end else begin
      read_head(stim_fd, stim_left, stim_bits);
      read_head(exp_fd, exp_left, exp_bits);
      if ((stim_left == 0 && exp_left == 0) || stim_bits == 0 || exp_bits == 0) begin
        $display("FAIL tb_{{ unit }}: no vectors in %0s, nothing ran", dir);
        exit_code = 8'd5;
        done = 1'b1;
      end else if (stim_bits != InW || exp_bits != OutW) begin
        $display("FAIL tb_{{ unit }}: rows of %0d and %0d bits in %0s,",
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
      travel <= (travel << 1) | (in_valid ? {{ travel_in }} : 0);
      if (out_valid && exp_left != 0) begin
{%- for p in outputs %}
        got = $fscanf(exp_fd, "%h", word);
        if (got != 1 || (word >> ({{ p.width }})) != 0) bad_out = 1'b1;
        if ({% if p.valid %}out_{{ p.valid }} !== 1'b0 && {% endif %}out_{{ p.name }} !== word{{ p.select }}) begin
          if (wrong < 10)
            $display("vector %0d, {{ p.name }}: expected %h, got %h",
                     checked, word{{ p.select }}, out_{{ p.name }});
          if (wrong == 0 && !row_wrong)
            $display("@fail unit={{ unit }} row=%0d port={{ p.name }} exp=%h got=%h",
                     checked, word{{ p.select }}, out_{{ p.name }});
          row_wrong = 1'b1;
        end
{%- endfor %}
        checked <= checked + 1;
        exp_left <= exp_left - 1;
        if (row_wrong) wrong <= wrong + 1;
      end
      if (stim_left > 0) begin
{%- for p in inputs %}
        got = $fscanf(stim_fd, "%h", word);
        if (got != 1 || (word >> ({{ p.width }})) != 0) bad_in = 1'b1;
        in_{{ p.name }} <= word{{ p.select }};
{%- endfor %}
        in_valid <= 1'b1;
        stim_left <= stim_left - 1;
      end else begin
        in_valid <= 1'b0;
        drain <= drain + 1;
      end
      if (bad_in || bad_out) begin
        $display("FAIL tb_{{ unit }}: %0s.hex holds other rows than it announces",
                 bad_in ? "stimulus" : "expected");
        exit_code <= 8'd2;
        done <= 1'b1;
      end else if (out_valid && exp_left == 0) begin
        $display("FAIL tb_{{ unit }}: %0s, after %0d",
                 "an unexpected result", checked);
        exit_code <= 8'd7;
        done <= 1'b1;
      end else if (drain > Latency + 4) begin
        done <= 1'b1;
        got = $fscanf(stim_fd, "%h", word);
        got_exp = $fscanf(exp_fd, "%h", word);
        if (exp_left > 0) begin
          $display("FAIL tb_{{ unit }}: vector %0d was expected and never came", checked);
          exit_code <= 8'd6;
        end else if (got == 1 || got_exp == 1) begin
          $display("FAIL tb_{{ unit }}: %0s in %0s holds more rows than it announces",
                   "stimulus.hex or expected.hex", dir);
          exit_code <= 8'd2;
        end else if (wrong > 0) begin
          $display("@done unit={{ unit }} checked=%0d wrong=%0d", checked, wrong);
          $display("FAIL tb_{{ unit }}: %0d of %0d mismatched", wrong, checked);
          exit_code <= 8'd1;
        end else begin
          $display("@done unit={{ unit }} checked=%0d wrong=0", checked);
          $display("PASS tb_{{ unit }}: 0 of %0d mismatched", checked);
        end
      end
    end
  endtask

  always @(posedge clk) begin
    if (!done) begin
{% if has_state %}      if (rst) resets <= resets - 2'd1;
      else step;{% else %}      lfsr <= {lfsr[30:0], lfsr[31] ^ lfsr[21] ^ lfsr[1] ^ lfsr[0]};
      ce <= lfsr[3] | lfsr[7];
      if (ce) step;{% endif %}
    end
  end
`endif
endmodule
`default_nettype wire
