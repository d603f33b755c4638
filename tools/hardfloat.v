// Berkeley HardFloat's add, multiply and comparison at 1/7/16 as `synth` measures ours: between ranks of registers on
// every data port, nearest even, flags open, tininess after rounding. L2 has its second register between the unit and
// its rounding. Ports and modules as in Release 1 (Verilog), whose operands are recoded: 25 bits.
module hf_add_l1 (input wire clk, input wire [24:0] a, b, output reg [24:0] result);
  reg [24:0] a_rank1, b_rank1, a_rank2, b_rank2, result_rank1;
  wire [24:0] sum;
  wire [4:0] flags;
  addRecFN #(7, 17) unit (1'b1, 1'b0, a_rank2, b_rank2, 3'b000, sum, flags);
  always @(posedge clk) begin
    {a_rank1, b_rank1, a_rank2, b_rank2} <= {a, b, a_rank1, b_rank1};
    {result_rank1, result} <= {sum, result_rank1};
  end
endmodule

module hf_add_l2 (input wire clk, input wire [24:0] a, b, output reg [24:0] result);
  reg [24:0] a_rank1, b_rank1, a_rank2, b_rank2, result_rank1;
  wire invalid, nan, inf, zero, sign;
  wire signed [8:0] exponent;
  wire [19:0] significand;
  reg r_invalid, r_nan, r_inf, r_zero, r_sign;
  reg signed [8:0] r_exponent;
  reg [19:0] r_significand;
  wire [24:0] sum;
  wire [4:0] flags;
  addRecFNToRaw #(7, 17) unit
    (1'b1, 1'b0, a_rank2, b_rank2, 3'b000, invalid, nan, inf, zero, sign, exponent, significand);
  roundRawFNToRecFN #(7, 17, 2) rounding
    (1'b1, r_invalid, 1'b0, r_nan, r_inf, r_zero, r_sign, r_exponent, r_significand, 3'b000, sum, flags);
  always @(posedge clk) begin
    {a_rank1, b_rank1, a_rank2, b_rank2} <= {a, b, a_rank1, b_rank1};
    {r_invalid, r_nan, r_inf, r_zero, r_sign} <= {invalid, nan, inf, zero, sign};
    {r_exponent, r_significand} <= {exponent, significand};
    {result_rank1, result} <= {sum, result_rank1};
  end
endmodule

module hf_mul_l1 (input wire clk, input wire [24:0] a, b, output reg [24:0] result);
  reg [24:0] a_rank1, b_rank1, a_rank2, b_rank2, result_rank1;
  wire [24:0] product;
  wire [4:0] flags;
  mulRecFN #(7, 17) unit (1'b1, a_rank2, b_rank2, 3'b000, product, flags);
  always @(posedge clk) begin
    {a_rank1, b_rank1, a_rank2, b_rank2} <= {a, b, a_rank1, b_rank1};
    {result_rank1, result} <= {product, result_rank1};
  end
endmodule

module hf_mul_l2 (input wire clk, input wire [24:0] a, b, output reg [24:0] result);
  reg [24:0] a_rank1, b_rank1, a_rank2, b_rank2, result_rank1;
  wire invalid, nan, inf, zero, sign;
  wire signed [8:0] exponent;
  wire [19:0] significand;
  reg r_invalid, r_nan, r_inf, r_zero, r_sign;
  reg signed [8:0] r_exponent;
  reg [19:0] r_significand;
  wire [24:0] product;
  wire [4:0] flags;
  mulRecFNToRaw #(7, 17) unit
    (1'b1, a_rank2, b_rank2, invalid, nan, inf, zero, sign, exponent, significand);
  roundRawFNToRecFN #(7, 17, 0) rounding
    (1'b1, r_invalid, 1'b0, r_nan, r_inf, r_zero, r_sign, r_exponent, r_significand, 3'b000, product, flags);
  always @(posedge clk) begin
    {a_rank1, b_rank1, a_rank2, b_rank2} <= {a, b, a_rank1, b_rank1};
    {r_invalid, r_nan, r_inf, r_zero, r_sign} <= {invalid, nan, inf, zero, sign};
    {r_exponent, r_significand} <= {exponent, significand};
    {result_rank1, result} <= {product, result_rank1};
  end
endmodule

module hf_lt_l1 (input wire clk, input wire [24:0] a, b, output reg result);
  reg [24:0] a_rank1, b_rank1, a_rank2, b_rank2;
  reg result_rank1;
  wire less, equal, greater, unordered;
  wire [4:0] flags;
  compareRecFN #(7, 17) unit (a_rank2, b_rank2, 1'b0, less, equal, greater, unordered, flags);
  always @(posedge clk) begin
    {a_rank1, b_rank1, a_rank2, b_rank2} <= {a, b, a_rank1, b_rank1};
    {result_rank1, result} <= {less, result_rank1};
  end
endmodule
