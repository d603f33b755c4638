//! Units that the published datapath alone has.
use super::super::datapath::PUBLISHED;
use super::super::ray_stimulus::{both_axes, both_positions, one_axis, one_axis_at_surface, one_node, whole_ray};
use super::super::unit::Unit;
use super::some_level;
use crate::bits::mask;
use crate::config::{DatapathConfig, Design, TraverseConfig};
use crate::golden::float as gf;
use crate::golden::{Datapath, Published, RayInput, descend_levels};

/// The entries.
pub const UNITS: &[&Unit] = &[
    &RAY_SCALE,
    &EXIT_PLANE,
    &BOUNDARY_TIME,
    &SURFACE_TIME,
    &NEARER_PLANE,
    &RAY_POINT,
    &CROSSING_TEST,
    &DESCENT_LEVEL,
    &LEVEL_CHOICE,
    &TEXEL_FRACTION,
];

static RAY_SCALE: Unit = Unit {
    name: "ray_scale",
    model: Some(|c, row, out| {
        // The setup knows nothing of the hit position and of the nudge, whose bits may be too many beside it.
        let traverse = TraverseConfig { frac_bits: 1, ..c.design.traverse };
        let datapath = DatapathConfig { nudge_bits: 0, ..c.design.datapath };
        let g = Published::prepare(&Design { traverse, datapath, ..c.design }).expect("the set's parameters are legal");
        let [u, v, du, dv] = ["u", "v", "du", "dv"].map(|p| row[p]);
        // What is no ray gives zeros.
        out.fill(0);
        if let Some(route) = g.route(&RayInput { u, v, du, dv, lod: 0 }) {
            out["ok"] = 1;
            out["level"] = c.levels();
            for (a, [p, d, first]) in [(route.u, ["p_x", "d_x", "first_x"]), (route.v, ["p_y", "d_y", "first_y"])] {
                out[p] = a.p;
                out[d] = a.d;
                out[first] = c.index(a.x);
            }
        }
    }),
    stimulus: Some(whole_ray),
    ..PUBLISHED
};

static EXIT_PLANE: Unit = Unit {
    name: "exit_plane",
    model: Some(|c, row, out| {
        let size = 1i64 << row["level"];
        let first = c.signed(row["x"]).div_euclid(size) * size;
        // Past the largest coordinate the plane wraps with its word.
        let plane = c.index(if row.is_set("neg") { first } else { first + size });
        out["plane"] = plane;
        out.set("even", u64::from(c.signed(plane).div_euclid(size).rem_euclid(2) == 0));
    }),
    legal: Some(|c, row| some_level(c, row, "level")),
    stimulus: Some(one_node),
    ..PUBLISHED
};

static BOUNDARY_TIME: Unit = Unit {
    name: "boundary_time",
    model: Some(|c, row, out| {
        let (f, nudge) = (c.design.format, c.param("NUDGE_W"));
        let step = match (nudge, row["neg"]) {
            (0, _) => 0,
            (_, 0) => 1,
            _ => -1,
        };
        let past = gf::from_fixed(f, (c.signed(row["plane"]) << nudge) + step, nudge);
        out["t"] = gf::div(f, gf::add(f, past, gf::neg(f, row["p"])), row["d"]);
    }),
    stimulus: Some(one_axis),
    ..PUBLISHED
};

static SURFACE_TIME: Unit = Unit {
    name: "surface_time",
    model: Some(|c, row, out| {
        let (f, m, t) = (c.design.format, (1u64 << c.param("HEIGHT_W")) - 1, row["t"]);
        let t_v = gf::mul(f, gf::from_int(f, (m - row["height"]) as i64), gf::recip_int(f, m));
        let reach = if gf::lt(f, t, t_v) { t_v } else { t };
        // The first trip asks for the ray's end.
        out["m"] = if row.is_set("first") { gf::from_int(f, 1) } else { reach };
        out["below"] = u64::from(gf::lt(f, t_v, t));
    }),
    stimulus: Some(both_axes),
    ..PUBLISHED
};

static NEARER_PLANE: Unit = Unit {
    name: "nearer_plane",
    model: Some(|c, row, out| {
        let y_first = gf::lt(c.design.format, row["t_y"], row["t_x"]);
        out["t_exit"] = row[if y_first { "t_y" } else { "t_x" }];
        out.set("x_first", u64::from(!y_first));
    }),
    stimulus: Some(both_axes),
    ..PUBLISHED
};

static RAY_POINT: Unit = Unit {
    name: "ray_point",
    model: Some(|c, row, out| {
        let f = c.design.format;
        out["position"] = gf::add(f, row["p"], gf::mul(f, row["d"], row["t"]));
    }),
    stimulus: Some(one_axis_at_surface),
    ..PUBLISHED
};

static CROSSING_TEST: Unit = Unit {
    name: "crossing_test",
    model: Some(|c, row, out| {
        let (f, t, t_exit) = (c.design.format, row["t"], row["t_exit"]);
        let beyond = |hit: &str, edge: &str, neg: &str| gf::lt(f, row[hit], row[edge]) == row.is_set(neg);
        let leaves = beyond("x_hit", "x_edge", "x_neg") || beyond("y_hit", "y_edge", "y_neg");
        out["crosses"] = u64::from(leaves && !gf::lt(f, gf::from_int(f, 1), t_exit));
        out["t_next"] = if gf::lt(f, t, t_exit) { t_exit } else { t };
    }),
    stimulus: Some(both_positions),
    ..PUBLISHED
};

static DESCENT_LEVEL: Unit = Unit {
    name: "descent_level",
    model: Some(|c, row, out| {
        let level = row["level"];
        let down = descend_levels(c.design.mode.levels_down, level as u32, row.is_set("crossed"));
        out["level_down"] = c.level(level.wrapping_sub(u64::from(down)));
    }),
    legal: Some(|c, row| row["level"] = row["level"] % c.levels() + 1),
    ..PUBLISHED
};

static LEVEL_CHOICE: Unit = Unit {
    name: "level_choice",
    model: Some(|c, row, out| {
        let level = row["level"];
        let crosses = row.is_set("exits") && !row.is_set("first");
        let hit = !crosses && level == 0;
        out["hit"] = u64::from(hit);
        out["crosses"] = u64::from(crosses);
        out["level_next"] = match (crosses, hit) {
            (true, _) => c.level(level + row["up"]),
            (false, true) => level,
            (false, false) => row["level_down"],
        };
        out["x_next"] = row[if crosses { "x_cross" } else { "x_hit" }];
        out["y_next"] = row[if crosses { "y_cross" } else { "y_hit" }];
        out["t_out"] = row[if crosses { "t_next" } else { "m" }];
    }),
    legal: Some(|c, row| some_level(c, row, "level")),
    stimulus: Some(both_positions),
    ..PUBLISHED
};

static TEXEL_FRACTION: Unit = Unit {
    name: "texel_fraction",
    model: Some(|c, row, out| {
        let (f, frac) = (c.design.format, c.param("FRAC_W"));
        let at = gf::add(f, row["p"], gf::mul(f, row["d"], row["t"]));
        out["fraction"] = gf::to_fixed(f, at, c.idx_w + frac, frac) as u64 & mask(frac);
    }),
    stimulus: Some(one_axis_at_surface),
    ..PUBLISHED
};
