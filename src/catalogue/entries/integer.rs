//! Units of integers that arithmetic and addresses are made of.
use super::super::unit::{UNIT, Unit};
use super::WIDTHS;
use crate::bits::mask;
use crate::proofs::{BIT_LEVEL, PROOF, Proof};

/// The entries.
pub const UNITS: &[&Unit] = &[&LZC, &INTERLEAVE, &DIV_ROWS, &SQRT_ROWS, &RECIP_TABLE];

static LZC: Unit = Unit {
    name: "lzc",
    model: Some(|c, row, out| {
        let w = c.param("W");
        out["count"] = (0..w).take_while(|k| row["bits"] >> (w - 1 - k) & 1 == 0).count() as u64;
    }),
    bindings: WIDTHS,
    proofs: &[Proof {
        name: "lzc",
        units: &["lzc"],
        claim: "zeros above the count, a one below it, at every width from 1 to 64",
        text: harness!("lzc"),
        engine: BIT_LEVEL,
        ..PROOF
    }],
    ..UNIT
};

static INTERLEAVE: Unit = Unit {
    name: "interleave",
    model: Some(|c, row, out| {
        let bit = |w: u64, i: u32| w >> i & 1;
        let pair = |i| bit(row["a"], i) << (2 * i) | bit(row["b"], i) << (2 * i + 1);
        out["result"] = (0..c.param("W")).map(pair).sum();
    }),
    bindings: WIDTHS,
    proofs: &[Proof {
        name: "interleave",
        units: &["interleave"],
        claim: "bits go where Morton order puts them, at every width from 1 to 32",
        text: harness!("interleave"),
        ..PROOF
    }],
    ..UNIT
};

static DIV_ROWS: Unit = Unit {
    name: "div_rows",
    model: Some(|c, row, out| {
        let (rows, w) = (c.param("ROWS"), c.param("W"));
        let n = u128::from(row["rem_in"]) << (rows - 1);
        let (q, r) = (n / u128::from(row["div"]), n % u128::from(row["div"]));
        out["rem_out"] = (r << 1) as u64 & mask(w + 1);
        out["quot"] = q as u64 & mask(rows);
    }),
    // A divisor is normalized, and the dividend below twice its value.
    legal: Some(|c, row| {
        row["div"] |= 1 << (c.param("W") - 1);
        row["rem_in"] %= 2 * row["div"];
    }),
    ..UNIT
};

static SQRT_ROWS: Unit = Unit {
    name: "sqrt_rows",
    model: Some(|c, row, out| {
        let (w, first, last) = (c.param("W"), c.param("FIRST") - 1, c.param("FIRST") - 1 + c.param("ROWS"));
        // The radicand in units of the root's last place squared, and its root cut to more digits.
        let radicand = u128::from(row["root_in"]).pow(2) + (u128::from(row["rem_in"]) << (w - 1 - first));
        let below = w - 1 - last;
        let root = (radicand >> (2 * below)).isqrt() << below;
        out["rem_out"] = ((radicand - root * root) >> below) as u64;
        out["root_out"] = root as u64;
    }),
    // Digits below FIRST are still 0; the remainder is below twice the root and the last digit's place.
    legal: Some(|c, row| {
        let (w, first) = (c.param("W"), c.param("FIRST"));
        row["root_in"] = (row["root_in"] | 1 << (w - 1)) & !mask(w - first);
        row["rem_in"] %= 2 * row["root_in"] + (1 << (w - first));
    }),
    bindings: &[
        &[("W", 18), ("FIRST", 3), ("ROWS", 4)],
        &[("W", 18), ("FIRST", 1), ("ROWS", 17)],
        &[("W", 30), ("FIRST", 12), ("ROWS", 18)],
        &[("W", 5), ("FIRST", 4), ("ROWS", 1)],
    ],
    ..UNIT
};

static RECIP_TABLE: Unit =
    Unit { name: "recip_table", model: Some(|_, row, out| out["word"] = reciprocal_line(row["index"].into())), ..UNIT };

/// Start and slope of the line for divisors from `1 + index / 256` up, as `docs/arithmetic.md` defines them.
fn reciprocal_line(index: i128) -> u64 {
    let (x, y) = (256 + index, 257 + index);
    // The chord falls by 2^8 / (x * y) along the interval, that is along 2^8 steps.
    let slope = (0..1 << 12).min_by_key(|s| (s * x * y - (1 << 28)).abs()).expect("there are slopes");
    // Chord and curve in the middle, (128 / x + 128 / y) and 512 / (x + y), as fractions of one denominator.
    let below = x * y * (x + y);
    let middle = (128 * (x + y) * (x + y) + 512 * x * y) << 21;
    let start = (middle - (below << 21)).div_euclid(below) + 128 * slope / 64 + 4;
    (start << 12 | slope) as u64
}
