// lzc: number of leading zeros of a word; W when the word is zero
// Source     src/units/lzc.rs (emitted: do not edit)
// Config     float 7/16, levels 8, heights 8 bits, start level, 2 down, up selective; clocks add 2
//            mul 1 div 2 compare 1 from_int 1 to_int 1
// Latency    none, combinational
`default_nettype none
module lzc #(
  parameter integer W = 8   // bits of the word
) (
  input  wire [W-1:0]           bits,   // the word [bits]
  output wire [$clog2(W+1)-1:0] count   // zeros above the topmost 1 [bits]
);
  localparam integer CountW = $clog2(W + 1);

  // Illegal parameters end elaboration here: the missing module's name says what must hold.
  generate
    if (1 > W) begin : gen_illegal_0
      must_hold_1_at_most_W u_illegal ();
    end
    if (W > 64) begin : gen_illegal_1
      must_hold_W_at_most_64 u_illegal ();
    end
  endgenerate

  // Ones below the last bit: the count of an all-zero word comes out as W by itself.
  localparam integer PadW = 1 << CountW;
  wire [PadW-1:0] padded = {bits, {(PadW - W){1'b1}}};

  // Step s looks at PadW >> s bits: if the upper half is zero it counts, and the lower half
  // goes on.
  genvar s;
  generate
    for (s = 0; s < CountW; s = s + 1) begin : gen_step
      localparam integer Half = PadW >> (s + 1);
      wire [2*Half-1:0] here;
      wire              upper_is_zero = (here[2*Half-1:Half] == {Half{1'b0}});
      wire [Half-1:0]   next = upper_is_zero ? here[Half-1:0] : here[2*Half-1:Half];
      if (s == 0) begin : gen_first
        assign here = padded;
      end else begin : gen_later
        assign here = gen_step[s-1].next;
      end
      assign count[CountW-1-s] = upper_is_zero;
    end
  endgenerate

  // verilator lint_off UNUSED
  wire unused_last = &{1'b0, gen_step[CountW-1].next};
  // verilator lint_on UNUSED
endmodule
`default_nettype wire
