// Proof harness: {{ claim }}.
`default_nettype none
module {{ prefix }}fv_level_decision;
{{ instance("level_decision", "") }}
  always @* begin
    assert (hit == (is_inside && level == {% if lod %}lod{% else %}0{% endif %}));
    assert (crosses == !is_inside);
    if (hit) assert (level_next == level && x_next == x_at && y_next == y_at && t_out == m);
    if (is_inside && !hit) assert (level_next == level_down && x_next == x_down && y_next == y_down && t_out == m);
    if (crosses) begin
      assert (t_out == t_next);
      assert (x_next == (x_first ? x_beyond : x_at));
      assert (y_next == (x_first ? y_at : y_beyond));
{%- if trims %}
      assert (level_next == level_across);
{%- else %}
      if (level != {{ value("level_decision", "LEVELS") }}) assert (level_next == level + up);
{%- endif %}
    end
  end
endmodule
`default_nettype wire
