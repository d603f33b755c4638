//! The one rounding.
use super::value::{infinity, zero};
use reliefrtl_base::format::{FloatFormat, Rounding};
use std::cmp::Ordering;

/// What a rounding cuts off, compared with half a unit in the last kept place; `None` is nothing.
type Loss = Option<Ordering>;

/// Rounds `(-1)^negative * (sig + r) * 2^exp`, where `r` is 0, or, with `rest`, anything strictly between 0 and 1.
///
/// Where subnormals are flushed, the exponent is unbounded until the significand is rounded; only then is the range looked
/// at: too small is zero of the sign. Where they are numbers, the last kept place is never below theirs. Too large is
/// infinity, or the largest number, as the direction of rounding and the format say.
///
/// # Panics
/// If `sig` is 0, or if there is a rest and `sig` has less than one bit more than the format keeps (the rest could not be weighed).
pub(super) fn round(fmt: FloatFormat, negative: bool, sig: u128, exp: i32, rest: bool) -> u64 {
    let keep = fmt.man as i32 + 1;
    let least = 1 - fmt.bias();
    let top = exp + u128::BITS as i32 - 1 - sig.leading_zeros() as i32;
    let mut last = top - fmt.man as i32;
    assert!(sig != 0 && (last > exp || !rest));
    if fmt.is_gradual() {
        last = last.max(least - fmt.man as i32);
    }
    let (kept, loss) = split(sig, last - exp, rest);
    let mut kept = kept as u64;
    kept += u64::from(goes_up(fmt.rounding, negative, kept & 1 == 1, loss));
    // The value is now kept * 2^last, and kept has at most `keep` bits, or is the power of two just above.
    if kept >> keep != 0 {
        kept >>= 1;
        last += 1;
    }
    let exponent = last + fmt.man as i32;
    let greatest = fmt.exp_max() as i32 - fmt.bias() - i32::from(!fmt.is_finite());
    if exponent < least || kept == 0 {
        zero(fmt, negative)
    } else if exponent > greatest {
        overflow(fmt, negative)
    } else if kept >> fmt.man == 0 {
        zero(fmt, negative) | kept
    } else {
        let field = (exponent + fmt.bias()) as u64;
        zero(fmt, negative) | (field << fmt.man) | (kept & fmt.man_mask())
    }
}

/// `sig` without its lowest `drop` bits, and what these and the rest after them weigh.
fn split(sig: u128, drop: i32, rest: bool) -> (u128, Loss) {
    let below = if rest { Some(Ordering::Less) } else { None };
    match drop {
        ..=0 => (sig << -drop, below),
        1..=127 => {
            let (half, tail) = (1u128 << (drop - 1), sig & ((1u128 << drop) - 1));
            let loss = match tail.cmp(&half) {
                Ordering::Equal if rest => Some(Ordering::Greater),
                Ordering::Less if tail == 0 => below,
                other => Some(other),
            };
            (sig >> drop, loss)
        }
        // Half of the kept place is bit 127.
        128 => {
            let half = (sig >> 127).cmp(&1);
            (0, Some(if sig << 1 == 0 && !rest { half } else { half.then(Ordering::Greater) }))
        }
        _ => (0, Some(Ordering::Less)),
    }
}

/// Whether the magnitude is rounded up.
fn goes_up(rounding: Rounding, negative: bool, odd: bool, loss: Loss) -> bool {
    let Some(loss) = loss else { return false };
    match rounding {
        Rounding::NearestEven => loss == Ordering::Greater || (loss == Ordering::Equal && odd),
        Rounding::NearestAway => loss != Ordering::Less,
        Rounding::TowardZero => false,
        Rounding::Up => !negative,
        Rounding::Down => negative,
    }
}

/// Beyond the largest number: directions that lead back give that one.
fn overflow(fmt: FloatFormat, negative: bool) -> u64 {
    let back = match fmt.rounding {
        Rounding::NearestEven | Rounding::NearestAway => false,
        Rounding::TowardZero => true,
        Rounding::Up => negative,
        Rounding::Down => !negative,
    };
    if back { zero(fmt, negative) | fmt.largest() } else { infinity(fmt, negative) }
}
