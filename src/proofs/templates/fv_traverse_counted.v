// Proof harness: {{ claim }}.
//
// Rays are counted at both doors and inside. That each keeps its words is what the proofs of what stands between the pipelines say, and that
// words are delayed as their valid bits are. When a ray is done is left open.
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
  (* keep *) wire leaves;
{%- for door in ["setup", "hit"] %}
{%- if flights.queues %}
  (* keep *) wire [4:0] {{ door }}_taken, {{ door }}_held;
  (* keep *) wire {{ door }}_has_room, {{ door }}_has_set_out, {{ door }}_has_gone, {{ door }}_is_offered;
  wire [7:0] {{ door }}_waits = {3'd0, {{ door }}_held} - {7'd0, {{ door }}_has_gone};
{%- else %}
  (* keep *) wire {{ door }}_is_ready, {{ door }}_some_valid, {{ door }}_awake, {{ door }}_writes_second, {{ door }}_reads_second;
{%- endif %}
{%- endfor %}

  // The slot that starts holds a ray: the one that stays, or the one that is offered.
  wire keeps = (loop_0 && !leaves) || {{ "setup_is_offered" if flights.queues else "setup_some_valid" }};
  reg started, was_stalled;
  initial {started, was_stalled} = 0;

  // How many rays are in a row of valid bits from place k to its end: one sum of two for each k, so that no solver has to add a whole row.
{%- macro row(name, places, enters, moves) %}
{%- for k in places %}
  reg [7:0] from_{{ name }}_{{ k }};
  always @(posedge clk) from_{{ name }}_{{ k }} <= rst ? 8'd0 : !({{ moves }}) ? from_{{ name }}_{{ k }} :
    from_{{ name }}_{{ k }} + {7'd0, {{ enters if loop.first else name ~ "_" ~ places[loop.index0 - 1] }}} - {7'd0, {{ name }}_{{ places | last }}};
  always @* if (started) assert (from_{{ name }}_{{ k }} == {7'd0, {{ name }}_{{ k }}}{% if not loop.last %} + from_{{ name }}_{{ places[loop.index0 + 1] }}{% endif %});
{%- endfor %}
  wire [7:0] in_{{ name }} = from_{{ name }}_{{ places | first }};
{%- endmacro %}
{{- row("setup", flights.rows[0], "(in_valid && in_ready)", "1'b1" if flights.queues else "setup_is_ready") }}
{{- row("loop", flights.rows[1], "keeps", "1'b1") }}
{{- row("hit", flights.rows[2], "leaves", "1'b1" if flights.queues else "hit_is_ready") }}
{%- for door, n in flights.parts if door != "loop" and not flights.queues %}
  wire [7:0] {{ door }}_waits = {7'd0, {{ door }}_{{ n - 2 }}} + {7'd0, {{ door }}_{{ n - 1 }}};
{%- endfor %}
  wire [7:0] inside = in_setup + in_loop + in_hit + setup_waits + hit_waits;
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
      // What makes it hold in every next clock.
      if (leaves) assert (loop_0);
{%- for door, n in flights.parts if door != "loop" %}
{%- if flights.queues %}
      assert ({3'd0, {{ door }}_taken} + {7'd0, {{ door }}_has_set_out} == in_{{ door }} + {3'd0, {{ door }}_held});
      assert ({3'd0, {{ door }}_taken} + {7'd0, {{ door }}_has_set_out} + {7'd0, {{ door }}_has_room} <= 16);
      assert ({{ door }}_held >= {4'd0, {{ door }}_has_gone} + {4'd0, {{ door }}_is_offered});
      assert (!{{ door }}_has_gone || !{{ door }}_is_offered);
{%- else %}
      // The places of the skid are the last two.
      assert ({{ door }}_some_valid == ({{ door }}_{{ n - 2 }} || {{ door }}_{{ n - 1 }}));
      assert ({{ door }}_is_ready == ({{ door }}_awake && !({{ door }}_{{ n - 2 }} && {{ door }}_{{ n - 1 }})));
      assert ({{ door }}_awake || !({{ door }}_{{ n - 2 }} || {{ door }}_{{ n - 1 }} || {{ door }}_writes_second));
      assert (({{ door }}_writes_second ^ {{ door }}_reads_second) == ({{ door }}_{{ n - 2 }} ^ {{ door }}_{{ n - 1 }}));
      assert (!({{ door }}_{{ n - 2 }} ^ {{ door }}_{{ n - 1 }}) || ({{ door }}_reads_second ? {{ door }}_{{ n - 1 }} : {{ door }}_{{ n - 2 }}));
{%- endif %}
{%- endfor %}
{%- if flights.queues %}
      // A ray that leaves finds a place: the queue has heard of all but it.
      if (leaves) assert (hit_taken + hit_has_set_out <= 15);
{%- elif flights.decided %}
      if (leaves) assert (hit_is_ready);
{%- endif %}
    end
  end
endmodule
`default_nettype wire
