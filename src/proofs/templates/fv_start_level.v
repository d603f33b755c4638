// Proof harness: {{ claim }}.
`default_nettype none
module {{ prefix }}fv_start_level;
  localparam integer LEVELS = {{ value("start_level", "LEVELS") }};
{{ instance("start_level", "") }}
  // At level n both ends lie in one node.
  wire [LEVELS:0] together;
  genvar n;
  generate
    for (n = 0; n <= LEVELS; n = n + 1) begin : gen_level
      assign together[n] = ($signed(x) >>> n) == ($signed(x_end) >>> n) && ($signed(y) >>> n) == ($signed(y_end) >>> n);
    end
  endgenerate
  always @* begin
    assert (level <= LEVELS);
    assert (level == LEVELS || together[level]);
    if (level != 0) assert (!together[level-1]);
  end
endmodule
`default_nettype wire
