// Proof harness: {{ claim }}.
//
// The rays inside that carry one tag, any tag, are counted at input and output and in the pipeline itself. Which iteration finishes a ray is left open.
`default_nettype none
module {{ prefix }}fv_traverse (input wire clk);
  localparam integer N = {{ slots }};
  localparam integer TAG_W = {{ tag_w }};
  (* anyseq *) wire rst;
  (* anyseq *) wire in_valid;
  (* anyseq *) wire out_ready;
  (* anyseq *) wire [TAG_W-1:0] in_tag;
  wire in_ready, out_valid;
  wire [TAG_W-1:0] out_tag;
  {{ prefix }}traverse{{ terms("traverse", "") }} dut (
    .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready), .in_tag(in_tag),
    .out_valid(out_valid), .out_ready(out_ready), .out_tag(out_tag)
  );

  // The script connects these to the registers that hold a ray.
{%- for k in range(slots) %}
  (* keep *) wire holds_{{ k }};
  (* keep *) wire [TAG_W-1:0] tag_{{ k }};
{%- endfor %}
  wire [N-1:0] holds = { {%- for k in range(slots) %}{{ "" if loop.first else ", " }}holds_{{ k }}{% endfor -%} };
  wire [N*TAG_W-1:0] tags = { {%- for k in range(slots) %}{{ "" if loop.first else ", " }}tag_{{ k }}{% endfor -%} };
  (* anyconst *) wire [TAG_W-1:0] tag;
  reg [7:0] held, found;
  integer k;
  always @* begin
    found = 0;
    for (k = 0; k < N; k = k + 1) found = found + (holds[k] && tags[k*TAG_W +: TAG_W] == tag);
  end
  reg started, was_stalled;
  reg [TAG_W-1:0] was_tag;
  initial {started, was_stalled} = 0;
  always @(posedge clk) begin
    started <= 1;
    was_stalled <= out_valid && !out_ready && !rst;
    was_tag <= out_tag;
    if (rst) held <= 0;
    else held <= held + (in_valid && in_ready && in_tag == tag) - (out_valid && out_ready && out_tag == tag);
  end
  always @* begin
    if (!started) assume (rst);
    if (started) assert (held == found);
    if (started && out_valid && out_tag == tag) assert (held != 0);
    if (was_stalled) assert (out_valid && out_tag == was_tag);
  end
endmodule
`default_nettype wire
