// Proof harness: {{ claim }}.
`default_nettype none
module {{ prefix }}fv_fp_lt (input wire clk);
  localparam integer E = {{ value("fp_lt", "EXP_W") }};
  localparam integer M = {{ value("fp_lt", "MAN_W") }};
{{ instance("fp_lt", "") }}
  // Sign and magnitude as one signed integer; an exponent of 0 is a zero.
  wire signed [E+M+1:0] a_size = (a[E+M-1:M] == 0) ? 0 : {2'b00, a[E+M-1:0]};
  wire signed [E+M+1:0] b_size = (b[E+M-1:M] == 0) ? 0 : {2'b00, b[E+M-1:0]};
  wire signed [E+M+1:0] a_value = a[E+M] ? -a_size : a_size;
  wire signed [E+M+1:0] b_value = b[E+M] ? -b_size : b_size;
  wire is_nan = (&a[E+M-1:M] && |a[M-1:0]) || (&b[E+M-1:M] && |b[M-1:0]);
  reg [7:0] clocks;
  initial clocks = 0;
  always @(posedge clk) clocks <= clocks + 1;
  always @* if (clocks == {{ latency }}) assert (result == (!is_nan && a_value < b_value));
endmodule
`default_nettype wire
