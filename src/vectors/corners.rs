//! Which inputs are tried: landmarks crossed with each other first, then the larger tables of corners, then weighted random rows;
//! everything where the space is small (the order of TestFloat, with tables of our own).
use super::kind::Kind;
use super::set::Counts;
use super::weights::{partner, word};
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

/// Input spaces up to this many bits are tried whole.
pub(super) const SMALL: u32 = 16;

/// True if a unit of inputs of so many bits together gets every input once.
pub const fn exhaustive(bits: u32) -> bool {
    bits <= SMALL
}

/// Rows of words for these columns.
pub fn plan_rows(columns: &[Kind], plan: Plan) -> (Vec<Vec<u64>>, Counts) {
    if columns.iter().map(|k| k.width()).sum::<u32>() <= SMALL {
        return every(columns);
    }
    let mut rng = ChaCha8Rng::seed_from_u64(plan.seed);
    let half = plan.rows / 2;
    let mut rows = Vec::with_capacity(plan.rows);
    // A class of operands that meets no other class is a policy that is not checked, so these pairs are never left to chance
    // where they fit at all.
    let landmarks: Vec<Vec<u64>> = columns.iter().map(|k| landmarks(*k)).collect();
    let room = if columns.len() <= 2 { plan.rows * 2 / 3 } else { plan.rows / 4 };
    choose(&landmarks, room, plan.rows / 4, &mut rng, &mut rows);
    let tables: Vec<Vec<u64>> = columns.iter().map(|k| table(*k)).collect();
    let left = half.saturating_sub(rows.len());
    choose(&tables, left, left, &mut rng, &mut rows);
    let corners = rows.len();
    while rows.len() < plan.rows {
        rows.push(random_row(columns, &mut rng));
    }
    let random = rows.len() - corners;
    (rows, Counts { corners, random, ..Counts::default() })
}

/// A weighted random row.
pub(super) fn random_row(columns: &[Kind], rng: &mut ChaCha8Rng) -> Vec<u64> {
    let mut row: Vec<u64> = Vec::with_capacity(columns.len());
    for (k, kind) in columns.iter().enumerate() {
        let before = (0..k).rev().find(|b| columns[*b] == *kind).map(|b| row[b]);
        row.push(match before {
            Some(a) => partner(*kind, a, rng),
            None => word(*kind, rng),
        });
    }
    row
}

/// All combinations of the tables if they are at most `room`, else `sample` of them.
fn choose(tables: &[Vec<u64>], room: usize, sample: usize, rng: &mut ChaCha8Rng, out: &mut Vec<Vec<u64>>) {
    let all = tables.iter().try_fold(1usize, |n, t| n.checked_mul(t.len()));
    match all.filter(|n| *n <= room) {
        Some(n) => out.extend((0..n).map(|mut k| {
            let pick = |t: &Vec<u64>| {
                let v = t[k % t.len()];
                k /= t.len();
                v
            };
            tables.iter().map(pick).collect()
        })),
        None => {
            out.extend(
                (0..sample).map(|_| tables.iter().map(|t| t[rng.random_range(0..t.len())]).collect::<Vec<u64>>()),
            );
        }
    }
}

/// A few values for each class that the rules tell apart.
pub fn landmarks(kind: Kind) -> Vec<u64> {
    match kind {
        Kind::Integer(w) => sorted(vec![0, 1, mask(w), mask(w) - 1, mask(w) >> 1, (mask(w) >> 1) + 1], mask(w)),
        Kind::Float(f) => {
            let one = (f.bias() as u64) << f.man;
            let inf = f.infinity();
            // Zero, subnormals, least and largest normal number, 1 and its neighbour, infinity, NaN of both kinds.
            let v = [0, 1, f.man_mask(), 1 << f.man, one, one + 1, inf - 1, inf, inf + 1, f.nan()];
            sorted(both_signs(f, &v), mask(f.width()))
        }
    }
}

/// The whole table of corners.
pub fn table(kind: Kind) -> Vec<u64> {
    match kind {
        Kind::Integer(w) => {
            let m = mask(w);
            let bits = (0..w).flat_map(|b| [1 << b, m ^ (1 << b), mask(b), m ^ mask(b), (1u64 << b) + 1]);
            let stripes = [0x5555_5555_5555_5555, 0xaaaa_aaaa_aaaa_aaaa, 0x3333_3333_3333_3333];
            sorted(bits.chain(stripes).chain(landmarks(kind)).collect(), m)
        }
        Kind::Float(f) => signed_numbers(f, &exponents(f), &fractions(f)),
    }
}

/// Every exponent field with every fraction, of both signs.
pub(super) fn signed_numbers(f: FloatFormat, exponents: &[u64], fractions: &[u64]) -> Vec<u64> {
    let v: Vec<u64> = exponents.iter().flat_map(|e| fractions.iter().map(move |m| (e << f.man) | m)).collect();
    sorted(both_signs(f, &v), mask(f.width()))
}

fn both_signs(f: FloatFormat, v: &[u64]) -> Vec<u64> {
    v.iter().flat_map(|x| [*x, x | f.sign_bit()]).collect()
}

pub(super) fn sorted(mut v: Vec<u64>, m: u64) -> Vec<u64> {
    v.iter_mut().for_each(|x| *x &= m);
    v.sort_unstable();
    v.dedup();
    v
}

pub(super) fn exponents(f: FloatFormat) -> Vec<u64> {
    let (bias, man, top) = (i64::from(f.bias()), i64::from(f.man), f.exp_max() as i64);
    let near_one = [-man - 2, -man - 1, -man, -1, 0, 1, man - 1, man, man + 1].map(|k| bias + k);
    let mut e: Vec<i64> = [0, 1, 2, top - 2, top - 1, top].into_iter().chain(near_one).collect();
    e.retain(|x| (0..=top).contains(x));
    e.sort_unstable();
    e.dedup();
    e.into_iter().map(|x| x as u64).collect()
}

pub(super) fn fractions(f: FloatFormat) -> Vec<u64> {
    let m = f.man_mask();
    let walking = (0..f.man).map(|b| 1 << b);
    let full = [0, m, m - 1, m >> 1, (m >> 1) + 2, m & 0x5555_5555_5555_5555];
    sorted(walking.chain(full).collect(), m)
}

/// Every combination of words of these columns.
pub(super) fn every(columns: &[Kind]) -> (Vec<Vec<u64>>, Counts) {
    let total = 1usize << columns.iter().map(|k| k.width()).sum::<u32>();
    let row = |mut k: u64| {
        let word = |c: &Kind| {
            let v = k & mask(c.width());
            k >>= c.width();
            v
        };
        columns.iter().map(word).collect()
    };
    ((0..total as u64).map(row).collect(), Counts { exhaustive: total, ..Counts::default() })
}
