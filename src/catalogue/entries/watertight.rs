//! Units that the watertight datapath alone has.
use super::super::datapath::WATERTIGHT;
use super::super::ray_stimulus::{both_axes, first_axis, one_axis, one_axis_in_node, whole_ray};
use super::super::row::Row;
use super::super::unit::Unit;
use super::float::FP_MUL;
use super::some_level;
use super::traversal::kept_in_node;
use crate::bits::mask;
use crate::config::{Design, TraverseConfig, Trim};
use crate::format::FloatFormat;
use crate::golden::float as gf;
use crate::golden::{Datapath, RayInput, Watertight};
use crate::proofs::{BIT_LEVEL, PROOF, Proof};

/// The entries.
pub const UNITS: &[&Unit] = &[
    &PLANE_TIME,
    &HEIGHT_TEST,
    &PREDICTED_HIT,
    &NODE_CROSSING,
    &AXIS_SCALE,
    &AXIS_SLOPE,
    &AXIS_ENDS,
    &RAY_SETUP,
    &HIT_POSITION,
    &CHORD_END,
];

/// Parameter values at which two chains of an adder and a multiplier are compared.
const TINY: &[(&str, i64)] = &[("EXP_W", 4), ("MAN_W", 2), ("IDX_W", 5)];

static PLANE_TIME: Unit = Unit {
    name: "plane_time",
    model: Some(|c, row, out| {
        let f = c.design.format;
        let distance = gf::add(f, gf::from_int(f, c.signed(row["plane"])), gf::neg(f, row["p"]));
        out["t"] = if row.is_set("never") { f.infinity() } else { gf::mul(f, distance, row["r"]) };
    }),
    stimulus: Some(one_axis),
    proofs: &[Proof {
        name: "plane_time",
        units: &["plane_time", FP_MUL.name],
        claim: "a later plane never has a smaller parameter (4/2)",
        text: harness!("plane_time"),
        engine: BIT_LEVEL,
        over: TINY,
        ..PROOF
    }],
    ..WATERTIGHT
};

static HEIGHT_TEST: Unit = Unit {
    name: "height_test",
    model: Some(|c, row, out| {
        let (f, t) = (c.design.format, row["t"]);
        let t_v = gf::from_int(f, ((1 << c.param("HEIGHT_W")) - 1 - row["height"]) as i64);
        out["m"] = if gf::lt(f, t, t_v) { t_v } else { t };
        out["below"] = u64::from(gf::lt(f, t_v, t));
    }),
    stimulus: Some(both_axes),
    ..WATERTIGHT
};

static PREDICTED_HIT: Unit = Unit {
    name: "predicted_hit",
    model: Some(|c, row, out| {
        let f = c.design.format;
        let at = gf::add(f, row["p_back"], gf::mul(f, row["d"], row["m"]));
        out["e"] = c.index(gf::to_int(f, at, c.idx_w));
    }),
    stimulus: Some(one_axis),
    ..WATERTIGHT
};

static NODE_CROSSING: Unit = Unit {
    name: "node_crossing",
    model: Some(|c, row, out| {
        let f = c.design.format;
        let [t, m, t_x, t_y] = ["t", "m", "t_x", "t_y"].map(|p| row[p]);
        let x_first = !gf::lt(f, t_y, t_x);
        let exit = if x_first { t_x } else { t_y };
        out["is_inside"] = u64::from(gf::lt(f, m, t_x) && gf::lt(f, m, t_y));
        out["x_first"] = u64::from(x_first);
        out["t_next"] = if gf::lt(f, t, exit) { exit } else { t };
    }),
    stimulus: Some(both_axes),
    ..WATERTIGHT
};

static AXIS_SCALE: Unit = Unit {
    name: "axis_scale",
    model: Some(|c, row, out| {
        let (f, n) = (c.design.format, u64::from(c.param("LEVELS")));
        let (frac, exp) = (f.man_mask(), |x: u64| (x & !f.sign_bit()) >> f.man);
        let number = |x: u64| if exp(x) == 0 { 0 } else { ((exp(x) + n) & mask(f.exp)) << f.man | x & frac };
        let end = |bits: u32| gf::from_int(f, 1 << bits);
        let [p, d] = ["p", "d"].map(|port| row[port]);
        let size = d & !f.sign_bit();
        let enters = exp(p) == 0 || p & f.sign_bit() == 0 && gf::lt(f, p, end(0));
        out["ok"] = u64::from(enters && gf::lt(f, size, end(c.param("TILE_W"))));
        out["p_texels"] = number(p);
        out["d_texels"] = d & f.sign_bit() | number(d);
    }),
    stimulus: Some(first_axis),
    ..WATERTIGHT
};

static AXIS_SLOPE: Unit = Unit {
    name: "axis_slope",
    model: Some(|c, row, out| {
        // The hit position is no matter of this unit, and how far a ray may travel only of one that trims.
        let tile_bits = if c.design.mode.trim == Trim::None { 1 } else { c.param("TILE_W") };
        let traverse = TraverseConfig { frac_bits: 1, tile_bits, ..c.design.traverse };
        let g = Watertight::prepare(&Design { traverse, ..c.design }).expect("the set's parameters are legal");
        let a = g.scaled_axis(row["p"], row["dn"]);
        out["p_back"] = a.pb;
        out["d"] = a.dt;
        out["r"] = a.r;
        out["never"] = u64::from(a.never);
        // Only a trim asks for these.
        out.set("p_ahead", a.pf);
        out.set("farthest", c.index(a.le));
    }),
    legal: Some(|c, row| a_number(c.design.format, row, "dn")),
    stimulus: Some(one_axis),
    ..WATERTIGHT
};

static AXIS_ENDS: Unit = Unit {
    name: "axis_ends",
    model: Some(|c, row, out| {
        let f = c.design.format;
        out["first"] = c.index(gf::to_int(f, row["p"], c.idx_w));
        out["last"] = c.index(gf::to_int(f, gf::add(f, row["p"], row["dn"]), c.idx_w));
    }),
    stimulus: Some(one_axis),
    ..WATERTIGHT
};

/// Makes the word of a port a finite number: of infinity and NaN the top bit of the exponent goes.
fn a_number(f: FloatFormat, row: &mut Row<'_>, port: &str) {
    if row[port] & f.infinity() == f.infinity() {
        row[port] ^= f.infinity() & !(f.infinity() >> 1);
    }
}

static RAY_SETUP: Unit = Unit {
    name: "ray_setup",
    model: Some(|c, row, out| {
        // The setup knows nothing of the hit position, whose bits may be too many beside it.
        let traverse = TraverseConfig { frac_bits: 1, ..c.design.traverse };
        let g = Watertight::prepare(&Design { traverse, ..c.design }).expect("the set's parameters are legal");
        let [u, v, du, dv] = ["u", "v", "du", "dv"].map(|p| row[p]);
        let o = g.setup(&RayInput { u, v, du, dv, lod: row.get("lod").unwrap_or(0) as u32 });
        out["ok"] = u64::from(o.valid);
        out["level"] = u64::from(o.level);
        let x = ["p_x", "pb_x", "d_x", "r_x", "never_x", "neg_x", "first_x", "pf_x", "le_x"];
        let y = ["p_y", "pb_y", "d_y", "r_y", "never_y", "neg_y", "first_y", "pf_y", "le_y"];
        for (a, [p, pb, d, r, never, neg, first, pf, le]) in [(o.u, x), (o.v, y)] {
            out[p] = a.p;
            out[pb] = a.pb;
            out[d] = a.dt;
            out[r] = a.r;
            out[never] = u64::from(a.never);
            out[neg] = u64::from(a.neg);
            out[first] = c.index(a.x);
            // Only a trim asks for these.
            out.set(pf, a.pf);
            out.set(le, c.index(a.le));
        }
        out.set("finest", u64::from(o.lod));
    }),
    stimulus: Some(whole_ray),
    ..WATERTIGHT
};

static HIT_POSITION: Unit = Unit {
    name: "hit_position",
    model: Some(|c, row, out| {
        let (f, frac) = (c.design.format, c.param("FRAC_W"));
        let at = gf::add(f, row["p"], gf::mul(f, row["d"], row["t"]));
        let (texel, fraction) = kept_in_node(c, frac, gf::to_fixed(f, at, c.idx_w + frac, frac), row);
        out["fraction"] = fraction;
        out.set("texel", texel);
    }),
    legal: Some(|c, row| some_level(c, row, "lod")),
    stimulus: Some(one_axis_in_node),
    ..WATERTIGHT
};

static CHORD_END: Unit = Unit {
    name: "chord_end",
    model: Some(|c, row, out| {
        let (f, t) = (c.design.format, row["t"]);
        let last = (1i64 << (c.idx_w - 1)) - 1;
        let reach = match gf::decode(f, t) {
            gf::Value::Infinite(_) | gf::Value::Nan if row.is_set("neg") => -last - 1,
            gf::Value::Infinite(_) | gf::Value::Nan => last,
            _ => gf::to_int(f, gf::add(f, row["p_ahead"], gf::mul(f, row["d"], t)), c.idx_w),
        };
        out["bound"] = c.index(reach);
    }),
    stimulus: Some(one_axis),
    ..WATERTIGHT
};
