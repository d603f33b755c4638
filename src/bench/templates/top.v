// {{ prefix }}tb_{{ unit }}_top: makes the clock of {{ prefix }}tb_{{ unit }} for event-driven simulators.
`default_nettype none
module {{ prefix }}tb_{{ unit }}_top{% if params %} #(
{%- for p in params %}
  parameter integer {{ p.name }} = {{ p.default }}{% if not loop.last %},{% endif %}
{%- endfor %}
){% endif %};
  reg        clk;
  wire       done;
  wire [7:0] exit_code;

  {{ prefix }}tb_{{ unit }}{% if params %} #(
{%- for p in params %}
    .{{ p.name }}({{ p.name }}){% if not loop.last %},{% endif %}
{%- endfor %}
  ){% endif %} bench (
    .clk(clk),
    .done(done),
    .exit_code(exit_code)
  );

  initial begin
    clk = 1'b0;
    forever #5 clk = ~clk;
  end

  always @(posedge done) begin
`ifdef __ICARUS__
    $finish_and_return(exit_code);
`else
    $display("exit code %0d", exit_code);
    $finish;
`endif
  end
  initial #1 if (done) begin
`ifdef __ICARUS__
    $finish_and_return(exit_code);
`else
    $display("exit code %0d", exit_code);
    $finish;
`endif
  end
endmodule
`default_nettype wire
