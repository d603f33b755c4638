// SPDX-License-Identifier: MIT OR Apache-2.0
// relief_traverse: traces rays against a height field: a looping pipeline, one node a clock
// Emitted    by reliefrtl as its unit traverse; do not edit
// Chosen     datapath watertight, levels_down 2, level_up selective, rounding nearest-even,
//            subnormals flush, specials ieee, bilinear false, lod false, start_level true, trim
//            none
// Latency    varies; valid/ready on both sides
// Throughput one iteration (one node) per clock; a ray takes as many iterations as its path needs
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (every NaN
//            result has the same bits); nearest, ties to even; x - x is +0.
`default_nettype none
module relief_traverse #(
  parameter integer EXP_W      = 7,      // exponent bits
  parameter integer MAN_W      = 16,     // fraction bits, the hidden one not counted
  parameter integer LEVELS     = 8,      // the map has 2^LEVELS x 2^LEVELS texels
  parameter integer HEIGHT_W   = 8,      // bits of a height code
  parameter integer TILE_W     = 4,      // a ray travels less than 2^TILE_W tiles along each axis
  parameter integer FRAC_W     = 12,     // fraction bits of the hit position
  parameter integer TAG_W      = 8,      // bits of a ray's tag
  parameter integer STEP_LIMIT = 65535,  // iterations after which a ray is given up
  parameter integer VARIANT    = 32'h3b71a3f0,  // digest of what it was generated for; checked
  // file for $readmemh with the words of the pyramid, level 0 first; "": none
  parameter MEM_INIT = ""
) (
  input  wire                 clk,            // rising edge
  // synchronous, active high; clears valid bits and counts, no data
  input  wire                 rst,
  input  wire                 load_en,        // write a word of the pyramid (while idle is 1)
  input  wire [2*LEVELS:0]    load_addr,      // address: level 0 first, the root last [words]
  input  wire [HEIGHT_W-1:0]  load_data,      // largest height in that node [height codes]
  input  wire                 in_valid,       // input valid
  // input ready (transfer when valid && ready); registered
  output wire                 in_ready,
  input  wire [TAG_W-1:0]     in_tag,         // identifies the ray: out_tag of its result [bits]
  // entry point at the top plane, 0 <= u < 1 [float, tiles]
  input  wire [EXP_W+MAN_W:0] in_u,
  // entry point at the top plane, 0 <= v < 1 [float, tiles]
  input  wire [EXP_W+MAN_W:0] in_v,
  // u travelled while the height falls from 1 to 0 [float, tiles]
  input  wire [EXP_W+MAN_W:0] in_du,
  // v travelled while the height falls from 1 to 0 [float, tiles]
  input  wire [EXP_W+MAN_W:0] in_dv,
  output wire                 out_valid,      // output valid
  input  wire                 out_ready,      // output ready (transfer when valid && ready)
  output wire [TAG_W-1:0]     out_tag,        // tag of the ray [bits]
  output wire [LEVELS-1:0]    out_i,          // hit texel, column (u) [texels]
  output wire [LEVELS-1:0]    out_j,          // hit texel, row (v) [texels]
  output wire [FRAC_W-1:0]    out_fu,         // position in the texel along u [1/2^FRAC_W texel]
  output wire [FRAC_W-1:0]    out_fv,         // position in the texel along v [1/2^FRAC_W texel]
  // ray parameter: 0 at the top plane [float, height codes]
  output wire [EXP_W+MAN_W:0] out_t,
  output wire                 out_wall,       // the hit is on the side of a texel
  // given up: STEP_LIMIT reached, or not a ray (steps 0)
  output wire                 out_limit,
  output wire [15:0]          out_steps,      // nodes visited [iterations]
  // iterations that crossed into a neighbour [iterations]
  output wire [15:0]          out_crossings,
  output wire [15:0]          out_ups,        // levels gone up [levels]
  // the slot in stage 0 holds a ray; its mean is the loop's utilization
  output wire                 slot_busy,
  // no ray in flight; falls one clock after an input transfer, rises two after the last output
  // transfer
  output wire                 idle
);
  localparam integer FloatW = EXP_W + MAN_W + 1;   // bits of a float: sign, exponent, fraction
  localparam integer LevelW = $clog2(LEVELS + 1);  // bits of a level
  localparam integer IdxW = LEVELS + TILE_W + 2;   // bits of a signed, unwrapped texel coordinate
  // steps before the last one that a ray may take
  localparam integer StepLimitLess1 = STEP_LIMIT - 1;

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
    if (FRAC_W < 1) begin : gen_illegal_13 FRAC_W_must_be_at_least_1 u_illegal (); end
    if (FRAC_W > 16) begin : gen_illegal_14 FRAC_W_must_be_at_most_16 u_illegal (); end
    if (TAG_W < 1) begin : gen_illegal_15 TAG_W_must_be_at_least_1 u_illegal (); end
    if (TAG_W > 32) begin : gen_illegal_16 TAG_W_must_be_at_most_32 u_illegal (); end
    if (STEP_LIMIT < 1) begin : gen_illegal_17 STEP_LIMIT_must_be_at_least_1 u_illegal (); end
    if (STEP_LIMIT > 65535) begin : gen_illegal_18
      STEP_LIMIT_must_be_at_most_65535 u_illegal ();
    end
    if (FRAC_W + LEVELS + MAN_W + TILE_W + 2 > 60) begin : gen_illegal_19
      FRAC_W_plus_LEVELS_plus_MAN_W_plus_TILE_W_plus_2_must_be_at_most_60 u_illegal ();
    end
    if (VARIANT != 32'h3b71a3f0) begin : gen_other_variant
      relief_traverse_has_VARIANT_3b71a3f0_watertight_selective_not_the_one_asked_for u_illegal ();
    end
  endgenerate

  // ---- state registers, written at the end of the module ------------------------------
  reg              s0_loop_valid_q;      // the slot holds a ray
  reg [TAG_W-1:0]  s0_loop_tag_q;        // tag of the ray [bits]
  reg [FloatW-1:0] s0_loop_p_x_q;        // entry point along x [float, texels]
  // entry point along x, biased against the direction [float, texels]
  reg [FloatW-1:0] s0_loop_pb_x_q;
  reg [FloatW-1:0] s0_loop_d_x_q;        // direction along x [float, texels per height code]
  // reciprocal of the direction along x [float, height codes per texel]
  reg [FloatW-1:0] s0_loop_r_x_q;
  reg              s0_loop_never_x_q;    // the ray does not move along x
  reg              s0_loop_neg_x_q;      // the ray runs toward smaller x coordinates
  reg [FloatW-1:0] s0_loop_p_y_q;        // entry point along y [float, texels]
  // entry point along y, biased against the direction [float, texels]
  reg [FloatW-1:0] s0_loop_pb_y_q;
  reg [FloatW-1:0] s0_loop_d_y_q;        // direction along y [float, texels per height code]
  // reciprocal of the direction along y [float, height codes per texel]
  reg [FloatW-1:0] s0_loop_r_y_q;
  reg              s0_loop_never_y_q;    // the ray does not move along y
  reg              s0_loop_neg_y_q;      // the ray runs toward smaller y coordinates
  reg [LevelW-1:0] s0_loop_level_q;      // level of the node [levels]
  reg [IdxW-1:0]   s0_loop_x_q;          // a texel of the node, column, unwrapped [texels]
  reg [IdxW-1:0]   s0_loop_y_q;          // a texel of the node, row, unwrapped [texels]
  reg [FloatW-1:0] s0_loop_t_q;          // ray parameter so far [float, height codes]
  reg              s0_loop_done_q;       // finished: recirculates until it retires
  reg              s0_loop_wall_q;       // the hit is on the side of a texel
  reg              s0_loop_limit_q;      // given up, or not a ray
  reg [15:0]       s0_loop_steps_q;      // nodes visited [iterations]
  reg [15:0]       s0_loop_crossings_q;  // iterations that crossed into a neighbour [iterations]
  reg [15:0]       s0_loop_ups_q;        // levels gone up [levels]
  reg              s0_loop_crossed_q;    // a node boundary was crossed already
  reg              s0_in_transfer_q;     // input transfer in the previous clock
  reg              s0_out_transfer_q;    // output transfer in the previous clock
  reg [6:0]        s0_in_flight_q;       // rays in flight, counted one clock late [rays]
  reg              s0_any_in_flight_q;   // rays are in flight

  // ---- nets that are driven further below ---------------------------------------------
  wire hit_valid;    // the buffer after the hit pipeline holds a word
  wire hit_ready;    // the hit pipeline can take a word
  wire setup_valid;  // the buffer after the setup pipeline holds a word
  wire setup_ready;  // the setup pipeline can take a word

  // ---- stage 0: retire ----------------------------------------------------------------
  // A finished ray retires when the hit pipeline is ready; until then it recirculates unchanged.
  wire s0_retire = s0_loop_valid_q & s0_loop_done_q & hit_ready;
  wire s0_slot_free = ~s0_loop_valid_q | s0_retire;

  // ---- stage 0: setup -----------------------------------------------------------------
  // The pipeline stalls, as a whole, while both words of the buffer after it are taken.
  // the ray can be traced: finite, entry in the tile, direction below 2^TILE_W
  wire              set_ok;
  wire [LevelW-1:0] set_level;    // level of the first iteration [levels]
  wire [FloatW-1:0] set_p_x;      // entry point along x [float, texels]
  wire [FloatW-1:0] set_pb_x;  // entry point along x, biased against the direction [float, texels]
  wire [FloatW-1:0] set_d_x;      // direction along x [float, texels per height code]
  wire [FloatW-1:0] set_r_x;  // reciprocal of the direction along x [float, height codes per texel]
  wire              set_never_x;  // the ray does not move along x
  wire              set_neg_x;    // the ray runs toward smaller x coordinates
  wire [IdxW-1:0]   set_first_x;  // x coordinate of the texel of the entry point [texels]
  wire [FloatW-1:0] set_p_y;      // entry point along y [float, texels]
  wire [FloatW-1:0] set_pb_y;  // entry point along y, biased against the direction [float, texels]
  wire [FloatW-1:0] set_d_y;      // direction along y [float, texels per height code]
  wire [FloatW-1:0] set_r_y;  // reciprocal of the direction along y [float, height codes per texel]
  wire              set_never_y;  // the ray does not move along y
  wire              set_neg_y;    // the ray runs toward smaller y coordinates
  wire [IdxW-1:0]   set_first_y;  // y coordinate of the texel of the entry point [texels]
  relief_ray_setup #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .LEVELS(LEVELS), .HEIGHT_W(HEIGHT_W), .TILE_W(TILE_W),
    .LATENCY(21), .VARIANT(32'h39c47949)
  ) u_setup (
    .clk(clk), .ce(setup_ready), .u(in_u), .v(in_v), .du(in_du), .dv(in_dv),
    .ok(set_ok), .level(set_level), .p_x(set_p_x), .pb_x(set_pb_x), .d_x(set_d_x), .r_x(set_r_x),
    .never_x(set_never_x), .neg_x(set_neg_x), .first_x(set_first_x), .p_y(set_p_y), .pb_y(set_pb_y),
    .d_y(set_d_y), .r_y(set_r_y), .never_y(set_never_y), .neg_y(set_neg_y), .first_y(set_first_y)
  );
  wire             setup_last_valid;  // the delayed word is valid
  wire [TAG_W-1:0] set_tag;           // identifies the ray: out_tag of its result [bits]
  relief_setup_delay #(.W(TAG_W), .LATENCY(21), .VARIANT(32'h306304c2)) u_setup_delay (
    .clk(clk), .ce(setup_ready), .rst(rst), .in_valid(in_valid), .in_data(in_tag),
    .out_valid(setup_last_valid), .out_data(set_tag)
  );
  // the ray can be traced: finite, entry in the tile, direction below 2^TILE_W
  wire              new_ok;
  wire [LevelW-1:0] new_level;    // level of the first iteration [levels]
  wire [FloatW-1:0] new_p_x;      // entry point along x [float, texels]
  wire [FloatW-1:0] new_pb_x;  // entry point along x, biased against the direction [float, texels]
  wire [FloatW-1:0] new_d_x;      // direction along x [float, texels per height code]
  wire [FloatW-1:0] new_r_x;  // reciprocal of the direction along x [float, height codes per texel]
  wire              new_never_x;  // the ray does not move along x
  wire              new_neg_x;    // the ray runs toward smaller x coordinates
  wire [IdxW-1:0]   new_first_x;  // x coordinate of the texel of the entry point [texels]
  wire [FloatW-1:0] new_p_y;      // entry point along y [float, texels]
  wire [FloatW-1:0] new_pb_y;  // entry point along y, biased against the direction [float, texels]
  wire [FloatW-1:0] new_d_y;      // direction along y [float, texels per height code]
  wire [FloatW-1:0] new_r_y;  // reciprocal of the direction along y [float, height codes per texel]
  wire              new_never_y;  // the ray does not move along y
  wire              new_neg_y;    // the ray runs toward smaller y coordinates
  wire [IdxW-1:0]   new_first_y;  // y coordinate of the texel of the entry point [texels]
  wire [TAG_W-1:0]  new_tag;      // identifies the ray: out_tag of its result [bits]
  relief_spill_register #(
    .W(TAG_W + 8 * FloatW + 2 * IdxW + LevelW + 5), .VARIANT(32'h4b082ec9)
  ) u_setup_buffer (
    .clk(clk), .rst(rst), .in_valid(setup_last_valid),
    .in_data({set_ok, set_level, set_p_x, set_pb_x, set_d_x, set_r_x, set_never_x, set_neg_x,
        set_first_x, set_p_y, set_pb_y, set_d_y, set_r_y, set_never_y, set_neg_y, set_first_y,
        set_tag}),
    .out_ready(s0_slot_free),
    .in_ready(setup_ready), .out_valid(setup_valid),
    .out_data({new_ok, new_level, new_p_x, new_pb_x, new_d_x, new_r_x, new_never_x, new_neg_x,
        new_first_x, new_p_y, new_pb_y, new_d_y, new_r_y, new_never_y, new_neg_y, new_first_y,
        new_tag})
  );
  wire s0_accept = setup_valid & s0_slot_free;

  // ---- stage 0: slot ------------------------------------------------------------------
  // A slot holds the new ray, or the one that recirculates. Both are registered before the choice:
  // its select reaches every bit of a ray.
  wire s0_new_refused = ~new_ok;
  wire s0_slot_busy = (s0_loop_valid_q & ~s0_retire) | s0_accept;

  // ---- stage 0: idle ------------------------------------------------------------------
  // Rays in flight: input transfers less output transfers, counted one clock late.
  wire       s0_in_transfer = in_valid & setup_ready;
  wire       out_transfer = hit_valid & out_ready;
  wire       s0_in_flight_down = s0_out_transfer_q & ~s0_in_transfer_q;
  wire [6:0] s0_in_flight_next = s0_in_flight_q +
      {{6{s0_in_flight_down}}, s0_in_transfer_q ^ s0_out_transfer_q};
  wire       s0_any_in_flight_next = |s0_in_flight_next;
  wire       s0_is_idle = ~(s0_any_in_flight_q | s0_in_transfer_q);

  // ---- stage 0: result ----------------------------------------------------------------
  // The ray that retires, from the loop registers.
  wire [FRAC_W-1:0] hit_fu;  // position inside the texel [1/2^FRAC_W texel]
  relief_hit_position #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .IDX_W(IdxW), .FRAC_W(FRAC_W), .LATENCY(7), .VARIANT(32'h2a9130b2)
  ) u_hit_u (
    .clk(clk), .ce(hit_ready), .p(s0_loop_p_x_q), .d(s0_loop_d_x_q), .t(s0_loop_t_q),
    .x(s0_loop_x_q),
    .fraction(hit_fu)
  );
  wire [FRAC_W-1:0] hit_fv;  // position inside the texel [1/2^FRAC_W texel]
  relief_hit_position #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .IDX_W(IdxW), .FRAC_W(FRAC_W), .LATENCY(7), .VARIANT(32'h2a9130b2)
  ) u_hit_v (
    .clk(clk), .ce(hit_ready), .p(s0_loop_p_y_q), .d(s0_loop_d_y_q), .t(s0_loop_t_q),
    .x(s0_loop_y_q),
    .fraction(hit_fv)
  );
  wire              hit_last_valid;  // the delayed word is valid
  wire [LEVELS-1:0] hit_i;           // hit texel, column [texels]
  wire [LEVELS-1:0] hit_j;           // hit texel, row [texels]
  wire [FloatW-1:0] hit_t;           // ray parameter so far [float, height codes]
  wire              hit_wall;        // the hit is on the side of a texel
  wire              hit_limit;       // given up, or not a ray
  wire [15:0]       hit_steps;       // nodes visited [iterations]
  wire [15:0]       hit_crossings;   // iterations that crossed into a neighbour [iterations]
  wire [15:0]       hit_ups;         // levels gone up [levels]
  wire [TAG_W-1:0]  hit_tag;         // tag of the ray [bits]
  relief_hit_delay #(
    .W(2 * LEVELS + TAG_W + FloatW + 50), .LATENCY(7), .VARIANT(32'h0069384e)
  ) u_hit_delay (
    .clk(clk), .ce(hit_ready), .rst(rst), .in_valid(s0_retire),
    .in_data({s0_loop_x_q[LEVELS-1:0], s0_loop_y_q[LEVELS-1:0], s0_loop_t_q, s0_loop_wall_q,
        s0_loop_limit_q, s0_loop_steps_q, s0_loop_crossings_q, s0_loop_ups_q, s0_loop_tag_q}),
    .out_valid(hit_last_valid),
    .out_data({hit_i, hit_j, hit_t, hit_wall, hit_limit, hit_steps, hit_crossings, hit_ups,
        hit_tag})
  );
  wire [FRAC_W-1:0] result_fu;         // position inside the texel [1/2^FRAC_W texel]
  wire [FRAC_W-1:0] result_fv;         // position inside the texel [1/2^FRAC_W texel]
  wire [LEVELS-1:0] result_i;          // hit texel, column [texels]
  wire [LEVELS-1:0] result_j;          // hit texel, row [texels]
  wire [FloatW-1:0] result_t;          // ray parameter so far [float, height codes]
  wire              result_wall;       // the hit is on the side of a texel
  wire              result_limit;      // given up, or not a ray
  wire [15:0]       result_steps;      // nodes visited [iterations]
  wire [15:0]       result_crossings;  // iterations that crossed into a neighbour [iterations]
  wire [15:0]       result_ups;        // levels gone up [levels]
  wire [TAG_W-1:0]  result_tag;        // tag of the ray [bits]
  relief_spill_register #(
    .W(2 * FRAC_W + 2 * LEVELS + TAG_W + FloatW + 50), .VARIANT(32'h4b082ec9)
  ) u_hit_buffer (
    .clk(clk), .rst(rst), .in_valid(hit_last_valid),
    .in_data({hit_fu, hit_fv, hit_i, hit_j, hit_t, hit_wall, hit_limit, hit_steps, hit_crossings,
        hit_ups, hit_tag}),
    .out_ready(out_ready),
    .in_ready(hit_ready), .out_valid(hit_valid),
    .out_data({result_fu, result_fv, result_i, result_j, result_t, result_wall, result_limit,
        result_steps, result_crossings, result_ups, result_tag})
  );

  // ---- stage 1: registers -------------------------------------------------------------
  reg [TAG_W-1:0]  s1_loop_tag_q;
  reg [FloatW-1:0] s1_loop_p_x_q;
  reg [FloatW-1:0] s1_loop_pb_x_q;
  reg [FloatW-1:0] s1_loop_d_x_q;
  reg [FloatW-1:0] s1_loop_r_x_q;
  reg              s1_loop_never_x_q;
  reg              s1_loop_neg_x_q;
  reg [FloatW-1:0] s1_loop_p_y_q;
  reg [FloatW-1:0] s1_loop_pb_y_q;
  reg [FloatW-1:0] s1_loop_d_y_q;
  reg [FloatW-1:0] s1_loop_r_y_q;
  reg              s1_loop_never_y_q;
  reg              s1_loop_neg_y_q;
  reg [LevelW-1:0] s1_loop_level_q;
  reg [IdxW-1:0]   s1_loop_x_q;
  reg [IdxW-1:0]   s1_loop_y_q;
  reg [FloatW-1:0] s1_loop_t_q;
  reg              s1_loop_done_q;
  reg              s1_loop_wall_q;
  reg              s1_loop_limit_q;
  reg [15:0]       s1_loop_steps_q;
  reg [15:0]       s1_loop_crossings_q;
  reg [15:0]       s1_loop_ups_q;
  reg              s1_loop_crossed_q;
  reg              s1_accept;
  reg [TAG_W-1:0]  s1_new_tag;
  reg [FloatW-1:0] s1_new_p_x;
  reg [FloatW-1:0] s1_new_pb_x;
  reg [FloatW-1:0] s1_new_d_x;
  reg [FloatW-1:0] s1_new_r_x;
  reg              s1_new_never_x;
  reg              s1_new_neg_x;
  reg [FloatW-1:0] s1_new_p_y;
  reg [FloatW-1:0] s1_new_pb_y;
  reg [FloatW-1:0] s1_new_d_y;
  reg [FloatW-1:0] s1_new_r_y;
  reg              s1_new_never_y;
  reg              s1_new_neg_y;
  reg [LevelW-1:0] s1_new_level;
  reg [IdxW-1:0]   s1_new_first_x;
  reg [IdxW-1:0]   s1_new_first_y;
  reg              s1_new_refused;
  always @(posedge clk) begin
    s1_loop_tag_q       <= s0_loop_tag_q;
    s1_loop_p_x_q       <= s0_loop_p_x_q;
    s1_loop_pb_x_q      <= s0_loop_pb_x_q;
    s1_loop_d_x_q       <= s0_loop_d_x_q;
    s1_loop_r_x_q       <= s0_loop_r_x_q;
    s1_loop_never_x_q   <= s0_loop_never_x_q;
    s1_loop_neg_x_q     <= s0_loop_neg_x_q;
    s1_loop_p_y_q       <= s0_loop_p_y_q;
    s1_loop_pb_y_q      <= s0_loop_pb_y_q;
    s1_loop_d_y_q       <= s0_loop_d_y_q;
    s1_loop_r_y_q       <= s0_loop_r_y_q;
    s1_loop_never_y_q   <= s0_loop_never_y_q;
    s1_loop_neg_y_q     <= s0_loop_neg_y_q;
    s1_loop_level_q     <= s0_loop_level_q;
    s1_loop_x_q         <= s0_loop_x_q;
    s1_loop_y_q         <= s0_loop_y_q;
    s1_loop_t_q         <= s0_loop_t_q;
    s1_loop_done_q      <= s0_loop_done_q;
    s1_loop_wall_q      <= s0_loop_wall_q;
    s1_loop_limit_q     <= s0_loop_limit_q;
    s1_loop_steps_q     <= s0_loop_steps_q;
    s1_loop_crossings_q <= s0_loop_crossings_q;
    s1_loop_ups_q       <= s0_loop_ups_q;
    s1_loop_crossed_q   <= s0_loop_crossed_q;
    s1_accept           <= s0_accept;
    s1_new_tag          <= new_tag;
    s1_new_p_x          <= new_p_x;
    s1_new_pb_x         <= new_pb_x;
    s1_new_d_x          <= new_d_x;
    s1_new_r_x          <= new_r_x;
    s1_new_never_x      <= new_never_x;
    s1_new_neg_x        <= new_neg_x;
    s1_new_p_y          <= new_p_y;
    s1_new_pb_y         <= new_pb_y;
    s1_new_d_y          <= new_d_y;
    s1_new_r_y          <= new_r_y;
    s1_new_never_y      <= new_never_y;
    s1_new_neg_y        <= new_neg_y;
    s1_new_level        <= new_level;
    s1_new_first_x      <= new_first_x;
    s1_new_first_y      <= new_first_y;
    s1_new_refused      <= s0_new_refused;
  end

  // ---- stage 1: slot ------------------------------------------------------------------
  // A slot holds the new ray, or the one that recirculates. Both are registered before the choice:
  // its select reaches every bit of a ray.
  wire [TAG_W-1:0]  s1_tag = s1_accept ? s1_new_tag : s1_loop_tag_q;
  wire [FloatW-1:0] s1_p_x = s1_accept ? s1_new_p_x : s1_loop_p_x_q;
  wire [FloatW-1:0] s1_pb_x = s1_accept ? s1_new_pb_x : s1_loop_pb_x_q;
  wire [FloatW-1:0] s1_d_x = s1_accept ? s1_new_d_x : s1_loop_d_x_q;
  wire [FloatW-1:0] s1_r_x = s1_accept ? s1_new_r_x : s1_loop_r_x_q;
  wire              s1_never_x = s1_accept ? s1_new_never_x : s1_loop_never_x_q;
  wire              s1_neg_x = s1_accept ? s1_new_neg_x : s1_loop_neg_x_q;
  wire [FloatW-1:0] s1_p_y = s1_accept ? s1_new_p_y : s1_loop_p_y_q;
  wire [FloatW-1:0] s1_pb_y = s1_accept ? s1_new_pb_y : s1_loop_pb_y_q;
  wire [FloatW-1:0] s1_d_y = s1_accept ? s1_new_d_y : s1_loop_d_y_q;
  wire [FloatW-1:0] s1_r_y = s1_accept ? s1_new_r_y : s1_loop_r_y_q;
  wire              s1_never_y = s1_accept ? s1_new_never_y : s1_loop_never_y_q;
  wire              s1_neg_y = s1_accept ? s1_new_neg_y : s1_loop_neg_y_q;
  wire [LevelW-1:0] s1_level = s1_accept ? s1_new_level : s1_loop_level_q;
  wire [IdxW-1:0]   s1_x = s1_accept ? s1_new_first_x : s1_loop_x_q;
  wire [IdxW-1:0]   s1_y = s1_accept ? s1_new_first_y : s1_loop_y_q;
  wire [FloatW-1:0] s1_t = s1_accept ? {FloatW{1'b0}} : s1_loop_t_q;
  wire              s1_done = s1_accept ? s1_new_refused : s1_loop_done_q;
  wire              s1_wall = s1_accept ? 1'b0 : s1_loop_wall_q;
  wire              s1_limit = s1_accept ? s1_new_refused : s1_loop_limit_q;
  wire [15:0]       s1_steps = s1_accept ? 16'd0 : s1_loop_steps_q;
  wire [15:0]       s1_crossings = s1_accept ? 16'd0 : s1_loop_crossings_q;
  wire [15:0]       s1_ups = s1_accept ? 16'd0 : s1_loop_ups_q;
  wire              s1_has_crossed = s1_accept ? 1'b0 : s1_loop_crossed_q;

  // ---- stage 2: registers -------------------------------------------------------------
  reg              s2_neg_x;
  reg              s2_neg_y;
  reg [LevelW-1:0] s2_level;
  reg [IdxW-1:0]   s2_x;
  reg [IdxW-1:0]   s2_y;
  reg              s2_done;
  reg [15:0]       s2_steps;
  always @(posedge clk) begin
    s2_neg_x <= s1_neg_x;
    s2_neg_y <= s1_neg_y;
    s2_level <= s1_level;
    s2_x     <= s1_x;
    s2_y     <= s1_y;
    s2_done  <= s1_done;
    s2_steps <= s1_steps;
  end

  // ---- stage 2: node ------------------------------------------------------------------
  // Extent and exit planes of the node, and its address in memory.
  // least texel that a descent may enter: none that the ray has passed [texels]
  wire [IdxW-1:0] s2_x_low;
  // greatest texel that a descent may enter: none that the ray has passed [texels]
  wire [IdxW-1:0] s2_x_high;
  wire [IdxW-1:0] s2_x_plane;   // coordinate of the exit plane [texels]
  wire [IdxW-1:0] s2_x_beyond;  // the first texel beyond the exit plane [texels]
  wire            s2_x_even;    // the plane also bounds the parent node
  relief_node_planes #(
    .LEVELS(LEVELS), .IDX_W(IdxW), .LATENCY(0), .VARIANT(32'h2afa0fb3)
  ) u_planes_x (
    .level(s2_level), .x(s2_x), .neg(s2_neg_x),
    .low(s2_x_low), .high(s2_x_high), .plane(s2_x_plane), .beyond(s2_x_beyond), .even(s2_x_even)
  );
  // least texel that a descent may enter: none that the ray has passed [texels]
  wire [IdxW-1:0] s2_y_low;
  // greatest texel that a descent may enter: none that the ray has passed [texels]
  wire [IdxW-1:0] s2_y_high;
  wire [IdxW-1:0] s2_y_plane;   // coordinate of the exit plane [texels]
  wire [IdxW-1:0] s2_y_beyond;  // the first texel beyond the exit plane [texels]
  wire            s2_y_even;    // the plane also bounds the parent node
  relief_node_planes #(
    .LEVELS(LEVELS), .IDX_W(IdxW), .LATENCY(0), .VARIANT(32'h2afa0fb3)
  ) u_planes_y (
    .level(s2_level), .x(s2_y), .neg(s2_neg_y),
    .low(s2_y_low), .high(s2_y_high), .plane(s2_y_plane), .beyond(s2_y_beyond), .even(s2_y_even)
  );
  wire [2*LEVELS:0] s2_address;  // level 0 first, the root last [words]
  relief_height_address #(.LEVELS(LEVELS), .LATENCY(0), .VARIANT(32'h23add022)) u_address (
    .level(s2_level), .i(s2_x[LEVELS-1:0]), .j(s2_y[LEVELS-1:0]),
    .address(s2_address)
  );

  // ---- stage 2: end of the ray --------------------------------------------------------
  // A finished ray takes no more steps. One that ends without a hit is given up, in simulation also
  // one whose hit is unknown (x).
  wire        s2_moves = ~s2_done;
  wire [15:0] s2_steps_next = s2_steps + {15'd0, s2_moves};
  wire        s2_last_step = s2_steps == StepLimitLess1[15:0];

  // ---- stage 3: registers -------------------------------------------------------------
  reg [IdxW-1:0]   s3_x_plane;
  reg [IdxW-1:0]   s3_y_plane;
  reg [2*LEVELS:0] s3_address;
  always @(posedge clk) begin
    s3_x_plane <= s2_x_plane;
    s3_y_plane <= s2_y_plane;
    s3_address <= s2_address;
  end
  // Delay of 2 clocks: stage 1 to 3.
  reg [FloatW-1:0]   s3_p_x;
  reg [FloatW-1:0]   s3_r_x;
  reg                s3_never_x;
  reg [FloatW-1:0]   s3_p_y;
  reg [FloatW-1:0]   s3_r_y;
  reg                s3_never_y;
  reg [4*FloatW+1:0] s1_to_s3;
  always @(posedge clk) begin
    {s3_p_x, s3_r_x, s3_never_x, s3_p_y, s3_r_y, s3_never_y, s1_to_s3} <=
        {s1_to_s3, s1_p_x, s1_r_x, s1_never_x, s1_p_y, s1_r_y, s1_never_y};
  end

  // ---- stage 3: height ----------------------------------------------------------------
  wire [HEIGHT_W-1:0] s5_height;  // highest code in the node [height codes]
  relief_height_banks #(
    .ADDR_W(2 * LEVELS + 1), .DATA_W(HEIGHT_W), .DEPTH(((1 << (2 * LEVELS + 2)) - 1) / 3),
    .BANK_W(13), .MEM_INIT(MEM_INIT)
  ) u_heights (
    .clk(clk), .write_en(load_en), .write_addr(load_addr), .write_data(load_data),
    .read_addr(s3_address),
    .read_data(s5_height)
  );

  // ---- stage 3: plane parameters ------------------------------------------------------
  wire [FloatW-1:0] s11_t_x;  // infinity if never [float, height codes]
  relief_plane_time #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .IDX_W(IdxW), .LATENCY(8), .VARIANT(32'h29588866)
  ) u_time_x (
    .clk(clk), .ce(1'b1), .plane(s3_x_plane), .p(s3_p_x), .r(s3_r_x), .never(s3_never_x),
    .t(s11_t_x)
  );
  wire [FloatW-1:0] s11_t_y;  // infinity if never [float, height codes]
  relief_plane_time #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .IDX_W(IdxW), .LATENCY(8), .VARIANT(32'h29588866)
  ) u_time_y (
    .clk(clk), .ce(1'b1), .plane(s3_y_plane), .p(s3_p_y), .r(s3_r_y), .never(s3_never_y),
    .t(s11_t_y)
  );

  // ---- stage 6: registers -------------------------------------------------------------
  reg [HEIGHT_W-1:0] s6_height;
  always @(posedge clk) begin
    s6_height <= s5_height;
  end
  // Delay of 5 clocks: stage 1 to 6.
  reg [FloatW-1:0]   s6_t;
  reg [4*FloatW-1:0] s1_to_s6;
  always @(posedge clk) begin
    {s6_t, s1_to_s6} <= {s1_to_s6, s1_t};
  end

  // ---- stage 6: height test -----------------------------------------------------------
  // the larger of t and the height plane's parameter [float, height codes]
  wire [FloatW-1:0] s10_m;
  // the ray is below the node's height already: a hit would be on a wall
  wire              s10_below;
  relief_height_test #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .HEIGHT_W(HEIGHT_W), .LATENCY(4), .VARIANT(32'h16a2e6ca)
  ) u_height_test (
    .clk(clk), .ce(1'b1), .height(s6_height), .t(s6_t),
    .m(s10_m), .below(s10_below)
  );

  // ---- stage 10: registers ------------------------------------------------------------
  // Delay of 9 clocks: stage 1 to 10.
  reg [FloatW-1:0]    s10_pb_x;
  reg [FloatW-1:0]    s10_d_x;
  reg [FloatW-1:0]    s10_pb_y;
  reg [FloatW-1:0]    s10_d_y;
  reg [32*FloatW-1:0] s1_to_s10;
  always @(posedge clk) begin
    {s10_pb_x, s10_d_x, s10_pb_y, s10_d_y, s1_to_s10} <=
        {s1_to_s10, s1_pb_x, s1_d_x, s1_pb_y, s1_d_y};
  end

  // ---- stage 10: predicted hit --------------------------------------------------------
  wire [IdxW-1:0] s17_x_hit;  // signed coordinate [texels]
  relief_predicted_hit #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .IDX_W(IdxW), .LATENCY(7), .VARIANT(32'h2e32196a)
  ) u_predict_x (
    .clk(clk), .ce(1'b1), .p_back(s10_pb_x), .d(s10_d_x), .m(s10_m),
    .e(s17_x_hit)
  );
  wire [IdxW-1:0] s17_y_hit;  // signed coordinate [texels]
  relief_predicted_hit #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .IDX_W(IdxW), .LATENCY(7), .VARIANT(32'h2e32196a)
  ) u_predict_y (
    .clk(clk), .ce(1'b1), .p_back(s10_pb_y), .d(s10_d_y), .m(s10_m),
    .e(s17_y_hit)
  );

  // ---- stage 11: registers ------------------------------------------------------------
  reg [FloatW-1:0] s11_m;
  always @(posedge clk) begin
    s11_m <= s10_m;
  end
  // Delay of 5 clocks: stage 6 to 11.
  reg [FloatW-1:0]   s11_t;
  reg [4*FloatW-1:0] s6_to_s11;
  always @(posedge clk) begin
    {s11_t, s6_to_s11} <= {s6_to_s11, s6_t};
  end

  // ---- stage 11: node crossing --------------------------------------------------------
  wire              s13_is_inside;  // the height is met before the ray leaves
  wire              s13_x_first;    // the x plane comes first, or both at once
  // parameter after a crossing: that of the exit plane, at least t [float, height codes]
  wire [FloatW-1:0] s13_t_next;
  relief_node_crossing #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .LATENCY(2), .VARIANT(32'h243bf875)
  ) u_crossing (
    .clk(clk), .ce(1'b1), .t(s11_t), .m(s11_m), .t_x(s11_t_x), .t_y(s11_t_y),
    .is_inside(s13_is_inside), .x_first(s13_x_first), .t_next(s13_t_next)
  );

  // ---- stage 13: registers ------------------------------------------------------------
  // Delay of 11 clocks: stage 2 to 13.
  reg        s13_x_even;
  reg        s13_y_even;
  reg [19:0] s2_to_s13;
  always @(posedge clk) begin
    {s13_x_even, s13_y_even, s2_to_s13} <= {s2_to_s13, s2_x_even, s2_y_even};
  end

  // ---- stage 13: level up -------------------------------------------------------------
  wire s13_even = s13_x_first ? s13_x_even : s13_y_even;

  // ---- stage 17: registers ------------------------------------------------------------
  // Delay of 16 clocks: stage 1 to 17.
  reg        s17_has_crossed;
  reg [14:0] s1_to_s17;
  always @(posedge clk) begin
    {s17_has_crossed, s1_to_s17} <= {s1_to_s17, s1_has_crossed};
  end
  // Delay of 15 clocks: stage 2 to 17.
  reg [IdxW-1:0]              s17_x_low;
  reg [IdxW-1:0]              s17_x_high;
  reg [IdxW-1:0]              s17_y_low;
  reg [IdxW-1:0]              s17_y_high;
  reg [LevelW-1:0]            s17_level;
  reg [IdxW-1:0]              s17_x;
  reg [IdxW-1:0]              s17_y;
  reg [84*IdxW+14*LevelW-1:0] s2_to_s17;
  always @(posedge clk) begin
    {s17_x_low, s17_x_high, s17_y_low, s17_y_high, s17_level, s17_x, s17_y, s2_to_s17} <=
        {s2_to_s17, s2_x_low, s2_x_high, s2_y_low, s2_y_high, s2_level, s2_x, s2_y};
  end
  // Delay of 4 clocks: stage 13 to 17.
  reg       s17_even;
  reg [2:0] s13_to_s17;
  always @(posedge clk) begin
    {s17_even, s13_to_s17} <= {s13_to_s17, s13_even};
  end

  // ---- stage 17: multi-level down -----------------------------------------------------
  wire [LevelW-1:0] s17_level_down;  // level after the descent [levels]
  wire [IdxW-1:0]   s17_x_down;      // predicted hit, kept between low and high [texels]
  wire [IdxW-1:0]   s17_y_down;      // predicted hit, kept between low and high [texels]
  relief_multi_level_down #(
    .LEVELS(LEVELS), .IDX_W(IdxW), .LATENCY(0), .VARIANT(32'h44b45e20)
  ) u_down (
    .level(s17_level), .crossed(s17_has_crossed), .x_low(s17_x_low), .x_high(s17_x_high),
    .x_hit(s17_x_hit), .y_low(s17_y_low), .y_high(s17_y_high), .y_hit(s17_y_hit),
    .level_down(s17_level_down), .x_down(s17_x_down), .y_down(s17_y_down)
  );

  // ---- stage 17: level up -------------------------------------------------------------
  wire s17_up;  // one level up; never at the root
  relief_level_up #(.LEVELS(LEVELS), .IDX_W(IdxW), .LATENCY(0), .VARIANT(32'h63e9f1ef)) u_up (
    .level(s17_level), .even(s17_even), .x_at(s17_x), .x_hit(s17_x_hit), .y_at(s17_y),
    .y_hit(s17_y_hit),
    .up(s17_up)
  );

  // ---- stage 18: registers ------------------------------------------------------------
  reg              s18_up;
  reg [LevelW-1:0] s18_level_down;
  reg [IdxW-1:0]   s18_x_down;
  reg [IdxW-1:0]   s18_y_down;
  reg [LevelW-1:0] s18_level;
  reg [IdxW-1:0]   s18_x;
  reg [IdxW-1:0]   s18_y;
  reg              s18_has_crossed;
  always @(posedge clk) begin
    s18_up          <= s17_up;
    s18_level_down  <= s17_level_down;
    s18_x_down      <= s17_x_down;
    s18_y_down      <= s17_y_down;
    s18_level       <= s17_level;
    s18_x           <= s17_x;
    s18_y           <= s17_y;
    s18_has_crossed <= s17_has_crossed;
  end
  // Delay of 18 clocks: stage 0 to 18.
  reg        s18_valid;
  reg [16:0] s0_to_s18_valid;
  always @(posedge clk) begin
    if (rst) begin
      {s18_valid, s0_to_s18_valid} <= 18'd0;
    end else begin
      {s18_valid, s0_to_s18_valid} <= {s0_to_s18_valid, s0_slot_busy};
    end
  end
  // Delay of 17 clocks: stage 1 to 18.
  reg [TAG_W-1:0]      s18_tag;
  reg                  s18_wall;
  reg                  s18_limit;
  reg [15:0]           s18_crossings;
  reg [15:0]           s18_ups;
  reg [16*TAG_W+543:0] s1_to_s18;
  always @(posedge clk) begin
    {s18_tag, s18_wall, s18_limit, s18_crossings, s18_ups, s1_to_s18} <=
        {s1_to_s18, s1_tag, s1_wall, s1_limit, s1_crossings, s1_ups};
  end
  // Delay of 16 clocks: stage 2 to 18.
  reg [IdxW-1:0]      s18_x_beyond;
  reg [IdxW-1:0]      s18_y_beyond;
  reg                 s18_last_step;
  reg                 s18_moves;
  reg                 s18_done;
  reg                 s18_neg_x;
  reg                 s18_neg_y;
  reg [15:0]          s18_steps_next;
  reg [30*IdxW+314:0] s2_to_s18;
  always @(posedge clk) begin
    {s18_x_beyond, s18_y_beyond, s18_last_step, s18_moves, s18_done, s18_neg_x, s18_neg_y,
     s18_steps_next, s2_to_s18} <=
        {s2_to_s18, s2_x_beyond, s2_y_beyond, s2_last_step, s2_moves, s2_done, s2_neg_x, s2_neg_y,
         s2_steps_next};
  end
  // Delay of 15 clocks: stage 3 to 18.
  reg [FloatW-1:0]     s18_p_x;
  reg [FloatW-1:0]     s18_r_x;
  reg                  s18_never_x;
  reg [FloatW-1:0]     s18_p_y;
  reg [FloatW-1:0]     s18_r_y;
  reg                  s18_never_y;
  reg [56*FloatW+27:0] s3_to_s18;
  always @(posedge clk) begin
    {s18_p_x, s18_r_x, s18_never_x, s18_p_y, s18_r_y, s18_never_y, s3_to_s18} <=
        {s3_to_s18, s3_p_x, s3_r_x, s3_never_x, s3_p_y, s3_r_y, s3_never_y};
  end
  // Delay of 8 clocks: stage 10 to 18.
  reg                 s18_below;
  reg [FloatW-1:0]    s18_pb_x;
  reg [FloatW-1:0]    s18_d_x;
  reg [FloatW-1:0]    s18_pb_y;
  reg [FloatW-1:0]    s18_d_y;
  reg [28*FloatW+6:0] s10_to_s18;
  always @(posedge clk) begin
    {s18_below, s18_pb_x, s18_d_x, s18_pb_y, s18_d_y, s10_to_s18} <=
        {s10_to_s18, s10_below, s10_pb_x, s10_d_x, s10_pb_y, s10_d_y};
  end
  // Delay of 7 clocks: stage 11 to 18.
  reg [FloatW-1:0]    s18_m;
  reg [FloatW-1:0]    s18_t;
  reg [12*FloatW-1:0] s11_to_s18;
  always @(posedge clk) begin
    {s18_m, s18_t, s11_to_s18} <= {s11_to_s18, s11_m, s11_t};
  end
  // Delay of 5 clocks: stage 13 to 18.
  reg                s18_is_inside;
  reg                s18_x_first;
  reg [FloatW-1:0]   s18_t_next;
  reg [4*FloatW+7:0] s13_to_s18;
  always @(posedge clk) begin
    {s18_is_inside, s18_x_first, s18_t_next, s13_to_s18} <=
        {s13_to_s18, s13_is_inside, s13_x_first, s13_t_next};
  end

  // ---- stage 18: level decision -------------------------------------------------------
  wire              s18_hit;         // the ray ends here
  wire              s18_crosses;     // the ray goes to the neighbour
  wire [LevelW-1:0] s18_level_next;  // level of the next iteration [levels]
  wire [IdxW-1:0]   s18_x_next;      // texel of the next node [texels]
  wire [IdxW-1:0]   s18_y_next;      // texel of the next node [texels]
  // parameter of the next iteration, or of the hit [float, height codes]
  wire [FloatW-1:0] s18_t_after;
  relief_level_decision #(
    .EXP_W(EXP_W), .MAN_W(MAN_W), .LEVELS(LEVELS), .IDX_W(IdxW), .LATENCY(0), .VARIANT(32'h4ae3ce84)
  ) u_decision (
    .is_inside(s18_is_inside), .x_first(s18_x_first), .up(s18_up), .level(s18_level),
    .level_down(s18_level_down), .m(s18_m), .t_next(s18_t_next), .x_at(s18_x), .x_down(s18_x_down),
    .x_beyond(s18_x_beyond), .y_at(s18_y), .y_down(s18_y_down), .y_beyond(s18_y_beyond),
    .hit(s18_hit), .crosses(s18_crosses), .level_next(s18_level_next), .x_next(s18_x_next),
    .y_next(s18_y_next), .t_out(s18_t_after)
  );

  // ---- stage 18: end of the ray -------------------------------------------------------
  // A finished ray takes no more steps. One that ends without a hit is given up, in simulation also
  // one whose hit is unknown (x).
  wire s18_ends_now = s18_hit | s18_last_step;
  wire s18_given_up = s18_ends_now & ~s18_hit & s18_moves;
  wire s18_crossed_now = s18_crosses & s18_moves;
  wire s18_up_now = s18_up & s18_crossed_now;

  // ---- state registers ----------------------------------------------------------------
  always @(posedge clk) begin
    s0_loop_tag_q       <= s18_tag;
    s0_loop_p_x_q       <= s18_p_x;
    s0_loop_pb_x_q      <= s18_pb_x;
    s0_loop_d_x_q       <= s18_d_x;
    s0_loop_r_x_q       <= s18_r_x;
    s0_loop_never_x_q   <= s18_never_x;
    s0_loop_neg_x_q     <= s18_neg_x;
    s0_loop_p_y_q       <= s18_p_y;
    s0_loop_pb_y_q      <= s18_pb_y;
    s0_loop_d_y_q       <= s18_d_y;
    s0_loop_r_y_q       <= s18_r_y;
    s0_loop_never_y_q   <= s18_never_y;
    s0_loop_neg_y_q     <= s18_neg_y;
    s0_loop_level_q     <= s18_done ? s18_level : s18_level_next;
    s0_loop_x_q         <= s18_done ? s18_x : s18_x_next;
    s0_loop_y_q         <= s18_done ? s18_y : s18_y_next;
    s0_loop_t_q         <= s18_done ? s18_t : s18_t_after;
    s0_loop_wall_q      <= s18_done ? s18_wall : (s18_hit & s18_below);
    s0_loop_steps_q     <= s18_steps_next;
    s0_loop_crossings_q <= s18_crossings + {15'd0, s18_crossed_now};
    s0_loop_ups_q       <= s18_ups + {15'd0, s18_up_now};
    s0_loop_crossed_q   <= s18_has_crossed | s18_crossed_now;
  end
  always @(posedge clk) begin
    if (rst) begin
      s0_loop_valid_q    <= 1'b0;
      s0_in_transfer_q   <= 1'b0;
      s0_out_transfer_q  <= 1'b0;
      s0_in_flight_q     <= 7'd0;
      s0_any_in_flight_q <= 1'b0;
    end else begin
      s0_loop_valid_q    <= s18_valid;
      s0_in_transfer_q   <= s0_in_transfer;
      s0_out_transfer_q  <= out_transfer;
      s0_in_flight_q     <= s0_in_flight_next;
      s0_any_in_flight_q <= s0_any_in_flight_next;
    end
  end
  // In simulation an unknown bit (x) counts as 1, so that no x reaches a handshake.
  always @(posedge clk) begin
    if (!(s18_done | s18_ends_now)) begin
      s0_loop_done_q <= 1'b0;
    end else begin
      s0_loop_done_q <= 1'b1;
    end
  end
  // In simulation an unknown bit (x) counts as 1, so that no x reaches a handshake.
  always @(posedge clk) begin
    if (!(s18_limit | s18_given_up)) begin
      s0_loop_limit_q <= 1'b0;
    end else begin
      s0_loop_limit_q <= 1'b1;
    end
  end

  assign in_ready = setup_ready;
  assign slot_busy = s0_slot_busy;
  assign idle = s0_is_idle;
  assign out_valid = hit_valid;
  assign out_tag = result_tag;
  assign out_i = result_i;
  assign out_j = result_j;
  assign out_fu = result_fu;
  assign out_fv = result_fv;
  assign out_t = result_t;
  assign out_wall = result_wall;
  assign out_limit = result_limit;
  assign out_steps = result_steps;
  assign out_crossings = result_crossings;
  assign out_ups = result_ups;
endmodule
`ifndef YOSYS
`default_nettype wire
`endif
