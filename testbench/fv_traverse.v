// Proof harness: no ray is lost, none comes twice, and an offered result stays, by induction.
//
// The rays inside that carry one tag, any tag, are counted at both doors and in the pipeline itself. When a ray is done is left open.
`default_nettype none
module fv_traverse (input wire clk);
  localparam integer N = 15;
  localparam integer TAG_W = 8;
  (* anyseq *) wire rst;
  (* anyseq *) wire in_valid;
  (* anyseq *) wire out_ready;
  (* anyseq *) wire [TAG_W-1:0] in_tag;
  wire in_ready, out_valid;
  wire [TAG_W-1:0] out_tag;
  traverse dut (
    .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready), .in_tag(in_tag),
    .out_valid(out_valid), .out_ready(out_ready), .out_tag(out_tag)
  );

  // The script connects these to the places that hold a ray.
  (* keep *) wire holds_0;
  (* keep *) wire [TAG_W-1:0] tag_0;
  (* keep *) wire holds_1;
  (* keep *) wire [TAG_W-1:0] tag_1;
  (* keep *) wire holds_2;
  (* keep *) wire [TAG_W-1:0] tag_2;
  (* keep *) wire holds_3;
  (* keep *) wire [TAG_W-1:0] tag_3;
  (* keep *) wire holds_4;
  (* keep *) wire [TAG_W-1:0] tag_4;
  (* keep *) wire holds_5;
  (* keep *) wire [TAG_W-1:0] tag_5;
  (* keep *) wire holds_6;
  (* keep *) wire [TAG_W-1:0] tag_6;
  (* keep *) wire holds_7;
  (* keep *) wire [TAG_W-1:0] tag_7;
  (* keep *) wire holds_8;
  (* keep *) wire [TAG_W-1:0] tag_8;
  (* keep *) wire holds_9;
  (* keep *) wire [TAG_W-1:0] tag_9;
  (* keep *) wire holds_10;
  (* keep *) wire [TAG_W-1:0] tag_10;
  (* keep *) wire holds_11;
  (* keep *) wire [TAG_W-1:0] tag_11;
  (* keep *) wire holds_12;
  (* keep *) wire [TAG_W-1:0] tag_12;
  (* keep *) wire holds_13;
  (* keep *) wire [TAG_W-1:0] tag_13;
  (* keep *) wire holds_14;
  (* keep *) wire [TAG_W-1:0] tag_14;
  wire [N-1:0] holds = {holds_0, holds_1, holds_2, holds_3, holds_4, holds_5, holds_6, holds_7, holds_8, holds_9, holds_10, holds_11, holds_12, holds_13, holds_14};
  wire [N*TAG_W-1:0] tags = {tag_0, tag_1, tag_2, tag_3, tag_4, tag_5, tag_6, tag_7, tag_8, tag_9, tag_10, tag_11, tag_12, tag_13, tag_14};
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
