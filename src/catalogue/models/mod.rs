//! The golden model of each unit, in the order of its ports: those of every datapath here, the others in a file a datapath.
mod bilinear;
mod fixed;
mod float;
mod published;
mod watertight;

use crate::bits::{mask, signed};
use crate::config::{DatapathKind, Design, LevelUp, Trim};
use crate::golden::{Crossing, address, descend_levels, level_up, start_level};
use crate::ir::Binding;

/// Expected outputs of `unit` for one row of inputs, at design `d` and parameter values `b`.
///
/// # Panics
/// If the unit has no model: the catalogue and the units went apart.
pub fn model(unit: &str, d: &Design, b: &Binding, x: &[u64]) -> Vec<u64> {
    let p = |name: &str| b[name] as u32;
    let idx = b.get("IDX_W").map_or(d.traverse.idx_bits(), |v| *v as u32);
    let s = |v: u64| signed(v, idx);
    let index = |v: i64| v as u64 & mask(idx);
    match unit {
        "lzc" => vec![(0..p("W")).take_while(|k| x[0] >> (p("W") - 1 - k) & 1 == 0).count() as u64],
        "interleave" => {
            let bit = |w: u64, i: u32| w >> i & 1;
            vec![(0..p("W")).map(|i| bit(x[0], i) << (2 * i) | bit(x[1], i) << (2 * i + 1)).sum()]
        }
        "div_rows" => {
            let (rows, w) = (p("ROWS"), p("W"));
            let n = u128::from(x[0]) << (rows - 1);
            let (q, r) = (n / u128::from(x[1]), n % u128::from(x[1]));
            vec![(r << 1) as u64 & mask(w + 1), q as u64 & mask(rows)]
        }
        "sqrt_rows" => {
            let (w, first, last) = (p("W"), p("FIRST") - 1, p("FIRST") - 1 + p("ROWS"));
            // The radicand in units of the root's last place squared, and its root cut to more digits.
            let radicand = u128::from(x[1]).pow(2) + (u128::from(x[0]) << (w - 1 - first));
            let below = w - 1 - last;
            let root = (radicand >> (2 * below)).isqrt() << below;
            vec![((radicand - root * root) >> below) as u64, root as u64]
        }
        "delay_line" => vec![x[0]],
        "recip_table" => vec![recip_line(x[0].into())],
        "start_level" => vec![u64::from(start_level(d.traverse.levels, idx, s(x[0]), s(x[1]), s(x[2]), s(x[3])))],
        "height_address" => {
            let k = x[0] as u32;
            vec![address(d.traverse.levels, k, x[1] as u32 >> k, x[2] as u32 >> k) as u64]
        }
        "node_planes" => {
            let (k, at, neg) = (x[0] as u32, s(x[1]), x[2] == 1);
            let size = 1i64 << k;
            let first = at.div_euclid(size) * size;
            let plane = if neg { first } else { first + size };
            let beyond = if neg { first - 1 } else { plane };
            let (low, high) = if neg { (first, at) } else { (at, first + size - 1) };
            let even = u64::from(plane.div_euclid(size).rem_euclid(2) == 0);
            let mut out = vec![index(low), index(high), index(plane), index(beyond)];
            if matches!(d.mode.level_up, LevelUp::Tevs | LevelUp::Selective) {
                // Past the largest coordinate the plane wraps with its word.
                let wrapped = signed(index(plane), idx).div_euclid(size).rem_euclid(2) == 0;
                out.push(if index(plane) == plane as u64 & mask(idx) { u64::from(wrapped) } else { even });
            }
            out
        }
        "multi_level_down" => {
            let many = d.mode.levels_down;
            let (crossed, o) = if many > 1 { (x[1] == 1, 2) } else { (false, 1) };
            let (lod, o) = if d.mode.lod { (x[o], o + 1) } else { (0, o) };
            let down = descend_levels(many, x[0] as u32, crossed);
            let clamp = |i: usize| index(if s(x[i + 2]) < s(x[i]) { s(x[i]) } else { s(x[i + 2]).min(s(x[i + 1])) });
            vec![(x[0] - u64::from(down)).max(lod), clamp(o), clamp(o + 3)]
        }
        "level_up" => vec![u64::from(up(d, x, s))],
        "level_decision" => {
            let x = &decision_row(d, x)[..];
            let [inside, x_first, across, level, lod, down, m, t_next] = x[..8] else { panic!("the row has 14 words") };
            let hit = inside == 1 && level == lod;
            let pick = |o: usize, crossed: bool| match (inside == 1, hit) {
                (true, true) => x[o],
                (true, false) => x[o + 1],
                (false, _) => x[if crossed { o + 2 } else { o }],
            };
            let level_next = match (inside == 1, hit) {
                (true, true) => level,
                (true, false) => down,
                (false, _) => across & mask(level_bits(d)),
            };
            let t = if inside == 1 { m } else { t_next };
            vec![u64::from(hit), 1 - inside, level_next, pick(8, x_first == 1), pick(11, x_first == 0), t]
        }
        "node_hit" => {
            let frac = p("FRAC_W");
            node_hit(d, frac, signed(x[0], idx + frac), s(x[1]), x[2])
        }
        "finest_level" => {
            let finest = x[0].min(u64::from(d.traverse.levels));
            vec![finest, x[1].max(finest)]
        }
        "chord_trim" => chord_trim(d, idx, x),
        "trim_return" => {
            let (k, read) = (x[0], x[1]);
            let up = x[2] == 1;
            let stays = read < k && !up && d.mode.level_up == LevelUp::Selective;
            let grows = read >= k && up;
            vec![if stays { read } else { (k + u64::from(grows)) & mask(level_bits(d)) }, u64::from(grows)]
        }
        _ => match d.datapath.kind {
            DatapathKind::Fixed => fixed::model(unit, d, b, x),
            DatapathKind::Published => published::model(unit, d, b, x),
            DatapathKind::Watertight => watertight::model(unit, d, b, x),
        },
    }
}

/// Start and slope of the line for divisors from `1 + index / 256` up, as `docs/arithmetic.md` defines them.
fn recip_line(index: i128) -> u64 {
    let (x, y) = (256 + index, 257 + index);
    // The chord falls by 2^8 / (x * y) along the interval, that is along 2^8 steps.
    let slope = (0..1 << 12).min_by_key(|s| (s * x * y - (1 << 28)).abs()).expect("there are slopes");
    // Chord and curve in the middle, (128 / x + 128 / y) and 512 / (x + y), as fractions of one denominator.
    let below = x * y * (x + y);
    let middle = (128 * (x + y) * (x + y) + 512 * x * y) << 21;
    let start = (middle - (below << 21)).div_euclid(below) + 128 * slope / 64 + 4;
    (start << 12 | slope) as u64
}

/// Texel (wrapped) and fraction of position `at`, kept in the level-`lod` node of `x`.
fn node_hit(d: &Design, frac: u32, at: i64, x: i64, lod: u64) -> Vec<u64> {
    let (unit, size) = (1i64 << frac, 1i64 << lod);
    let first = x.div_euclid(size) * size;
    let kept = at.clamp(first * unit, (first + size) * unit - 1);
    let (texel, fraction) = (kept.div_euclid(unit), kept.rem_euclid(unit));
    vec![texel.rem_euclid(1 << d.traverse.levels) as u64, fraction as u64]
}

/// Both ends of the chord, then the level to read.
fn chord_trim(d: &Design, idx: u32, x: &[u64]) -> Vec<u64> {
    let (k, mut o) = (x[0], 1);
    let mut next = |there: bool| {
        o += usize::from(there);
        if there { x[o - 1] } else { 0 }
    };
    let descended = next(d.mode.trim == Trim::Descent) == 1;
    let lod = next(d.mode.lod);
    let x_first = x[o] == 1;
    let s = |v: u64| signed(v, idx);
    let axis = |o: usize, exits: bool| {
        let [at, low, high, neg, reach, last] = x[o..o + 6] else { panic!("an axis has 6 words") };
        let nearer = if neg == 1 { s(reach).max(s(last)) } else { s(reach).min(s(last)) };
        let end = if exits { s(last) } else { nearer };
        (s(at), if end < s(low) { s(low) } else { end.min(s(high)) })
    };
    let ((x_at, x_end), (y_at, y_end)) = (axis(o + 1, x_first), axis(o + 7, !x_first));
    let tight = u64::from(start_level(d.traverse.levels, idx, x_at, y_at, x_end, y_end)).max(lod);
    let read = if d.mode.trim == Trim::Always || descended { tight } else { k };
    [x_end, y_end].map(|v| v as u64 & mask(idx)).into_iter().chain([read]).collect()
}

/// A row of `level_decision` with the level of a crossing and the finest level in their places, whatever ports the design has.
fn decision_row(d: &Design, x: &[u64]) -> Vec<u64> {
    let trims = d.mode.trim != Trim::None;
    // Ports: is_inside, x_first, up and level, or level and level_across, then lod.
    let (level, across) = if trims { (x[2], x[3]) } else { (x[3], x[3] + x[2]) };
    let (lod, rest) = if d.mode.lod { (x[4], 5) } else { (0, 4) };
    [&[x[0], x[1], across, level, lod], &x[rest..]].concat()
}

fn level_bits(d: &Design) -> u32 {
    (d.traverse.levels + 1).next_power_of_two().trailing_zeros()
}

fn up(d: &Design, x: &[u64], s: impl Fn(u64) -> i64) -> bool {
    use LevelUp as L;
    let level = x[0] as u32;
    // A plane whose parity in node units is the wanted one.
    let plane = |even: u64| (1 - even as i64) << level;
    let none = Crossing { level, plane: 0, x: 0, y: 0, e_x: 0, e_y: 0, previous: false };
    let c = match d.mode.level_up {
        L::Coherent => Crossing { previous: x[1] == 1, ..none },
        L::Tevs => Crossing { plane: plane(x[1]), ..none },
        L::Selective => Crossing { plane: plane(x[1]), x: s(x[2]), e_x: s(x[3]), y: s(x[4]), e_y: s(x[5]), ..none },
        L::None | L::Always => none,
    };
    level < d.traverse.levels && level_up(d.mode.level_up, &c)
}

/// Makes a row one that the unit can meet: levels that exist, divisors that are normalized.
pub fn legal(unit: &str, d: &Design, b: &Binding, mut x: Vec<u64>) -> Vec<u64> {
    let n = u64::from(d.traverse.levels);
    match unit {
        "height_address" | "node_planes" | "exit_plane" => x[0] %= n + 1,
        "finest_level" => x[1] %= n + 1,
        "node_hit" => x[2] %= n + 1,
        "hit_position" if d.mode.lod && d.datapath.kind != DatapathKind::Fixed => x[4] %= n + 1,
        "trim_return" => {
            x[0] %= n + 1;
            x[1] %= x[0] + 1;
        }
        "chord_trim" => {
            x[0] %= n + 1;
            let flags = usize::from(d.mode.trim == Trim::Descent);
            if d.mode.lod {
                x[1 + flags] %= n + 1;
            }
            let first = 2 + flags + usize::from(d.mode.lod);
            let idx = b.get("IDX_W").map_or(d.traverse.idx_bits(), |v| *v as u32);
            for o in [first + 1, first + 7] {
                if signed(x[o], idx) > signed(x[o + 1], idx) {
                    x.swap(o, o + 1);
                }
            }
        }
        "descent_level" => x[0] = x[0] % n + 1,
        "level_choice" => x[if d.mode.start_level { 3 } else { 2 }] %= n + 1,
        "level_up" => {
            // Coordinates keep a bit of headroom: IDX_W holds any sum of an entry point and a travel.
            let idx = b.get("IDX_W").map_or(d.traverse.idx_bits(), |v| *v as u32);
            x[0] %= n + 1;
            x.iter_mut().skip(2).for_each(|v| *v = (signed(*v, idx) >> 1) as u64 & mask(idx));
        }
        "multi_level_down" => {
            x[0] = x[0] % n + 1;
            order_bounds(d, b, &mut x);
            if d.mode.lod {
                let at = if d.mode.levels_down > 1 { 2 } else { 1 };
                x[at] %= n + 1;
            }
        }
        "level_decision" => {
            let level = if d.mode.trim == Trim::None { 3 } else { 2 };
            x[level] %= n + 1;
            if d.mode.lod {
                x[4] %= n + 1;
            }
        }
        // A distance is moved by at most as much as loses its last bit.
        "plane_time" if d.datapath.kind == DatapathKind::Fixed => {
            x[4] = x[4].min(u64::from(d.datapath.fraction_bits + d.traverse.tile_bits + 1));
        }
        // A ray's way stays below 2^TILE_W tiles.
        "hit_position" if d.datapath.kind == DatapathKind::Fixed => {
            x[1] &= mask(d.datapath.fraction_bits + d.traverse.tile_bits);
            if d.mode.lod {
                x[5] %= n + 1;
            }
        }
        "sqrt_rows" => {
            // Digits below FIRST are still 0; the remainder is below twice the root and the last digit's place.
            let (w, first) = (b["W"] as u32, b["FIRST"] as u32);
            x[1] = (x[1] | 1 << (w - 1)) & !mask(w - first);
            x[0] %= 2 * x[1] + (1 << (w - first));
        }
        // A travel per height code is less than 4/3 of a travel: two height bits make the least M.
        "chord_end" if d.datapath.kind == DatapathKind::Fixed => {
            x[1] = x[1].min(mask(d.datapath.fraction_bits + d.traverse.tile_bits) * 4 / 3);
        }
        "div_rows" => {
            let w = b["W"] as u32;
            x[1] |= 1 << (w - 1);
            x[0] %= 2 * x[1];
        }
        _ => {}
    }
    x
}

/// The lower bound of a descent comes before the upper one.
fn order_bounds(d: &Design, b: &Binding, x: &mut [u64]) {
    let idx = b.get("IDX_W").map_or(d.traverse.idx_bits(), |v| *v as u32);
    let first = if d.mode.levels_down > 1 { 2 } else { 1 } + usize::from(d.mode.lod);
    for o in [first, first + 3] {
        if signed(x[o], idx) > signed(x[o + 1], idx) {
            x.swap(o, o + 1);
        }
    }
}
