//! A bed of stones of several sizes, each a dome cut by facets.
use super::noise::{around, fractal, smooth_min};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};

/// One stone. Lengths in tiles; height in the same unit.
struct Stone {
    x: f64,
    y: f64,
    radius: f64,
    /// A unit vector along the longer axis, and how much shorter the other is.
    axis: (f64, f64),
    squeeze: f64,
    /// How high its middle lies.
    base: f64,
    /// Planes that cut the dome: at (x, y), no higher than `top - slope . (x, y)`, in radii.
    facets: Vec<(f64, f64, f64)>,
    seed: u64,
}

/// All stones of a tile, sorted into cells so that a texel asks only its neighbours.
pub(super) struct Rocks {
    stones: Vec<Stone>,
    cells: Vec<Vec<usize>>,
    seed: u64,
}

const CELLS: usize = 32;

/// Radius, how many are tried, how near two may come (1: they touch), how high they lie.
const SIZES: [(f64, usize, f64, f64); 6] = [
    (0.145, 14, 0.90, 0.030),
    (0.098, 90, 0.84, 0.018),
    (0.062, 400, 0.80, 0.008),
    (0.036, 1600, 0.78, 0.003),
    (0.020, 4000, 0.80, 0.0),
    (0.012, 6000, 0.84, 0.0),
];

fn unit(random: &mut ChaCha8Rng) -> f64 {
    super::noise::unit(random.next_u64())
}

/// A random direction: a point of the disc, stretched to length 1.
fn direction(random: &mut ChaCha8Rng) -> (f64, f64) {
    loop {
        let (x, y) = (unit(random) * 2.0 - 1.0, unit(random) * 2.0 - 1.0);
        let square = x * x + y * y;
        if square > 0.01 && square < 1.0 {
            let length = square.sqrt();
            return (x / length, y / length);
        }
    }
}

impl Rocks {
    pub(super) fn new(seed: u64) -> Self {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut stones: Vec<Stone> = Vec::new();
        for (size, tries, near, base) in SIZES {
            for _ in 0..tries {
                let (x, y) = (unit(&mut random), unit(&mut random));
                let radius = size * (0.8 + 0.4 * unit(&mut random));
                let stone = Stone::random(&mut random, x, y, radius, base);
                let free = stones.iter().all(|other| {
                    let (dx, dy) = (around(other.x, x), around(other.y, y));
                    let gap = near * (other.reach() + stone.reach());
                    dx * dx + dy * dy > gap * gap
                });
                if free {
                    stones.push(stone);
                }
            }
        }
        let mut cells = vec![Vec::new(); CELLS * CELLS];
        for (index, stone) in stones.iter().enumerate() {
            let span = ((stone.radius * CELLS as f64).ceil() as i64) + 1;
            let (ci, cj) = ((stone.x * CELLS as f64) as i64, (stone.y * CELLS as f64) as i64);
            for j in cj - span..=cj + span {
                for i in ci - span..=ci + span {
                    let cell = j.rem_euclid(CELLS as i64) as usize * CELLS + i.rem_euclid(CELLS as i64) as usize;
                    cells[cell].push(index);
                }
            }
        }
        Self { stones, cells, seed }
    }

    /// Height at (x, y) in tiles; not yet in [0, 1].
    pub(super) fn height(&self, x: f64, y: f64) -> f64 {
        let cell = (y * CELLS as f64) as usize * CELLS + (x * CELLS as f64) as usize;
        let ground = 0.004 * fractal(self.seed ^ 0x51, x, y, 12, 5);
        self.cells[cell].iter().map(|&index| self.stones[index].height(x, y)).fold(ground, f64::max)
    }
}

impl Stone {
    fn random(random: &mut ChaCha8Rng, x: f64, y: f64, radius: f64, base: f64) -> Self {
        let axis = direction(random);
        let squeeze = 0.72 + 0.28 * unit(random);
        let mut facets = Vec::new();
        // One flat face on top, tilted a little, and steeper ones around it.
        let (tx, ty) = direction(random);
        let tilt = 0.25 * unit(random);
        facets.push((0.62 + 0.16 * unit(random), tx * tilt, ty * tilt));
        for _ in 0..6 {
            let (nx, ny) = direction(random);
            let slope = 0.5 + 1.5 * unit(random);
            let far = 0.50 + 0.35 * unit(random);
            facets.push((0.55 + slope * far * 0.72, nx * slope, ny * slope));
        }
        Self { x, y, radius, axis, squeeze, base, facets, seed: random.next_u64() }
    }

    /// Radius of a disc of about the same area.
    fn reach(&self) -> f64 {
        self.radius * (1.0 + self.squeeze) * 0.5
    }

    fn height(&self, x: f64, y: f64) -> f64 {
        let (dx, dy) = (around(self.x, x) / self.radius, around(self.y, y) / self.radius);
        if dx * dx + dy * dy > 1.4 {
            return f64::NEG_INFINITY;
        }
        // The outline wavers, or every stone would be an ellipse.
        let waver = 1.0 + 0.10 * fractal(self.seed, x, y, 9, 3);
        let along = (dx * self.axis.0 + dy * self.axis.1) * waver;
        let across = (dy * self.axis.0 - dx * self.axis.1) * waver / self.squeeze;
        let square = along * along + across * across;
        if square >= 1.0 {
            return f64::NEG_INFINITY;
        }
        // A sphere would stand upright at its outline, and upright walls show the texels most.
        let mut body = (1.0 - square) * 1.6 - 0.06;
        for &(top, sx, sy) in &self.facets {
            body = smooth_min(body, top - sx * along - sy * across, 0.10);
        }
        // As deep on a large stone as on a small one: it is the same rock.
        let grain = 0.0075 * fractal(self.seed ^ 7, x, y, 14, 5) + 0.0035 * fractal(self.seed ^ 9, x, y, 44, 3);
        let rough = grain / (self.radius + 0.03);
        self.base + self.radius * (body + rough) * 0.85
    }
}
