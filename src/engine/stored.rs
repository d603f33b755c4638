//! What stands in the directory of a unit's vectors.
use crate::config::{Design, WindowSet};
use crate::error::{Error, Result};
use crate::files::read_text_of_tree;
use crate::golden::{Pyramid, RayInput, datapath};
use std::path::Path;

/// The pyramid of a memory image.
///
/// # Errors
/// An image that is too short.
pub fn pyramid_of(d: &Design, image: &[u64]) -> Result<Pyramid> {
    let n = d.traverse.levels;
    let side = 1u32 << n;
    let place = datapath(d.datapath.kind).texel_word;
    let texel = |k: u32| {
        let word = image.get(place(d, k % side, k / side)).and_then(|word| u32::try_from(*word).ok());
        word.ok_or_else(|| Error::input(format!("memory.hex holds no pyramid of {side} x {side} texels")))
    };
    Pyramid::build(n, d.traverse.height_bits, &(0..side * side).map(texel).collect::<Result<Vec<u32>>>()?)
}

/// The words of a ray.
pub fn ray_of(row: &[u64]) -> RayInput {
    RayInput { u: row[0], v: row[1], du: row[2], dv: row[3], lod: row.get(4).map_or(0, |v| *v as u32) }
}

/// The names of the images in the vectors' directory `place`: the pyramid's first, or those of windows of each size.
pub fn memory_files(place: &Path) -> Vec<String> {
    let sizes = (0..WindowSet::MOST).map(|k| format!("memory.hex.{k}"));
    std::iter::once("memory.hex".to_string()).chain(sizes).filter(|name| place.join(name).exists()).collect()
}

/// The words of a pyramid's image, or of the windows of each size, from the vectors' directory `place`.
///
/// # Errors
/// A file that is missing or no image.
pub fn memory(place: &Path) -> Result<Vec<u64>> {
    let files = memory_files(place);
    let whole = files.is_empty() || files[0] == "memory.hex";
    if whole {
        return words(&place.join("memory.hex"));
    }
    Ok(files.iter().map(|name| words(&place.join(name))).collect::<Result<Vec<_>>>()?.concat())
}

fn words(path: &Path) -> Result<Vec<u64>> {
    let text = read_text_of_tree(path)?;
    let bad = || Error::input(format!("{} is not a pyramid image", path.display()));
    let words = text.lines().map(|l| l.split("//").next().unwrap_or("").trim()).filter(|l| !l.is_empty());
    let words: Vec<u64> = words.map(|w| u64::from_str_radix(w, 16).map_err(|_| bad())).collect::<Result<_>>()?;
    Ok(words)
}
