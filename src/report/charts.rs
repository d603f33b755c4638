//! The charts of the report.
use super::figures::{Aggregate, DesignPoint, Series};
use super::plan::{DesignSpec, Plan};
use super::svg::{Chart, Line, Mark, Scale, decades};
use super::table::short;
use crate::config::modes::BEST;
use crate::measure::spread::{BINS, upper};

/// Colour and shape of a design.
fn kind(d: &DesignSpec) -> usize {
    match d.nudge_bits {
        Some(0) => 3,
        // Other widths of a datapath that is compared in all of them.
        None if d.mode == BEST && d.man.is_some_and(|man| man != 16) => 4,
        // Fixed point, however it searches.
        _ if d.fraction_bits.is_some() => 2,
        _ => d.kind as usize,
    }
}

/// What is shown of an error: its name, its value, and whether that is only a bound.
type Error = (&'static str, fn(&Aggregate<'_>) -> (f64, bool));

const WRONG: Error = ("wrong texel or given up, part of the rays", |p| p.rate_or_bound());
const UV: Error = ("uv error p99 of the worst view, texels", |p| (p.largest(|c| c.uv_all.p99), false));

/// What a plot of all designs shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plot {
    /// Cycles against wrong texels.
    Wrong,
    /// Cycles against the position error.
    Uv,
    /// Size against wrong texels.
    Size,
    /// Cells times clock against wrong texels, of what was placed.
    Placed,
}

/// The stair of points (cost, drawn error, measured error) that no other is cheaper and more often right than. None wrong is better than any,
/// even if it is drawn higher, at its bound.
fn frontier(mut at: Vec<(f64, f64, f64)>) -> Vec<(f64, f64)> {
    at.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.2.total_cmp(&b.2)));
    let mut least = f64::INFINITY;
    at.retain(|p| {
        let better = p.2 < least;
        least = least.min(p.2);
        better
    });
    at.into_iter().map(|(x, y, _)| (x, y)).collect()
}

/// Cost against an error, a dot a design.
pub fn pareto(plan: &Plan, points: &[DesignPoint<'_>], plot: Plot) -> String {
    let (name, error) = if plot == Plot::Uv { UV } else { WRONG };
    let (unit, x_name) = match plot {
        Plot::Size => {
            ("counted bits", "counted bits: logic + products + registers, before synthesis (fewer is better)")
        }
        Plot::Placed => ("LUTs × ns per ray", "look-up tables × ns per ray, placed and routed (less is better)"),
        _ => ("cycles per ray", "cycles per ray, mean over maps and views (less is better)"),
    };
    // A design without hardware has no size to be drawn at.
    let cost = |d: &DesignPoint<'_>| match plot {
        Plot::Size => d.size.map(|bits| bits as f64),
        Plot::Placed => d.area_time(),
        Plot::Wrong | Plot::Uv => Some(d.aggregate.cycles()),
    };
    let drawn = points.iter().filter(|d| d.comparable()).filter_map(|d| Some((d, cost(d)?)));
    let (points, costs): (Vec<&DesignPoint<'_>>, Vec<f64>) = drawn.unzip();
    if points.is_empty() {
        return String::new();
    }
    let named = &plan.headlines;
    let at: Vec<(f64, f64)> = points.iter().zip(costs).map(|(d, cost)| (cost, error(&d.aggregate).0)).collect();
    let measured = |d: &&DesignPoint<'_>| match error(&d.aggregate) {
        (_, true) => 0.0,
        (error, false) => error,
    };
    let edge = frontier(at.iter().zip(&points).map(|(&(x, y), d)| (x, y, measured(d))).collect());
    let plain = |x, y| Mark { x, y, hollow: false, tip: String::new(), label: String::new() };
    // What costs less is not as good: the frontier is a stair.
    let mut stair = Vec::new();
    for (k, (x, y)) in edge.iter().enumerate() {
        stair.extend(k.checked_sub(1).map(|before| plain(*x, edge[before].1)));
        stair.push(plain(*x, *y));
    }
    let end = |xs: &mut dyn Iterator<Item = f64>| xs.fold(0.0f64, f64::max);
    let high = end(&mut at.iter().map(|p| p.0));
    let low = at.iter().map(|p| p.0).fold(high, f64::min);
    let space = (high - low).max(1.0) * 0.08;
    // To the right of the last one, what costs more is no better.
    stair.extend(edge.last().map(|(_, y)| plain(high + space, *y)));
    let mut lines = vec![Line { kind: 9, joined: true, marked: false, marks: stair }];
    let mut said: Vec<(f64, f64)> = Vec::new();
    for (d, place) in points.iter().zip(&at) {
        let (y, hollow) = error(&d.aggregate);
        let headline = named.iter().any(|h| h.design == *d.design);
        let near = |p: &(f64, f64)| (p.0 - place.0).abs() < space * 0.15 && (p.1 / place.1 - 1.0).abs() < 0.1;
        // Designs that differ in nothing visible share a label.
        let wanted = headline || edge.contains(place) && !said.iter().any(near);
        let twins = at.iter().filter(|p| *p == place).count() - 1;
        let mut label = String::new();
        if wanted {
            said.push(*place);
            label = d.design.label();
            if d.design.mode != BEST {
                label += &format!(", {}", d.design.way());
            }
            if twins > 0 && !headline {
                label += &format!(" and {twins} more");
            }
        }
        let below = if hollow { "below " } else { "" };
        let tip = format!("{}: {} {unit}, {name} {below}{}", d.label(), short(place.0), short(y));
        let mark = Mark { x: place.0, y, hollow, tip, label };
        lines.push(Line { kind: kind(d.design), joined: false, marked: true, marks: vec![mark] });
    }
    Chart {
        title: format!("{unit} against {name}"),
        x_name: x_name.into(),
        y_name: name.into(),
        // Few points have long labels beside them.
        x: Scale::Linear(low - space, high + if plot == Plot::Placed { 6.0 * space } else { space }),
        y: decades(at.iter().map(|p| p.1)),
        size: (620.0, 430.0),
        right: 24.0,
        lines,
        bars: Vec::new(),
    }
    .svg()
}

/// Octaves above 0.75 degrees.
fn octave(degrees: f64) -> f64 {
    (degrees / 0.75).log2()
}

/// How an error, or the cost, goes with angle, map size or width.
pub fn along(plan: &Plan, all: &[Series<'_>], by: &str, what: &str) -> String {
    let mine: Vec<&Series<'_>> = all.iter().filter(|s| s.by == by).collect();
    if mine.is_empty() {
        return String::new();
    }
    let named = &plan.headlines;
    let (name, value): Error = match what {
        "wrong" => WRONG,
        "uv" => UV,
        _ => ("cycles per ray", |p| (p.cycles(), false)),
    };
    let mut lines: Vec<Line> = Vec::new();
    let mut drawn: Vec<(Vec<f64>, usize)> = Vec::new();
    for (k, s) in mine.iter().enumerate() {
        let design = s.points.first().and_then(|p| p.aggregate.measurements.first()).map(|c| &c.spec.design);
        let ys: Vec<f64> = s.points.iter().map(|p| value(&p.aggregate).0).collect();
        // Lines on top of each other become one, with the names of all.
        let widths = design.and_then(|d| d.exp).filter(|_| by == "bits");
        if let Some((exp, (_, line))) = widths.zip(drawn.iter().find(|d| d.0 == ys)) {
            let label = lines[*line].marks.last_mut().map(|m| &mut m.label);
            label.into_iter().for_each(|text| *text += &format!(" {exp}"));
            continue;
        }
        drawn.push((ys, lines.len()));
        let colour = match (by, design) {
            ("bits", Some(d)) if d.exp.is_none() => kind(d),
            ("bits", _) => [0, 4, 1, 3][k % 4],
            (_, Some(d)) if named.iter().any(|h| h.design == *d) => kind(d),
            _ => 4,
        };
        let last = s.points.len() - 1;
        let mark = |(k, p): (usize, &super::figures::At<'_>)| {
            let (y, hollow) = value(&p.aggregate);
            // There is little room beside a line: the nudge is said in tables.
            let (before, after) = s.name.split_once(", ").unwrap_or((&s.name, ""));
            let name = if after == "no nudge" { after } else { before };
            let short_name = widths.map_or_else(|| name.to_owned(), |exp| format!("EXP_W {exp}"));
            let label = if k == last { short_name } else { String::new() };
            let tip = format!(
                "{}: {}{} of {} rays",
                s.name,
                if hollow { "below " } else { "" },
                short(y),
                p.aggregate.rays()
            );
            Mark { x: if by == "angle" { octave(p.x) } else { p.x }, y, hollow, tip, label }
        };
        let marks = s.points.iter().enumerate().map(mark).collect();
        lines.push(Line { kind: colour, joined: true, marked: true, marks });
    }
    let marks = || lines.iter().flat_map(|l| l.marks.iter());
    let y = if what == "cycles" {
        Scale::Linear(0.0, marks().map(|m| m.y).fold(1.0, f64::max) * 1.05)
    } else {
        decades(marks().map(|m| m.y))
    };
    let (x, x_name) = match by {
        "angle" => {
            // Angles halve from tick to tick, from 0.75 to 96 degrees.
            let tick = |e: f64| (octave(e), format!("{e}°"));
            (Scale::Named(7.0, [1.0, 3.0, 8.0, 22.0, 45.0, 90.0].map(tick).to_vec()), "degrees above the plane")
        }
        "size" => {
            let all = || plan.maps.iter().map(|s| s.spec.levels);
            let (a, b) = (all().min().unwrap_or(0), all().max().unwrap_or(0));
            (
                Scale::Linear(f64::from(a) - 0.3, f64::from(b.max(a + 1)) + 0.3),
                "levels: the map is 2^levels texels wide",
            )
        }
        _ => (Scale::Linear(6.5, 28.5), "fraction bits (MAN_W, or F of fixed point)"),
    };
    let chart = Chart {
        title: format!("{name} by {x_name}"),
        x_name: x_name.into(),
        y_name: name.into(),
        x,
        y,
        size: (400.0, 290.0),
        right: 122.0,
        lines,
        bars: Vec::new(),
    };
    chart.svg()
}

/// Histogram of the position error of one design, with its cumulative curve.
pub fn histogram(dot: &DesignPoint<'_>) -> String {
    let (all, right) = (dot.aggregate.bins(true), dot.aggregate.bins(false));
    let total = all.iter().sum::<u64>().max(1) as f64;
    let mut bars = Vec::new();
    let mut sum = 0;
    let mut curve = Vec::new();
    for k in 0..BINS {
        let (from, to) = (k as f64, k as f64 + 1.0);
        let tip =
            format!("below {} texel: {} rays, {} of them with the right texel", short(upper(k)), all[k], right[k]);
        let mut bar =
            |n: u64, kind| bars.extend((n > 0).then(|| (from, to, 100.0 * n as f64 / total, kind, tip.clone())));
        bar(all[k], 1);
        bar(right[k], 0);
        sum += all[k];
        let beyond = 100.0 * (total - sum as f64) / total;
        if beyond > 0.0 {
            curve.push(Mark { x: to, y: beyond, hollow: false, tip: String::new(), label: String::new() });
        }
    }
    // Ticks at powers of two that people read: 2^-16, 2^-12 ...
    let tick = |k: usize| (k as f64 + 1.0, if k == 16 { "1".to_owned() } else { format!("2^{}", k as i32 - 16) });
    let chart = Chart {
        title: format!("Position error of {}", dot.design.label()),
        x_name: "position error, texels (one bar an octave)".into(),
        y_name: format!("{}: % of the rays; line: with a larger error", dot.design.label()),
        x: Scale::Named(BINS as f64, (0..BINS).step_by(4).map(tick).collect()),
        y: Scale::Log(-3, 2),
        size: (400.0, 270.0),
        right: 16.0,
        lines: vec![Line { kind: 2, joined: true, marked: false, marks: curve }],
        bars,
    };
    chart.svg()
}

#[cfg(test)]
mod tests {
    use super::frontier;

    #[test]
    fn none_wrong_is_better_than_one_below_its_bound() {
        let (few, one, none) = ((5.0, 0.027, 0.0), (6.0, 0.009, 0.009), (4.0, 0.2, 0.2));
        assert_eq!(frontier(vec![one, few, none]), [(4.0, 0.2), (5.0, 0.027)]);
        assert_eq!(frontier(vec![one, none]), [(4.0, 0.2), (6.0, 0.009)]);
    }
}
