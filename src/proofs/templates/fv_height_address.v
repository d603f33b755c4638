// Proof harness: {{ claim }}.
`default_nettype none
module {{ prefix }}fv_height_address;
  localparam integer LEVELS = {{ value("height_address", "LEVELS") }};
  localparam [63:0] DEPTH = ((64'd4 << (2 * LEVELS)) - 64'd1) / 64'd3;
{{ instance("height_address", "p_") }}
{{ instance("height_address", "q_") }}
  wire same = p_level == q_level && (p_i >> p_level) == (q_i >> q_level) && (p_j >> p_level) == (q_j >> q_level);
  always @* begin
    assume (p_level <= LEVELS && q_level <= LEVELS);
    assert (p_address < DEPTH);
    assert ((p_address == q_address) == same);
    if (p_level == 0) assert (p_address < (64'd1 << (2 * LEVELS)));
    if (p_level == LEVELS) assert (p_address == DEPTH - 1);
  end
endmodule
`default_nettype wire
