//! Heights to the codes that the memory holds.
use super::height_map::{Depth, HeightMap};
use super::resample::{Column, stretch};
use reliefrtl_base::error::{Error, Result};
use reliefrtl_config::Border;

/// The map as unsigned-normalized codes of `height_bits` bits for 2^levels x 2^levels texels, row by row:
/// height h becomes h * (2^height_bits - 1), rounded to nearest. Codes of a source with as many bits come out unchanged.
///
/// With `resample`, a map of another size is filtered to fit (the mean over a texel's area where the map shrinks, bilinear
/// where it grows; the map repeats), and a finer source may be reduced.
///
/// # Errors
/// [`Error::Input`] without `resample`, if the size is another or the source has more bits; it names both and what to do.
pub fn to_codes(map: &HeightMap, levels: u32, height_bits: u32, resample: bool) -> Result<Vec<u32>> {
    bordered_codes(map, Border::Wrap, levels, height_bits, resample)
}

/// As [`to_codes`], for a design of 2^levels x 2^levels texels that sees what `border` puts beyond the map's border.
///
/// # Errors
/// As [`to_codes`].
pub fn bordered_codes(
    map: &HeightMap,
    border: Border,
    levels: u32,
    height_bits: u32,
    resample: bool,
) -> Result<Vec<u32>> {
    let own = levels - border.levels();
    let ways = Ways { resample, ..Ways::default() };
    let mut fit = Fit::new((map.width, map.height), map.depth, border, own, height_bits, ways)?;
    map.samples.chunks_exact(map.width).for_each(|row| fit.row(row));
    Ok(super::border::prepared(border, own, fit.codes()))
}

/// Takes heights in 0 to 1, row by row.
pub(super) trait Sink {
    /// The next row of what is kept.
    fn row(&mut self, heights: &[f64]);
}

/// How a map of another size may be made to fit.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Ways {
    /// Filtered.
    pub(super) resample: bool,
    /// Cut to its first columns and rows.
    pub(super) crop: bool,
    /// Continued by its last column and row.
    pub(super) pad: bool,
}

impl Ways {
    /// Columns and rows that are kept of a map of this size.
    pub(super) fn kept(self, (width, height): (usize, usize), side: usize) -> (usize, usize) {
        if self.crop { (width.min(side), height.min(side)) } else { (width, height) }
    }
}

/// Rows of heights to codes, as they come.
pub(super) struct Fit {
    size: (usize, usize),
    side: usize,
    pad: bool,
    /// Code of full height.
    max: f64,
    /// Rows so far.
    at: usize,
    line: Vec<f64>,
    column: Option<Column>,
    codes: Vec<u32>,
}

impl Fit {
    /// For a map of `size` into 2^levels x 2^levels texels.
    pub(super) fn new(
        size: (usize, usize),
        depth: Depth,
        border: Border,
        levels: u32,
        height_bits: u32,
        ways: Ways,
    ) -> Result<Self> {
        let (width, height) = size;
        let side = 1usize << levels;
        let padded = |length: usize| if ways.pad { length.max(side) } else { length };
        if !ways.resample {
            let fits = (padded(width), padded(height)) == (side, side);
            let problems: Vec<String> = (!fits)
                .then(|| size_problem(size, border, levels))
                .into_iter()
                .chain(depth_problem(depth, height_bits))
                .collect();
            if !problems.is_empty() {
                return Err(Error::input(problems.join("; ")));
            }
        }
        let column = (padded(height) != side).then(|| Column::new(height, side));
        let max = f64::from((1u32 << height_bits) - 1);
        Ok(Self { size, side, pad: ways.pad, max, at: 0, line: vec![0.0; side], column, codes: Vec::new() })
    }

    /// What became of another size, in words.
    pub(super) fn told(&self) -> Option<String> {
        let (width, height) = self.size;
        let way = |length: usize| match length {
            length if length == self.side => None,
            length if length < self.side && self.pad => Some("continued"),
            _ => Some("resampled"),
        };
        let ways: Vec<&str> = [way(width), way(height)].into_iter().flatten().collect();
        let word = match ways.as_slice() {
            [] => return None,
            [a, b] if a != b => "continued and resampled",
            [one, ..] => one,
        };
        Some(format!("{word} to {0} x {0}", self.side))
    }

    /// The codes, after the last row.
    pub(super) fn codes(mut self) -> Vec<u32> {
        if let Some(column) = &self.column {
            return column.sums().iter().map(|&height| code(height, self.max)).collect();
        }
        while !self.codes.is_empty() && self.codes.len() < self.side * self.side {
            self.codes.extend_from_within(self.codes.len() - self.side..);
        }
        self.codes
    }
}

/// Rounding is half away from zero: exact, and the same everywhere.
fn code(height: f64, max: f64) -> u32 {
    (height.clamp(0.0, 1.0) * max).round() as u32
}

impl Sink for Fit {
    fn row(&mut self, heights: &[f64]) {
        let width = heights.len();
        let line = if width == self.side {
            heights
        } else {
            if width < self.side && self.pad {
                self.line[..width].copy_from_slice(heights);
                self.line[width..].fill(heights[width - 1]);
            } else {
                stretch(heights, &mut self.line);
            }
            &self.line
        };
        match &mut self.column {
            Some(column) => column.add(self.at, line),
            None => self.codes.extend(line.iter().map(|&height| code(height, self.max))),
        }
        self.at += 1;
    }
}

/// What is wrong with a map of another size, and what can be done.
fn size_problem((width, height): (usize, usize), border: Border, levels: u32) -> String {
    let more = border.levels();
    let side = 1usize << levels;
    let with = if more > 0 { format!(" with map.border = \"{border}\"") } else { String::new() };
    let needed = format!("traverse.levels = {}{with} needs {side} x {side}", levels + more);
    let legal = |levels: u32| (2..=12).contains(&(levels + more));
    if width == height && width.is_power_of_two() && legal(width.ilog2()) {
        let other = width.ilog2() + more;
        return format!(
            "the map is {width} x {height}, but {needed}: use --set traverse.levels={other}, or --resample"
        );
    }
    let why = if width != height {
        ", not square,"
    } else if width.is_power_of_two() {
        &format!(", not {} to {} texels wide,", 4 >> more, 4096 >> more)
    } else {
        ", no power of two,"
    };
    // The largest square in it, and the smallest around it.
    let (inner, outer) = (width.min(height).ilog2(), width.max(height).next_power_of_two().ilog2());
    let set = |own: u32| if own == levels { String::new() } else { format!("--set traverse.levels={} ", own + more) };
    let mut ways = Vec::new();
    if legal(inner) {
        ways.push(format!("{}--crop (its first {1} x {1})", set(inner), 1u64 << inner));
    } else if inner > levels {
        ways.push(format!("--crop (its first {side} x {side})"));
    }
    if legal(outer) {
        ways.push(format!("{}--pad (continued to {1} x {1})", set(outer), 1u64 << outer));
    }
    ways.push(format!("--resample (filtered to {side} x {side})"));
    let last = ways.pop().unwrap_or_default();
    let ways = if ways.is_empty() { last } else { format!("{}, or {last}", ways.join(", ")) };
    format!("the map is {width} x {height}{why} and {needed}: use {ways}")
}

fn depth_problem(depth: Depth, height_bits: u32) -> Option<String> {
    match depth {
        Depth::Bits(bits) if bits > height_bits => {
            let keep = if bits <= 16 { format!("set height_bits = {bits} or ") } else { String::new() };
            Some(format!("{bits}-bit map into traverse.height_bits = {height_bits}: {keep}ask for it with --resample"))
        }
        Depth::Float => Some(format!(
            "floating-point map into traverse.height_bits = {height_bits}: it is rounded to that many bits only with --resample, or where map.range is given"
        )),
        Depth::Bits(_) | Depth::Ranged | Depth::Formula => None,
    }
}
