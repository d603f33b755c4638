// {{ prefix }}tb_{{ unit }}_top: clock of {{ prefix }}tb_{{ unit }},
// for event-driven simulators.
`default_nettype none
module {{ prefix }}tb_{{ unit }}_top{% if params %} #(
{%- for p in params %}
  {{ p.declared }}
{%- endfor %}
{%- for f in files %}
  parameter {{ f }} = ""{% if not loop.last %},{% endif %}
{%- endfor %}
){% endif %};
  reg        clk;
  wire       done;
  wire [7:0] exit_code;

  {{ prefix }}tb_{{ unit }}{% if params %} #(
{%- for p in params %}
    .{{ p.name }}({{ p.name }}){% if files or not loop.last %},{% endif %}
{%- endfor %}
{%- for f in files %}
    .{{ f }}({{ f }}){% if not loop.last %},{% endif %}
{%- endfor %}
  ){% endif %} bench (
    .clk(clk),
    .done(done),
    .exit_code(exit_code)
  );

  // Yosys has no delays: it sees the bench without a clock.
`ifndef YOSYS
  initial begin
    clk = 1'b0;
    forever #5 clk = ~clk;
  end

  // Icarus ends with the code itself; every other simulator with a status of its own, which is not 0
  // if the code isn't (of Verilator, too, where this module is the top): the code is printed.
  task automatic stop;
    begin
`ifdef __ICARUS__
      $finish_and_return(exit_code);
`elsif VERILATOR
      if (exit_code != 8'd0) begin
        $display("exit code %0d", exit_code);
        $stop;
      end
      $finish;
`else
      if (exit_code == 8'd0) $finish;
      else $fatal(1, "exit code %0d", exit_code);
`endif
    end
  endtask

  always @(posedge done) stop;
  initial #1 if (done) stop;
`endif
endmodule
`default_nettype wire
