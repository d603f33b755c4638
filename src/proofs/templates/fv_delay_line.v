// Proof harness: {{ claim }}.
//
// Reference: a shift register beside each line. The newest word is the one before the next index.
`default_nettype none
module {{ prefix }}fv_delay_line (input wire clk);
  (* anyseq *) wire ce;
  (* anyseq *) wire word;
{%- for n in lengths %}

  wire out_{{ n }};
  reg [{{ n - 1 }}:0] registers_{{ n }};
  reg [4:0] filled_{{ n }};
  initial filled_{{ n }} = 0;
  {{ prefix }}delay_line #(.W(1), .CLOCKS({{ n }})) dut_{{ n }} (.clk(clk), .ce(ce), .in_data(word), .out_data(out_{{ n }}));
  // The script connects these to the ring.
{%- for k in range(n - 1) %}
  (* keep *) wire ring_{{ n }}_{{ k }};
{%- endfor %}
  (* keep *) wire [{{ 3 if n > 9 else 2 if n > 5 else 1 if n > 3 else 0 }}:0] index_{{ n }};
  always @(posedge clk) begin
    if (ce) begin
      registers_{{ n }} <= {registers_{{ n }}, word};
      if (filled_{{ n }} != {{ n }}) filled_{{ n }} <= filled_{{ n }} + 1;
    end
  end
  always @* begin
    assert (index_{{ n }} <= {{ n - 2 }});
    assert (filled_{{ n }} <= {{ n }});
{%- for p in range(n - 1) %}
    if (index_{{ n }} == {{ p }}) begin
{%- for k in range(n - 1) %}
      if (filled_{{ n }} > {{ k }}) assert (ring_{{ n }}_{{ (p + n - 2 - k) % (n - 1) }} == registers_{{ n }}[{{ k }}]);
{%- endfor %}
    end
{%- endfor %}
    if (filled_{{ n }} == {{ n }}) assert (out_{{ n }} == registers_{{ n }}[{{ n - 1 }}]);
  end
{%- endfor %}
endmodule
`default_nettype wire
