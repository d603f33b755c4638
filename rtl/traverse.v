// traverse: traces rays against a height field: a looping pipeline, one node a clock
// Source     src/units/traversal/traverse.rs (emitted: do not edit)
// Config     float 7/16, levels 8, heights 8 bits, start level, 2 down, up selective; clocks add 2
//            mul 1 div 2 compare 1 from_int 1 to_int 1
// Latency    varies; valid/ready on both sides
// Throughput one iteration (one node) per clock; a ray takes as many iterations as its path needs
// Note       Float: sign, EXP_W exponent bits of bias 2^(EXP_W-1)-1, MAN_W fraction bits. Exponent
//            0 reads as zero of its sign; results below the smallest normal, after rounding, become
//            zero of their sign; exponent all ones is infinity (fraction 0) or NaN (one NaN comes
//            out); nearest, ties to even; x - x is +0.
`default_nettype none
module traverse #(
  parameter integer EXP_W      = 7,      // exponent bits
  parameter integer MAN_W      = 16,     // fraction bits, the hidden one not counted
  parameter integer LEVELS     = 8,      // the map has 2^LEVELS x 2^LEVELS texels
  parameter integer HEIGHT_W   = 8,      // bits of a height code
  parameter integer TILE_W     = 4,      // a ray travels less than 2^TILE_W tiles along each axis
  parameter integer FRAC_W     = 12,     // fraction bits of the hit position
  parameter integer TAG_W      = 8,      // bits of a ray's tag
  parameter integer STEP_LIMIT = 65535   // iterations after which a ray is given up
) (
  input  wire                 clk,            // rising edge
  // synchronous, active high; clears valid bits and counts, no data
  input  wire                 rst,
  // write a word of the pyramid (while no ray is inside)
  input  wire                 load_en,
  input  wire [2*LEVELS:0]    load_addr,      // where: level 0 first, the root last [words]
  input  wire [HEIGHT_W-1:0]  load_data,      // largest height in that node [height codes]
  input  wire                 in_valid,       // a ray is offered
  output wire                 in_ready,       // it is taken at the next edge
  input  wire [TAG_W-1:0]     in_tag,         // comes back with the result [bits]
  // entry point at the top plane, 0 <= u < 1 [float, tiles]
  input  wire [EXP_W+MAN_W:0] in_u,
  // entry point at the top plane, 0 <= v < 1 [float, tiles]
  input  wire [EXP_W+MAN_W:0] in_v,
  // u travelled while the height falls from 1 to 0 [float, tiles]
  input  wire [EXP_W+MAN_W:0] in_du,
  // v travelled while the height falls from 1 to 0 [float, tiles]
  input  wire [EXP_W+MAN_W:0] in_dv,
  output wire                 out_valid,      // a result is offered
  input  wire                 out_ready,      // it is taken at the next edge
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
  output wire [15:0]          out_crossings,  // of these, node crossings [iterations]
  output wire [15:0]          out_ups,        // levels gone up [levels]
  // the slot that starts now holds a ray: counts the loop's load
  output wire                 slot_busy
);
  localparam integer FloatW = EXP_W + MAN_W + 1;
  localparam integer LevelW = $clog2(LEVELS + 1);
  localparam integer IdxW = LEVELS + TILE_W + 2;
  localparam integer StepsBeforeLast = STEP_LIMIT - 1;

  // Illegal parameters end elaboration here: the missing module's name says what must hold.
  generate
    if (2 > EXP_W) begin : gen_illegal_0
      must_hold_2_at_most_EXP_W u_illegal ();
    end
    if (EXP_W > 11) begin : gen_illegal_1
      must_hold_EXP_W_at_most_11 u_illegal ();
    end
    if (7 > MAN_W) begin : gen_illegal_2
      must_hold_7_at_most_MAN_W u_illegal ();
    end
    if (MAN_W > 28) begin : gen_illegal_3
      must_hold_MAN_W_at_most_28 u_illegal ();
    end
    if (2 > LEVELS) begin : gen_illegal_4
      must_hold_2_at_most_LEVELS u_illegal ();
    end
    if (LEVELS > 12) begin : gen_illegal_5
      must_hold_LEVELS_at_most_12 u_illegal ();
    end
    if (2 > HEIGHT_W) begin : gen_illegal_6
      must_hold_2_at_most_HEIGHT_W u_illegal ();
    end
    if (HEIGHT_W > 16) begin : gen_illegal_7
      must_hold_HEIGHT_W_at_most_16 u_illegal ();
    end
    if (HEIGHT_W > MAN_W + 1) begin : gen_illegal_8
      must_hold_HEIGHT_W_at_most_MAN_W_plus_1 u_illegal ();
    end
    if (1 > TILE_W) begin : gen_illegal_9
      must_hold_1_at_most_TILE_W u_illegal ();
    end
    if (TILE_W > 8) begin : gen_illegal_10
      must_hold_TILE_W_at_most_8 u_illegal ();
    end
    if (LEVELS + TILE_W + 2 > 24) begin : gen_illegal_11
      must_hold_LEVELS_plus_TILE_W_plus_2_at_most_24 u_illegal ();
    end
    if (LEVELS + TILE_W + 1 > (1 << (EXP_W - 1)) - 1) begin : gen_illegal_12
      must_hold_LEVELS_plus_TILE_W_plus_1_at_most_2_to_the_EXP_W_minus_1_minus_1 u_illegal ();
    end
    if (HEIGHT_W + 2 > (1 << (EXP_W - 1)) - 1) begin : gen_illegal_13
      must_hold_HEIGHT_W_plus_2_at_most_2_to_the_EXP_W_minus_1_minus_1 u_illegal ();
    end
    if (MAN_W > LEVELS + (1 << (EXP_W - 1)) - 1) begin : gen_illegal_14
      must_hold_MAN_W_at_most_LEVELS_plus_2_to_the_EXP_W_minus_1_minus_1 u_illegal ();
    end
    if (1 > FRAC_W) begin : gen_illegal_15
      must_hold_1_at_most_FRAC_W u_illegal ();
    end
    if (FRAC_W > 16) begin : gen_illegal_16
      must_hold_FRAC_W_at_most_16 u_illegal ();
    end
    if (1 > TAG_W) begin : gen_illegal_17
      must_hold_1_at_most_TAG_W u_illegal ();
    end
    if (TAG_W > 32) begin : gen_illegal_18
      must_hold_TAG_W_at_most_32 u_illegal ();
    end
    if (1 > STEP_LIMIT) begin : gen_illegal_19
      must_hold_1_at_most_STEP_LIMIT u_illegal ();
    end
    if (STEP_LIMIT > 65535) begin : gen_illegal_20
      must_hold_STEP_LIMIT_at_most_65535 u_illegal ();
    end
    if (FRAC_W + LEVELS + MAN_W + TILE_W + 2 > 60) begin : gen_illegal_21
      must_hold_FRAC_W_plus_LEVELS_plus_MAN_W_plus_TILE_W_plus_2_at_most_60 u_illegal ();
    end
  endgenerate

  // ---- state that comes back from the last stage, and handshakes
  reg              s0_back_valid;
  reg [TAG_W-1:0]  s0_back_tag;
  reg [FloatW-1:0] s0_back_p_x;
  reg [FloatW-1:0] s0_back_pb_x;
  reg [FloatW-1:0] s0_back_d_x;
  reg [FloatW-1:0] s0_back_r_x;
  reg              s0_back_never_x;
  reg              s0_back_neg_x;
  reg [FloatW-1:0] s0_back_p_y;
  reg [FloatW-1:0] s0_back_pb_y;
  reg [FloatW-1:0] s0_back_d_y;
  reg [FloatW-1:0] s0_back_r_y;
  reg              s0_back_never_y;
  reg              s0_back_neg_y;
  reg [LevelW-1:0] s0_back_level;
  reg [IdxW-1:0]   s0_back_x;
  reg [IdxW-1:0]   s0_back_y;
  reg [FloatW-1:0] s0_back_t;
  reg              s0_back_done;
  reg              s0_back_wall;
  reg              s0_back_limit;
  reg [15:0]       s0_back_steps;
  reg [15:0]       s0_back_crossings;
  reg [15:0]       s0_back_ups;
  reg              s0_back_crossed;
  wire hit_valid;
  wire setup_valid;

  // ---- stage 0: leave ----------------------------------------------------- traverse.rs
  // A ray that is done leaves when the output pipeline moves.
  wire hit_ce = ~hit_valid | out_ready;
  wire s0_leaves = s0_back_valid & s0_back_done & hit_ce;
  wire s0_is_free = ~s0_back_valid | s0_leaves;

  // ---- stage 0: set up ---------------------------------------------------- traverse.rs
  // The setup pipeline holds while its ray finds no free slot.
  wire              setup_ce = ~setup_valid | s0_is_free;
  wire              s0_new_ok;
  wire [LevelW-1:0] s0_new_level;
  wire [FloatW-1:0] s0_new_p_x;
  wire [FloatW-1:0] s0_new_pb_x;
  wire [FloatW-1:0] s0_new_d_x;
  wire [FloatW-1:0] s0_new_r_x;
  wire              s0_new_never_x;
  wire              s0_new_neg_x;
  wire [IdxW-1:0]   s0_new_first_x;
  wire [FloatW-1:0] s0_new_p_y;
  wire [FloatW-1:0] s0_new_pb_y;
  wire [FloatW-1:0] s0_new_d_y;
  wire [FloatW-1:0] s0_new_r_y;
  wire              s0_new_never_y;
  wire              s0_new_neg_y;
  wire [IdxW-1:0]   s0_new_first_y;
  ray_setup #(
    .EXP_W   (EXP_W),
    .MAN_W   (MAN_W),
    .LEVELS  (LEVELS),
    .HEIGHT_W(HEIGHT_W),
    .TILE_W  (TILE_W)
  ) u_setup (
    .clk    (clk),
    .ce     (setup_ce),
    .u      (in_u),
    .v      (in_v),
    .du     (in_du),
    .dv     (in_dv),
    .ok     (s0_new_ok),
    .level  (s0_new_level),
    .p_x    (s0_new_p_x),
    .pb_x   (s0_new_pb_x),
    .d_x    (s0_new_d_x),
    .r_x    (s0_new_r_x),
    .never_x(s0_new_never_x),
    .neg_x  (s0_new_neg_x),
    .first_x(s0_new_first_x),
    .p_y    (s0_new_p_y),
    .pb_y   (s0_new_pb_y),
    .d_y    (s0_new_d_y),
    .r_y    (s0_new_r_y),
    .never_y(s0_new_never_y),
    .neg_y  (s0_new_neg_y),
    .first_y(s0_new_first_y)
  );
  wire             s0_setup_tracked;
  wire [TAG_W-1:0] s0_new_tag;
  setup_delay #(.W(TAG_W)) u_setup_delay (
    .clk      (clk),
    .ce       (setup_ce),
    .rst      (rst),
    .in_valid (in_valid),
    .out_valid(s0_setup_tracked),
    .in_data  (in_tag),
    .out_data (s0_new_tag)
  );
  wire s0_admits = setup_valid & s0_is_free;

  // ---- stage 0: slot ------------------------------------------------------ traverse.rs
  // The new ray, or the one that comes back.
  wire              s0_new_refused = ~s0_new_ok;
  wire              s0_valid = (s0_back_valid & ~s0_leaves) | s0_admits;
  wire [TAG_W-1:0]  s0_tag = s0_admits ? s0_new_tag : s0_back_tag;
  wire [FloatW-1:0] s0_p_x = s0_admits ? s0_new_p_x : s0_back_p_x;
  wire [FloatW-1:0] s0_pb_x = s0_admits ? s0_new_pb_x : s0_back_pb_x;
  wire [FloatW-1:0] s0_d_x = s0_admits ? s0_new_d_x : s0_back_d_x;
  wire [FloatW-1:0] s0_r_x = s0_admits ? s0_new_r_x : s0_back_r_x;
  wire              s0_never_x = s0_admits ? s0_new_never_x : s0_back_never_x;
  wire              s0_neg_x = s0_admits ? s0_new_neg_x : s0_back_neg_x;
  wire [FloatW-1:0] s0_p_y = s0_admits ? s0_new_p_y : s0_back_p_y;
  wire [FloatW-1:0] s0_pb_y = s0_admits ? s0_new_pb_y : s0_back_pb_y;
  wire [FloatW-1:0] s0_d_y = s0_admits ? s0_new_d_y : s0_back_d_y;
  wire [FloatW-1:0] s0_r_y = s0_admits ? s0_new_r_y : s0_back_r_y;
  wire              s0_never_y = s0_admits ? s0_new_never_y : s0_back_never_y;
  wire              s0_neg_y = s0_admits ? s0_new_neg_y : s0_back_neg_y;
  wire [LevelW-1:0] s0_level = s0_admits ? s0_new_level : s0_back_level;
  wire [IdxW-1:0]   s0_x = s0_admits ? s0_new_first_x : s0_back_x;
  wire [IdxW-1:0]   s0_y = s0_admits ? s0_new_first_y : s0_back_y;
  wire [FloatW-1:0] s0_t = s0_admits ? {FloatW{1'b0}} : s0_back_t;
  wire              s0_done = s0_admits ? s0_new_refused : s0_back_done;
  wire              s0_wall = s0_admits ? 1'b0 : s0_back_wall;
  wire              s0_limit = s0_admits ? s0_new_refused : s0_back_limit;
  wire [15:0]       s0_steps = s0_admits ? 16'd0 : s0_back_steps;
  wire [15:0]       s0_crossings = s0_admits ? 16'd0 : s0_back_crossings;
  wire [15:0]       s0_ups = s0_admits ? 16'd0 : s0_back_ups;
  wire              s0_has_crossed = s0_admits ? 1'b0 : s0_back_crossed;

  // ---- stage 0: node ------------------------------------------------------ traverse.rs
  // Extent and exit planes of the node, and its place in memory.
  wire [IdxW-1:0] s0_x_low;
  wire [IdxW-1:0] s0_x_high;
  wire [IdxW-1:0] s0_x_plane;
  wire [IdxW-1:0] s0_x_beyond;
  wire            s0_x_even;
  node_planes #(.LEVELS(LEVELS), .IDX_W(IdxW)) u_planes_x (
    .level (s0_level),
    .x     (s0_x),
    .neg   (s0_neg_x),
    .low   (s0_x_low),
    .high  (s0_x_high),
    .plane (s0_x_plane),
    .beyond(s0_x_beyond),
    .even  (s0_x_even)
  );
  wire [IdxW-1:0] s0_y_low;
  wire [IdxW-1:0] s0_y_high;
  wire [IdxW-1:0] s0_y_plane;
  wire [IdxW-1:0] s0_y_beyond;
  wire            s0_y_even;
  node_planes #(.LEVELS(LEVELS), .IDX_W(IdxW)) u_planes_y (
    .level (s0_level),
    .x     (s0_y),
    .neg   (s0_neg_y),
    .low   (s0_y_low),
    .high  (s0_y_high),
    .plane (s0_y_plane),
    .beyond(s0_y_beyond),
    .even  (s0_y_even)
  );
  wire [2*LEVELS:0] s0_address;
  height_address #(.LEVELS(LEVELS)) u_address (
    .level  (s0_level),
    .i      (s0_x[LEVELS-1:0]),
    .j      (s0_y[LEVELS-1:0]),
    .address(s0_address)
  );

  // ---- stage 0: height ---------------------------------------------------- traverse.rs
  wire [HEIGHT_W-1:0] s1_height;
  height_memory #(
    .ADDR_W(2 * LEVELS + 1),
    .DATA_W(HEIGHT_W),
    .DEPTH (((1 << (2 * LEVELS + 2)) - 1) / 3)
  ) u_heights (
    .clk       (clk),
    .write_en  (load_en),
    .write_addr(load_addr),
    .write_data(load_data),
    .read_addr (s0_address),
    .read_data (s1_height)
  );

  // ---- stage 0: plane parameters ------------------------------------------ traverse.rs
  wire [FloatW-1:0] s4_t_x;
  plane_time #(.EXP_W(EXP_W), .MAN_W(MAN_W), .IDX_W(IdxW)) u_time_x (
    .clk  (clk),
    .ce   (1'b1),
    .plane(s0_x_plane),
    .p    (s0_p_x),
    .r    (s0_r_x),
    .never(s0_never_x),
    .t    (s4_t_x)
  );
  wire [FloatW-1:0] s4_t_y;
  plane_time #(.EXP_W(EXP_W), .MAN_W(MAN_W), .IDX_W(IdxW)) u_time_y (
    .clk  (clk),
    .ce   (1'b1),
    .plane(s0_y_plane),
    .p    (s0_p_y),
    .r    (s0_r_y),
    .never(s0_never_y),
    .t    (s4_t_y)
  );

  // ---- stage 0: step limit ------------------------------------------------ traverse.rs
  // A ray that is done takes no more steps.
  wire        s0_moves = ~s0_done;
  wire [15:0] s0_steps_next = s0_steps + {15'd0, s0_moves};
  wire        s0_last_step = s0_steps == StepsBeforeLast[15:0];

  // ---- stage 0: result ---------------------------------------------------- traverse.rs
  // The ray that leaves, from the state registers.
  wire [FRAC_W-1:0] hit_fu;
  hit_position #(.EXP_W(EXP_W), .MAN_W(MAN_W), .IDX_W(IdxW), .FRAC_W(FRAC_W)) u_hit_u (
    .clk     (clk),
    .ce      (hit_ce),
    .p       (s0_back_p_x),
    .d       (s0_back_d_x),
    .t       (s0_back_t),
    .x       (s0_back_x),
    .fraction(hit_fu)
  );
  wire [FRAC_W-1:0] hit_fv;
  hit_position #(.EXP_W(EXP_W), .MAN_W(MAN_W), .IDX_W(IdxW), .FRAC_W(FRAC_W)) u_hit_v (
    .clk     (clk),
    .ce      (hit_ce),
    .p       (s0_back_p_y),
    .d       (s0_back_d_y),
    .t       (s0_back_t),
    .x       (s0_back_y),
    .fraction(hit_fv)
  );
  wire [TAG_W-1:0] hit_tag;
  hit_delay #(.W(TAG_W)) u_hit_tag (
    .clk     (clk),
    .ce      (hit_ce),
    .in_data (s0_back_tag),
    .out_data(hit_tag)
  );
  wire [LEVELS-1:0] hit_i;
  hit_delay #(.W(LEVELS)) u_hit_i (
    .clk     (clk),
    .ce      (hit_ce),
    .in_data (s0_back_x[LEVELS-1:0]),
    .out_data(hit_i)
  );
  wire [LEVELS-1:0] hit_j;
  hit_delay #(.W(LEVELS)) u_hit_j (
    .clk     (clk),
    .ce      (hit_ce),
    .in_data (s0_back_y[LEVELS-1:0]),
    .out_data(hit_j)
  );
  wire [FloatW-1:0] hit_t;
  hit_delay #(.W(FloatW)) u_hit_t (
    .clk     (clk),
    .ce      (hit_ce),
    .in_data (s0_back_t),
    .out_data(hit_t)
  );
  wire hit_wall;
  hit_delay #(.W(1)) u_hit_wall (
    .clk     (clk),
    .ce      (hit_ce),
    .in_data (s0_back_wall),
    .out_data(hit_wall)
  );
  wire hit_limit;
  hit_delay #(.W(1)) u_hit_limit (
    .clk     (clk),
    .ce      (hit_ce),
    .in_data (s0_back_limit),
    .out_data(hit_limit)
  );
  wire [15:0] hit_steps;
  hit_delay #(.W(16)) u_hit_steps (
    .clk     (clk),
    .ce      (hit_ce),
    .in_data (s0_back_steps),
    .out_data(hit_steps)
  );
  wire [15:0] hit_crossings;
  hit_delay #(.W(16)) u_hit_crossings (
    .clk     (clk),
    .ce      (hit_ce),
    .in_data (s0_back_crossings),
    .out_data(hit_crossings)
  );
  wire [15:0] hit_ups;
  hit_delay #(.W(16)) u_hit_ups (
    .clk     (clk),
    .ce      (hit_ce),
    .in_data (s0_back_ups),
    .out_data(hit_ups)
  );
  wire hit_tracked;
  hit_valid_delay u_hit_valid (
    .clk      (clk),
    .ce       (hit_ce),
    .rst      (rst),
    .in_valid (s0_leaves),
    .out_valid(hit_tracked)
  );

  // ---- stage 1: registers ------------------------------------------------- traverse.rs
  reg [FloatW-1:0] s1_t;
  reg [FloatW-1:0] s1_pb_x;
  reg [FloatW-1:0] s1_d_x;
  reg [FloatW-1:0] s1_pb_y;
  reg [FloatW-1:0] s1_d_y;
  reg [LevelW-1:0] s1_level;
  reg              s1_has_crossed;
  reg [IdxW-1:0]   s1_x_low;
  reg [IdxW-1:0]   s1_x_high;
  reg [IdxW-1:0]   s1_y_low;
  reg [IdxW-1:0]   s1_y_high;
  reg              s1_x_even;
  reg              s1_y_even;
  reg [IdxW-1:0]   s1_x;
  reg [IdxW-1:0]   s1_y;
  reg [IdxW-1:0]   s1_x_beyond;
  reg [IdxW-1:0]   s1_y_beyond;
  reg              s1_last_step;
  reg              s1_moves;
  reg              s1_done;
  reg              s1_wall;
  reg              s1_limit;
  reg [15:0]       s1_crossings;
  reg [15:0]       s1_ups;
  reg              s1_valid;
  reg [TAG_W-1:0]  s1_tag;
  reg [FloatW-1:0] s1_p_x;
  reg [FloatW-1:0] s1_r_x;
  reg              s1_never_x;
  reg              s1_neg_x;
  reg [FloatW-1:0] s1_p_y;
  reg [FloatW-1:0] s1_r_y;
  reg              s1_never_y;
  reg              s1_neg_y;
  reg [15:0]       s1_steps_next;
  always @(posedge clk) begin
    s1_t           <= s0_t;
    s1_pb_x        <= s0_pb_x;
    s1_d_x         <= s0_d_x;
    s1_pb_y        <= s0_pb_y;
    s1_d_y         <= s0_d_y;
    s1_level       <= s0_level;
    s1_has_crossed <= s0_has_crossed;
    s1_x_low       <= s0_x_low;
    s1_x_high      <= s0_x_high;
    s1_y_low       <= s0_y_low;
    s1_y_high      <= s0_y_high;
    s1_x_even      <= s0_x_even;
    s1_y_even      <= s0_y_even;
    s1_x           <= s0_x;
    s1_y           <= s0_y;
    s1_x_beyond    <= s0_x_beyond;
    s1_y_beyond    <= s0_y_beyond;
    s1_last_step   <= s0_last_step;
    s1_moves       <= s0_moves;
    s1_done        <= s0_done;
    s1_wall        <= s0_wall;
    s1_limit       <= s0_limit;
    s1_crossings   <= s0_crossings;
    s1_ups         <= s0_ups;
    s1_tag         <= s0_tag;
    s1_p_x         <= s0_p_x;
    s1_r_x         <= s0_r_x;
    s1_never_x     <= s0_never_x;
    s1_neg_x       <= s0_neg_x;
    s1_p_y         <= s0_p_y;
    s1_r_y         <= s0_r_y;
    s1_never_y     <= s0_never_y;
    s1_neg_y       <= s0_neg_y;
    s1_steps_next  <= s0_steps_next;
  end
  always @(posedge clk) begin
    if (rst) begin
      s1_valid <= 1'b0;
    end else begin
      s1_valid <= s0_valid;
    end
  end

  // ---- stage 1: height test ----------------------------------------------- traverse.rs
  wire [FloatW-1:0] s3_m;
  wire              s3_below;
  height_test #(.EXP_W(EXP_W), .MAN_W(MAN_W), .HEIGHT_W(HEIGHT_W)) u_height_test (
    .clk   (clk),
    .ce    (1'b1),
    .height(s1_height),
    .t     (s1_t),
    .m     (s3_m),
    .below (s3_below)
  );

  // ---- stage 2: registers ------------------------------------------------- traverse.rs
  reg [FloatW-1:0] s2_pb_x;
  reg [FloatW-1:0] s2_d_x;
  reg [FloatW-1:0] s2_pb_y;
  reg [FloatW-1:0] s2_d_y;
  reg [FloatW-1:0] s2_t;
  reg [LevelW-1:0] s2_level;
  reg              s2_has_crossed;
  reg [IdxW-1:0]   s2_x_low;
  reg [IdxW-1:0]   s2_x_high;
  reg [IdxW-1:0]   s2_y_low;
  reg [IdxW-1:0]   s2_y_high;
  reg              s2_x_even;
  reg              s2_y_even;
  reg [IdxW-1:0]   s2_x;
  reg [IdxW-1:0]   s2_y;
  reg [IdxW-1:0]   s2_x_beyond;
  reg [IdxW-1:0]   s2_y_beyond;
  reg              s2_last_step;
  reg              s2_moves;
  reg              s2_done;
  reg              s2_wall;
  reg              s2_limit;
  reg [15:0]       s2_crossings;
  reg [15:0]       s2_ups;
  reg              s2_valid;
  reg [TAG_W-1:0]  s2_tag;
  reg [FloatW-1:0] s2_p_x;
  reg [FloatW-1:0] s2_r_x;
  reg              s2_never_x;
  reg              s2_neg_x;
  reg [FloatW-1:0] s2_p_y;
  reg [FloatW-1:0] s2_r_y;
  reg              s2_never_y;
  reg              s2_neg_y;
  reg [15:0]       s2_steps_next;
  always @(posedge clk) begin
    s2_pb_x        <= s1_pb_x;
    s2_d_x         <= s1_d_x;
    s2_pb_y        <= s1_pb_y;
    s2_d_y         <= s1_d_y;
    s2_t           <= s1_t;
    s2_level       <= s1_level;
    s2_has_crossed <= s1_has_crossed;
    s2_x_low       <= s1_x_low;
    s2_x_high      <= s1_x_high;
    s2_y_low       <= s1_y_low;
    s2_y_high      <= s1_y_high;
    s2_x_even      <= s1_x_even;
    s2_y_even      <= s1_y_even;
    s2_x           <= s1_x;
    s2_y           <= s1_y;
    s2_x_beyond    <= s1_x_beyond;
    s2_y_beyond    <= s1_y_beyond;
    s2_last_step   <= s1_last_step;
    s2_moves       <= s1_moves;
    s2_done        <= s1_done;
    s2_wall        <= s1_wall;
    s2_limit       <= s1_limit;
    s2_crossings   <= s1_crossings;
    s2_ups         <= s1_ups;
    s2_tag         <= s1_tag;
    s2_p_x         <= s1_p_x;
    s2_r_x         <= s1_r_x;
    s2_never_x     <= s1_never_x;
    s2_neg_x       <= s1_neg_x;
    s2_p_y         <= s1_p_y;
    s2_r_y         <= s1_r_y;
    s2_never_y     <= s1_never_y;
    s2_neg_y       <= s1_neg_y;
    s2_steps_next  <= s1_steps_next;
  end
  always @(posedge clk) begin
    if (rst) begin
      s2_valid <= 1'b0;
    end else begin
      s2_valid <= s1_valid;
    end
  end

  // ---- stage 3: registers ------------------------------------------------- traverse.rs
  reg [FloatW-1:0] s3_pb_x;
  reg [FloatW-1:0] s3_d_x;
  reg [FloatW-1:0] s3_pb_y;
  reg [FloatW-1:0] s3_d_y;
  reg [FloatW-1:0] s3_t;
  reg [LevelW-1:0] s3_level;
  reg              s3_has_crossed;
  reg [IdxW-1:0]   s3_x_low;
  reg [IdxW-1:0]   s3_x_high;
  reg [IdxW-1:0]   s3_y_low;
  reg [IdxW-1:0]   s3_y_high;
  reg              s3_x_even;
  reg              s3_y_even;
  reg [IdxW-1:0]   s3_x;
  reg [IdxW-1:0]   s3_y;
  reg [IdxW-1:0]   s3_x_beyond;
  reg [IdxW-1:0]   s3_y_beyond;
  reg              s3_last_step;
  reg              s3_moves;
  reg              s3_done;
  reg              s3_wall;
  reg              s3_limit;
  reg [15:0]       s3_crossings;
  reg [15:0]       s3_ups;
  reg              s3_valid;
  reg [TAG_W-1:0]  s3_tag;
  reg [FloatW-1:0] s3_p_x;
  reg [FloatW-1:0] s3_r_x;
  reg              s3_never_x;
  reg              s3_neg_x;
  reg [FloatW-1:0] s3_p_y;
  reg [FloatW-1:0] s3_r_y;
  reg              s3_never_y;
  reg              s3_neg_y;
  reg [15:0]       s3_steps_next;
  always @(posedge clk) begin
    s3_pb_x        <= s2_pb_x;
    s3_d_x         <= s2_d_x;
    s3_pb_y        <= s2_pb_y;
    s3_d_y         <= s2_d_y;
    s3_t           <= s2_t;
    s3_level       <= s2_level;
    s3_has_crossed <= s2_has_crossed;
    s3_x_low       <= s2_x_low;
    s3_x_high      <= s2_x_high;
    s3_y_low       <= s2_y_low;
    s3_y_high      <= s2_y_high;
    s3_x_even      <= s2_x_even;
    s3_y_even      <= s2_y_even;
    s3_x           <= s2_x;
    s3_y           <= s2_y;
    s3_x_beyond    <= s2_x_beyond;
    s3_y_beyond    <= s2_y_beyond;
    s3_last_step   <= s2_last_step;
    s3_moves       <= s2_moves;
    s3_done        <= s2_done;
    s3_wall        <= s2_wall;
    s3_limit       <= s2_limit;
    s3_crossings   <= s2_crossings;
    s3_ups         <= s2_ups;
    s3_tag         <= s2_tag;
    s3_p_x         <= s2_p_x;
    s3_r_x         <= s2_r_x;
    s3_never_x     <= s2_never_x;
    s3_neg_x       <= s2_neg_x;
    s3_p_y         <= s2_p_y;
    s3_r_y         <= s2_r_y;
    s3_never_y     <= s2_never_y;
    s3_neg_y       <= s2_neg_y;
    s3_steps_next  <= s2_steps_next;
  end
  always @(posedge clk) begin
    if (rst) begin
      s3_valid <= 1'b0;
    end else begin
      s3_valid <= s2_valid;
    end
  end

  // ---- stage 3: predicted hit --------------------------------------------- traverse.rs
  wire [IdxW-1:0] s7_x_hit;
  predicted_hit #(.EXP_W(EXP_W), .MAN_W(MAN_W), .IDX_W(IdxW)) u_predict_x (
    .clk   (clk),
    .ce    (1'b1),
    .p_back(s3_pb_x),
    .d     (s3_d_x),
    .m     (s3_m),
    .e     (s7_x_hit)
  );
  wire [IdxW-1:0] s7_y_hit;
  predicted_hit #(.EXP_W(EXP_W), .MAN_W(MAN_W), .IDX_W(IdxW)) u_predict_y (
    .clk   (clk),
    .ce    (1'b1),
    .p_back(s3_pb_y),
    .d     (s3_d_y),
    .m     (s3_m),
    .e     (s7_y_hit)
  );

  // ---- stage 4: registers ------------------------------------------------- traverse.rs
  reg [FloatW-1:0] s4_t;
  reg [FloatW-1:0] s4_m;
  reg [LevelW-1:0] s4_level;
  reg              s4_has_crossed;
  reg [IdxW-1:0]   s4_x_low;
  reg [IdxW-1:0]   s4_x_high;
  reg [IdxW-1:0]   s4_y_low;
  reg [IdxW-1:0]   s4_y_high;
  reg              s4_x_even;
  reg              s4_y_even;
  reg [IdxW-1:0]   s4_x;
  reg [IdxW-1:0]   s4_y;
  reg [IdxW-1:0]   s4_x_beyond;
  reg [IdxW-1:0]   s4_y_beyond;
  reg              s4_last_step;
  reg              s4_moves;
  reg              s4_done;
  reg              s4_below;
  reg              s4_wall;
  reg              s4_limit;
  reg [15:0]       s4_crossings;
  reg [15:0]       s4_ups;
  reg              s4_valid;
  reg [TAG_W-1:0]  s4_tag;
  reg [FloatW-1:0] s4_p_x;
  reg [FloatW-1:0] s4_pb_x;
  reg [FloatW-1:0] s4_d_x;
  reg [FloatW-1:0] s4_r_x;
  reg              s4_never_x;
  reg              s4_neg_x;
  reg [FloatW-1:0] s4_p_y;
  reg [FloatW-1:0] s4_pb_y;
  reg [FloatW-1:0] s4_d_y;
  reg [FloatW-1:0] s4_r_y;
  reg              s4_never_y;
  reg              s4_neg_y;
  reg [15:0]       s4_steps_next;
  always @(posedge clk) begin
    s4_t           <= s3_t;
    s4_m           <= s3_m;
    s4_level       <= s3_level;
    s4_has_crossed <= s3_has_crossed;
    s4_x_low       <= s3_x_low;
    s4_x_high      <= s3_x_high;
    s4_y_low       <= s3_y_low;
    s4_y_high      <= s3_y_high;
    s4_x_even      <= s3_x_even;
    s4_y_even      <= s3_y_even;
    s4_x           <= s3_x;
    s4_y           <= s3_y;
    s4_x_beyond    <= s3_x_beyond;
    s4_y_beyond    <= s3_y_beyond;
    s4_last_step   <= s3_last_step;
    s4_moves       <= s3_moves;
    s4_done        <= s3_done;
    s4_below       <= s3_below;
    s4_wall        <= s3_wall;
    s4_limit       <= s3_limit;
    s4_crossings   <= s3_crossings;
    s4_ups         <= s3_ups;
    s4_tag         <= s3_tag;
    s4_p_x         <= s3_p_x;
    s4_pb_x        <= s3_pb_x;
    s4_d_x         <= s3_d_x;
    s4_r_x         <= s3_r_x;
    s4_never_x     <= s3_never_x;
    s4_neg_x       <= s3_neg_x;
    s4_p_y         <= s3_p_y;
    s4_pb_y        <= s3_pb_y;
    s4_d_y         <= s3_d_y;
    s4_r_y         <= s3_r_y;
    s4_never_y     <= s3_never_y;
    s4_neg_y       <= s3_neg_y;
    s4_steps_next  <= s3_steps_next;
  end
  always @(posedge clk) begin
    if (rst) begin
      s4_valid <= 1'b0;
    end else begin
      s4_valid <= s3_valid;
    end
  end

  // ---- stage 4: node crossing --------------------------------------------- traverse.rs
  wire              s5_is_inside;
  wire              s5_x_first;
  wire [FloatW-1:0] s5_t_next;
  node_crossing #(.EXP_W(EXP_W), .MAN_W(MAN_W)) u_crossing (
    .clk      (clk),
    .ce       (1'b1),
    .t        (s4_t),
    .m        (s4_m),
    .t_x      (s4_t_x),
    .t_y      (s4_t_y),
    .is_inside(s5_is_inside),
    .x_first  (s5_x_first),
    .t_next   (s5_t_next)
  );

  // ---- stage 5: registers ------------------------------------------------- traverse.rs
  reg [LevelW-1:0] s5_level;
  reg              s5_has_crossed;
  reg [IdxW-1:0]   s5_x_low;
  reg [IdxW-1:0]   s5_x_high;
  reg [IdxW-1:0]   s5_y_low;
  reg [IdxW-1:0]   s5_y_high;
  reg              s5_x_even;
  reg              s5_y_even;
  reg [IdxW-1:0]   s5_x;
  reg [IdxW-1:0]   s5_y;
  reg [FloatW-1:0] s5_m;
  reg [IdxW-1:0]   s5_x_beyond;
  reg [IdxW-1:0]   s5_y_beyond;
  reg              s5_last_step;
  reg              s5_moves;
  reg              s5_done;
  reg [FloatW-1:0] s5_t;
  reg              s5_below;
  reg              s5_wall;
  reg              s5_limit;
  reg [15:0]       s5_crossings;
  reg [15:0]       s5_ups;
  reg              s5_valid;
  reg [TAG_W-1:0]  s5_tag;
  reg [FloatW-1:0] s5_p_x;
  reg [FloatW-1:0] s5_pb_x;
  reg [FloatW-1:0] s5_d_x;
  reg [FloatW-1:0] s5_r_x;
  reg              s5_never_x;
  reg              s5_neg_x;
  reg [FloatW-1:0] s5_p_y;
  reg [FloatW-1:0] s5_pb_y;
  reg [FloatW-1:0] s5_d_y;
  reg [FloatW-1:0] s5_r_y;
  reg              s5_never_y;
  reg              s5_neg_y;
  reg [15:0]       s5_steps_next;
  always @(posedge clk) begin
    s5_level       <= s4_level;
    s5_has_crossed <= s4_has_crossed;
    s5_x_low       <= s4_x_low;
    s5_x_high      <= s4_x_high;
    s5_y_low       <= s4_y_low;
    s5_y_high      <= s4_y_high;
    s5_x_even      <= s4_x_even;
    s5_y_even      <= s4_y_even;
    s5_x           <= s4_x;
    s5_y           <= s4_y;
    s5_m           <= s4_m;
    s5_x_beyond    <= s4_x_beyond;
    s5_y_beyond    <= s4_y_beyond;
    s5_last_step   <= s4_last_step;
    s5_moves       <= s4_moves;
    s5_done        <= s4_done;
    s5_t           <= s4_t;
    s5_below       <= s4_below;
    s5_wall        <= s4_wall;
    s5_limit       <= s4_limit;
    s5_crossings   <= s4_crossings;
    s5_ups         <= s4_ups;
    s5_tag         <= s4_tag;
    s5_p_x         <= s4_p_x;
    s5_pb_x        <= s4_pb_x;
    s5_d_x         <= s4_d_x;
    s5_r_x         <= s4_r_x;
    s5_never_x     <= s4_never_x;
    s5_neg_x       <= s4_neg_x;
    s5_p_y         <= s4_p_y;
    s5_pb_y        <= s4_pb_y;
    s5_d_y         <= s4_d_y;
    s5_r_y         <= s4_r_y;
    s5_never_y     <= s4_never_y;
    s5_neg_y       <= s4_neg_y;
    s5_steps_next  <= s4_steps_next;
  end
  always @(posedge clk) begin
    if (rst) begin
      s5_valid <= 1'b0;
    end else begin
      s5_valid <= s4_valid;
    end
  end

  // ---- stage 5: level up -------------------------------------------------- traverse.rs
  wire s5_even = s5_x_first ? s5_x_even : s5_y_even;

  // ---- stage 6: registers ------------------------------------------------- traverse.rs
  reg [LevelW-1:0] s6_level;
  reg              s6_has_crossed;
  reg [IdxW-1:0]   s6_x_low;
  reg [IdxW-1:0]   s6_x_high;
  reg [IdxW-1:0]   s6_y_low;
  reg [IdxW-1:0]   s6_y_high;
  reg              s6_even;
  reg [IdxW-1:0]   s6_x;
  reg [IdxW-1:0]   s6_y;
  reg              s6_is_inside;
  reg              s6_x_first;
  reg [FloatW-1:0] s6_m;
  reg [FloatW-1:0] s6_t_next;
  reg [IdxW-1:0]   s6_x_beyond;
  reg [IdxW-1:0]   s6_y_beyond;
  reg              s6_last_step;
  reg              s6_moves;
  reg              s6_done;
  reg [FloatW-1:0] s6_t;
  reg              s6_below;
  reg              s6_wall;
  reg              s6_limit;
  reg [15:0]       s6_crossings;
  reg [15:0]       s6_ups;
  reg              s6_valid;
  reg [TAG_W-1:0]  s6_tag;
  reg [FloatW-1:0] s6_p_x;
  reg [FloatW-1:0] s6_pb_x;
  reg [FloatW-1:0] s6_d_x;
  reg [FloatW-1:0] s6_r_x;
  reg              s6_never_x;
  reg              s6_neg_x;
  reg [FloatW-1:0] s6_p_y;
  reg [FloatW-1:0] s6_pb_y;
  reg [FloatW-1:0] s6_d_y;
  reg [FloatW-1:0] s6_r_y;
  reg              s6_never_y;
  reg              s6_neg_y;
  reg [15:0]       s6_steps_next;
  always @(posedge clk) begin
    s6_level       <= s5_level;
    s6_has_crossed <= s5_has_crossed;
    s6_x_low       <= s5_x_low;
    s6_x_high      <= s5_x_high;
    s6_y_low       <= s5_y_low;
    s6_y_high      <= s5_y_high;
    s6_even        <= s5_even;
    s6_x           <= s5_x;
    s6_y           <= s5_y;
    s6_is_inside   <= s5_is_inside;
    s6_x_first     <= s5_x_first;
    s6_m           <= s5_m;
    s6_t_next      <= s5_t_next;
    s6_x_beyond    <= s5_x_beyond;
    s6_y_beyond    <= s5_y_beyond;
    s6_last_step   <= s5_last_step;
    s6_moves       <= s5_moves;
    s6_done        <= s5_done;
    s6_t           <= s5_t;
    s6_below       <= s5_below;
    s6_wall        <= s5_wall;
    s6_limit       <= s5_limit;
    s6_crossings   <= s5_crossings;
    s6_ups         <= s5_ups;
    s6_tag         <= s5_tag;
    s6_p_x         <= s5_p_x;
    s6_pb_x        <= s5_pb_x;
    s6_d_x         <= s5_d_x;
    s6_r_x         <= s5_r_x;
    s6_never_x     <= s5_never_x;
    s6_neg_x       <= s5_neg_x;
    s6_p_y         <= s5_p_y;
    s6_pb_y        <= s5_pb_y;
    s6_d_y         <= s5_d_y;
    s6_r_y         <= s5_r_y;
    s6_never_y     <= s5_never_y;
    s6_neg_y       <= s5_neg_y;
    s6_steps_next  <= s5_steps_next;
  end
  always @(posedge clk) begin
    if (rst) begin
      s6_valid <= 1'b0;
    end else begin
      s6_valid <= s5_valid;
    end
  end

  // ---- stage 7: registers ------------------------------------------------- traverse.rs
  reg [LevelW-1:0] s7_level;
  reg              s7_has_crossed;
  reg [IdxW-1:0]   s7_x_low;
  reg [IdxW-1:0]   s7_x_high;
  reg [IdxW-1:0]   s7_y_low;
  reg [IdxW-1:0]   s7_y_high;
  reg              s7_even;
  reg [IdxW-1:0]   s7_x;
  reg [IdxW-1:0]   s7_y;
  reg              s7_is_inside;
  reg              s7_x_first;
  reg [FloatW-1:0] s7_m;
  reg [FloatW-1:0] s7_t_next;
  reg [IdxW-1:0]   s7_x_beyond;
  reg [IdxW-1:0]   s7_y_beyond;
  reg              s7_last_step;
  reg              s7_moves;
  reg              s7_done;
  reg [FloatW-1:0] s7_t;
  reg              s7_below;
  reg              s7_wall;
  reg              s7_limit;
  reg [15:0]       s7_crossings;
  reg [15:0]       s7_ups;
  reg              s7_valid;
  reg [TAG_W-1:0]  s7_tag;
  reg [FloatW-1:0] s7_p_x;
  reg [FloatW-1:0] s7_pb_x;
  reg [FloatW-1:0] s7_d_x;
  reg [FloatW-1:0] s7_r_x;
  reg              s7_never_x;
  reg              s7_neg_x;
  reg [FloatW-1:0] s7_p_y;
  reg [FloatW-1:0] s7_pb_y;
  reg [FloatW-1:0] s7_d_y;
  reg [FloatW-1:0] s7_r_y;
  reg              s7_never_y;
  reg              s7_neg_y;
  reg [15:0]       s7_steps_next;
  always @(posedge clk) begin
    s7_level       <= s6_level;
    s7_has_crossed <= s6_has_crossed;
    s7_x_low       <= s6_x_low;
    s7_x_high      <= s6_x_high;
    s7_y_low       <= s6_y_low;
    s7_y_high      <= s6_y_high;
    s7_even        <= s6_even;
    s7_x           <= s6_x;
    s7_y           <= s6_y;
    s7_is_inside   <= s6_is_inside;
    s7_x_first     <= s6_x_first;
    s7_m           <= s6_m;
    s7_t_next      <= s6_t_next;
    s7_x_beyond    <= s6_x_beyond;
    s7_y_beyond    <= s6_y_beyond;
    s7_last_step   <= s6_last_step;
    s7_moves       <= s6_moves;
    s7_done        <= s6_done;
    s7_t           <= s6_t;
    s7_below       <= s6_below;
    s7_wall        <= s6_wall;
    s7_limit       <= s6_limit;
    s7_crossings   <= s6_crossings;
    s7_ups         <= s6_ups;
    s7_tag         <= s6_tag;
    s7_p_x         <= s6_p_x;
    s7_pb_x        <= s6_pb_x;
    s7_d_x         <= s6_d_x;
    s7_r_x         <= s6_r_x;
    s7_never_x     <= s6_never_x;
    s7_neg_x       <= s6_neg_x;
    s7_p_y         <= s6_p_y;
    s7_pb_y        <= s6_pb_y;
    s7_d_y         <= s6_d_y;
    s7_r_y         <= s6_r_y;
    s7_never_y     <= s6_never_y;
    s7_neg_y       <= s6_neg_y;
    s7_steps_next  <= s6_steps_next;
  end
  always @(posedge clk) begin
    if (rst) begin
      s7_valid <= 1'b0;
    end else begin
      s7_valid <= s6_valid;
    end
  end

  // ---- stage 7: multi-level down ------------------------------------------ traverse.rs
  wire [LevelW-1:0] s7_level_down;
  wire [IdxW-1:0]   s7_x_down;
  wire [IdxW-1:0]   s7_y_down;
  multi_level_down #(.LEVELS(LEVELS), .IDX_W(IdxW)) u_down (
    .level     (s7_level),
    .crossed   (s7_has_crossed),
    .x_low     (s7_x_low),
    .x_high    (s7_x_high),
    .x_hit     (s7_x_hit),
    .y_low     (s7_y_low),
    .y_high    (s7_y_high),
    .y_hit     (s7_y_hit),
    .level_down(s7_level_down),
    .x_down    (s7_x_down),
    .y_down    (s7_y_down)
  );

  // ---- stage 7: level up -------------------------------------------------- traverse.rs
  wire s7_up;
  level_up #(.LEVELS(LEVELS), .IDX_W(IdxW)) u_up (
    .level(s7_level),
    .even (s7_even),
    .x_at (s7_x),
    .x_hit(s7_x_hit),
    .y_at (s7_y),
    .y_hit(s7_y_hit),
    .up   (s7_up)
  );

  // ---- stage 7: level decision -------------------------------------------- traverse.rs
  wire              s7_hit;
  wire              s7_crosses;
  wire [LevelW-1:0] s7_level_next;
  wire [IdxW-1:0]   s7_x_next;
  wire [IdxW-1:0]   s7_y_next;
  wire [FloatW-1:0] s7_t_after;
  level_decision #(.EXP_W(EXP_W), .MAN_W(MAN_W), .LEVELS(LEVELS), .IDX_W(IdxW)) u_decision (
    .is_inside (s7_is_inside),
    .x_first   (s7_x_first),
    .up        (s7_up),
    .level     (s7_level),
    .level_down(s7_level_down),
    .m         (s7_m),
    .t_next    (s7_t_next),
    .x_at      (s7_x),
    .x_down    (s7_x_down),
    .x_beyond  (s7_x_beyond),
    .y_at      (s7_y),
    .y_down    (s7_y_down),
    .y_beyond  (s7_y_beyond),
    .hit       (s7_hit),
    .crosses   (s7_crosses),
    .level_next(s7_level_next),
    .x_next    (s7_x_next),
    .y_next    (s7_y_next),
    .t_out     (s7_t_after)
  );

  // ---- stage 7: step limit ------------------------------------------------ traverse.rs
  // A ray that is done takes no more steps.
  wire s7_at_limit = s7_last_step & ~s7_hit;
  wire s7_crossed_now = s7_crosses & s7_moves;
  wire s7_up_now = s7_up & s7_crossed_now;

  // ---- back to stage 0
  always @(posedge clk) begin
    s0_back_tag       <= s7_tag;
    s0_back_p_x       <= s7_p_x;
    s0_back_pb_x      <= s7_pb_x;
    s0_back_d_x       <= s7_d_x;
    s0_back_r_x       <= s7_r_x;
    s0_back_never_x   <= s7_never_x;
    s0_back_neg_x     <= s7_neg_x;
    s0_back_p_y       <= s7_p_y;
    s0_back_pb_y      <= s7_pb_y;
    s0_back_d_y       <= s7_d_y;
    s0_back_r_y       <= s7_r_y;
    s0_back_never_y   <= s7_never_y;
    s0_back_neg_y     <= s7_neg_y;
    s0_back_level     <= s7_done ? s7_level : s7_level_next;
    s0_back_x         <= s7_done ? s7_x : s7_x_next;
    s0_back_y         <= s7_done ? s7_y : s7_y_next;
    s0_back_t         <= s7_done ? s7_t : s7_t_after;
    s0_back_done      <= s7_done | s7_hit | s7_at_limit;
    s0_back_wall      <= s7_done ? s7_wall : (s7_hit & s7_below);
    s0_back_limit     <= s7_limit | (s7_at_limit & s7_moves);
    s0_back_steps     <= s7_steps_next;
    s0_back_crossings <= s7_crossings + {15'd0, s7_crossed_now};
    s0_back_ups       <= s7_ups + {15'd0, s7_up_now};
    s0_back_crossed   <= s7_has_crossed | s7_crossed_now;
  end
  always @(posedge clk) begin
    if (rst) begin
      s0_back_valid <= 1'b0;
    end else begin
      s0_back_valid <= s7_valid;
    end
  end

  assign hit_valid = hit_tracked;
  assign setup_valid = s0_setup_tracked;
  assign in_ready = setup_ce;
  assign slot_busy = s0_valid;
  assign out_valid = hit_valid;
  assign out_tag = hit_tag;
  assign out_i = hit_i;
  assign out_j = hit_j;
  assign out_t = hit_t;
  assign out_wall = hit_wall;
  assign out_limit = hit_limit;
  assign out_steps = hit_steps;
  assign out_crossings = hit_crossings;
  assign out_ups = hit_ups;
  assign out_fu = hit_fu;
  assign out_fv = hit_fv;
endmodule
`default_nettype wire
