//! The charts of the report.
use super::figures::{Dot, Pool, Series, headlines};
use super::plan::{BEST, DesignSpec, Plan, mode_label};
use super::stats::{BINS, upper};
use super::svg::{Chart, Line, Mark, Scale, decades};
use super::table::short;
use crate::config::{DatapathKind, View};

/// Colour and shape of a design.
fn kind(d: &DesignSpec) -> usize {
    match (d.kind, d.nudge_bits) {
        (DatapathKind::Watertight, _) if d.man == Some(16) || d.mode != BEST => 0,
        (DatapathKind::Watertight, _) => 4,
        (DatapathKind::Fixed, _) => 2,
        (DatapathKind::Published, Some(0)) => 3,
        (DatapathKind::Published, _) => 1,
    }
}

/// What is shown of an error: its name, its value, and whether that is only a bound.
type Error = (&'static str, fn(&Pool<'_>) -> (f64, bool));

const WRONG: Error = ("wrong texel or given up, part of the rays", |p| p.rate_or_bound());
const UV: Error = ("uv error p99 of the worst view, texels", |p| (p.largest(|c| c.uv_all.p99), false));

/// Cycles against an error, a dot a design; `true` for wrong texels, `false` for the position error.
pub fn pareto(plan: &Plan, dots: &[Dot<'_>], rate: bool) -> String {
    let (name, error) = if rate { WRONG } else { UV };
    let named = headlines(plan);
    let mut lines: Vec<Line> = Vec::new();
    let front = |d: &Dot<'_>| if rate { d.front_rate } else { d.front_uv };
    let mut edge: Vec<(f64, f64)> = dots.iter().filter(|d| front(d)).map(|d| (d.pool.cycles(), error(&d.pool).0)).collect();
    edge.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.total_cmp(&a.1)));
    let mut marks = Vec::new();
    for (k, (x, y)) in edge.iter().enumerate() {
        let plain = |x, y| Mark { x, y, hollow: false, tip: String::new(), label: String::new() };
        // What costs less is not as good: the frontier is a stair.
        if k > 0 {
            marks.push(plain(*x, edge[k - 1].1));
        }
        marks.push(plain(*x, *y));
    }
    lines.push(Line { kind: 9, joined: true, marked: false, marks });
    for d in dots {
        let (y, hollow) = error(&d.pool);
        let x = d.pool.cycles();
        let headline = named.iter().any(|h| h.design == *d.design);
        let label = match (headline, front(d)) {
            (true, _) => d.design.label(),
            (false, true) if d.design.mode == BEST => d.design.label(),
            (false, true) => format!("{}, {}", d.design.label(), mode_label(&d.design.mode)),
            _ => String::new(),
        };
        let tip = format!("{}: {} cycles per ray, {} {}{}", d.label(), short(x), name, if hollow { "below " } else { "" }, short(y));
        lines.push(Line { kind: kind(d.design), joined: false, marked: true, marks: vec![Mark { x, y, hollow, tip, label }] });
    }
    let (mut low, mut high) = (f64::INFINITY, 0.0f64);
    dots.iter().map(|d| d.pool.cycles()).for_each(|x| (low, high) = (low.min(x), high.max(x)));
    let space = (high - low).max(1.0) * 0.08;
    Chart {
        title: format!("Cycles per ray against {name}"),
        x_name: "cycles per ray, mean over maps and views (less is better)".into(),
        y_name: name.into(),
        x: Scale::Linear(low - space, high + space),
        y: decades(dots.iter().map(|d| error(&d.pool).0)),
        size: (760.0, 430.0),
        right: 150.0,
        lines,
        bars: Vec::new(),
    }
    .svg()
}

/// How an error, or the cost, goes with angle, map size or width.
pub fn along(plan: &Plan, all: &[Series<'_>], by: &str, what: &str) -> String {
    let mine: Vec<&Series<'_>> = all.iter().filter(|s| s.by == by).collect();
    if mine.is_empty() {
        return String::new();
    }
    let named = headlines(plan);
    let (name, value): Error = match what {
        "wrong" => WRONG,
        "uv" => UV,
        _ => ("cycles per ray", |p| (p.cycles(), false)),
    };
    let mut lines = Vec::new();
    for (k, s) in mine.iter().enumerate() {
        let design = s.points.first().and_then(|p| p.pool.cells.first()).map(|c| &c.spec.design);
        let colour = match (by, design) {
            ("bits", Some(d)) if d.kind == DatapathKind::Fixed => 2,
            ("bits", _) => [4, 1, 0, 3][k % 4],
            (_, Some(d)) if named.iter().any(|h| h.design == *d) => kind(d),
            _ => 4,
        };
        let last = s.points.len() - 1;
        let mark = |(k, p): (usize, &super::figures::At<'_>)| {
            let (y, hollow) = value(&p.pool);
            let label = if k == last { s.name.clone() } else { String::new() };
            let tip = format!("{}: {}{} of {} rays", s.name, if hollow { "below " } else { "" }, short(y), p.pool.rays());
            Mark { x: p.x, y, hollow, tip, label }
        };
        lines.push(Line { kind: colour, joined: true, marked: true, marks: s.points.iter().enumerate().map(mark).collect() });
    }
    let marks = || lines.iter().flat_map(|l| l.marks.iter());
    let y = if what == "cycles" {
        Scale::Linear(0.0, marks().map(|m| m.y).fold(1.0, f64::max) * 1.05)
    } else {
        decades(marks().map(|m| m.y))
    };
    let (x, x_name) = match by {
        "angle" => (Scale::Words(View::WORDS.iter().map(|w| (*w).to_owned()).collect()), "view (90°, 22°, 3° above the plane)"),
        "size" => {
            let (a, b) = (plan.config.traverse.levels, plan.sites.iter().map(|s| s.spec.levels).max().unwrap_or(0));
            (Scale::Linear(f64::from(a) - 0.3, f64::from(b.max(a + 1)) + 0.3), "levels: the map is 2^levels texels wide")
        }
        _ => (Scale::Linear(6.5, 28.5), "fraction bits (MAN_W, or F of fixed point)"),
    };
    let chart = Chart {
        title: format!("{name} by {x_name}"),
        x_name: x_name.into(),
        y_name: name.into(),
        x,
        y,
        size: (480.0, 320.0),
        right: 140.0,
        lines,
        bars: Vec::new(),
    };
    chart.svg()
}

/// Histogram of the position error of one design, with its cumulative curve.
pub fn histogram(dot: &Dot<'_>) -> String {
    let (all, right) = (dot.pool.bins(true), dot.pool.bins(false));
    let total = all.iter().sum::<u64>().max(1) as f64;
    let mut bars = Vec::new();
    let mut sum = 0;
    let mut curve = Vec::new();
    for k in 0..BINS {
        let (from, to) = (k as f64, k as f64 + 1.0);
        let tip = format!("below {} texel: {} rays, {} of them with the right texel", short(upper(k)), all[k], right[k]);
        bars.push((from, to, 100.0 * all[k] as f64 / total, 1, tip.clone()));
        bars.push((from, to, 100.0 * right[k] as f64 / total, 0, tip));
        sum += all[k];
        let part = 100.0 * sum as f64 / total;
        let tip = format!("{part:.3} % of the rays are below {} texel", short(upper(k)));
        curve.push(Mark { x: to, y: part, hollow: false, tip, label: String::new() });
    }
    // Ticks at powers of two that people read: 2^-16, 2^-12 ...
    let tick = |k: usize| (k as f64 + 1.0, if k == 16 { "1".to_owned() } else { format!("2^{}", k as i32 - 16) });
    let chart = Chart {
        title: format!("Position error of {}", dot.design.label()),
        x_name: "position error, texels (one bar an octave)".into(),
        y_name: format!("{}: % of the rays (bars) and cumulative (line)", dot.design.label()),
        x: Scale::Named(BINS as f64, (0..BINS).step_by(4).map(tick).collect()),
        y: Scale::Linear(0.0, 100.0),
        size: (480.0, 260.0),
        right: 16.0,
        lines: vec![Line { kind: 2, joined: true, marked: false, marks: curve }],
        bars,
    };
    chart.svg()
}
