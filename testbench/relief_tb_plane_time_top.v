// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_tb_plane_time_top: clock of relief_tb_plane_time,
// for event-driven simulators.
`default_nettype none
module relief_tb_plane_time_top #(
  parameter integer EXP_W = 7,   // exponent bits
  parameter integer MAN_W = 16,  // fraction bits, the hidden one not counted
  parameter integer IDX_W = 14   // bits of a signed, unwrapped texel coordinate
);
  reg        clk;
  wire       done;
  wire [7:0] exit_code;

  relief_tb_plane_time #(
    .EXP_W(EXP_W),
    .MAN_W(MAN_W),
    .IDX_W(IDX_W)
  ) bench (
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
`ifndef YOSYS
`default_nettype wire
`endif
