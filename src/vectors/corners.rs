//! Which inputs are tried: corner tables crossed with each other first, then weighted random rows; everything where the
//! space is small (the order of TestFloat, with tables of our own).
use super::set::Counts;
use crate::bits::mask;
use crate::format::FloatFormat;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// How many rows, and from which bits.
#[derive(Clone, Copy, Debug)]
pub struct Plan {
    /// Rows in all, where the space is larger.
    pub rows: usize,
    /// Seed (ChaCha8).
    pub seed: u64,
}

/// Input spaces up to this many rows are tried whole.
const SMALL: u32 = 16;

/// Rows of `arity` floats of one format.
pub fn float_rows(f: FloatFormat, arity: usize, plan: Plan) -> (Vec<Vec<u64>>, Counts) {
    let w = f.width();
    if w * arity as u32 <= SMALL {
        return every(&vec![w; arity]);
    }
    let (exps, fracs) = (exponents(f), fractions(f));
    let table: Vec<u64> = exps.iter().flat_map(|e| fracs.iter().map(move |m| (e << f.man) | m)).collect();
    let table: Vec<u64> = table.iter().copied().chain(table.iter().map(|v| v | f.sign_bit())).collect();
    let mut rng = ChaCha8Rng::seed_from_u64(plan.seed);
    let pick = |rng: &mut ChaCha8Rng| table[rng.random_range(0..table.len())];
    let crossed = table.len().pow(arity as u32);
    let half = plan.rows / 2;
    let mut rows: Vec<Vec<u64>> = if crossed <= half {
        (0..crossed).map(|k| (0..arity as u32).map(|a| table[k / table.len().pow(a) % table.len()]).collect()).collect()
    } else {
        // The crossed table does not fit the budget: a sample of it, each operand a corner.
        (0..half).map(|_| (0..arity).map(|_| pick(&mut rng)).collect()).collect()
    };
    let corners = rows.len();
    while rows.len() < plan.rows {
        let mut row: Vec<u64> = vec![number(f, &mut rng)];
        while row.len() < arity {
            row.push(near(f, row[0], &mut rng));
        }
        rows.push(row);
    }
    let counts = Counts { corners, random: rows.len() - corners, exhaustive: 0 };
    (rows, counts)
}

fn exponents(f: FloatFormat) -> Vec<u64> {
    let (bias, man, top) = (f.bias() as i64, i64::from(f.man), f.exp_max() as i64);
    let mut e = vec![
        0,
        1,
        2,
        bias - man - 1,
        bias - man,
        bias - 1,
        bias,
        bias + 1,
        bias + man,
        bias + man + 1,
        top - 2,
        top - 1,
        top,
    ];
    e.retain(|x| (0..=top).contains(x));
    e.sort_unstable();
    e.dedup();
    e.into_iter().map(|x| x as u64).collect()
}

fn fractions(f: FloatFormat) -> Vec<u64> {
    let m = f.man_mask();
    let mut v =
        vec![0, 1, 2, m, m - 1, m >> 1, (m >> 1) + 1, ((m >> 1) + 2) & m, m & 0x5555_5555_5555_5555, 1 << (f.man / 2)];
    v.sort_unstable();
    v.dedup();
    v
}

/// A float with a plain exponent half of the time, any bits otherwise.
fn number(f: FloatFormat, rng: &mut ChaCha8Rng) -> u64 {
    let any = rng.random::<u64>() & mask(f.width());
    if rng.random::<bool>() {
        return any;
    }
    let span = i64::from(f.man) + 3;
    let e = (i64::from(f.bias()) + rng.random_range(-span..=span)).clamp(1, f.exp_max() as i64 - 1) as u64;
    (any & !(f.exp_max() << f.man)) | (e << f.man)
}

/// A partner for `a`: close in exponent, almost equal, with few bits set, or any.
fn near(f: FloatFormat, a: u64, rng: &mut ChaCha8Rng) -> u64 {
    let e = ((a >> f.man) & f.exp_max()) as i64;
    let sign = if rng.random::<bool>() { f.sign_bit() } else { 0 };
    let with = |e: i64, m: u64| sign | ((e.clamp(0, f.exp_max() as i64) as u64) << f.man) | (m & f.man_mask());
    match rng.random_range(0..5) {
        0 => with(e + rng.random_range(-2..=2), rng.random()),
        1 => (a ^ f.sign_bit()).wrapping_add(rng.random_range(0..3)) & mask(f.width()),
        2 => with(e - rng.random_range(0..=i64::from(f.man) + 3), 0),
        3 => with(e + rng.random_range(-3..=3), 1 << rng.random_range(0..f.man)),
        _ => number(f, rng),
    }
}

/// Rows of integers of the given widths: corners crossed or sampled, then random.
pub fn integer_rows(widths: &[u32], plan: Plan) -> (Vec<Vec<u64>>, Counts) {
    if widths.iter().sum::<u32>() <= SMALL {
        return every(widths);
    }
    let mut rng = ChaCha8Rng::seed_from_u64(plan.seed);
    let corner = |w: u32, rng: &mut ChaCha8Rng| {
        let m = mask(w);
        [0, 1, m, m >> 1, (m >> 1) + 1, m & !1, 1 << rng.random_range(0..w), m >> rng.random_range(0..w)]
            [rng.random_range(0..8)]
            & m
    };
    let half = plan.rows / 2;
    let rows = (0..plan.rows).map(|k| {
        let one = |w: &u32| {
            let r = rng.random::<u64>() & mask(*w);
            if k < half || rng.random_range(0..4) == 0 { corner(*w, &mut rng) } else { r }
        };
        widths.iter().map(one).collect()
    });
    (rows.collect(), Counts { corners: half, random: plan.rows - half, exhaustive: 0 })
}

/// Every combination of words of these widths.
fn every(widths: &[u32]) -> (Vec<Vec<u64>>, Counts) {
    let total = 1usize << widths.iter().sum::<u32>();
    let row = |mut k: u64| {
        let word = |w: &u32| {
            let v = k & mask(*w);
            k >>= w;
            v
        };
        widths.iter().map(word).collect()
    };
    ((0..total as u64).map(row).collect(), Counts { exhaustive: total, ..Counts::default() })
}
