//! What the datapaths in floating point share.
use crate::{Config, Design};
use reliefrtl_base::format::{FloatFormat, Words};

/// The numbers of a ray.
pub(super) fn words(d: &Design) -> Words {
    Words::Float(d.format)
}

/// INT_W and FRAC_W of a hit's position.
pub(super) fn hit_word(d: &Design) -> (u32, u32) {
    let t = &d.traverse;
    (t.idx_bits() + t.frac_bits, t.frac_bits)
}

/// Every fraction width, and of each the exponents, few to many bits.
pub(super) fn ladder(d: &Design) -> Vec<Vec<Design>> {
    let at = |man: u32| (5..=8).map(move |exp| Design { format: FloatFormat::new(exp, man), ..*d }).collect();
    (7..=23).map(at).collect()
}

/// The bounds that keep every intermediate result of the datapath inside its width (`docs/datapath.md`, Parameters).
pub(super) fn widths(c: &Config, problems: &mut Vec<String>) {
    let (exp, man) = (c.format.exp, c.format.man);
    let (levels, height, tiles) = (c.traverse.levels, c.traverse.height_bits, c.traverse.tile_bits);
    let bias = (1u32 << (exp - 1)) - 1;
    if man < 7 {
        problems.push(format!("format.man = {man} is too small for the traverse unit: 7 to 23 are legal"));
    }
    if height > man + 1 {
        problems.push(format!(
            "traverse.height_bits = {height} is too large for format.man = {man}: at most format.man + 1 = {} is legal, so that a height code is exact",
            man + 1
        ));
    }
    let index = c.traverse.idx_bits();
    let position = index + c.traverse.frac_bits + man;
    if position > 60 {
        problems.push(format!(
            "traverse.frac_bits = {} is too large for a texel coordinate of {index} bits and format.man = {man}: levels + tile_bits + 2 + frac_bits + man = {position} may be at most 60",
            c.traverse.frac_bits
        ));
    }
    if index > 24 {
        problems.push(format!(
            "traverse.levels = {levels} and traverse.tile_bits = {tiles} make a texel coordinate of {index} bits: levels + tile_bits + 2 may be at most 24"
        ));
    }
    if levels + tiles + 1 > bias {
        problems.push(format!(
            "format.exp = {exp} is too small for traverse.levels = {levels} and traverse.tile_bits = {tiles}: levels + tile_bits + 1 = {} may be at most 2^(exp-1) - 1 = {bias}",
            levels + tiles + 1
        ));
    }
    if man > bias + levels {
        problems.push(format!(
            "format.man = {man} is too large for format.exp = {exp} and traverse.levels = {levels}: at most 2^(exp-1) - 1 + levels = {} is legal",
            bias + levels
        ));
    }
    if height + 2 > bias {
        problems.push(format!(
            "format.exp = {exp} is too small for traverse.height_bits = {height}: height_bits + 2 = {} may be at most 2^(exp-1) - 1 = {bias}",
            height + 2
        ));
    }
}
