// Proof harness: {{ claim }}.
//
// Any one input is followed: how many words of others transfer while it waits, in all and of any one other. Requests are kept until they
// transfer, as the protocol asks.
{%- set n = width("arbiter", "in_valid") %}
`default_nettype none
module {{ prefix }}fv_arbiter (input wire clk);
  (* anyseq *) wire rst;
  (* anyseq *) wire [{{ n - 1 }}:0] in_valid;
  (* anyseq *) wire [{{ 3 * n - 1 }}:0] in_data;
  (* anyseq *) wire out_ready;
  wire [{{ n - 1 }}:0] in_ready, out_grant;
  wire out_valid;
  wire [2:0] out_data;
  {{ prefix }}arbiter{{ terms("arbiter", ".W(3)") }} dut (
    .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready), .in_data(in_data), .out_valid(out_valid),
    .out_ready(out_ready), .out_data(out_data), .out_grant(out_grant)
  );

  // The script connects these to registers inside.
  (* keep *) wire [{{ n - 1 }}:0] first, kept;
  // One-hot: the input that is followed, and another one.
  (* anyconst *) wire [{{ n - 1 }}:0] mine, other;
  wire waits = (in_valid & ~in_ready & mine) != 0;
  wire transfer = out_valid && out_ready;
  reg [3:0] passed;
  reg passed_other;
  reg [{{ n - 1 }}:0] was_valid, was_ready, was_grant;
  reg [{{ 3 * n - 1 }}:0] was_words;
  reg [2:0] was_data;
  reg started, was_stalled, was_reset;
  initial {started, was_stalled} = 0;
  always @(posedge clk) begin
    started <= 1;
    was_reset <= rst;
    was_stalled <= out_valid && !out_ready && !rst;
    {was_grant, was_data} <= {out_grant, out_data};
    {was_valid, was_ready, was_words} <= {in_valid, in_ready, in_data};
    if (rst || !waits) {passed, passed_other} <= 5'd0;
    else if (transfer) begin
      passed <= passed + 4'd1;
      // A second time would be one too many.
      if ((out_grant & other) != 0) passed_other <= 1'b1;
    end
  end

  // The turn: the inputs from the lowest bit of first up, then those below it; those that come before mine, and before the kept one.
  wire [{{ n - 1 }}:0] second = ~first;
  wire [{{ n - 1 }}:0] below_mine = mine - 1'b1;
  wire [{{ n - 1 }}:0] before_mine = (first & mine) != 0 ? first & below_mine : first | (second & below_mine);
  wire [3:0] many_before = {{ "" }}{% for k in range(n) %}{{ "" if loop.first else " + " }}{3'd0, before_mine[{{ k }}]}{% endfor %};
  always @* begin
    assume (mine != 0 && (mine & (mine - 1'b1)) == 0);
    assume (other != 0 && (other & (other - 1'b1)) == 0 && other != mine);
    if (!started) assume (rst);
{%- for k in range(n) %}
    if (started && !was_reset && was_valid[{{ k }}] && !was_ready[{{ k }}])
      assume (in_valid[{{ k }}] && in_data[{{ 3 * k + 2 }}:{{ 3 * k }}] == was_words[{{ 3 * k + 2 }}:{{ 3 * k }}]);
{%- endfor %}
    if (started) begin
      // The claim: one grant, to a valid input, whenever there is one; only the granted input transfers, with its word;
      assert ((out_grant & (out_grant - 1'b1)) == 0 && (out_grant & ~in_valid) == 0);
      assert (out_valid == (in_valid != 0) && out_valid == (out_grant != 0));
      assert (in_ready == (out_ready ? out_grant : {{ n }}'d0));
{%- for k in range(n) %}
      if (out_grant[{{ k }}]) assert (out_data == in_data[{{ 3 * k + 2 }}:{{ 3 * k }}]);
{%- endfor %}
      // stable until the transfer;
      if (was_stalled) assert (out_valid && out_grant == was_grant && out_data == was_data);
      // and an input that waits sees each other one once at most.
      assert (passed <= {{ n - 1 }});
      if (waits && transfer && (out_grant & other) != 0) assert (!passed_other);
      // Invariants that make the induction hold: first is the inputs from some one up; a kept grant is that of the clock before.
      assert ((first | (first - 1'b1)) == {{ "{" }}{{ n }}{1'b1}} || first == 0);
      assert (kept == (was_stalled ? was_grant : {{ n }}'d0));
      assert ((was_grant & ~was_valid) == 0);
      if (was_stalled) assert ((was_grant & was_ready) == 0 && (was_grant & (was_grant - 1'b1)) == 0 && !was_reset);
      if (passed != 0) assert (!was_reset && (was_valid & ~was_ready & mine) != 0);
      if (passed != 0) assert (passed + many_before <= {{ n - 1 }});
      if (passed_other) assert (passed != 0 && (before_mine & other) == 0);
      if (passed != 0 && kept != 0) assert ((kept & before_mine) != 0 || kept == mine);
    end
  end
endmodule
`default_nettype wire
