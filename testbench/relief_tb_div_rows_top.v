// relief_tb_div_rows_top: makes the clock of relief_tb_div_rows for event-driven simulators.
`default_nettype none
module relief_tb_div_rows_top #(
  parameter integer W = 17,
  parameter integer ROWS = 19
);
  reg        clk;
  wire       done;
  wire [7:0] exit_code;

  relief_tb_div_rows #(
    .W(W),
    .ROWS(ROWS)
  ) bench (
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
