//! Heights to the codes that the memory holds.
use super::height_map::{Depth, HeightMap};
use crate::config::Border;
use crate::error::{Error, Result};

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

/// As [`to_codes`], for a design of 2^levels x 2^levels texels that sees what `border` puts behind the map's border.
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
    let codes = own_codes(map, border, own, height_bits, resample)?;
    Ok(super::border::prepared(border, own, codes))
}

/// The map alone, as codes of 2^levels x 2^levels texels.
fn own_codes(map: &HeightMap, border: Border, levels: u32, height_bits: u32, resample: bool) -> Result<Vec<u32>> {
    let side = 1usize << levels;
    if !resample {
        let mut problems = Vec::new();
        problems.extend(size_problem(map, border, levels));
        problems.extend(depth_problem(map, height_bits));
        if !problems.is_empty() {
            return Err(Error::input(problems.join("; ")));
        }
    }
    let max = f64::from((1u32 << height_bits) - 1);
    // Rounding is half away from zero: exact, and the same everywhere.
    let code = |height: &f64| (height * max).round() as u32;
    if (map.width, map.height) == (side, side) {
        return Ok(map.samples.iter().map(code).collect());
    }
    let rows = stretch(&map.samples, map.width, side);
    let columns = stretch(&transpose(&rows, side), map.height, side);
    Ok(transpose(&columns, side).iter().map(|height| code(&height.clamp(0.0, 1.0))).collect())
}

fn size_problem(map: &HeightMap, border: Border, levels: u32) -> Option<String> {
    let more = border.levels();
    let (width, height, side) = (map.width, map.height, 1usize << levels);
    if (width, height) == (side, side) {
        return None;
    }
    let with = if more > 0 { format!(" with map.border = \"{border}\"") } else { String::new() };
    let needed = format!("traverse.levels = {}{with} needs {side} x {side}", levels + more);
    let square = width == height && width.is_power_of_two() && (2..=12).contains(&(width.ilog2() + more));
    Some(if square {
        let other = width.ilog2() + more;
        format!("the map is {width} x {height}, but {needed}: use --set traverse.levels={other}, or --resample")
    } else if width != height {
        format!("the map is {width} x {height}, not square, and {needed}: use --resample")
    } else if width.is_power_of_two() {
        format!(
            "the map is {width} x {height}, not {} to {} texels wide, and {needed}: use --resample",
            4 >> more,
            4096 >> more
        )
    } else {
        format!("the map is {width} x {height}, no power of two, and {needed}: use --resample")
    })
}

fn depth_problem(map: &HeightMap, height_bits: u32) -> Option<String> {
    match map.depth {
        Depth::Bits(bits) if bits > height_bits => {
            let keep = if bits <= 16 { format!("set height_bits = {bits} or ") } else { String::new() };
            Some(format!("{bits}-bit map into traverse.height_bits = {height_bits}: {keep}ask for it with --resample"))
        }
        Depth::Float => Some(format!(
            "floating-point map into traverse.height_bits = {height_bits}: it is rounded to that many bits only with --resample"
        )),
        Depth::Bits(_) | Depth::Formula => None,
    }
}

/// Every row of `width` samples to `side` samples.
fn stretch(samples: &[f64], width: usize, side: usize) -> Vec<f64> {
    if width == side {
        return samples.to_vec();
    }
    let taps: Vec<Vec<(usize, f64)>> =
        (0..side).map(|at| if side < width { area(at, width, side) } else { line(at, width, side) }).collect();
    samples
        .chunks_exact(width)
        .flat_map(|row| taps.iter().map(move |taps| taps.iter().map(|&(from, weight)| row[from] * weight).sum()))
        .collect()
}

/// The source samples under target sample `at`, each with the part of it that lies there.
fn area(at: usize, width: usize, side: usize) -> Vec<(usize, f64)> {
    // In units of 1 / side source samples, so that every border is a whole number and the weights are exact ratios.
    let (from, to) = (at * width, (at + 1) * width);
    (from / side..to.div_ceil(side))
        .map(|source| {
            let inside = to.min((source + 1) * side) - from.max(source * side);
            (source, inside as f64 / width as f64)
        })
        .collect()
}

/// The two source samples around the centre of target sample `at`, wrapped.
fn line(at: usize, width: usize, side: usize) -> Vec<(usize, f64)> {
    // The centre lies at (2 at + 1) width / (2 side) - 1/2 source samples; twice that and shifted by width stays a whole number.
    let twice = (2 * at + 1) * width + 2 * side * width - side;
    let low = twice / (2 * side);
    let part = (twice % (2 * side)) as f64 / (2 * side) as f64;
    vec![(low % width, 1.0 - part), ((low + 1) % width, part)]
}

/// Columns to rows; `width` is the length of a row before.
fn transpose(samples: &[f64], width: usize) -> Vec<f64> {
    let height = samples.len() / width;
    (0..width).flat_map(|i| (0..height).map(move |j| samples[j * width + i])).collect()
}
