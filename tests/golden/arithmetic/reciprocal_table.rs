//! The fixed-point reciprocal by table: the bounds of its estimates, exactly, on every line and at every place of it.
use rayon::prelude::*;
use reliefrtl::bits::recip_table;

/// Units of 2^-22 that the line's value is given less.
const LESS: u64 = 13;
/// 1 in units of 2^-53.
const ONE: u128 = 1 << 53;

/// What is seen of the lines, each the worst of all.
#[derive(Clone, Copy, Debug, Default)]
struct Worst {
    /// How far r d lies below 1, in units of 2^-53.
    below: u128,
    /// The remainder after the first 18 digits, of d, in units of 2^-53 of a last place.
    rest: u128,
    /// What the digits of a result of 31 bits lack before they are cut, in parts of 1000 of a last place.
    lack: u128,
}

/// One place of a line, for all divisors that have it: 31 fraction bits, of which the line knows 26.
fn at(index: u64, along: u64) -> Worst {
    let word = recip_table(index);
    let line = (1 << 21) + (word >> 12) - (((word & 0xfff) * along) >> 16);
    let recip = line - LESS;
    assert!(recip < 1 << 22, "the reciprocal leaves its width at {index}, {along}");
    let low = ((1u64 << 26) + (index << 18) + along) << 5;
    let (recip, low, high) = (u128::from(recip), u128::from(low), u128::from(low + 31));
    // Their product is 2^53 but for the error.
    assert!(recip * high <= ONE, "the reciprocal is too large at {index}, {along}");
    let below = ONE - recip * low;
    // The dividend lies below 2; doubled where it is less than the divisor, which then lies above 3/2. The estimate loses a unit of 2^-21 beside what
    // the reciprocal lacks, doubled alike, and a last place when it is cut.
    let double = high > 3 << 30;
    let (dividend, lost) = if double { (4, 3) } else { (2, 4) };
    let d = high << 22;
    let rest = d + ((dividend * below) << 17) + (d >> lost);
    // The upper 18 bits of both, the remainder's in units of 2^-15: times d, and 13 digits further.
    let upper = (1u128 << 49) - (recip >> 4) * low;
    let lack = ((rest * upper) >> 36) + (1 << 51);
    let lack = (lack * 1000).div_ceil(low << 22);
    Worst { below, rest, lack }
}

#[test]
fn every_estimate_is_near_enough() {
    let join =
        |a: Worst, b: Worst| Worst { below: a.below.max(b.below), rest: a.rest.max(b.rest), lack: a.lack.max(b.lack) };
    let line = |index: u64| (0..1 << 18).map(|along| at(index, along)).fold(Worst::default(), join);
    let worst = (0..256u64).into_par_iter().map(line).reduce(Worst::default, join);
    println!(
        "{} lines: r d is below 1 by {:.2} units of 2^-22 at most, the remainder below {:.3}, 31 digits lack {:.3} of the last place",
        256,
        worst.below as f64 / f64::from(1u32 << 31),
        worst.rest as f64 / ONE as f64,
        worst.lack as f64 / 1000.0
    );
    assert!(worst.below <= 23 << 31, "the reciprocal is too small");
    assert!(worst.rest < 6 * ONE, "the remainder leaves its bits");
    assert!(worst.lack < 500, "a result of 31 bits may be two more than the estimate");
    assert!(worst.lack > 250, "a bound that nothing comes near says nothing");
}
