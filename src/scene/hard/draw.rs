//! What the cases are made of: random rays and places, rough maps.
use super::numbers::Numbers;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// A ray: u, v, du, dv in tiles.
pub type Ray = [f64; 4];

/// A supply of random choices for one case.
pub struct Draw {
    /// What the format holds.
    pub numbers: Numbers,
    rng: ChaCha8Rng,
    seed: u64,
}

impl Draw {
    /// A supply that depends on the case's name and the seed alone.
    pub fn new(numbers: Numbers, name: &str, seed: u64) -> Self {
        // FNV-1a: equal everywhere and for ever.
        let seed =
            name.bytes().fold(seed ^ 0xcbf2_9ce4_8422_2325, |h, b| (h ^ u64::from(b)).wrapping_mul(0x100_0000_01b3));
        Self { numbers, rng: ChaCha8Rng::seed_from_u64(seed), seed }
    }

    /// One of `0 .. count`.
    pub fn below(&mut self, count: u32) -> u32 {
        self.rng.random_range(0..count)
    }

    /// Anything in [low, high).
    pub fn real(&mut self, low: f64, high: f64) -> f64 {
        self.rng.random_range(low..high)
    }

    /// Yes or no.
    pub fn coin(&mut self) -> bool {
        self.rng.random()
    }

    /// `x` or `-x`.
    pub fn signed(&mut self, x: f64) -> f64 {
        if self.coin() { -x } else { x }
    }

    /// One of the list.
    pub fn pick<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.below(list.len() as u32) as usize]
    }

    /// An entry point anywhere.
    pub fn entry(&mut self) -> f64 {
        self.real(0.0, 1.0)
    }

    /// A travel of any sign, from a quarter of a texel to `most` tiles, short ones as often as long ones.
    pub fn travel(&mut self, most: f64) -> f64 {
        let octaves = (most * f64::from(self.numbers.side()) * 4.0).log2();
        let length = most * 2f64.powf(-self.real(0.0, octaves.max(0.1)));
        self.signed(length.min(self.numbers.longest()))
    }

    /// A ray anywhere, of any direction, up to a tile long.
    pub fn ray(&mut self) -> Ray {
        [self.entry(), self.entry(), self.travel(1.0), self.travel(1.0)]
    }

    /// A texel's border.
    pub fn border(&mut self) -> f64 {
        let texel = f64::from(self.below(self.numbers.side()));
        self.numbers.tiles(texel)
    }

    /// A border of a node of any level: a multiple of 2^level texels.
    pub fn node_border(&mut self) -> f64 {
        let level = self.below(self.numbers.levels + 1);
        let node = self.below(1 << (self.numbers.levels - level));
        self.numbers.tiles(f64::from(node << level))
    }

    /// A whole number of texels to travel, not 0, up to a tile.
    pub fn whole_travel(&mut self) -> f64 {
        let most = self.below(self.numbers.levels + 1);
        let texels = f64::from(1 + self.below(1 << most));
        let texels = self.numbers.tiles(texels);
        self.signed(texels)
    }

    /// A map by its texels (i, j).
    pub fn map(&self, code: impl Fn(u32, u32) -> u32) -> Vec<u32> {
        let side = self.numbers.side();
        (0..side).flat_map(|j| (0..side).map(move |i| (i, j))).map(|(i, j)| code(i, j)).collect()
    }

    /// A map of every code, texel by texel at random.
    pub fn noise(&self) -> Vec<u32> {
        let top = u64::from(self.numbers.top) + 1;
        self.map(|i, j| (self.hash(i, j) % top) as u32)
    }

    /// A map of hills with steps of single texels on them: nodes of every level matter.
    pub fn rough(&self) -> Vec<u32> {
        let n = self.numbers.levels;
        let top = f64::from(self.numbers.top);
        let unit =
            |level: u32, i: u32, j: u32| (self.hash(i >> level, (j >> level) + (level << 16)) % 1024) as f64 / 1023.0;
        self.map(|i, j| {
            // Coarse nodes weigh most; the sum of them lies in the middle too often and is spread.
            let height: f64 = (0..n).map(|level| (unit(level, i, j) - 0.5) * 0.6f64.powi((n - level) as i32)).sum();
            ((0.45 + 1.3 * height).clamp(0.0, 1.0) * top).round() as u32
        })
    }

    /// A number that depends on place and seed alone.
    pub fn hash(&self, i: u32, j: u32) -> u64 {
        let mut x = self.seed ^ (u64::from(j) << 32 | u64::from(i));
        for factor in [0xbf58_476d_1ce4_e5b9_u64, 0x94d0_49bb_1331_11eb] {
            x = (x ^ (x >> 30)).wrapping_add(0x9e37_79b9_7f4a_7c15).wrapping_mul(factor);
        }
        x ^ (x >> 31)
    }
}
