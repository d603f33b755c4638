//! Sizes and sets that the search by windows is tried with.
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use reliefrtl::config::{DatapathConfig, DatapathKind, Design, Window, WindowSet, WindowsConfig};

use super::super::fixed::design as fixed;

/// Sets that the documents name, and the smallest one.
pub const SETS: [&str; 9] = [
    "1 4@2 12@4 40@8",
    "1 4@2 16@4",
    "1 4@2 8@4 16@8 32@16",
    "1 4@2 12@4 24@8 64@16",
    "1 4 16",
    "1 3 9 27",
    "1 2 5 17",
    "1 2@2",
    "1 64",
];

/// Fraction bits, reciprocal bits, levels, height bits, tile bits: the usual ones, and where the derived widths turn: no bits below a texel (F = n),
/// fewer than 18 bits of t (F < 16), no fraction of the estimate (n + T = 18 and beyond), no guard bits, the widest of all.
pub const SIZES: [(u32, u32, u32, u32, u32); 20] = [
    (24, 24, 8, 8, 4),
    (24, 18, 6, 16, 4),
    (20, 18, 5, 8, 4),
    (8, 8, 8, 8, 4),
    (8, 32, 2, 2, 8),
    (28, 31, 5, 16, 4),
    (28, 8, 3, 2, 1),
    (16, 16, 3, 12, 8),
    (24, 30, 2, 8, 8),
    (12, 31, 4, 12, 4),
    (14, 10, 5, 2, 7),
    (9, 9, 9, 9, 8),
    (10, 20, 10, 4, 8),
    (10, 8, 10, 10, 1),
    (15, 8, 7, 15, 8),
    (17, 12, 10, 16, 8),
    (24, 31, 10, 16, 8),
    (16, 8, 6, 3, 2),
    (26, 29, 7, 9, 6),
    (13, 32, 8, 5, 3),
];

/// A design of these sizes that searches by `set`.
pub fn windows((f, w, n, h, tile): (u32, u32, u32, u32, u32), set: WindowSet) -> Design {
    let base = fixed(f, w, n, h, tile);
    let datapath = DatapathConfig { kind: DatapathKind::Windows, ..base.datapath };
    Design { datapath, windows: WindowsConfig { set: Some(set) }, ..base }
}

/// The same in the pyramid.
pub fn pyramid(d: &Design) -> Design {
    Design { datapath: DatapathConfig { kind: DatapathKind::Fixed, ..d.datapath }, ..*d }
}

/// Any legal sizes with at most 2^`most` texels a side.
pub fn any_sizes(most: u32, rng: &mut ChaCha8Rng) -> (u32, u32, u32, u32, u32) {
    loop {
        let (f, w, n) = (rng.random_range(8..=28), rng.random_range(8..=32), rng.random_range(2..=most));
        let (h, tile) = (rng.random_range(2..=16), rng.random_range(1..=8u32));
        if n <= f && h <= f && n + tile + 2 <= 24 && f + tile <= 32 && f + tile + w <= 63 {
            return (f, w, n, h, tile);
        }
    }
}

/// Any legal set on 2^`levels` texels a side.
pub fn any_set(levels: u32, rng: &mut ChaCha8Rng) -> WindowSet {
    loop {
        let mut sizes = vec![Window::TEXEL];
        for _ in 0..rng.random_range(1..WindowSet::MOST) {
            let grid = 1 << rng.random_range(0..=4);
            sizes.push(Window { side: grid * rng.random_range(1..=64), grid });
        }
        sizes.sort_by_key(|w| (w.grid, w.side));
        if let Some(set) = WindowSet::new(&sizes).ok().filter(|set| set.misfit(levels).is_none()) {
            return set;
        }
    }
}
