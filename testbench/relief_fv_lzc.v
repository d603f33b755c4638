// SPDX-License-Identifier: MIT OR Apache-2.0
// Proof harness: zeros above the count, a one below it, at every width from 1 to 64.
`default_nettype none
module relief_fv_lzc;
  (* anyconst *) wire [63:0] word;
  genvar w;
  generate
    for (w = 1; w <= 64; w = w + 1) begin : gen_width
      wire [$clog2(w+1)-1:0] count;
      relief_lzc #(.W(w)) dut (.bits(word[w-1:0]), .count(count));
      // Zeros above, then a one, unless there is none.
      wire [w-1:0] up = word[w-1:0] << count;
      always @* begin
        assert (count <= w);
        assert (({1'b0, word[w-1:0]} >> (w - count)) == 0);
        if (count != w) assert (up[w-1]);
      end
    end
  endgenerate
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
