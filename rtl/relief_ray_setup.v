// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_ray_setup: a ray's constants, from texture coordinates to texels and height codes
// Emitted    by reliefrtl as its unit ray_setup; do not edit
// Chosen     rounding nearest-even, subnormals flush, specials ieee
// Latency    21 clocks
// Throughput one result per clock
// Note       A ray that can't be traced (see ok) has all other outputs 0.
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (every NaN
//            result has the same bits); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_ray_setup #(
  parameter integer EXP_W    = 7,   // exponent bits
  parameter integer MAN_W    = 16,  // fraction bits, the hidden one not counted
  parameter integer LEVELS   = 8,   // the map has 2^LEVELS x 2^LEVELS texels
  parameter integer HEIGHT_W = 8,   // bits of a height code
  parameter integer TILE_W   = 4,   // a ray travels less than 2^TILE_W tiles along each axis
  parameter integer LATENCY  = 21,  // clocks it was generated for; checked
  parameter integer VARIANT  = 32'h39c47949  // digest of what it was generated for; checked
) (
  input  wire                        clk,      // rising edge
  input  wire                        ce,       // clock enable: registers hold while 0
  // entry point at the top plane, 0 <= u < 1 [float, tiles]
  input  wire [EXP_W+MAN_W:0]        u,
  // entry point at the top plane, 0 <= v < 1 [float, tiles]
  input  wire [EXP_W+MAN_W:0]        v,
  // u travelled while the height falls from 1 to 0 [float, tiles]
  input  wire [EXP_W+MAN_W:0]        du,
  // v travelled while the height falls from 1 to 0 [float, tiles]
  input  wire [EXP_W+MAN_W:0]        dv,
  // the ray can be traced: finite, entry in the tile, direction below 2^TILE_W
  output wire                        ok,
  output wire [$clog2(LEVELS+1)-1:0] level,    // level of the first iteration [levels]
  output wire [EXP_W+MAN_W:0]        p_x,      // entry point along x [float, texels]
  // entry point along x, biased against the direction [float, texels]
  output wire [EXP_W+MAN_W:0]        pb_x,
  output wire [EXP_W+MAN_W:0]        d_x,      // direction along x [float, texels per height code]
  // reciprocal of the direction along x [float, height codes per texel]
  output wire [EXP_W+MAN_W:0]        r_x,
  output wire                        never_x,  // the ray does not move along x
  output wire                        neg_x,    // the ray runs toward smaller x coordinates
  // x coordinate of the texel of the entry point [texels]
  output wire [LEVELS+TILE_W+1:0]    first_x,
  output wire [EXP_W+MAN_W:0]        p_y,      // entry point along y [float, texels]
  // entry point along y, biased against the direction [float, texels]
  output wire [EXP_W+MAN_W:0]        pb_y,
  output wire [EXP_W+MAN_W:0]        d_y,      // direction along y [float, texels per height code]
  // reciprocal of the direction along y [float, height codes per texel]
  output wire [EXP_W+MAN_W:0]        r_y,
  output wire                        never_y,  // the ray does not move along y
  output wire                        neg_y,    // the ray runs toward smaller y coordinates
  // y coordinate of the texel of the entry point [texels]
  output wire [LEVELS+TILE_W+1:0]    first_y
);
  localparam integer FloatW = EXP_W + MAN_W + 1;   // bits of a float: sign, exponent, fraction
  localparam integer LevelW = $clog2(LEVELS + 1);  // bits of a level
  localparam integer IdxW = LEVELS + TILE_W + 2;   // bits of a signed, unwrapped texel coordinate

  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.
  generate
    if (EXP_W < 2) begin : gen_illegal_0 EXP_W_must_be_at_least_2 u_illegal (); end
    if (EXP_W > 11) begin : gen_illegal_1 EXP_W_must_be_at_most_11 u_illegal (); end
    if (MAN_W < 16) begin : gen_illegal_2 MAN_W_must_be_at_least_16 u_illegal (); end
    if (MAN_W > 28) begin : gen_illegal_3 MAN_W_must_be_at_most_28 u_illegal (); end
    if (LEVELS < 2) begin : gen_illegal_4 LEVELS_must_be_at_least_2 u_illegal (); end
    if (LEVELS > 12) begin : gen_illegal_5 LEVELS_must_be_at_most_12 u_illegal (); end
    if (HEIGHT_W < 2) begin : gen_illegal_6 HEIGHT_W_must_be_at_least_2 u_illegal (); end
    if (HEIGHT_W > 16) begin : gen_illegal_7 HEIGHT_W_must_be_at_most_16 u_illegal (); end
    if (TILE_W < 1) begin : gen_illegal_8 TILE_W_must_be_at_least_1 u_illegal (); end
    if (TILE_W > 8) begin : gen_illegal_9 TILE_W_must_be_at_most_8 u_illegal (); end
    if (LEVELS + TILE_W + 1 > (1 << (EXP_W - 1)) - 1) begin : gen_illegal_10
      LEVELS_plus_TILE_W_plus_1_must_be_at_most_the_exponent_bias u_illegal ();
    end
    if (HEIGHT_W + 2 > (1 << (EXP_W - 1)) - 1) begin : gen_illegal_11
      HEIGHT_W_plus_2_must_be_at_most_the_exponent_bias u_illegal ();
    end
    if (MAN_W > LEVELS + (1 << (EXP_W - 1)) - 1) begin : gen_illegal_12
      MAN_W_must_be_at_most_LEVELS_plus_the_exponent_bias u_illegal ();
    end
    if (LATENCY != 21) begin : gen_other_latency
      relief_ray_setup_has_LATENCY_21_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h39c47949) begin : gen_other_variant
      relief_ray_setup_has_VARIANT_39c47949_nearest_even_flush_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 0: axis x ----------------------------------------------------------------
  wire              s0_x_ok;  // can be traced: 0 <= p < 1 and |d| < 2^TILE_W
  wire [FloatW-1:0] s0_x_p;   // entry point, without its sign [float, texels]
  wire [FloatW-1:0] s0_x_dn;  // travel [float, texels]
  relief_axis_scale #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .LEVELS(LEVELS), .TILE_W(TILE_W), .LATENCY(0),
    .VARIANT(32'h23f2236f)
  ) u_scale_x (
    .p(u), .d(du),
    .ok(s0_x_ok), .p_texels(s0_x_p), .d_texels(s0_x_dn)
  );

  // ---- stage 0: axis y ----------------------------------------------------------------
  wire              s0_y_ok;  // can be traced: 0 <= p < 1 and |d| < 2^TILE_W
  wire [FloatW-1:0] s0_y_p;   // entry point, without its sign [float, texels]
  wire [FloatW-1:0] s0_y_dn;  // travel [float, texels]
  relief_axis_scale #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .LEVELS(LEVELS), .TILE_W(TILE_W), .LATENCY(0),
    .VARIANT(32'h23f2236f)
  ) u_scale_y (
    .p(v), .d(dv),
    .ok(s0_y_ok), .p_texels(s0_y_p), .d_texels(s0_y_dn)
  );

  // ---- stage 0: acceptance and level --------------------------------------------------
  wire s0_is_ok = s0_x_ok & s0_y_ok;

  // ---- stage 1: registers -------------------------------------------------------------
  reg [FloatW-1:0] s1_x_p;
  reg [FloatW-1:0] s1_x_dn;
  reg [FloatW-1:0] s1_y_p;
  reg [FloatW-1:0] s1_y_dn;
  reg              s1_is_ok;
  always @(posedge clk) begin
    if (ce) begin
      s1_x_p  <= s0_x_p;
      s1_x_dn <= s0_x_dn;
      s1_y_p  <= s0_y_p;
      s1_y_dn <= s0_y_dn;
    end
  end
  // In simulation an unknown bit (x) counts as 0, so that no x reaches a handshake.
  always @(posedge clk) begin
    if (ce) begin
      if (s0_is_ok) begin
        s1_is_ok <= 1'b1;
      end else begin
        s1_is_ok <= 1'b0;
      end
    end
  end

  // ---- stage 1: axis x ----------------------------------------------------------------
  wire [FloatW-1:0] s21_x_pb;  // entry point, biased against the direction [float, texels]
  wire [FloatW-1:0] s21_x_d;   // direction [float, texels per height code]
  wire [FloatW-1:0] s21_x_r;   // reciprocal direction [float, height codes per texel]
  // the ray does not move along this axis: dn is zero, or M / dn overflows
  wire              s21_x_never;
  relief_axis_slope #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .LEVELS(LEVELS), .HEIGHT_W(HEIGHT_W), .LATENCY(20),
    .VARIANT(32'h054b90fe)
  ) u_slope_x (
    .clk(clk), .ce(ce), .p(s1_x_p), .dn(s1_x_dn),
    .p_back(s21_x_pb), .d(s21_x_d), .r(s21_x_r), .never(s21_x_never)
  );
  wire [IdxW-1:0] s6_x_first;  // texel of the entry point [texels]
  wire [IdxW-1:0] s6_x_last;   // texel of the rounded end point p + dn [texels]
  relief_axis_ends #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .IDX_W(IdxW), .LATENCY(5), .VARIANT(32'h4fde34f4)
  ) u_ends_x (
    .clk(clk), .ce(ce), .p(s1_x_p), .dn(s1_x_dn),
    .first(s6_x_first), .last(s6_x_last)
  );
  wire s1_x_neg = s1_x_dn[FloatW-1];

  // ---- stage 1: axis y ----------------------------------------------------------------
  wire [FloatW-1:0] s21_y_pb;  // entry point, biased against the direction [float, texels]
  wire [FloatW-1:0] s21_y_d;   // direction [float, texels per height code]
  wire [FloatW-1:0] s21_y_r;   // reciprocal direction [float, height codes per texel]
  // the ray does not move along this axis: dn is zero, or M / dn overflows
  wire              s21_y_never;
  relief_axis_slope #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .LEVELS(LEVELS), .HEIGHT_W(HEIGHT_W), .LATENCY(20),
    .VARIANT(32'h054b90fe)
  ) u_slope_y (
    .clk(clk), .ce(ce), .p(s1_y_p), .dn(s1_y_dn),
    .p_back(s21_y_pb), .d(s21_y_d), .r(s21_y_r), .never(s21_y_never)
  );
  wire [IdxW-1:0] s6_y_first;  // texel of the entry point [texels]
  wire [IdxW-1:0] s6_y_last;   // texel of the rounded end point p + dn [texels]
  relief_axis_ends #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .IDX_W(IdxW), .LATENCY(5), .VARIANT(32'h4fde34f4)
  ) u_ends_y (
    .clk(clk), .ce(ce), .p(s1_y_p), .dn(s1_y_dn),
    .first(s6_y_first), .last(s6_y_last)
  );
  wire s1_y_neg = s1_y_dn[FloatW-1];

  // ---- stage 6: acceptance and level --------------------------------------------------
  // 0: both in one texel; LEVELS: the root (also across tiles) [levels]
  wire [LevelW-1:0] s6_start;
  relief_start_level #(
    .LEVELS(LEVELS), .IDX_W(IdxW), .LATENCY(0), .VARIANT(32'h4c35fe41)
  ) u_start_level (
    .x(s6_x_first), .y(s6_y_first), .x_end(s6_x_last), .y_end(s6_y_last),
    .level(s6_start)
  );

  // ---- stage 21: registers ------------------------------------------------------------
  // Delay of 20 clocks: stage 1 to 21.
  reg                  s21_is_ok;
  reg [FloatW-1:0]     s21_x_p;
  reg                  s21_x_neg;
  reg [FloatW-1:0]     s21_y_p;
  reg                  s21_y_neg;
  reg [38*FloatW+56:0] s1_to_s21;
  always @(posedge clk) begin
    if (ce) begin
      {s21_is_ok, s21_x_p, s21_x_neg, s21_y_p, s21_y_neg, s1_to_s21} <=
          {s1_to_s21, s1_is_ok, s1_x_p, s1_x_neg, s1_y_p, s1_y_neg};
    end
  end
  // Delay of 15 clocks: stage 6 to 21.
  reg [LevelW-1:0]            s21_start;
  reg [IdxW-1:0]              s21_x_first;
  reg [IdxW-1:0]              s21_y_first;
  reg [28*IdxW+14*LevelW-1:0] s6_to_s21;
  always @(posedge clk) begin
    if (ce) begin
      {s21_start, s21_x_first, s21_y_first, s6_to_s21} <=
          {s6_to_s21, s6_start, s6_x_first, s6_y_first};
    end
  end

  assign ok = s21_is_ok;
  assign level = s21_start & {LevelW{s21_is_ok}};
  assign p_x = s21_x_p & {FloatW{s21_is_ok}};
  assign pb_x = s21_x_pb & {FloatW{s21_is_ok}};
  assign d_x = s21_x_d & {FloatW{s21_is_ok}};
  assign r_x = s21_x_r & {FloatW{s21_is_ok}};
  assign never_x = s21_x_never & s21_is_ok;
  assign neg_x = s21_x_neg & s21_is_ok;
  assign first_x = s21_x_first & {IdxW{s21_is_ok}};
  assign p_y = s21_y_p & {FloatW{s21_is_ok}};
  assign pb_y = s21_y_pb & {FloatW{s21_is_ok}};
  assign d_y = s21_y_d & {FloatW{s21_is_ok}};
  assign r_y = s21_y_r & {FloatW{s21_is_ok}};
  assign never_y = s21_y_never & s21_is_ok;
  assign neg_y = s21_y_neg & s21_is_ok;
  assign first_y = s21_y_first & {IdxW{s21_is_ok}};
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
