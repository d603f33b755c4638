//! Whole tables of corners: those of every operand crossed with those of every other, in two sizes, and in any number of parts.
use super::corners::{Kind, SMALL, every, fractions, landmarks, random_row, signed_numbers, sorted, table};
use super::{Counts, Plan};
use crate::bits::mask;
use crate::error::{Error, Result};
use crate::format::FloatFormat;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};

/// How large the tables are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
pub enum Level {
    /// Some 20 thousand rows of two operands, and the random ones.
    #[value(name = "1")]
    #[serde(rename = "1")]
    One,
    /// Some 440 thousand rows of two operands, and the random ones.
    #[value(name = "2")]
    #[serde(rename = "2")]
    Two,
    /// No tables: weighted random rows, of one seed after the other, until somebody stops it.
    #[value(name = "3")]
    #[serde(rename = "3")]
    Three,
}

/// One part of all rows, counted from 1: every `of`-th row, so that the parts are alike.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Shard {
    /// Which.
    pub index: u32,
    /// Of how many.
    pub of: u32,
}

impl Shard {
    /// All rows.
    pub const WHOLE: Self = Self { index: 1, of: 1 };
}

impl std::str::FromStr for Shard {
    type Err = Error;
    fn from_str(text: &str) -> Result<Self> {
        let parts = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
        let shard = parts.map(|(index, of)| Self { index, of });
        let wrong = || Error::input(format!("--shard {text} is no part of a whole: 3/16 is the third of 16 parts"));
        shard.filter(|s| s.index >= 1 && s.index <= s.of).ok_or_else(wrong)
    }
}

/// Tables crossed whole, then `plan.rows` weighted random rows; of these, one part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Campaign {
    /// Size of the tables.
    pub level: Level,
    /// Part.
    pub shard: Shard,
}

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
