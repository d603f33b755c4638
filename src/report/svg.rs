//! Charts as SVG: axes, lines, marks and labels beside what they name. Colours are classes, so that the page's style sets them.
use std::fmt::Write;

/// An axis.
#[derive(Clone, Debug)]
pub enum Scale {
    /// From, to.
    Linear(f64, f64),
    /// Powers of ten, from and to.
    Log(i32, i32),
    /// From 0 to an end, with ticks of its own.
    Named(f64, Vec<(f64, String)>),
}

/// A point of a line.
#[derive(Clone, Debug)]
pub struct Mark {
    /// Along x.
    pub x: f64,
    /// Along y.
    pub y: f64,
    /// A bound, not a measured value.
    pub hollow: bool,
    /// What the pointer shows.
    pub tip: String,
    /// Label beside the point; empty for none.
    pub label: String,
}

/// A line or a cloud of one kind.
#[derive(Clone, Debug)]
pub struct Line {
    /// Colour and shape.
    pub kind: usize,
    /// Joined by a line.
    pub joined: bool,
    /// Marks are drawn.
    pub marked: bool,
    /// Points.
    pub marks: Vec<Mark>,
}

/// A chart.
#[derive(Clone, Debug)]
pub struct Chart {
    /// What it shows, for readers that do not see it.
    pub title: String,
    /// Name and unit of the x axis.
    pub x_name: String,
    /// Name and unit of the y axis.
    pub y_name: String,
    /// x axis.
    pub x: Scale,
    /// y axis.
    pub y: Scale,
    /// Width and height.
    pub size: (f64, f64),
    /// Room for labels at the right.
    pub right: f64,
    /// Lines.
    pub lines: Vec<Line>,
    /// Not drawn as marks but as bars up from the x axis: left, right, y and the kind.
    pub bars: Vec<(f64, f64, f64, usize, String)>,
}

const LEFT: f64 = 58.0;
const TOP: f64 = 22.0;
const BOTTOM: f64 = 44.0;
/// Width of a character of a label, on average and not too small.
const CHARACTER: f64 = 6.5;

impl Scale {
    /// Part of the axis, 0 to 1.
    fn place(&self, v: f64) -> f64 {
        match self {
            Self::Linear(a, b) => (v - a) / (b - a),
            Self::Log(a, b) => (v.max(f64::MIN_POSITIVE).log10() - f64::from(*a)) / f64::from(b - a),
            Self::Named(end, _) => v / end,
        }
    }

    fn ticks(&self) -> Vec<(f64, String)> {
        match self {
            Self::Linear(a, b) => {
                let rough = (b - a) / 6.0;
                let unit = 10f64.powi(rough.log10().floor() as i32);
                let step = [1.0, 2.0, 5.0, 10.0].map(|k| k * unit).into_iter().find(|s| *s >= rough).unwrap_or(rough);
                let first = (a / step).ceil() as i64;
                let last = (b / step + 1e-9).floor() as i64;
                (first..=last).map(|k| (k as f64 * step, super::table::short(k as f64 * step))).map(trimmed).collect()
            }
            Self::Log(a, b) => {
                let every = ((b - a) / 8 + 1) as usize;
                (*a..=*b).step_by(every).map(|k| (10f64.powi(k), power(k))).collect()
            }
            Self::Named(_, ticks) => ticks.clone(),
        }
    }
}

fn trimmed((at, text): (f64, String)) -> (f64, String) {
    let text = if text.contains('.') && !text.contains('e') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    };
    (at, text)
}

/// 10 to a power, as it is read.
fn power(k: i32) -> String {
    if (-2..=3).contains(&k) {
        return trimmed((0.0, format!("{:.2}", 10f64.powi(k)))).1;
    }
    let digit = |c: char| {
        if c == '-' { '⁻' } else { "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(c as usize - 48).unwrap_or(c) }
    };
    "10".to_owned() + &k.to_string().chars().map(digit).collect::<String>()
}

/// The powers of ten around values.
pub fn decades(values: impl Iterator<Item = f64>) -> Scale {
    let (mut low, mut high) = (f64::INFINITY, 0.0f64);
    values.filter(|v| *v > 0.0).for_each(|v| (low, high) = (low.min(v), high.max(v)));
    if high == 0.0 {
        return Scale::Log(-3, 0);
    }
    let a = low.log10().floor() as i32;
    Scale::Log(a, (high.log10().ceil() as i32).max(a + 1))
}

/// Characters that mean something in SVG, written as such.
pub fn escape(s: &str) -> String {
    s.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A mark's outline; kinds differ by shape as well as by colour.
fn shape(kind: usize, x: f64, y: f64, hollow: bool) -> String {
    let corners: &[(f64, f64)] = match (hollow, kind % 5) {
        (true, _) => &[(-4.5, -4.0), (4.5, -4.0), (0.0, 4.5)],
        (false, 1) => &[(-3.8, -3.8), (3.8, -3.8), (3.8, 3.8), (-3.8, 3.8)],
        (false, 2) => &[(0.0, -5.2), (5.2, 0.0), (0.0, 5.2), (-5.2, 0.0)],
        (false, 3) => &[(0.0, -5.0), (4.8, 3.6), (-4.8, 3.6)],
        (false, 4) => &[
            (-1.5, -5.0),
            (1.5, -5.0),
            (1.5, -1.5),
            (5.0, -1.5),
            (5.0, 1.5),
            (1.5, 1.5),
            (1.5, 5.0),
            (-1.5, 5.0),
            (-1.5, 1.5),
            (-5.0, 1.5),
            (-5.0, -1.5),
            (-1.5, -1.5),
        ],
        (false, _) => return format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4.2\""),
    };
    let points: Vec<String> = corners.iter().map(|(dx, dy)| format!("{:.1},{:.1}", x + dx, y + dy)).collect();
    format!("<polygon points=\"{}\"", points.join(" "))
}

/// Boxes that are taken: left, top, right, bottom.
type Taken = Vec<[f64; 4]>;

/// A free place for a label near (x, y), and whether it needs a line to its point.
fn free(taken: &Taken, x: f64, y: f64, text: &str, room: &[f64; 4]) -> (f64, f64, bool) {
    let width = CHARACTER * text.chars().count() as f64;
    let mut best = (x + 9.0, y, false);
    let mut least = f64::INFINITY;
    // Beside its point; a long one above or below it, as far to the right as there is room.
    let beside = [(x + 9.0, 0.0), (x - 9.0 - width, 15.0), ((x + 9.0).min(room[2] - width).max(room[0]), 25.0)];
    for (away, (at, aside)) in (0..20).flat_map(|k| beside.map(|place| (k, place))) {
        for side in [1.0, -1.0] {
            let dy = f64::from(away) * 6.5 * side;
            let this = [at, y + dy - 6.0, at + width, y + dy + 6.0];
            let inside = this[0] >= room[0] && this[2] <= room[2] && this[1] >= room[1] && this[3] <= room[3];
            let hits =
                taken.iter().filter(|t| t[0] < this[2] && this[0] < t[2] && t[1] < this[3] && this[1] < t[3]).count();
            let cost = hits as f64 * 40.0 + dy.abs() + aside + if inside { 0.0 } else { 1000.0 };
            if cost < least {
                (least, best) = (cost, (at, y + dy, dy.abs() > 7.0));
            }
        }
    }
    best
}

impl Chart {
    /// The chart as an `svg` element.
    pub fn svg(&self) -> String {
        let (width, height) = self.size;
        let (w, h) = (width - LEFT - self.right, height - TOP - BOTTOM);
        let px = |v: f64| LEFT + self.x.place(v) * w;
        let py = |v: f64| TOP + (1.0 - self.y.place(v).clamp(0.0, 1.0)) * h;
        let mut s = format!(
            "<svg class=\"chart\" viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{}\"><title>{}</title>",
            escape(&self.title),
            escape(&self.title)
        );
        for (v, text) in self.y.ticks() {
            let y = py(v);
            let _ = write!(
                s,
                "<path class=\"grid\" d=\"M{LEFT} {y:.1}h{w:.1}\"/><text class=\"tick end\" x=\"{:.1}\" y=\"{:.1}\">{}</text>",
                LEFT - 7.0,
                y + 3.8,
                escape(&text)
            );
        }
        for (v, text) in self.x.ticks() {
            let x = px(v);
            let _ = write!(
                s,
                "<path class=\"grid faint\" d=\"M{x:.1} {TOP}v{h:.1}\"/><text class=\"tick mid\" x=\"{x:.1}\" y=\"{:.1}\">{}</text>",
                TOP + h + 16.0,
                escape(&text)
            );
        }
        let _ = write!(s, "<path class=\"axis\" d=\"M{LEFT} {:.1}h{w:.1}\"/>", TOP + h);
        let _ = write!(
            s,
            "<text class=\"name mid\" x=\"{:.1}\" y=\"{:.1}\">{}</text>",
            LEFT + w / 2.0,
            height - 8.0,
            escape(&self.x_name)
        );
        let _ = write!(s, "<text class=\"name\" x=\"4\" y=\"12\">{}</text>", escape(&self.y_name));
        for (from, to, y, kind, tip) in &self.bars {
            let (a, b, top) = (px(*from), px(*to), py(*y));
            let _ = write!(
                s,
                "<rect class=\"bar k{kind}\" x=\"{a:.1}\" y=\"{top:.1}\" width=\"{:.1}\" height=\"{:.1}\"><title>{}</title></rect>",
                (b - a - 1.0).max(0.5),
                TOP + h - top,
                escape(tip)
            );
        }
        let mut taken = Taken::new();
        for line in self.lines.iter().filter(|l| l.joined && l.marks.len() > 1) {
            let way: Vec<String> = line.marks.iter().map(|m| format!("{:.1} {:.1}", px(m.x), py(m.y))).collect();
            let _ = write!(s, "<path class=\"line k{}\" d=\"M{}\"/>", line.kind, way.join("L"));
            // A line without marks is a stair: labels stand beside its steps.
            taken.extend(line.marks.windows(2).filter(|_| !line.marked).map(|two| {
                let ([x, to_x], [y, to_y]) = ([px(two[0].x), px(two[1].x)], [py(two[0].y), py(two[1].y)]);
                [x.min(to_x) - 1.0, y.min(to_y) - 1.0, x.max(to_x) + 1.0, y.max(to_y) + 1.0]
            }));
        }
        for line in self.lines.iter().filter(|l| l.marked) {
            for m in &line.marks {
                let (x, y) = (px(m.x), py(m.y));
                taken.push([x - 5.0, y - 5.0, x + 5.0, y + 5.0]);
                let hollow = if m.hollow { " hollow" } else { "" };
                let _ = write!(
                    s,
                    "{} class=\"mark k{}{hollow}\"><title>{}</title></{}>",
                    shape(line.kind, x, y, m.hollow),
                    line.kind,
                    escape(&m.tip),
                    if !m.hollow && line.kind.is_multiple_of(5) { "circle" } else { "polygon" }
                );
            }
        }
        let mut labels: Vec<(f64, f64, usize, &str)> = self
            .lines
            .iter()
            .flat_map(|l| {
                l.marks.iter().filter(|m| !m.label.is_empty()).map(|m| (px(m.x), py(m.y), l.kind, m.label.as_str()))
            })
            .collect();
        labels.sort_by(|a, b| a.1.total_cmp(&b.1));
        let room = [LEFT + 2.0, TOP - 4.0, width - 2.0, TOP + h - 2.0];
        for (x, y, kind, text) in labels {
            let (lx, ly, far) = free(&taken, x, y, text, &room);
            let text_width = CHARACTER * text.chars().count() as f64;
            taken.push([lx, ly - 6.0, lx + text_width, ly + 6.0]);
            if far {
                let end = if lx > x { lx - 2.0 } else { x.min(lx + text_width + 2.0) };
                let _ = write!(s, "<path class=\"leader\" d=\"M{x:.1} {y:.1}L{end:.1} {ly:.1}\"/>");
            }
            let _ =
                write!(s, "<text class=\"label t{kind}\" x=\"{lx:.1}\" y=\"{:.1}\">{}</text>", ly + 3.8, escape(text));
        }
        s + "</svg>"
    }
}

#[cfg(test)]
mod tests {
    use super::{CHARACTER, free};

    #[test]
    fn a_long_label_stays_in_the_picture() {
        let room = [60.0, 18.0, 618.0, 384.0];
        for (x, chars) in [(100.0, 20), (300.0, 50), (360.0, 60), (600.0, 30)] {
            let text = "x".repeat(chars);
            let (at, _, _) = free(&vec![[x - 5.0, 95.0, x + 5.0, 105.0]], x, 100.0, &text, &room);
            assert!(at >= room[0] && at + CHARACTER * chars as f64 <= room[2], "{at} for {chars} characters at {x}");
        }
    }
}
