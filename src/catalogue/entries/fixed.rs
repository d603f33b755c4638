//! Units that the fixed-point datapath alone has.
use super::super::datapath::FIXED;
use super::super::ray_stimulus::{both_axes, first_axis, one_axis, one_axis_in_node, whole_ray};
use super::super::row::{Context, Row};
use super::super::unit::Unit;
use super::some_level;
use super::traversal::kept_in_node;
use crate::bits::mask;
use crate::golden::fixed::{Fixed, FixedAxis};
use crate::golden::{Datapath, RayInput};
use crate::proofs::{BIT_LEVEL, PROOF, Proof};

/// The entries.
pub const UNITS: &[&Unit] = &[
    &RECIPROCAL,
    &PLANE_TIME,
    &HEIGHT_TEST,
    &PREDICTED_HIT,
    &NODE_CROSSING,
    &AXIS_SLOPE,
    &AXIS_ENDS,
    &RAY_SETUP,
    &HIT_POSITION,
    &CHORD_END,
];

/// The narrowest words of the fixed-point datapath, and a map whose texels are their units.
const NARROW: &[(&str, i64)] = &[("FRACTION_W", 8), ("RECIP_W", 8), ("LEVELS", 8), ("HEIGHT_W", 2), ("TILE_W", 1)];

/// The golden model at the least value of what a unit does not depend on: beside the values that it has, the defaults may be too large.
fn golden(c: &Context<'_>) -> Fixed {
    let mut d = c.design;
    let least = |name: &str, slot: &mut u32, value: u32| {
        if !c.binding.contains_key(name) {
            *slot = value;
        }
    };
    least("LEVELS", &mut d.traverse.levels, 2);
    least("HEIGHT_W", &mut d.traverse.height_bits, 2);
    least("TILE_W", &mut d.traverse.tile_bits, 1);
    least("RECIP_W", &mut d.datapath.reciprocal_bits, 8);
    Fixed::prepare(&d).expect("the set's parameters are legal")
}

/// A ray's constants along an axis, as the ports of a unit bring them.
fn axis(row: &Row<'_>) -> FixedAxis {
    FixedAxis { p: row["p"], s: row["s"], neg: row.is_set("neg"), ..FixedAxis::default() }
}

/// Bits of a distance: a ray's way stays below 2^TILE_W tiles.
const fn reach(c: &Context<'_>) -> u32 {
    c.design.datapath.fraction_bits + c.design.traverse.tile_bits
}

pub(super) const RECIPROCAL: Unit = Unit {
    name: "reciprocal",
    model: Some(|c, row, out| {
        let (r, z) = golden(c).reciprocal(row["a"]);
        out["r"] = r;
        out["z"] = u64::from(z);
    }),
    stimulus: Some(one_axis),
    ..FIXED
};

static PLANE_TIME: Unit = Unit {
    name: "plane_time",
    model: Some(|c, row, out| {
        let plane = c.signed(row["plane"]) << (c.design.datapath.fraction_bits - c.design.traverse.levels);
        let ahead = plane - row["p"] as i64;
        // A plane that no ray looks at may be passed or too far; its distance has as many bits as any.
        let distance = if row.is_set("neg") { -ahead } else { ahead } as u64 & mask(reach(c) + 1);
        out["t"] = golden(c).plane_time(distance, row["r"], row["z"] as u32);
    }),
    // A distance is moved by at most as much as loses its last bit.
    legal: Some(|c, row| row["z"] = row["z"].min(u64::from(reach(c) + 1))),
    stimulus: Some(one_axis),
    proofs: &[Proof {
        name: "fixed_plane_time",
        units: &["plane_time", RECIPROCAL.name],
        claim: "the product of distance and slope, rounded down, or all ones: monotone in the plane (8/8)",
        text: harness!("fixed_plane_time"),
        engine: BIT_LEVEL,
        over: NARROW,
        ..PROOF
    }],
    ..FIXED
};

static HEIGHT_TEST: Unit = Unit {
    name: "height_test",
    model: Some(|c, row, out| {
        let (t_v, t) = (golden(c).height_time(row["height"]), row["t"]);
        out["m"] = t.max(t_v);
        out["below"] = u64::from(t_v < t);
    }),
    stimulus: Some(both_axes),
    ..FIXED
};

static PREDICTED_HIT: Unit = Unit {
    name: "predicted_hit",
    model: Some(|c, row, out| out["e"] = c.index(golden(c).estimate(&axis(row), row["m"]))),
    stimulus: Some(one_axis),
    proofs: &[Proof {
        name: "fixed_predicted_hit",
        units: &[RAY_SETUP.name, PLANE_TIME.name, "predicted_hit", RECIPROCAL.name],
        claim: "an estimate passes no plane before its parameter (8/8)",
        text: harness!("fixed_predicted_hit"),
        engine: BIT_LEVEL,
        over: NARROW,
        chained: true,
        ..PROOF
    }],
    ..FIXED
};

static NODE_CROSSING: Unit = Unit {
    name: "node_crossing",
    model: Some(|_, row, out| {
        let [t, m, t_x, t_y] = ["t", "m", "t_x", "t_y"].map(|p| row[p]);
        out["is_inside"] = u64::from(m < t_x && m < t_y);
        out["x_first"] = u64::from(t_x <= t_y);
        out["t_next"] = t.max(t_x.min(t_y));
    }),
    stimulus: Some(both_axes),
    ..FIXED
};

/// A travel of F + T + 1 bits.
fn travel(c: &Context<'_>, row: &Row<'_>) -> i64 {
    let sign = 1 << reach(c);
    (row["d"] & (sign - 1)) as i64 - (row["d"] & sign) as i64
}

pub(super) const AXIS_SLOPE: Unit = Unit {
    name: "axis_slope",
    model: Some(|c, row, out| {
        let d = travel(c, row);
        // The most negative word has no magnitude of its bits.
        let magnitude = d.unsigned_abs() & mask(reach(c));
        let a = golden(c).slope(row.get("p").unwrap_or(0), magnitude, d < 0);
        out["s"] = a.s;
        out["r"] = a.r;
        out["z"] = u64::from(a.z);
        out["neg"] = u64::from(a.neg);
        // Only a trim asks for it.
        out.set("farthest", c.index(a.le));
    }),
    stimulus: Some(first_axis),
    ..FIXED
};

static AXIS_ENDS: Unit = Unit {
    name: "axis_ends",
    model: Some(|c, row, out| {
        let [first, last] = golden(c).ends(row["p"], travel(c, row));
        out["first"] = c.index(first);
        out["last"] = c.index(last);
    }),
    stimulus: Some(first_axis),
    ..FIXED
};

pub(super) const RAY_SETUP: Unit = Unit {
    name: "ray_setup",
    model: Some(|c, row, out| {
        let [u, v, du, dv] = ["u", "v", "du", "dv"].map(|p| row[p]);
        let o = golden(c).setup(&RayInput { u, v, du, dv, lod: row.get("lod").unwrap_or(0) as u32 });
        out["ok"] = u64::from(o.valid);
        // A search by windows has no nodes: no level, and no first texel beside the entry point.
        out.set("level", u64::from(o.level));
        let x = ["p_x", "s_x", "r_x", "z_x", "neg_x", "first_x", "le_x"];
        let y = ["p_y", "s_y", "r_y", "z_y", "neg_y", "first_y", "le_y"];
        for (a, [p, s, r, z, neg, first, le]) in [(o.u, x), (o.v, y)] {
            out[p] = a.p;
            out[s] = a.s;
            out[r] = a.r;
            out[z] = u64::from(a.z);
            out[neg] = u64::from(a.neg);
            out.set(first, c.index(a.x));
            // Only a trim asks for it.
            out.set(le, c.index(a.le));
        }
        out.set("finest", u64::from(o.lod));
    }),
    stimulus: Some(whole_ray),
    ..FIXED
};

pub(super) const HIT_POSITION: Unit = Unit {
    name: "hit_position",
    model: Some(|c, row, out| {
        let at = golden(c).place(&axis(row), row["t"]);
        let (texel, fraction) = kept_in_node(c, c.design.traverse.frac_bits, at, row);
        out["fraction"] = fraction;
        out.set("texel", texel);
    }),
    legal: Some(|c, row| {
        row["s"] &= mask(reach(c));
        some_level(c, row, "lod");
    }),
    stimulus: Some(one_axis_in_node),
    ..FIXED
};

static CHORD_END: Unit = Unit {
    name: "chord_end",
    model: Some(|c, row, out| out["bound"] = c.index(golden(c).chord_end(&axis(row), row["t"]))),
    // A travel per height code is less than 4/3 of a travel: two height bits make the least M.
    legal: Some(|c, row| row["s"] = row["s"].min(mask(reach(c)) * 4 / 3)),
    stimulus: Some(one_axis),
    proofs: &[Proof {
        name: "fixed_chord_end",
        units: &[RAY_SETUP.name, PLANE_TIME.name, "chord_end", RECIPROCAL.name],
        claim: "a chord ends beyond every plane that is met by its parameter, and so does the ray at the bottom plane (8/8)",
        text: harness!("fixed_chord_end"),
        engine: BIT_LEVEL,
        over: NARROW,
        chained: true,
        ..PROOF
    }],
    ..FIXED
};
