//! Maps and rays for the traversal tests, all from a seed.
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use reliefrtl::format::FloatFormat;
use reliefrtl::golden::RayInput;

/// Reads a number from the environment.
pub fn env(name: &str, default: u64) -> u64 {
    std::env::var(name).map_or(default, |v| v.parse().unwrap_or_else(|_| panic!("{name}={v} is not a number")))
}

/// Number of maps that [`map`] knows.
pub const MAPS: usize = 6;

/// Height codes of 2^n x 2^n texels: random, spiky, flat, checker, hills, pits.
pub fn map(kind: usize, n: u32, h: u32, seed: u64) -> Vec<u32> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed ^ 0x5ce7e);
    let (side, top) = (1u32 << n, (1u32 << h) - 1);
    let mut code = |i: u32, j: u32| match kind {
        0 => rng.random_range(0..=top),
        1 => {
            if rng.random_ratio(1, 50) {
                top
            } else {
                rng.random_range(0..=top / 16)
            }
        }
        2 => top / 3,
        3 => (i + j) % 2 * (top / 2),
        4 => {
            let wave = |a: u32| (f64::from(a) / f64::from(side) * std::f64::consts::TAU).sin() / 4.0;
            ((0.5 + wave(i) + wave(2 * j)) * f64::from(top)) as u32
        }
        _ => {
            if rng.random_ratio(1, 20) {
                0
            } else {
                top - rng.random_range(0..=1)
            }
        }
    };
    (0..side * side).map(|at| code(at % side, at / side)).collect()
}

/// Kinds of rays; all but the first are hard in some way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Anywhere, of any slope up to one tile.
    Generic,
    /// Entry and travel are multiples of a small power of two.
    Lattice,
    /// Travels along one axis only.
    AxisParallel,
    /// Travels nowhere; both signs of zero.
    Down,
    /// Enters on a texel border or a few units in the last place beside it.
    Border,
    /// Travels less than a texel, down to the smallest number.
    Tiny,
    /// Travels nearly as far as it may.
    Long,
    /// |du| = |dv|.
    Diagonal,
    /// Random fields.
    Fields,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Self; 9] = [
        Self::Generic,
        Self::Lattice,
        Self::AxisParallel,
        Self::Down,
        Self::Border,
        Self::Tiny,
        Self::Long,
        Self::Diagonal,
        Self::Fields,
    ];
}

/// An endless supply of valid rays.
pub struct Rays {
    rng: ChaCha8Rng,
    fmt: FloatFormat,
    n: u32,
    tile: u32,
}

impl Rays {
    /// Rays over a map of 2^n x 2^n texels that travel less than 2^tile tiles.
    pub fn new(fmt: FloatFormat, n: u32, tile: u32, seed: u64) -> Self {
        Self { rng: ChaCha8Rng::seed_from_u64(seed), fmt, n, tile }
    }

    /// The next ray of a kind.
    pub fn next(&mut self, kind: Kind) -> RayInput {
        let mut p = [self.entry(), self.entry()];
        let mut d = [self.travel(), self.travel()];
        let which = self.rng.random_range(0..2);
        match kind {
            Kind::Generic => {}
            Kind::Lattice => {
                p = [self.lattice_entry(), self.lattice_entry()];
                d = [self.lattice_travel(), self.lattice_travel()];
            }
            Kind::AxisParallel => {
                if self.rng.random() {
                    p = [self.lattice_entry(), self.border()];
                }
                d[which] = self.zero();
            }
            Kind::Down => {
                if self.rng.random() {
                    p = [self.border(), self.lattice_entry()];
                }
                d = [self.zero(), self.zero()];
            }
            Kind::Border => {
                p = [self.border(), self.border()];
                if self.rng.random() {
                    d[which] = self.lattice_travel();
                }
            }
            Kind::Tiny => {
                if self.rng.random() {
                    p[which] = self.border();
                }
                d = [self.small(), self.small()];
            }
            Kind::Long => d = [self.long(), self.long()],
            Kind::Diagonal => {
                if self.rng.random() {
                    p = [self.lattice_entry(), self.lattice_entry()];
                    d[0] = self.lattice_travel();
                }
                d[1] = d[0] ^ if self.rng.random() { self.fmt.sign_bit() } else { 0 };
            }
            Kind::Fields => {
                p = [self.field(-1), self.field(-1)].map(|x| x & !self.fmt.sign_bit());
                d = [self.field(self.tile as i32 - 1), self.field(self.tile as i32 - 1)];
            }
        }
        RayInput { u: p[0], v: p[1], du: d[0], dv: d[1], lod: 0 }
    }

    /// A number of random sign and fraction, with a random exponent up to `top` (that of 2^top).
    fn field(&mut self, top: i32) -> u64 {
        let field = self.rng.random_range(0..=(top + self.fmt.bias()) as u64);
        self.with_exponent(field)
    }

    fn with_exponent(&mut self, field: u64) -> u64 {
        let fraction = self.rng.random_range(0..=self.fmt.man_mask());
        (field << self.fmt.man) | fraction | self.sign()
    }

    fn sign(&mut self) -> u64 {
        if self.rng.random() { self.fmt.sign_bit() } else { 0 }
    }

    fn zero(&mut self) -> u64 {
        self.sign()
    }

    fn entry(&mut self) -> u64 {
        let p = encode(self.fmt, self.rng.random_range(0.0..1.0));
        // What rounds up to 1 is the largest number below it instead.
        p.min(encode(self.fmt, 1.0) - 1)
    }

    fn travel(&mut self) -> u64 {
        let scale = 0.5f64.powi(self.rng.random_range(0..6));
        encode(self.fmt, self.rng.random_range(-1.0..1.0) * scale)
    }

    /// A multiple of a power of two no finer than an eighth of a texel.
    fn lattice_entry(&mut self) -> u64 {
        let k = self.rng.random_range(0..=(self.n + 3).min(self.fmt.man + 1));
        encode(self.fmt, f64::from(self.rng.random_range(0..1u32 << k)) * 0.5f64.powi(k as i32))
    }

    fn lattice_travel(&mut self) -> u64 {
        let k = self.rng.random_range(0..=self.n + 3);
        let most = (1i32 << self.rng.random_range(0..=(k + self.tile).min(self.fmt.man))) - 1;
        encode(self.fmt, f64::from(self.rng.random_range(-most..=most)) * 0.5f64.powi(k as i32))
    }

    fn border(&mut self) -> u64 {
        let texel = self.rng.random_range(0..1u64 << self.n) as f64;
        let p = encode(self.fmt, texel * 0.5f64.powi(self.n as i32)).min(encode(self.fmt, 1.0) - 1);
        let aside = self.rng.random_range(-3i64..=3).max(-(p as i64));
        // A code just below the smallest normal number reads as zero, which is a border too.
        ((p as i64 + aside) as u64).min(encode(self.fmt, 1.0) - 1)
    }

    fn small(&mut self) -> u64 {
        self.field(-(self.n as i32))
    }

    fn long(&mut self) -> u64 {
        let field = (self.tile as i32 - 1 + self.fmt.bias()) as u64;
        let field = field - self.rng.random_range(0..2);
        if self.rng.random_ratio(1, 4) {
            (field << self.fmt.man) | self.fmt.man_mask() | self.sign()
        } else {
            self.with_exponent(field)
        }
    }
}

fn encode(fmt: FloatFormat, x: f64) -> u64 {
    reliefrtl::golden::float::from_f64(fmt, x)
}
