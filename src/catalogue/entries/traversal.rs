//! Units of the traversal that more than one datapath has: nodes, levels, addresses.
use super::super::ray_stimulus::{both_axes, both_ends};
use super::super::row::{Context, Row};
use super::super::unit::{UNIT, Unit};
use super::{in_order, some_level};
use crate::bits::signed;
use crate::config::{LevelUp, Trim};
use crate::golden::{Crossing, address, descend_levels, level_after, start_level};
use crate::proofs::{BIT_LEVEL, PROOF, Proof};

/// The entries.
pub const UNITS: &[&Unit] = &[
    &START_LEVEL,
    &FINEST_LEVEL,
    &HEIGHT_ADDRESS,
    &NODE_PLANES,
    &MULTI_LEVEL_DOWN,
    &LEVEL_UP,
    &LEVEL_DECISION,
    &NODE_HIT,
    &CHORD_TRIM,
    &TRIM_RETURN,
];

static START_LEVEL: Unit = Unit {
    name: "start_level",
    model: Some(|c, row, out| {
        let [x, y, x_end, y_end] = ["x", "y", "x_end", "y_end"].map(|p| c.signed(row[p]));
        out["level"] = u64::from(start_level(c.design.traverse.levels, c.idx_w, x, y, x_end, y_end));
    }),
    stimulus: Some(both_ends),
    proofs: &[Proof {
        name: "start_level",
        units: &["start_level"],
        claim: "the lowest level whose node holds both ends of the ray",
        text: harness!("start_level"),
        ..PROOF
    }],
    ..UNIT
};

static FINEST_LEVEL: Unit = Unit {
    name: "finest_level",
    model: Some(|c, row, out| {
        let finest = row["lod"].min(u64::from(c.design.top_level()));
        out["finest"] = finest;
        out["level"] = row["start"].max(finest);
    }),
    legal: Some(|c, row| row["start"] %= u64::from(c.design.top_level()) + 1),
    ..UNIT
};

static HEIGHT_ADDRESS: Unit = Unit {
    name: "height_address",
    model: Some(|c, row, out| {
        let [k, i, j] = ["level", "i", "j"].map(|p| row[p] as u32);
        out["address"] = address(c.design.traverse.levels, k, i >> k, j >> k) as u64;
    }),
    legal: Some(|c, row| some_level(c, row, "level")),
    proofs: &[Proof {
        name: "height_address",
        units: &["height_address"],
        claim: "inside the memory, and no two nodes share a word",
        text: harness!("height_address"),
        ..PROOF
    }],
    ..UNIT
};

static NODE_PLANES: Unit = Unit {
    name: "node_planes",
    model: Some(|c, row, out| {
        let (k, at, neg) = (row["level"] as u32, c.signed(row["x"]), row.is_set("neg"));
        let size = 1i64 << k;
        let first = at.div_euclid(size) * size;
        let plane = if neg { first } else { first + size };
        out["low"] = c.index(if neg { first } else { at });
        out["high"] = c.index(if neg { at } else { first + size - 1 });
        out["plane"] = c.index(plane);
        out["beyond"] = c.index(if neg { first - 1 } else { plane });
        // Past the largest coordinate the plane wraps with its word.
        let wrapped = c.signed(c.index(plane)).div_euclid(size);
        out.set("even", u64::from(wrapped.rem_euclid(2) == 0));
    }),
    legal: Some(|c, row| some_level(c, row, "level")),
    proofs: &[Proof {
        name: "node_planes",
        units: &["node_planes"],
        claim: "extent, exit plane and the texel beyond it are those of the node",
        text: harness!("node_planes"),
        ..PROOF
    }],
    ..UNIT
};

static MULTI_LEVEL_DOWN: Unit = Unit {
    name: "multi_level_down",
    model: Some(|c, row, out| {
        let level = row["level"];
        let down = descend_levels(c.design.mode.levels_down, level as u32, row.is_set("crossed"));
        out["level_down"] = (level - u64::from(down)).max(row.get("lod").unwrap_or(0));
        let kept = |low: &str, high: &str, hit: &str| {
            let (low, high, hit) = (c.signed(row[low]), c.signed(row[high]), c.signed(row[hit]));
            c.index(if hit < low { low } else { hit.min(high) })
        };
        out["x_down"] = kept("x_low", "x_high", "x_hit");
        out["y_down"] = kept("y_low", "y_high", "y_hit");
    }),
    legal: Some(|c, row| {
        row["level"] = row["level"] % c.levels() + 1;
        in_order(c, row, "x_low", "x_high");
        in_order(c, row, "y_low", "y_high");
        some_level(c, row, "lod");
    }),
    stimulus: Some(both_axes),
    proofs: &[Proof {
        name: "multi_level_down",
        units: &["multi_level_down"],
        claim: "a descent goes at least one level down, stays in its bounds, and obeys the mode",
        text: harness!("multi_level_down"),
        ..PROOF
    }],
    ..UNIT
};

static LEVEL_UP: Unit = Unit {
    name: "level_up",
    model: Some(|c, row, out| {
        let level = row["level"] as u32;
        // A plane whose parity in node units is the wanted one.
        let plane = row.get("even").map_or(0, |even| (1 - even as i64) << level);
        let [x, e_x, y, e_y] = ["x_at", "x_hit", "y_at", "y_hit"].map(|p| row.get(p).map_or(0, |v| c.signed(v)));
        let crossing = Crossing { level, plane, x, y, e_x, e_y, previous: row.is_set("prev_crossed") };
        out["up"] = u64::from(level_after(&c.design.mode, c.design.traverse.levels, level, &crossing) > level);
    }),
    // Coordinates keep a bit of headroom: IDX_W holds any sum of an entry point and a travel.
    legal: Some(|c, row| {
        some_level(c, row, "level");
        for port in ["x_at", "x_hit", "y_at", "y_hit"] {
            row.map(port, |v| c.index(c.signed(v) >> 1));
        }
    }),
    stimulus: Some(both_axes),
    proofs: &[Proof {
        name: "level_up",
        units: &["level_up"],
        claim: "the rule, and never above the root",
        text: harness!("level_up"),
        ..PROOF
    }],
    ..UNIT
};

static LEVEL_DECISION: Unit = Unit {
    name: "level_decision",
    model: Some(|c, row, out| {
        let (inside, level) = (row.is_set("is_inside"), row["level"]);
        let hit = inside && level == row.get("lod").unwrap_or(0);
        // Where the design trims, the level of a crossing comes from outside.
        let across = row.get("level_across").unwrap_or_else(|| level + row["up"]);
        let choose = |here: u64, down: u64, beyond: u64| match (hit, inside) {
            (true, _) => here,
            (false, true) => down,
            (false, false) => beyond,
        };
        out["hit"] = u64::from(hit);
        out["crosses"] = u64::from(!inside);
        out["level_next"] = choose(level, row["level_down"], c.level(across));
        let x_first = row.is_set("x_first");
        out["x_next"] = choose(row["x_at"], row["x_down"], row[if x_first { "x_beyond" } else { "x_at" }]);
        out["y_next"] = choose(row["y_at"], row["y_down"], row[if x_first { "y_at" } else { "y_beyond" }]);
        out["t_out"] = row[if inside { "m" } else { "t_next" }];
    }),
    legal: Some(|c, row| {
        some_level(c, row, "level");
        some_level(c, row, "lod");
    }),
    proofs: &[
        Proof {
            name: "level_decision",
            units: &["level_decision"],
            claim: "hit, descent or crossing: every output is that of the case",
            text: harness!("level_decision"),
            engine: BIT_LEVEL,
            ..PROOF
        },
        Proof {
            name: "progress",
            units: &[NODE_PLANES.name, MULTI_LEVEL_DOWN.name, "level_decision"],
            claim: "a crossing moves the integer index forward, a descent never back: no ray visits a texel again",
            text: harness!("progress"),
            chained: true,
            ..PROOF
        },
    ],
    ..UNIT
};

static NODE_HIT: Unit = Unit {
    name: "node_hit",
    model: Some(|c, row, out| {
        let at = signed(row["at"], c.idx_w + c.param("FRAC_W"));
        let (texel, fraction) = kept_in_node(c, c.param("FRAC_W"), at, row);
        out["texel"] = texel;
        out["fraction"] = fraction;
    }),
    legal: Some(|c, row| some_level(c, row, "lod")),
    ..UNIT
};

/// Texel (wrapped) and fraction of position `at`, in units of 2^-`frac` texels, kept in the node of level `lod` that holds the texel `x`.
pub(super) fn kept_in_node(c: &Context<'_>, frac: u32, at: i64, row: &Row<'_>) -> (u64, u64) {
    let (x, lod) = (c.signed(row["x"]), row.get("lod").unwrap_or(0));
    let (unit, size) = (1i64 << frac, 1i64 << lod);
    let first = x.div_euclid(size) * size;
    let kept = at.clamp(first * unit, (first + size) * unit - 1);
    let (texel, fraction) = (kept.div_euclid(unit), kept.rem_euclid(unit));
    (texel.rem_euclid(1 << c.design.traverse.levels) as u64, fraction as u64)
}

static CHORD_TRIM: Unit = Unit {
    name: "chord_trim",
    model: Some(|c, row, out| {
        // The far end along an axis: at the ray's end, or before, where the other axis' plane is met.
        let end = |[low, high, neg, reach, last]: [&str; 5], exits: bool| {
            let [low, high, reach, last] = [low, high, reach, last].map(|p| c.signed(row[p]));
            let nearer = if row.is_set(neg) { reach.max(last) } else { reach.min(last) };
            let end = if exits { last } else { nearer };
            if end < low { low } else { end.min(high) }
        };
        let x_first = row.is_set("x_first");
        let x_end = end(["x_low", "x_high", "x_neg", "x_bound", "x_last"], x_first);
        let y_end = end(["y_low", "y_high", "y_neg", "y_bound", "y_last"], !x_first);
        let (x, y) = (c.signed(row["x_at"]), c.signed(row["y_at"]));
        let tight = u64::from(start_level(c.design.traverse.levels, c.idx_w, x, y, x_end, y_end));
        // Of a block, its cells' level.
        let tight = if c.design.fetch.blocks() { tight.saturating_sub(1) } else { tight };
        let trims = c.design.mode.trim == Trim::Always || row.is_set("descended");
        out["x_chord"] = c.index(x_end);
        out["y_chord"] = c.index(y_end);
        out["level_read"] = if trims { tight.max(row.get("lod").unwrap_or(0)) } else { row["level"] };
    }),
    legal: Some(|c, row| {
        some_level(c, row, "level");
        some_level(c, row, "lod");
        in_order(c, row, "x_low", "x_high");
        in_order(c, row, "y_low", "y_high");
    }),
    stimulus: Some(both_axes),
    ..UNIT
};

static TRIM_RETURN: Unit = Unit {
    name: "trim_return",
    model: Some(|c, row, out| {
        let (level, read, up) = (row["level"], row["level_read"], row.is_set("up"));
        let stays = read < level && !up && c.design.mode.level_up == LevelUp::Selective;
        let grows = read >= level && up;
        out["level_across"] = if stays { read } else { c.level(level + u64::from(grows)) };
        out["grown"] = u64::from(grows);
    }),
    legal: Some(|c, row| {
        some_level(c, row, "level");
        row["level_read"] %= row["level"] + 1;
    }),
    ..UNIT
};
