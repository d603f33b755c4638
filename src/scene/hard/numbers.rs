//! What a design's number format can hold exactly, as f64.
use reliefrtl_base::format::Words;
use reliefrtl_config::Design;

/// The numbers of a design's rays; all of them fit into an f64 exactly.
#[derive(Clone, Copy, Debug)]
pub struct Numbers {
    /// log2 of the map's side.
    pub levels: u32,
    /// The largest height code, M.
    pub top: u32,
    /// Rays travel less than 2^tile_bits tiles.
    pub tile_bits: u32,
    /// Iterations after which a ray is given up.
    pub step_limit: u32,
    words: Words,
}

impl Numbers {
    /// The numbers of `design`.
    pub fn of(design: &Design) -> Self {
        let t = &design.traverse;
        let top = (1 << t.height_bits) - 1;
        Self { levels: t.levels, top, tile_bits: t.tile_bits, step_limit: t.step_limit, words: design.words() }
    }

    /// Texels in a row.
    pub fn side(&self) -> u32 {
        1 << self.levels
    }

    /// `x` texels in tiles.
    pub fn tiles(&self, x: f64) -> f64 {
        x / f64::from(self.side())
    }

    /// The smallest positive number.
    pub fn smallest(&self) -> f64 {
        2f64.powi(self.words.least_exponent())
    }

    /// The number `ulps` places from the number `x`, away from 0 if positive; never across 0.
    pub fn nudge(&self, x: f64, ulps: i32) -> f64 {
        let one = if ulps < 0 { -1 } else { 1 };
        let mut near = x.abs();
        for _ in 0..ulps.abs() {
            // Below a power of two floating-point numbers stand twice as close as above it.
            let exp = exponent(near);
            let exp = if one < 0 && near == 2f64.powi(exp) { exp - 1 } else { exp };
            let unit = 2f64.powi(self.words.spacing_exponent(exp));
            near = (near + f64::from(one) * unit).max(0.0);
        }
        // What is below the smallest number is zero.
        let near = if near < self.smallest() && one < 0 { 0.0 } else { near.max(0.0) };
        near.copysign(x)
    }

    /// The largest number below 1: the last entry point.
    pub fn below_one(&self) -> f64 {
        self.nudge(1.0, -1)
    }

    /// The largest travel.
    pub fn longest(&self) -> f64 {
        self.nudge(2f64.powi(self.tile_bits as i32), -1)
    }

    /// k such that a ray that travels M * 2^-k texels falls by exactly 2^k height codes a texel, with a travel that is legal and, as far as
    /// the format allows, exact.
    pub fn codes_per_texel(&self) -> u32 {
        let height_bits = u32::BITS - self.top.leading_zeros();
        (height_bits + 1)
            .saturating_sub(self.levels + self.tile_bits)
            .max(u32::from(height_bits > 4))
            .min(height_bits - 1)
    }
}

/// Floor of the binary logarithm; far below every exponent of 0.
fn exponent(x: f64) -> i32 {
    if x == 0.0 { -1022 } else { (x.to_bits() >> 52) as i32 - 1023 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_of_the_default_format() {
        let n = Numbers::of(&Design::default());
        assert_eq!(n.below_one(), 1.0 - 2f64.powi(-17));
        assert_eq!(n.longest(), 16.0 - 2f64.powi(-13));
        assert_eq!(n.nudge(1.0, 1), 1.0 + 2f64.powi(-16));
        assert_eq!(n.nudge(-1.0, -2), -1.0 + 2f64.powi(-16));
        assert_eq!(n.smallest(), 2f64.powi(-62));
        assert_eq!(n.nudge(n.smallest(), -1), 0.0);
        assert_eq!(n.nudge(n.smallest(), 1), 2f64.powi(-62) + 2f64.powi(-78));
    }
}
