//! Whole tables of corners: those of every operand crossed with those of every other, in two sizes, and in any number of parts.
use super::campaign::{Campaign, Level};
use super::corners::{Plan, SMALL, every, fractions, landmarks, random_row, signed_numbers, sorted, table};
use super::kind::Kind;
use super::set::Counts;
use crate::bits::mask;
use crate::format::FloatFormat;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// Rows of a campaign for these columns; every input once where there are few.
pub fn campaign_rows(columns: &[Kind], plan: Plan, c: Campaign) -> (Vec<Vec<u64>>, Counts) {
    let mine = |k: &usize| *k as u64 % u64::from(c.shard.of) == u64::from(c.shard.index) - 1;
    if columns.iter().map(|k| k.width()).sum::<u32>() <= SMALL {
        let rows: Vec<Vec<u64>> =
            every(columns).0.into_iter().enumerate().filter(|r| mine(&r.0)).map(|r| r.1).collect();
        let exhaustive = rows.len();
        return (rows, Counts { exhaustive, ..Counts::default() });
    }
    let tables: Vec<Vec<u64>> = columns.iter().map(|k| corners(*k, c.level, columns.len())).collect();
    let crossed: usize = tables.iter().map(Vec::len).product();
    let row = |mut k: usize| {
        let pick = |t: &Vec<u64>| {
            let v = t[k % t.len()];
            k /= t.len();
            v
        };
        tables.iter().map(pick).collect()
    };
    let mut rows: Vec<Vec<u64>> = (0..crossed).filter(mine).map(row).collect();
    let corners = rows.len();
    // All of them are drawn, so that the parts are those of one whole.
    let mut rng = ChaCha8Rng::seed_from_u64(plan.seed);
    let random = (crossed..crossed + plan.rows).map(|k| (k, random_row(columns, &mut rng)));
    rows.extend(random.filter(|r| mine(&r.0)).map(|r| r.1));
    let random = rows.len() - corners;
    (rows, Counts { corners, random, ..Counts::default() })
}

/// The corners of a column that stands among `columns` of them.
fn corners(kind: Kind, level: Level, columns: usize) -> Vec<u64> {
    let numbers = |e: &[u64], m: &[u64], f| signed_numbers(f, e, m);
    match (kind, columns, level) {
        (_, _, Level::Three) => vec![],
        (Kind::Float(_), 1, Level::One) | (Kind::Float(_), 2, Level::Two) => table(kind),
        (Kind::Float(f), 1, Level::Two) => numbers(&(0..=f.exp_max()).collect::<Vec<_>>(), &fractions(f), f),
        (Kind::Float(f), 2, Level::One) => numbers(&few_exponents(f), &few_fractions(f), f),
        (Kind::Float(_), _, Level::One) => landmarks(kind),
        (Kind::Float(f), _, Level::Two) => numbers(&few_exponents(f), &few_fractions(f)[..4], f),
        (Kind::Integer(w), 1, Level::Two) => {
            let bits = || 0..w;
            let two =
                bits().flat_map(|a| bits().flat_map(move |b| [(1u64 << a) + (1 << b), (1 << a) - (1 << b.min(a))]));
            let two: Vec<u64> = two.flat_map(|v| [v, v.wrapping_neg(), v + 1, v.wrapping_sub(1)]).collect();
            sorted([two, table(kind)].concat(), mask(w))
        }
        (Kind::Integer(_), ..) => table(kind),
    }
}

/// Both ends, the neighbourhood of 1, and where one operand no longer reaches another, or just the largest number.
fn few_exponents(f: FloatFormat) -> Vec<u64> {
    let (bias, man, top) = (i64::from(f.bias()), i64::from(f.man), f.exp_max() as i64);
    let near_one = [-man - 1, -man, -1, 0, 1, man].map(|k| bias + k);
    let all = [0, 1, 2, top - man - 2, top - 1, top].into_iter().chain(near_one);
    let legal = all.filter(|e| (0..=top).contains(e)).map(|e| e as u64).collect();
    sorted(legal, f.exp_max())
}

/// 0, all ones, a tie's half and its neighbour; then the lowest bit and all ones but it.
fn few_fractions(f: FloatFormat) -> Vec<u64> {
    let (m, half) = (f.man_mask(), 1 << (f.man - 1));
    vec![0, m, half, 1, half + 1, m - 1]
}
