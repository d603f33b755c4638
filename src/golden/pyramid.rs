//! The maximum pyramid and its place in memory.
use super::window_maps::{Made, WindowMaps};
use reliefrtl_base::error::{Error, Result};
use reliefrtl_config::WindowSet;
use std::sync::Arc;

/// A pyramid of maxima over a square map that repeats; level 0 is the map, level `levels` one node.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pyramid {
    levels: u32,
    height_bits: u32,
    /// Words in the order of the addresses.
    words: Vec<u32>,
    /// Maps of windows that were made of it.
    windows: Made,
}

/// Word address of node `(i, j)` of level `k` in the memory of a pyramid over 2^n x 2^n texels; `i`, `j` below 2^(n-k).
///
/// Levels follow each other without a gap, and inside a level bit b of `i` stands at bit 2b, bit b of `j` at bit 2b + 1.
pub fn address(n: u32, k: u32, i: u32, j: u32) -> usize {
    // base(k) is all even bits from 2(q + 1) to 2n.
    let q = n - k;
    let base = (((1u64 << (2 * n + 2)) - (1u64 << (2 * q + 2))) / 3) as usize;
    base + spread(i) + 2 * spread(j)
}

/// Bit b of `v` (at most 16 bits) to bit 2b.
fn spread(v: u32) -> usize {
    let v = u64::from(v);
    let v = (v | (v << 8)) & 0x00ff_00ff;
    let v = (v | (v << 4)) & 0x0f0f_0f0f;
    let v = (v | (v << 2)) & 0x3333_3333;
    ((v | (v << 1)) & 0x5555_5555) as usize
}

impl Pyramid {
    /// Builds the pyramid over `texels`, height codes in row-major order (u along the row), 2^levels to a side.
    ///
    /// # Errors
    /// [`Error::Input`] if `levels` is not 1 to 12, `height_bits` not 1 to 16, there are not 4^levels texels,
    /// or one of them has more than `height_bits` bits.
    pub fn build(levels: u32, height_bits: u32, texels: &[u32]) -> Result<Self> {
        if !(1..=12).contains(&levels) || !(1..=16).contains(&height_bits) {
            return Err(Error::input(format!(
                "a pyramid has 1 to 12 levels and 1 to 16 height bits, not {levels} and {height_bits}"
            )));
        }
        let side = 1u32 << levels;
        if texels.len() != 1 << (2 * levels) {
            return Err(Error::input(format!("the map has {} texels, {side} x {side} are needed", texels.len())));
        }
        if let Some(at) = texels.iter().position(|&c| c >> height_bits != 0) {
            let (i, j) = (at as u32 % side, at as u32 / side);
            let code = texels[at];
            return Err(Error::input(format!("texel ({i}, {j}) has height code {code}, more than {height_bits} bits")));
        }
        let mut words = vec![0; address(levels, levels, 0, 0) + 1];
        for (at, &code) in texels.iter().enumerate() {
            words[address(levels, 0, at as u32 % side, at as u32 / side)] = code;
        }
        for k in 1..=levels {
            for j in 0..side >> k {
                for i in 0..side >> k {
                    let child = |a, b| words[address(levels, k - 1, 2 * i + a, 2 * j + b)];
                    let most = child(0, 0).max(child(1, 0)).max(child(0, 1)).max(child(1, 1));
                    words[address(levels, k, i, j)] = most;
                }
            }
        }
        Ok(Self { levels, height_bits, words, windows: Made::default() })
    }

    /// Maximum height code of node `(i, j)` of a level; the indices are below 2^(levels - level).
    pub fn node(&self, level: u32, i: u32, j: u32) -> u32 {
        self.words[address(self.levels, level, i, j)]
    }

    /// The memory image: (4^(levels + 1) - 1) / 3 words of `height_bits` bits, by address.
    pub fn memory(&self) -> &[u32] {
        &self.words
    }

    /// The maps of windows over the same texels (`docs/windows.md`), made when they are first asked for.
    ///
    /// # Panics
    /// If a window's grid is larger than the map.
    pub fn windows(&self, set: &WindowSet) -> Arc<WindowMaps> {
        self.windows.get(set, || WindowMaps::build(self.levels, set, |k, i, j| self.node(k, i, j)))
    }

    /// log2 of the map's side.
    pub fn levels(&self) -> u32 {
        self.levels
    }

    /// Bits of a height code.
    pub fn height_bits(&self) -> u32 {
        self.height_bits
    }
}
