// SPDX-License-Identifier: MIT OR Apache-2.0
// Proof harness: bits go where Morton order puts them, at every width from 1 to 32.
`default_nettype none
module relief_fv_interleave;
  (* anyconst *) wire [31:0] even;
  (* anyconst *) wire [31:0] odd;
  genvar w, k;
  generate
    for (w = 1; w <= 32; w = w + 1) begin : gen_width
      wire [2*w-1:0] result;
      relief_interleave #(.W(w)) dut (.a(even[w-1:0]), .b(odd[w-1:0]), .result(result));
      for (k = 0; k < w; k = k + 1) begin : gen_bit
        always @* begin
          assert (result[2*k] == even[k]);
          assert (result[2*k+1] == odd[k]);
        end
      end
    end
  endgenerate
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
