// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_spill_register: two-slot buffer between two handshakes: in_ready is registered
// Emitted    by reliefrtl as its unit spill_register; do not edit
// Latency    varies; valid/ready on both sides
// Throughput one result per clock
// Note       First in, first out, one word per clock. Not ready in the first clock after reset.
`default_nettype none
module relief_spill_register #(
  parameter integer W       = 8,  // bits of a word
  parameter integer VARIANT = 32'h4b082ec9  // digest of what it was generated for; checked
) (
  input  wire         clk,        // rising edge
  input  wire         rst,        // synchronous, active high; clears valid bits and counts, no data
  input  wire         in_valid,   // input valid
  output wire         in_ready,   // input ready (transfer when valid && ready); registered
  input  wire [W-1:0] in_data,    // input word [bits]
  output wire         out_valid,  // output valid
  input  wire         out_ready,  // output ready (transfer when valid && ready)
  output wire [W-1:0] out_data    // output word [bits]
);

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (W < 1) begin : gen_illegal_0 W_must_be_at_least_1 u_illegal (); end
    if (VARIANT != 32'h4b082ec9) begin : gen_other_variant
      relief_spill_register_has_VARIANT_4b082ec9_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- state registers, written at the end of the module ------------------------------
  reg         first_valid;    // the slot holds a word
  reg         second_valid;   // the slot holds a word
  reg         valid_q;        // either slot holds a word
  reg         wr_sel_q;       // write select: 0 the first slot, 1 the second
  reg         rd_sel_q;       // read select: 0 the first slot, 1 the second
  reg         out_of_reset;   // reset has ended
  reg         ready_q;        // a slot is free
  reg         load_first_q;   // the slot is free: it loads
  reg         load_second_q;  // the slot is free: it loads
  reg [W-1:0] first;          // word of the slot [bits]
  reg [W-1:0] second;         // word of the slot [bits]

  // ---- handshake ----------------------------------------------------------------------
  // An empty slot loads whatever is at the input; it becomes valid if the write select points to
  // it.
  wire push = in_valid & out_of_reset & ~(first_valid & second_valid);
  wire pop = valid_q & out_ready;
  wire push_first = push & ~wr_sel_q;
  wire push_second = push & wr_sel_q;
  wire pop_first = pop & ~rd_sel_q;
  wire pop_second = pop & rd_sel_q;
  wire first_valid_next = push_first | (first_valid & ~pop_first);
  wire second_valid_next = push_second | (second_valid & ~pop_second);

  // ---- data ---------------------------------------------------------------------------
  // The output word is selected by a register.
  wire [W-1:0] first_next = load_first_q ? in_data : first;
  wire [W-1:0] second_next = load_second_q ? in_data : second;
  wire [W-1:0] selected = rd_sel_q ? second : first;

  // ---- registers ----------------------------------------------------------------------
  // Every control output has a register of its own beside the slots' valid bits.
  wire valid_next = first_valid_next | second_valid_next;
  wire wr_sel_next = wr_sel_q ^ push;
  wire rd_sel_next = rd_sel_q ^ pop;
  wire ready_next = ~(first_valid_next & second_valid_next);
  wire load_first_next = ~first_valid_next;
  wire load_second_next = ~second_valid_next;

  // ---- state registers ----------------------------------------------------------------
  always @(posedge clk) begin
    first  <= first_next;
    second <= second_next;
  end
  always @(posedge clk) begin
    if (rst) begin
      first_valid   <= 1'b0;
      second_valid  <= 1'b0;
      valid_q       <= 1'b0;
      wr_sel_q      <= 1'b0;
      rd_sel_q      <= 1'b0;
      out_of_reset  <= 1'b0;
      ready_q       <= 1'b0;
      load_first_q  <= 1'b0;
      load_second_q <= 1'b0;
    end else begin
      first_valid   <= first_valid_next;
      second_valid  <= second_valid_next;
      valid_q       <= valid_next;
      wr_sel_q      <= wr_sel_next;
      rd_sel_q      <= rd_sel_next;
      out_of_reset  <= 1'b1;
      ready_q       <= ready_next;
      load_first_q  <= load_first_next;
      load_second_q <= load_second_next;
    end
  end

  assign in_ready = ready_q;
  assign out_valid = valid_q;
  assign out_data = selected;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
