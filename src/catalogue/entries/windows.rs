//! Units that the search by windows alone has.
use super::super::datapath::WINDOWS;
use super::super::ray_stimulus::{whole_ray, window_axis, windows::with_least_set};
use super::super::row::Context;
use super::super::unit::Unit;
use super::fixed;
use crate::bits::mask;
use crate::config::{Design, Window, WindowWidths};
use crate::golden::fixed::FixedAxis;
use crate::golden::{Datapath, RayInput, WindowAxis, Windows};
use crate::proofs::{PROOF, Proof};

/// The entries.
pub const UNITS: &[&Unit] = &[
    &RECIPROCAL,
    &AXIS_SLOPE,
    &RAY_SETUP,
    &HIT_POSITION,
    &CONSTANTS,
    &SETUP,
    &TEXEL,
    &ADDRESS,
    &PRODUCT,
    &SUM,
    &SPAN,
    &END,
    &EXIT,
    &CHOICE,
    &ADVANCE,
    &WAY,
    &INDEX,
];

/// Bits of a multiplier's operand.
const OPERAND: u32 = 18;
/// The farthest plane of a window, counted from the one ahead of the texel.
const FARTHEST: u64 = 78;

static RECIPROCAL: Unit = Unit { datapath: WINDOWS.datapath, ..fixed::RECIPROCAL };
static AXIS_SLOPE: Unit = Unit { datapath: WINDOWS.datapath, ..fixed::AXIS_SLOPE };
static RAY_SETUP: Unit = Unit { datapath: WINDOWS.datapath, ..fixed::RAY_SETUP };
static HIT_POSITION: Unit = Unit { datapath: WINDOWS.datapath, ..fixed::HIT_POSITION };

/// The design with the least value of what a unit does not depend on: beside the values that it has, the defaults may be too large.
fn least(c: &Context<'_>) -> Design {
    let mut d = with_least_set(&c.design);
    let least = |name: &str, slot: &mut u32, value: u32| {
        if !c.binding.contains_key(name) {
            *slot = value;
        }
    };
    least("LEVELS", &mut d.traverse.levels, 2);
    least("HEIGHT_W", &mut d.traverse.height_bits, 2);
    least("TILE_W", &mut d.traverse.tile_bits, 1);
    least("RECIP_W", &mut d.datapath.reciprocal_bits, 8);
    d
}

fn golden(c: &Context<'_>) -> Windows {
    Windows::prepare(&least(c)).expect("the set's parameters are legal")
}

fn widths(c: &Context<'_>) -> WindowWidths {
    WindowWidths::of(&least(c))
}

/// Bits of a parameter below a height code.
fn low_bits(c: &Context<'_>) -> u32 {
    c.design.datapath.fraction_bits + 2 - c.design.traverse.height_bits
}

/// Bits of Q that the lower multiplier takes.
fn low_of_plane(c: &Context<'_>) -> u32 {
    OPERAND.min(widths(c).plane - 1)
}

/// A ray's place along an axis.
fn at(texel: u64, neg: bool) -> WindowAxis {
    WindowAxis { fixed: FixedAxis { x: texel as i64, neg, ..FixedAxis::default() }, ..WindowAxis::default() }
}

static CONSTANTS: Unit = Unit {
    name: "window_constants",
    model: Some(|c, row, out| {
        let [p, r, s] = ["p", "r", "s"].map(|n| row[n]);
        let neg = row.is_set("neg");
        let axis = golden(c).axis(FixedAxis { p, a: r, neg, r, z: row["z"] as u32, s, ..FixedAxis::default() });
        [out["q"], out["c"], out["travel"], out["offset"]] = [axis.q, axis.c, axis.s, axis.o];
    }),
    legal: Some(|c, row| {
        // Of a ray that moves, the top bit is set.
        let (d, r) = (&c.design, row["r"]);
        row["r"] = if r >> 2 == 0 { 0 } else { r | 1 << (d.datapath.reciprocal_bits - 1) };
        row["z"] = row["z"].min(u64::from(d.datapath.fraction_bits + d.traverse.tile_bits + 1));
    }),
    stimulus: Some(window_axis),
    ..WINDOWS
};

static SETUP: Unit = Unit {
    name: "window_setup",
    model: Some(|c, row, out| {
        let [u, v, du, dv] = ["u", "v", "du", "dv"].map(|p| row[p]);
        let g = golden(c);
        let axes = g.setup(&RayInput { u, v, du, dv, lod: 0 });
        out["ok"] = u64::from(axes.is_some());
        // What can't be traced moves along no axis.
        let axes = axes.unwrap_or_else(|| [g.axis(FixedAxis::default()); 2]);
        let x = ["p_x", "s_x", "neg_x", "q_x", "c_x", "travel_x", "offset_x"];
        let y = ["p_y", "s_y", "neg_y", "q_y", "c_y", "travel_y", "offset_y"];
        for (a, names) in axes.iter().zip([x, y]) {
            let words = [a.fixed.p, a.fixed.s, u64::from(a.fixed.neg), a.q, a.c, a.s, a.o];
            names.into_iter().zip(words).for_each(|(n, word)| out[n] = word);
        }
    }),
    stimulus: Some(whole_ray),
    ..WINDOWS
};

static TEXEL: Unit = Unit {
    name: "window_texel",
    model: Some(|c, row, out| {
        let texel = at(row["origin"], row.is_set("neg")).texel(row["k"] as i64);
        out["texel"] = texel as u64 & mask(c.design.traverse.levels);
    }),
    stimulus: Some(window_axis),
    ..WINDOWS
};

static ADDRESS: Unit = Unit {
    name: "window_address",
    model: Some(|c, row, out| {
        let grid = 1 << c.param("GRID_W");
        let window = Window { side: grid * c.param("CELLS"), grid };
        let bits = c.design.traverse.levels - window.grid_bits();
        let axes = ["x", "y"].map(|a| at(row[a], row.is_set(if a == "x" { "neg_x" } else { "neg_y" })));
        let [i, j] = axes.map(|a| a.index(0, window) as u64 & mask(bits));
        out["address"] = j << bits | i;
        for (name, axis) in ["border_x", "border_y"].into_iter().zip(axes) {
            out[name] = axis.beyond(0, window) as u64 - u64::from(window.ahead());
        }
    }),
    bindings: &[
        &[("GRID_W", 0), ("CELLS", 1)],
        &[("GRID_W", 0), ("CELLS", 27)],
        &[("GRID_W", 2), ("CELLS", 3)],
        &[("GRID_W", 2), ("CELLS", 16), ("LEVELS", 2)],
        &[("GRID_W", 3), ("CELLS", 5), ("LEVELS", 4)],
        &[("GRID_W", 4), ("CELLS", 4)],
    ],
    ..WINDOWS
};

static PRODUCT: Unit = Unit {
    name: "plane_product",
    model: Some(|c, row, out| {
        let (k, q, low) = (row["k"], row["q"], low_of_plane(c));
        out["low"] = k * (q & mask(low));
        out["high"] = k * (q >> low);
    }),
    stimulus: Some(window_axis),
    ..WINDOWS
};

static SUM: Unit = Unit {
    name: "plane_sum",
    model: Some(|c, row, out| {
        let [begin, low, high] = ["c", "low", "high"].map(|n| u128::from(row[n]));
        let (exact, bits) = (begin + low + (high << low_of_plane(c)), widths(c).plane);
        out["plane"] = u64::from(exact >> bits != 0) << bits | exact as u64 & mask(bits);
    }),
    ..WINDOWS
};

static SPAN: Unit = Unit {
    name: "window_span",
    model: Some(|c, row, out| out["span"] = row["q"] * (u64::from(c.param("AHEAD")) + row["border"])),
    // The grid divides S - g, so they have no bit in common.
    legal: Some(|c, row| row["border"] &= !u64::from(c.param("AHEAD"))),
    stimulus: Some(window_axis),
    bindings: &[&[("AHEAD", 0)], &[("AHEAD", 8)], &[("AHEAD", 26)], &[("AHEAD", 48)], &[("AHEAD", 63)]],
    ..WINDOWS
};

static END: Unit = Unit {
    name: "window_end",
    model: Some(|_, row, out| out["ends_at"] = row["plane"] + row["span"]),
    legal: Some(|c, row| row["span"] = row["span"].min(FARTHEST * mask(widths(c).plane))),
    ..WINDOWS
};

static EXIT: Unit = Unit {
    name: "window_exit",
    model: Some(|c, row, out| {
        let (g, w) = (golden(c), widths(c));
        // Of a plane that is `end` from the entry on: the first one of its axis.
        let met = |end: u64| {
            let all = mask(w.plane);
            g.plane_time(&WindowAxis { c: end.min(all), ..WindowAxis::default() }, 0)
        };
        let [t_x, t_y] = ["end_x", "end_y"].map(|n| met(row[n]));
        let (exit, depth) = (t_x.min(t_y), mask(c.design.traverse.height_bits) - row["height"]);
        out["exit"] = exit;
        out["x_first"] = u64::from(t_x <= t_y);
        out["fraction"] = u64::from(exit & mask(low_bits(c)) != 0);
        out["is_in"] = u64::from(depth << low_bits(c) < exit);
        out["is_open"] = u64::from(row["t"] < exit);
        out["depth"] = depth;
    }),
    stimulus: Some(window_axis),
    ..WINDOWS
};

/// A port of a size.
fn of(name: &str, size: usize) -> String {
    format!("{name}_{size}")
}

static CHOICE: Unit = Unit {
    name: "window_choice",
    model: Some(|c, row, out| {
        let set = c.design.window_set();
        let sizes = set.sizes();
        let last = sizes.len() - 1;
        let word = |name: &str, size: usize| row[of(name, size).as_str()];
        let is_in = |size: usize| word("is_in", size) == 1;
        let a = (0..=last).rev().find(|size| !is_in(*size)).unwrap_or(0);
        let goes = !row.is_set("stays");
        let ends = is_in(0) && row.is_set("is_open");
        out["hit"] = u64::from(ends && goes);
        out["exit"] = word("exit", a);
        out["x_first"] = word("x_first", a);
        out["fraction"] = word("fraction", a);
        out["depth"] = if is_in(0) {
            word("depth", 0)
        } else if a < last {
            word("depth", a + 1)
        } else {
            0
        };
        out["takes_exit"] = u64::from(!is_in(0) && goes);
        out["takes_depth"] = u64::from(goes && if is_in(0) { ends } else { a < last });
        out["crosses"] = u64::from(goes && !ends);
        for (past, border) in [("past_x", "border_x"), ("past_y", "border_y")] {
            out[past] = u64::from(sizes[a].ahead()) + (row[border] & u64::from(sizes[a].grid - 1));
        }
    }),
    // What can hold the hit is larger than what can't.
    legal: Some(|c, row| {
        for size in 1..c.design.window_set().sizes().len() {
            row[of("is_in", size).as_str()] |= row[of("is_in", size - 1).as_str()];
        }
    }),
    ..WINDOWS
};

static ADVANCE: Unit = Unit {
    name: "window_advance",
    model: Some(|c, row, out| {
        let (t, depth) = (row["t"], row["depth"] << low_bits(c));
        let counts = |flag: &str, word: u64| if row.is_set(flag) { word } else { 0 };
        out["m"] = t.max(counts("takes_exit", row["exit"])).max(counts("takes_depth", depth));
        out["below"] = u64::from(depth < t);
        let x_first = row.is_set("x_first");
        let passed = |first: bool, past: u64| if row.is_set("crosses") && first { past + 1 } else { 0 };
        let all = mask(widths(c).planes);
        out["passed_x"] = (row["k_x"] + passed(x_first, row["past_x"])) & all;
        out["passed_y"] = (row["k_y"] + passed(!x_first, row["past_y"])) & all;
    }),
    legal: Some(|c, row| row["fraction"] = u64::from(row["exit"] & mask(low_bits(c)) != 0)),
    ..WINDOWS
};

static WAY: Unit = Unit {
    name: "window_way",
    model: Some(|c, row, out| {
        // Without a fraction of the texel and from its border, an estimate is the way itself.
        let (g, w) = (golden(c), widths(c));
        let axis = WindowAxis { s: row["travel"], ..WindowAxis::default() };
        let whole = g.planes_passed(&axis, row["m"]) as u64;
        let way = ((u128::from(row["travel"]) * u128::from(row["m"] >> (w.parameter - w.time))) >> w.time) as u64;
        assert_eq!(way >> w.estimate_fraction, whole, "the way is that of the estimate");
        out["way"] = way;
    }),
    stimulus: Some(window_axis),
    ..WINDOWS
};

static INDEX: Unit = Unit {
    name: "window_index",
    model: Some(|c, row, out| {
        out["k"] = row["passed"].max((row["way"] + row["offset"]) >> widths(c).estimate_fraction);
    }),
    // An offset is less than a texel.
    legal: Some(|c, row| row["offset"] &= mask(widths(c).estimate_fraction)),
    proofs: &[Proof {
        name: "window_progress",
        units: &[CHOICE.name, ADVANCE.name, "window_index"],
        claim: "an iteration without a hit takes the ray beyond a plane, and none takes it back: no ray visits a texel again",
        text: harness!("window_progress"),
        chained: true,
        ..PROOF
    }],
    ..WINDOWS
};
