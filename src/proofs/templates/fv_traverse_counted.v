// Proof harness: {{ claim }}.
//
// Rays are counted at input, output and inside. That each keeps its words is the claim of the elastic boundaries' own proofs, together with
// data and valid bits having the same delay. Which iteration finishes a ray is left open.
`default_nettype none
module {{ prefix }}fv_traverse (input wire clk);
  (* anyseq *) wire rst;
  (* anyseq *) wire in_valid;
  (* anyseq *) wire out_ready;
  wire in_ready, out_valid;
  {{ prefix }}traverse{{ terms("traverse", "") }} dut (
    .clk(clk), .rst(rst), .in_valid(in_valid), .in_ready(in_ready), .out_valid(out_valid), .out_ready(out_ready)
  );

  // The script connects these to valid bits and registers inside.
{%- for name, n in flights.parts %}
{%- for k in range(n) %}
  (* keep *) wire {{ name }}_{{ k }};
{%- endfor %}
{%- endfor %}
  (* keep *) wire retire;
{%- for at in ["setup", "hit"] %}
{%- if flights.credits %}
  (* keep *) wire [4:0] {{ at }}_reserved, {{ at }}_occupancy;
  (* keep *) wire {{ at }}_credit_q, {{ at }}_issued, {{ at }}_popped, {{ at }}_valid_q;
  wire [7:0] {{ at }}_waiting = {3'd0, {{ at }}_occupancy} - {7'd0, {{ at }}_popped};
{%- else %}
  (* keep *) wire {{ at }}_ready_q, {{ at }}_valid_q, {{ at }}_out_of_reset, {{ at }}_wr_sel_q, {{ at }}_rd_sel_q;
{%- endif %}
{%- endfor %}

  // The slot in stage 0 holds a ray: the one that recirculates, or a new one.
  wire slot_busy = (loop_0 && !retire) || setup_valid_q;
  reg started, was_stalled;
  initial {started, was_stalled} = 0;

  // Rays in a row of valid bits from stage k to its end: one two-operand sum for each k, so that no solver has to add a whole row.
{%- macro row(name, places, enters, moves) %}
{%- for k in places %}
  reg [7:0] from_{{ name }}_{{ k }};
  always @(posedge clk) from_{{ name }}_{{ k }} <= rst ? 8'd0 : !({{ moves }}) ? from_{{ name }}_{{ k }} :
    from_{{ name }}_{{ k }} + {7'd0, {{ enters if loop.first else name ~ "_" ~ places[loop.index0 - 1] }}} - {7'd0, {{ name }}_{{ places | last }}};
  always @* if (started) assert (from_{{ name }}_{{ k }} == {7'd0, {{ name }}_{{ k }}}{% if not loop.last %} + from_{{ name }}_{{ places[loop.index0 + 1] }}{% endif %});
{%- endfor %}
  wire [7:0] in_{{ name }} = from_{{ name }}_{{ places | first }};
{%- endmacro %}
{{- row("setup", flights.rows[0], "(in_valid && in_ready)", "1'b1" if flights.credits else "setup_ready_q") }}
{{- row("loop", flights.rows[1], "slot_busy", "1'b1") }}
{{- row("hit", flights.rows[2], "retire", "1'b1" if flights.credits else "hit_ready_q") }}
{%- for at, n in flights.parts if at != "loop" and not flights.credits %}
  wire [7:0] {{ at }}_waiting = {7'd0, {{ at }}_{{ n - 2 }}} + {7'd0, {{ at }}_{{ n - 1 }}};
{%- endfor %}
  wire [7:0] inside = in_setup + in_loop + in_hit + setup_waiting + hit_waiting;
  reg [7:0] held;
  always @(posedge clk) begin
    started <= 1;
    was_stalled <= out_valid && !out_ready && !rst;
    if (rst) held <= 0;
    else held <= held + {7'd0, in_valid && in_ready} - {7'd0, out_valid && out_ready};
  end
  always @* begin
    if (!started) assume (rst);
    if (started) begin
      // The claim.
      assert (held == inside);
      if (was_stalled) assert (out_valid);
      // Invariants that make the induction hold.
      if (retire) assert (loop_0);
{%- for at, n in flights.parts if at != "loop" %}
{%- if flights.credits %}
      assert ({3'd0, {{ at }}_reserved} + {7'd0, {{ at }}_issued} == in_{{ at }} + {3'd0, {{ at }}_occupancy});
      assert ({3'd0, {{ at }}_reserved} + {7'd0, {{ at }}_issued} + {7'd0, {{ at }}_credit_q} <= 16);
      assert ({{ at }}_occupancy >= {4'd0, {{ at }}_popped} + {4'd0, {{ at }}_valid_q});
      assert (!{{ at }}_popped || !{{ at }}_valid_q);
{%- else %}
      // The slots of the spill register are the last two.
      assert ({{ at }}_valid_q == ({{ at }}_{{ n - 2 }} || {{ at }}_{{ n - 1 }}));
      assert ({{ at }}_ready_q == ({{ at }}_out_of_reset && !({{ at }}_{{ n - 2 }} && {{ at }}_{{ n - 1 }})));
      assert ({{ at }}_out_of_reset || !({{ at }}_{{ n - 2 }} || {{ at }}_{{ n - 1 }} || {{ at }}_wr_sel_q));
      assert (({{ at }}_wr_sel_q ^ {{ at }}_rd_sel_q) == ({{ at }}_{{ n - 2 }} ^ {{ at }}_{{ n - 1 }}));
      assert (!({{ at }}_{{ n - 2 }} ^ {{ at }}_{{ n - 1 }}) || ({{ at }}_rd_sel_q ? {{ at }}_{{ n - 1 }} : {{ at }}_{{ n - 2 }}));
{%- endif %}
{%- endfor %}
{%- if flights.credits %}
      // A ray that retires finds a free slot: the FIFO has reserved one for all others.
      if (retire) assert (hit_reserved + hit_issued <= 15);
{%- elif flights.registered %}
      if (retire) assert (hit_ready_q);
{%- endif %}
    end
  end
endmodule
`default_nettype wire
