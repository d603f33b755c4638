// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_ray_setup: a ray's constants, from texture coordinates to texels and height codes
// Emitted    by reliefrtl as its unit ray_setup; do not edit
// Chosen     rounding nearest-even, subnormals flush, specials ieee
// Latency    21 clocks
// Throughput one result per clock
// Note       A ray that can't be traced (see ok) has all other outputs 0.
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (one NaN comes
//            out); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_ray_setup #(
  parameter integer EXP_W    = 7,   // exponent bits
  parameter integer MAN_W    = 16,  // fraction bits, the hidden one not counted
  parameter integer LEVELS   = 8,   // the map has 2^LEVELS x 2^LEVELS texels
  parameter integer HEIGHT_W = 8,   // bits of a height code
  parameter integer TILE_W   = 4,   // a ray travels less than 2^TILE_W tiles along each axis
  parameter integer LATENCY  = 21,  // clocks that it was generated for
  parameter integer VARIANT  = 32'h32708489  // digest of what is no parameter
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
  output wire [EXP_W+MAN_W:0]        p_x,      // entry point [float, texels]
  output wire [EXP_W+MAN_W:0]        pb_x,     // entry point, biased backwards [float, texels]
  output wire [EXP_W+MAN_W:0]        d_x,      // direction [float, texels per height code]
  // reciprocal direction [float, height codes per texel]
  output wire [EXP_W+MAN_W:0]        r_x,
  output wire                        never_x,  // the ray does not move along this axis
  output wire                        neg_x,    // it runs toward smaller coordinates
  output wire [LEVELS+TILE_W+1:0]    first_x,  // texel of the entry point [texels]
  output wire [EXP_W+MAN_W:0]        p_y,      // entry point [float, texels]
  output wire [EXP_W+MAN_W:0]        pb_y,     // entry point, biased backwards [float, texels]
  output wire [EXP_W+MAN_W:0]        d_y,      // direction [float, texels per height code]
  // reciprocal direction [float, height codes per texel]
  output wire [EXP_W+MAN_W:0]        r_y,
  output wire                        never_y,  // the ray does not move along this axis
  output wire                        neg_y,    // it runs toward smaller coordinates
  output wire [LEVELS+TILE_W+1:0]    first_y   // texel of the entry point [texels]
);
  localparam integer FloatW = EXP_W + MAN_W + 1;
  localparam integer LevelW = $clog2(LEVELS + 1);
  localparam integer IdxW = LEVELS + TILE_W + 2;
  localparam integer OneExp = (1 << (EXP_W - 1)) - 1;
  localparam integer FarExp = TILE_W + (1 << (EXP_W - 1)) - 1;
  localparam integer Grow = LEVELS;
  localparam integer MExp = HEIGHT_W + (1 << (EXP_W - 1)) - 2;
  localparam integer MFrac = (1 << MAN_W) - (1 << (MAN_W - HEIGHT_W + 1));
  localparam integer RecipExp = (1 << (EXP_W - 1)) - HEIGHT_W - 1;
  localparam [63:0] RecipFrac =
      ((64'd1 << HEIGHT_W) +
      (64'd1 << (HEIGHT_W + MAN_W + 1)) - 64'd1) / (64'd2 * (64'd1 << HEIGHT_W) - 64'd2);
  localparam integer Least = LEVELS + (1 << (EXP_W - 1)) + 1;
  localparam integer Ulps = MAN_W + 1;

  // Parameter checks: an illegal value ends elaboration, the missing module names the rule.
  generate
    if (EXP_W < 2) begin : gen_illegal_0 EXP_W_must_be_at_least_2 u_illegal (); end
    if (EXP_W > 11) begin : gen_illegal_1 EXP_W_must_be_at_most_11 u_illegal (); end
    if (MAN_W < 16) begin : gen_illegal_2 MAN_W_must_be_at_least_16 u_illegal (); end
    if (MAN_W > 28) begin : gen_illegal_3 MAN_W_must_be_at_most_28 u_illegal (); end
    if (LEVELS < 2) begin : gen_illegal_4 LEVELS_must_be_at_least_2 u_illegal (); end
    if (LEVELS > 12) begin : gen_illegal_5 LEVELS_must_be_at_most_12 u_illegal (); end
    if (HEIGHT_W < 2) begin : gen_illegal_6 HEIGHT_W_must_be_at_least_2 u_illegal (); end
    if (HEIGHT_W > 16) begin : gen_illegal_7 HEIGHT_W_must_be_at_most_16 u_illegal (); end
    if (HEIGHT_W > MAN_W + 1) begin : gen_illegal_8
      HEIGHT_W_must_be_at_most_MAN_W_plus_1 u_illegal ();
    end
    if (TILE_W < 1) begin : gen_illegal_9 TILE_W_must_be_at_least_1 u_illegal (); end
    if (TILE_W > 8) begin : gen_illegal_10 TILE_W_must_be_at_most_8 u_illegal (); end
    if (LEVELS + TILE_W + 2 > 24) begin : gen_illegal_11
      LEVELS_plus_TILE_W_plus_2_must_be_at_most_24 u_illegal ();
    end
    if (LEVELS + TILE_W + 1 > (1 << (EXP_W - 1)) - 1) begin : gen_illegal_12
      LEVELS_plus_TILE_W_plus_1_must_be_at_most_2_to_the_EXP_W_minus_1_minus_1 u_illegal ();
    end
    if (HEIGHT_W + 2 > (1 << (EXP_W - 1)) - 1) begin : gen_illegal_13
      HEIGHT_W_plus_2_must_be_at_most_2_to_the_EXP_W_minus_1_minus_1 u_illegal ();
    end
    if (MAN_W > LEVELS + (1 << (EXP_W - 1)) - 1) begin : gen_illegal_14
      MAN_W_must_be_at_most_LEVELS_plus_2_to_the_EXP_W_minus_1_minus_1 u_illegal ();
    end
    if (LATENCY != 21) begin : gen_other_latency
      relief_ray_setup_has_LATENCY_21_not_the_one_asked_for u_illegal ();
    end else if (VARIANT != 32'h32708489) begin : gen_other_variant
      relief_ray_setup_has_VARIANT_32708489_nearest_even_flush_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- stage 0: x_scale ---------------------------------------------------------------
  // Times 2^LEVELS: the exponent grows; zeros stay zeros.
  wire              s0_x_p_in_sign = u[FloatW-1];
  wire [EXP_W-1:0]  s0_x_p_in_exp = u[EXP_W+MAN_W-1:MAN_W];
  wire [MAN_W-1:0]  s0_x_p_in_frac = u[MAN_W-1:0];
  wire              s0_x_p_in_is_zero = ~(|s0_x_p_in_exp);
  wire              s0_x_p_in_exp_ones = &s0_x_p_in_exp;
  wire              s0_x_p_in_frac_some = |s0_x_p_in_frac;
  wire              s0_x_p_in_is_inf = s0_x_p_in_exp_ones & ~s0_x_p_in_frac_some;
  wire              s0_x_p_in_is_nan = s0_x_p_in_exp_ones & s0_x_p_in_frac_some;
  wire              s0_x_d_in_sign = du[FloatW-1];
  wire [EXP_W-1:0]  s0_x_d_in_exp = du[EXP_W+MAN_W-1:MAN_W];
  wire [MAN_W-1:0]  s0_x_d_in_frac = du[MAN_W-1:0];
  wire              s0_x_d_in_is_zero = ~(|s0_x_d_in_exp);
  wire              s0_x_d_in_exp_ones = &s0_x_d_in_exp;
  wire              s0_x_d_in_frac_some = |s0_x_d_in_frac;
  wire              s0_x_d_in_is_inf = s0_x_d_in_exp_ones & ~s0_x_d_in_frac_some;
  wire              s0_x_d_in_is_nan = s0_x_d_in_exp_ones & s0_x_d_in_frac_some;
  wire              s0_x_ok =
      (s0_x_p_in_is_zero | (~s0_x_p_in_sign & (s0_x_p_in_exp < OneExp[EXP_W-1:0]))) &
      (s0_x_d_in_exp < FarExp[EXP_W-1:0]);
  wire [FloatW-1:0] s0_x_p =
      {1'b0, {s0_x_p_in_exp + Grow[EXP_W-1:0], s0_x_p_in_frac} &
      {(EXP_W + MAN_W){~s0_x_p_in_is_zero}}};
  wire [FloatW-1:0] s0_x_dn =
      {s0_x_d_in_sign, {s0_x_d_in_exp + Grow[EXP_W-1:0], s0_x_d_in_frac} &
      {(EXP_W + MAN_W){~s0_x_d_in_is_zero}}};

  // ---- stage 0: x_bias ----------------------------------------------------------------
  // A power of two above the position estimate's error, subtracted against the direction.
  wire s0_x_forward = ~s0_x_d_in_sign;

  // ---- stage 0: y_scale ---------------------------------------------------------------
  // Times 2^LEVELS: the exponent grows; zeros stay zeros.
  wire              s0_y_p_in_sign = v[FloatW-1];
  wire [EXP_W-1:0]  s0_y_p_in_exp = v[EXP_W+MAN_W-1:MAN_W];
  wire [MAN_W-1:0]  s0_y_p_in_frac = v[MAN_W-1:0];
  wire              s0_y_p_in_is_zero = ~(|s0_y_p_in_exp);
  wire              s0_y_p_in_exp_ones = &s0_y_p_in_exp;
  wire              s0_y_p_in_frac_some = |s0_y_p_in_frac;
  wire              s0_y_p_in_is_inf = s0_y_p_in_exp_ones & ~s0_y_p_in_frac_some;
  wire              s0_y_p_in_is_nan = s0_y_p_in_exp_ones & s0_y_p_in_frac_some;
  wire              s0_y_d_in_sign = dv[FloatW-1];
  wire [EXP_W-1:0]  s0_y_d_in_exp = dv[EXP_W+MAN_W-1:MAN_W];
  wire [MAN_W-1:0]  s0_y_d_in_frac = dv[MAN_W-1:0];
  wire              s0_y_d_in_is_zero = ~(|s0_y_d_in_exp);
  wire              s0_y_d_in_exp_ones = &s0_y_d_in_exp;
  wire              s0_y_d_in_frac_some = |s0_y_d_in_frac;
  wire              s0_y_d_in_is_inf = s0_y_d_in_exp_ones & ~s0_y_d_in_frac_some;
  wire              s0_y_d_in_is_nan = s0_y_d_in_exp_ones & s0_y_d_in_frac_some;
  wire              s0_y_ok =
      (s0_y_p_in_is_zero | (~s0_y_p_in_sign & (s0_y_p_in_exp < OneExp[EXP_W-1:0]))) &
      (s0_y_d_in_exp < FarExp[EXP_W-1:0]);
  wire [FloatW-1:0] s0_y_p =
      {1'b0, {s0_y_p_in_exp + Grow[EXP_W-1:0], s0_y_p_in_frac} &
      {(EXP_W + MAN_W){~s0_y_p_in_is_zero}}};
  wire [FloatW-1:0] s0_y_dn =
      {s0_y_d_in_sign, {s0_y_d_in_exp + Grow[EXP_W-1:0], s0_y_d_in_frac} &
      {(EXP_W + MAN_W){~s0_y_d_in_is_zero}}};

  // ---- stage 0: y_bias ----------------------------------------------------------------
  // A power of two above the position estimate's error, subtracted against the direction.
  wire s0_y_forward = ~s0_y_d_in_sign;

  // ---- stage 0: level -----------------------------------------------------------------
  wire s0_is_ok = s0_x_ok & s0_y_ok;

  // ---- stage 1: registers -------------------------------------------------------------
  reg [FloatW-1:0] s1_x_p;
  reg [FloatW-1:0] s1_x_dn;
  reg              s1_x_forward;
  reg [FloatW-1:0] s1_y_p;
  reg [FloatW-1:0] s1_y_dn;
  reg              s1_y_forward;
  reg              s1_is_ok;
  always @(posedge clk) begin
    if (ce) begin
      s1_x_p       <= s0_x_p;
      s1_x_dn      <= s0_x_dn;
      s1_x_forward <= s0_x_forward;
      s1_y_p       <= s0_y_p;
      s1_y_dn      <= s0_y_dn;
      s1_y_forward <= s0_y_forward;
    end
  end
  // An unknown bit of a simulation counts as 0: none reaches a handshake.
  always @(posedge clk) begin
    if (ce) begin
      if (s0_is_ok) begin
        s1_is_ok <= 1'b1;
      end else begin
        s1_is_ok <= 1'b0;
      end
    end
  end

  // ---- stage 1: x_slope ---------------------------------------------------------------
  // In height codes: d / M and its reciprocal, M = 2^HEIGHT_W - 1.
  wire [FloatW-1:0] s21_x_r;  // a / b [float]
  relief_fp_div #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(20), .VARIANT(32'h168f7dd3)) u_x_div (
    .clk(clk), .ce(ce), .a({1'b0, MExp[EXP_W-1:0], MFrac[MAN_W-1:0]}), .b(s1_x_dn),
    .result(s21_x_r)
  );
  wire [FloatW-1:0] s3_x_d;  // a * b [float]
  relief_fp_mul #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(2), .VARIANT(32'h5bd17165)) u_x_mul (
    .clk(clk), .ce(ce), .a(s1_x_dn), .b({1'b0, RecipExp[EXP_W-1:0], RecipFrac[MAN_W-1:0]}),
    .result(s3_x_d)
  );

  // ---- stage 1: x_bias ----------------------------------------------------------------
  // A power of two above the position estimate's error, subtracted against the direction.
  wire [EXP_W:0]    s1_x_reach = {1'b0, s1_x_dn[EXP_W+MAN_W-1:MAN_W]} + {{(EXP_W - 2){1'b0}}, 3'd5};
  wire [EXP_W:0]    s1_x_bias_top = (Least[EXP_W:0] < s1_x_reach) ? s1_x_reach : Least[EXP_W:0];
  wire [EXP_W:0]    s1_x_bias_exp = s1_x_bias_top - Ulps[EXP_W:0];
  wire [FloatW-1:0] s1_x_bias = {s1_x_forward, s1_x_bias_exp[EXP_W-1:0], {MAN_W{1'b0}}};

  // ---- stage 1: x_texels --------------------------------------------------------------
  wire [IdxW-1:0] s3_x_first;  // floor of a, saturated [integer]
  relief_fp_to_int #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .INT_W(IdxW), .LATENCY(2), .VARIANT(32'h097a7d26)
  ) u_x_first (
    .clk(clk), .ce(ce), .a(s1_x_p),
    .result(s3_x_first)
  );
  wire [FloatW-1:0] s4_x_end;  // a + b [float]
  relief_fp_add #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(3), .VARIANT(32'h6bc4a879)) u_x_end (
    .clk(clk), .ce(ce), .a(s1_x_p), .b(s1_x_dn),
    .result(s4_x_end)
  );

  // ---- stage 1: y_slope ---------------------------------------------------------------
  // In height codes: d / M and its reciprocal, M = 2^HEIGHT_W - 1.
  wire [FloatW-1:0] s21_y_r;  // a / b [float]
  relief_fp_div #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(20), .VARIANT(32'h168f7dd3)) u_y_div (
    .clk(clk), .ce(ce), .a({1'b0, MExp[EXP_W-1:0], MFrac[MAN_W-1:0]}), .b(s1_y_dn),
    .result(s21_y_r)
  );
  wire [FloatW-1:0] s3_y_d;  // a * b [float]
  relief_fp_mul #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(2), .VARIANT(32'h5bd17165)) u_y_mul (
    .clk(clk), .ce(ce), .a(s1_y_dn), .b({1'b0, RecipExp[EXP_W-1:0], RecipFrac[MAN_W-1:0]}),
    .result(s3_y_d)
  );

  // ---- stage 1: y_bias ----------------------------------------------------------------
  // A power of two above the position estimate's error, subtracted against the direction.
  wire [EXP_W:0]    s1_y_reach = {1'b0, s1_y_dn[EXP_W+MAN_W-1:MAN_W]} + {{(EXP_W - 2){1'b0}}, 3'd5};
  wire [EXP_W:0]    s1_y_bias_top = (Least[EXP_W:0] < s1_y_reach) ? s1_y_reach : Least[EXP_W:0];
  wire [EXP_W:0]    s1_y_bias_exp = s1_y_bias_top - Ulps[EXP_W:0];
  wire [FloatW-1:0] s1_y_bias = {s1_y_forward, s1_y_bias_exp[EXP_W-1:0], {MAN_W{1'b0}}};

  // ---- stage 1: y_texels --------------------------------------------------------------
  wire [IdxW-1:0] s3_y_first;  // floor of a, saturated [integer]
  relief_fp_to_int #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .INT_W(IdxW), .LATENCY(2), .VARIANT(32'h097a7d26)
  ) u_y_first (
    .clk(clk), .ce(ce), .a(s1_y_p),
    .result(s3_y_first)
  );
  wire [FloatW-1:0] s4_y_end;  // a + b [float]
  relief_fp_add #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(3), .VARIANT(32'h6bc4a879)) u_y_end (
    .clk(clk), .ce(ce), .a(s1_y_p), .b(s1_y_dn),
    .result(s4_y_end)
  );

  // ---- stage 2: registers -------------------------------------------------------------
  reg [FloatW-1:0] s2_x_bias;
  reg [FloatW-1:0] s2_x_p;
  reg [FloatW-1:0] s2_y_bias;
  reg [FloatW-1:0] s2_y_p;
  always @(posedge clk) begin
    if (ce) begin
      s2_x_bias <= s1_x_bias;
      s2_x_p    <= s1_x_p;
      s2_y_bias <= s1_y_bias;
      s2_y_p    <= s1_y_p;
    end
  end

  // ---- stage 2: x_bias ----------------------------------------------------------------
  // A power of two above the position estimate's error, subtracted against the direction.
  wire [FloatW-1:0] s5_x_pb;  // a + b [float]
  relief_fp_add #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(3), .VARIANT(32'h6bc4a879)) u_x_back (
    .clk(clk), .ce(ce), .a(s2_x_p), .b(s2_x_bias),
    .result(s5_x_pb)
  );

  // ---- stage 2: y_bias ----------------------------------------------------------------
  // A power of two above the position estimate's error, subtracted against the direction.
  wire [FloatW-1:0] s5_y_pb;  // a + b [float]
  relief_fp_add #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(3), .VARIANT(32'h6bc4a879)) u_y_back (
    .clk(clk), .ce(ce), .a(s2_y_p), .b(s2_y_bias),
    .result(s5_y_pb)
  );

  // ---- stage 4: x_texels --------------------------------------------------------------
  wire [IdxW-1:0] s6_x_last;  // floor of a, saturated [integer]
  relief_fp_to_int #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .INT_W(IdxW), .LATENCY(2), .VARIANT(32'h097a7d26)
  ) u_x_last (
    .clk(clk), .ce(ce), .a(s4_x_end),
    .result(s6_x_last)
  );

  // ---- stage 4: y_texels --------------------------------------------------------------
  wire [IdxW-1:0] s6_y_last;  // floor of a, saturated [integer]
  relief_fp_to_int #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .INT_W(IdxW), .LATENCY(2), .VARIANT(32'h097a7d26)
  ) u_y_last (
    .clk(clk), .ce(ce), .a(s4_y_end),
    .result(s6_y_last)
  );

  // ---- stage 6: registers -------------------------------------------------------------
  // Delay of 3 clocks: stage 3 to 6.
  reg [IdxW-1:0]   s6_x_first;
  reg [IdxW-1:0]   s6_y_first;
  reg [4*IdxW-1:0] s3_to_s6;
  always @(posedge clk) begin
    if (ce) begin
      {s6_x_first, s6_y_first, s3_to_s6} <= {s3_to_s6, s3_x_first, s3_y_first};
    end
  end

  // ---- stage 6: level -----------------------------------------------------------------
  // 0: both in one texel; LEVELS: the root (also across tiles) [levels]
  wire [LevelW-1:0] s6_start;
  relief_start_level #(
    .LEVELS(LEVELS), .IDX_W(IdxW), .LATENCY(0), .VARIANT(32'h4c35fe41)
  ) u_start_level (
    .x(s6_x_first), .y(s6_y_first), .x_end(s6_x_last), .y_end(s6_y_last),
    .level(s6_start)
  );

  // ---- stage 21: registers ------------------------------------------------------------
  // Delay of 21 clocks: stage 0 to 21.
  reg        s21_x_d_in_is_zero;
  reg        s21_y_d_in_is_zero;
  reg        s21_x_d_in_sign;
  reg        s21_y_d_in_sign;
  reg [79:0] s0_to_s21;
  always @(posedge clk) begin
    if (ce) begin
      {s21_x_d_in_is_zero, s21_y_d_in_is_zero, s21_x_d_in_sign, s21_y_d_in_sign, s0_to_s21} <=
          {s0_to_s21, s0_x_d_in_is_zero, s0_y_d_in_is_zero, s0_x_d_in_sign, s0_y_d_in_sign};
    end
  end
  // Delay of 20 clocks: stage 1 to 21.
  reg        s21_is_ok;
  reg [18:0] s1_to_s21;
  always @(posedge clk) begin
    if (ce) begin
      {s21_is_ok, s1_to_s21} <= {s1_to_s21, s1_is_ok};
    end
  end
  // Delay of 19 clocks: stage 2 to 21.
  reg [FloatW-1:0]    s21_x_p;
  reg [FloatW-1:0]    s21_y_p;
  reg [36*FloatW-1:0] s2_to_s21;
  always @(posedge clk) begin
    if (ce) begin
      {s21_x_p, s21_y_p, s2_to_s21} <= {s2_to_s21, s2_x_p, s2_y_p};
    end
  end
  // Delay of 18 clocks: stage 3 to 21.
  reg [FloatW-1:0]    s21_x_d;
  reg [FloatW-1:0]    s21_y_d;
  reg [34*FloatW-1:0] s3_to_s21;
  always @(posedge clk) begin
    if (ce) begin
      {s21_x_d, s21_y_d, s3_to_s21} <= {s3_to_s21, s3_x_d, s3_y_d};
    end
  end
  // Delay of 16 clocks: stage 5 to 21.
  reg [FloatW-1:0]    s21_x_pb;
  reg [FloatW-1:0]    s21_y_pb;
  reg [30*FloatW-1:0] s5_to_s21;
  always @(posedge clk) begin
    if (ce) begin
      {s21_x_pb, s21_y_pb, s5_to_s21} <= {s5_to_s21, s5_x_pb, s5_y_pb};
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

  // ---- stage 21: x_slope --------------------------------------------------------------
  // In height codes: d / M and its reciprocal, M = 2^HEIGHT_W - 1.
  wire s21_x_never = (&s21_x_r[EXP_W+MAN_W-1:MAN_W]) | s21_x_d_in_is_zero;

  // ---- stage 21: y_slope --------------------------------------------------------------
  // In height codes: d / M and its reciprocal, M = 2^HEIGHT_W - 1.
  wire s21_y_never = (&s21_y_r[EXP_W+MAN_W-1:MAN_W]) | s21_y_d_in_is_zero;

  // Bits that nothing needs, named so that no lint has to be switched off for the rest.
  // verilator lint_off UNUSED
  wire unused_0 = &{1'b0, s0_x_p_in_is_inf, s0_x_p_in_is_nan, s0_x_d_in_is_inf, s0_x_d_in_is_nan};
  wire unused_1 = &{1'b0, s1_x_bias_exp[EXP_W]};
  wire unused_2 = &{1'b0, s0_y_p_in_is_inf, s0_y_p_in_is_nan, s0_y_d_in_is_inf, s0_y_d_in_is_nan};
  wire unused_3 = &{1'b0, s1_y_bias_exp[EXP_W]};
  // verilator lint_on UNUSED

  assign ok = s21_is_ok;
  assign level = s21_start & {LevelW{s21_is_ok}};
  assign p_x = s21_x_p & {FloatW{s21_is_ok}};
  assign pb_x = s21_x_pb & {FloatW{s21_is_ok}};
  assign d_x = s21_x_d & {FloatW{s21_is_ok}};
  assign r_x = s21_x_r & {FloatW{s21_is_ok}};
  assign never_x = s21_x_never & s21_is_ok;
  assign neg_x = s21_x_d_in_sign & s21_is_ok;
  assign first_x = s21_x_first & {IdxW{s21_is_ok}};
  assign p_y = s21_y_p & {FloatW{s21_is_ok}};
  assign pb_y = s21_y_pb & {FloatW{s21_is_ok}};
  assign d_y = s21_y_d & {FloatW{s21_is_ok}};
  assign r_y = s21_y_r & {FloatW{s21_is_ok}};
  assign never_y = s21_y_never & s21_is_ok;
  assign neg_y = s21_y_d_in_sign & s21_is_ok;
  assign first_y = s21_y_first & {IdxW{s21_is_ok}};
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
