// relief_tb_start_level_top: makes the clock of relief_tb_start_level for event-driven simulators.
`default_nettype none
module relief_tb_start_level_top #(
  parameter integer LEVELS = 8,
  parameter integer IDX_W = 14
);
  reg        clk;
  wire       done;
  wire [7:0] exit_code;

  relief_tb_start_level #(
    .LEVELS(LEVELS),
    .IDX_W(IDX_W)
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
