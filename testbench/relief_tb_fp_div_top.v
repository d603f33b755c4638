// relief_tb_fp_div_top: makes the clock of relief_tb_fp_div for event-driven simulators.
`default_nettype none
module relief_tb_fp_div_top #(
  parameter integer EXP_W = 7,
  parameter integer MAN_W = 16
);
  reg        clk;
  wire       done;
  wire [7:0] exit_code;

  relief_tb_fp_div #(
    .EXP_W(EXP_W),
    .MAN_W(MAN_W)
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
