// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_axis_scale: a ray along one axis, from tiles to texels: times 2^LEVELS
// Emitted    by reliefrtl as its unit axis_scale; do not edit
// Chosen     rounding nearest-even, subnormals flush, specials ieee
// Latency    none, combinational
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (every NaN
//            result has the same bits); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_axis_scale #(
  parameter integer EXP_W   = 7,   // exponent bits
  parameter integer MAN_W   = 16,  // fraction bits, the hidden one not counted
  parameter integer LEVELS  = 8,   // the map has 2^LEVELS x 2^LEVELS texels
  parameter integer TILE_W  = 4,   // a ray travels less than 2^TILE_W tiles along each axis
  parameter integer LATENCY = 0,   // clocks it was generated for; checked
  parameter integer VARIANT = 32'h23f2236f  // digest of what it was generated for; checked
) (
  input  wire [EXP_W+MAN_W:0] p,         // entry point at the top plane [float, tiles]
  input  wire [EXP_W+MAN_W:0] d,         // travel while the height falls from 1 to 0 [float, tiles]
  output wire                 ok,        // can be traced: 0 <= p < 1 and |d| < 2^TILE_W
  output wire [EXP_W+MAN_W:0] p_texels,  // entry point, without its sign [float, texels]
  output wire [EXP_W+MAN_W:0] d_texels   // travel [float, texels]
);
  localparam integer FloatW = EXP_W + MAN_W + 1;  // bits of a float: sign, exponent, fraction
  localparam integer OneExp = (1 << (EXP_W - 1)) - 1;           // biased exponent of 1
  localparam integer FarExp = TILE_W + (1 << (EXP_W - 1)) - 1;  // biased exponent of 2^TILE_W
  localparam integer Grow = LEVELS;  // added to an exponent: times 2^LEVELS

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (EXP_W < 2) begin : gen_illegal_0 EXP_W_must_be_at_least_2 u_illegal (); end
    if (EXP_W > 11) begin : gen_illegal_1 EXP_W_must_be_at_most_11 u_illegal (); end
    if (MAN_W < 2) begin : gen_illegal_2 MAN_W_must_be_at_least_2 u_illegal (); end
    if (MAN_W > 28) begin : gen_illegal_3 MAN_W_must_be_at_most_28 u_illegal (); end
    if (LEVELS < 2) begin : gen_illegal_4 LEVELS_must_be_at_least_2 u_illegal (); end
    if (LEVELS > 12) begin : gen_illegal_5 LEVELS_must_be_at_most_12 u_illegal (); end
    if (TILE_W < 1) begin : gen_illegal_6 TILE_W_must_be_at_least_1 u_illegal (); end
    if (TILE_W > 8) begin : gen_illegal_7 TILE_W_must_be_at_most_8 u_illegal (); end
    if (LEVELS + TILE_W + 1 > (1 << (EXP_W - 1)) - 1) begin : gen_illegal_8
      LEVELS_plus_TILE_W_plus_1_must_be_at_most_the_exponent_bias u_illegal ();
    end
    if (LATENCY != 0) begin : gen_other_latency
      relief_axis_scale_has_LATENCY_0_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h23f2236f) begin : gen_other_variant
      relief_axis_scale_has_VARIANT_23f2236f_nearest_even_flush_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- range --------------------------------------------------------------------------
  // Compares exponents alone: those of 1 and of 2^TILE_W are the least that are too large.
  wire             p_sign = p[FloatW-1];
  wire [EXP_W-1:0] p_exp = p[EXP_W+MAN_W-1:MAN_W];
  wire [MAN_W-1:0] p_frac = p[MAN_W-1:0];
  wire             p_is_zero = ~(|p_exp);
  wire             p_exp_ones = &p_exp;
  wire             p_frac_some = |p_frac;
  wire             p_is_inf = p_exp_ones & ~p_frac_some;
  wire             p_is_nan = p_exp_ones & p_frac_some;
  wire             d_sign = d[FloatW-1];
  wire [EXP_W-1:0] d_exp = d[EXP_W+MAN_W-1:MAN_W];
  wire [MAN_W-1:0] d_frac = d[MAN_W-1:0];
  wire             d_is_zero = ~(|d_exp);
  wire             d_exp_ones = &d_exp;
  wire             d_frac_some = |d_frac;
  wire             d_is_inf = d_exp_ones & ~d_frac_some;
  wire             d_is_nan = d_exp_ones & d_frac_some;
  wire             in_range = (p_is_zero | (~p_sign & (p_exp < OneExp[EXP_W-1:0]))) &
      (d_exp < FarExp[EXP_W-1:0]);

  // ---- scale --------------------------------------------------------------------------
  // LEVELS is added to the exponent; zeros stay zeros. Of a refused ray (ok = 0) the sum may wrap.
  wire [FloatW-1:0] p_scaled =
      {1'b0, {p_exp + Grow[EXP_W-1:0], p_frac} & {(EXP_W + MAN_W){~p_is_zero}}};
  wire [FloatW-1:0] d_scaled =
      {d_sign, {d_exp + Grow[EXP_W-1:0], d_frac} & {(EXP_W + MAN_W){~d_is_zero}}};

  // Nets and bits that nothing reads, at some parameter values or at all, gathered so that the
  // lint for unused bits stays on for all others.
  // verilator lint_off UNUSED
  wire unused_0 = &{1'b0, p_is_inf, p_is_nan, d_is_inf, d_is_nan};
  // verilator lint_on UNUSED

  assign ok = in_range;
  assign p_texels = p_scaled;
  assign d_texels = d_scaled;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
