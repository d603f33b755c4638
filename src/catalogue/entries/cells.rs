//! Units that judge four cells in one iteration, of both watertight datapaths.
use super::super::datapath::{FIXED, WATERTIGHT};
use super::super::ray_stimulus::{block_planes, both_axes, one_axis, one_node};
use super::super::row::Row;
use super::super::unit::{UNIT, Unit};
use super::{in_order, some_level};
use crate::bits::mask;
use crate::golden::float as gf;

/// The entries.
pub const UNITS: &[&Unit] = &[&MIDDLE, &DESCENT, &CHOICE, &ORDER, &FIXED_ORDER, &LIMIT, &FIXED_LIMIT];

static MIDDLE: Unit = Unit {
    name: "block_middle",
    model: Some(|c, row, out| {
        let (at, neg, half) = (c.signed(row["x"]), row.is_set("neg"), 1i64 << row["level"]);
        let plane = at.div_euclid(2 * half) * 2 * half + half;
        let past = if neg { at < plane } else { at >= plane };
        let border = if neg { plane - 1 } else { plane };
        out["middle"] = c.index(plane);
        out["past"] = u64::from(past);
        out["first"] = c.index(if past { at } else { border });
    }),
    legal: Some(|c, row| row["level"] %= c.levels()),
    stimulus: Some(one_node),
    ..UNIT
};

static DESCENT: Unit = Unit {
    name: "block_descent",
    model: Some(|c, row, out| {
        let mode = &c.design.mode;
        let down = if row.is_set("crossed") { c.design.levels_down_after() } else { mode.levels_down };
        out["level_down"] = row["level"].saturating_sub(u64::from(down)).max(row.get("lod").unwrap_or(0));
        let kept = |low: &str, high: &str, hit: &str| {
            let (low, high, hit) = (c.signed(row[low]), c.signed(row[high]), c.signed(row[hit]));
            c.index(hit.clamp(low, high))
        };
        out["x_down"] = kept("x_low", "x_high", "x_hit");
        out["y_down"] = kept("y_low", "y_high", "y_hit");
    }),
    legal: Some(|c, row| {
        row["level"] %= c.levels();
        in_order(c, row, "x_low", "x_high");
        in_order(c, row, "y_low", "y_high");
        some_level(c, row, "lod");
    }),
    stimulus: Some(both_axes),
    ..UNIT
};

/// A cell: whether it is in the far half along x and along y.
type Cell = [bool; 2];

/// What the bits of a row say of a block, whether or not there is a ray of which they are true.
struct Block<'a, 'b>(&'a Row<'b>);

impl Block<'_, '_> {
    fn past(&self) -> Cell {
        ["past_x", "past_y"].map(|n| self.0.is_set(n))
    }

    /// Whether the first of two parameters is less.
    fn less(&self, first: &str, second: &str) -> bool {
        self.0.is_set(&format!("{first}_lt_{second}"))
    }

    /// The plane by which a cell ends along each axis.
    fn exits(cell: Cell) -> [&'static str; 2] {
        [if cell[0] { "far_x" } else { "mid_x" }, if cell[1] { "far_y" } else { "mid_y" }]
    }

    /// What must come before a cell is left: the ray itself, and the middle planes that it has yet to pass.
    fn entries(&self, cell: Cell) -> Vec<&'static str> {
        let past = self.past();
        let planes = ["mid_x", "mid_y"].into_iter().enumerate().filter(|(k, _)| cell[*k] && !past[*k]);
        ["t"].into_iter().chain(planes.map(|p| p.1)).collect()
    }

    fn place(&self, cell: Cell) -> usize {
        let upper = |k: usize, neg: &str| usize::from(cell[k] != self.0.is_set(neg));
        upper(0, "neg_x") + 2 * upper(1, "neg_y")
    }

    fn height(&self, cell: Cell) -> u64 {
        self.0[["height_0", "height_1", "height_2", "height_3"][self.place(cell)]]
    }

    fn hits(&self, height_bits: u32, cell: Cell) -> bool {
        let (past, exits) = (self.past(), Self::exits(cell));
        let open = (0..2).all(|k| cell[k] || !past[k]);
        let on_way = self.entries(cell).into_iter().all(|entry| exits.iter().all(|exit| self.less(entry, exit)));
        let depth = mask(height_bits) - self.height(cell);
        open && on_way && exits.iter().all(|exit| depth < self.0[format!("limit_{exit}").as_str()])
    }
}

static CHOICE: Unit = Unit {
    name: "cell_choice",
    model: Some(|c, row, out| {
        let block = Block(row);
        let order: [Cell; 4] = [[false, false], [true, false], [false, true], [true, true]];
        let found = order.into_iter().find(|cell| block.hits(c.param("HEIGHT_W"), *cell));
        let [past_x, past_y] = block.past();
        let x_first = !block.less("far_y", "far_x");
        let last: Cell = match x_first {
            true => [true, past_y || block.less("mid_y", "far_x")],
            false => [past_x || !block.less("far_y", "mid_x"), true],
        };
        let cell = found.unwrap_or(last);
        // By the bits alone: they need not be those of the words.
        let enters = block.entries(cell).into_iter().reduce(|a, b| if block.less(a, b) { b } else { a });
        let exit = if x_first { "far_x" } else { "far_y" };
        out["is_inside"] = u64::from(found.is_some());
        out["is_far_x"] = u64::from(cell[0]);
        out["is_far_y"] = u64::from(cell[1]);
        out["x_first"] = u64::from(x_first);
        out["height"] = block.height(cell);
        out["enters"] = row[enters.expect("the ray is one of them")];
        out["t_next"] = row[if block.less("t", exit) { exit } else { "t" }];
    }),
    ..UNIT
};

/// Writes every comparison that the unit makes, by `less`.
fn compare(row: &Row<'_>, out: &mut Row<'_>, less: impl Fn(u64, u64) -> bool) {
    for (first, seconds) in [
        ("t", &["mid_x", "mid_y", "far_x", "far_y"][..]),
        ("mid_x", &["mid_y", "far_x", "far_y"]),
        ("mid_y", &["mid_x", "far_y", "far_x"]),
        ("far_y", &["far_x", "mid_x"]),
    ] {
        for second in seconds {
            out[format!("{first}_lt_{second}").as_str()] = u64::from(less(row[first], row[second]));
        }
    }
}

const ORDER: Unit = Unit {
    name: "plane_order",
    model: Some(|c, row, out| compare(row, out, |a, b| gf::lt(c.design.format, a, b))),
    stimulus: Some(block_planes),
    ..WATERTIGHT
};

static FIXED_ORDER: Unit =
    Unit { datapath: FIXED.datapath, model: Some(|_, row, out| compare(row, out, |a, b| a < b)), ..ORDER };

const LIMIT: Unit = Unit {
    name: "depth_limit",
    model: Some(|c, row, out| {
        let t = gf::to_f64(c.design.format, row["t"]);
        let most = (1u64 << c.param("HEIGHT_W")) as f64;
        out["limit"] = if t.is_nan() { 0 } else { t.ceil().clamp(0.0, most) as u64 };
    }),
    stimulus: Some(one_axis),
    ..WATERTIGHT
};

static FIXED_LIMIT: Unit = Unit {
    datapath: FIXED.datapath,
    model: Some(|c, row, out| {
        let below = c.design.datapath.fraction_bits + 2 - c.design.traverse.height_bits;
        out["limit"] = row["t"].div_ceil(1 << below);
    }),
    ..LIMIT
};
