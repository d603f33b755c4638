//! Unsigned integers of 256 bits: as many operations as an exact comparison needs, and no more.
use std::cmp::Ordering;

/// `high * 2^128 + low`; the order of the fields is that of the numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct U256 {
    /// The upper 128 bits.
    pub high: u128,
    /// The lower 128 bits.
    pub low: u128,
}

impl From<u128> for U256 {
    fn from(low: u128) -> Self {
        Self { high: 0, low }
    }
}

impl U256 {
    /// Width in bits.
    pub const BITS: u32 = 256;

    /// Zeros above the leading one; 256 of zero.
    pub const fn leading_zeros(self) -> u32 {
        if self.high == 0 { 128 + self.low.leading_zeros() } else { self.high.leading_zeros() }
    }

    /// Times 2^by; `None` if a one would be lost.
    pub const fn checked_shl(self, by: u32) -> Option<Self> {
        if self.high == 0 && self.low == 0 {
            return Some(self);
        }
        if by > self.leading_zeros() {
            return None;
        }
        Some(match by {
            0 => self,
            1..128 => Self { high: self.high << by | self.low >> (128 - by), low: self.low << by },
            _ => Self { high: self.low << (by - 128), low: 0 },
        })
    }

    /// The product; `None` if it needs more than 256 bits.
    pub fn checked_mul(self, factor: u128) -> Option<Self> {
        let low = full(self.low, factor);
        if self.high == 0 {
            return Some(low);
        }
        let high = self.high.checked_mul(factor)?.checked_add(low.high)?;
        Some(Self { high, low: low.low })
    }

    /// The sum; `None` if it needs more than 256 bits.
    pub const fn checked_add(self, other: Self) -> Option<Self> {
        let (low, carry) = self.low.overflowing_add(other.low);
        match self.high.checked_add(other.high) {
            Some(high) => match high.checked_add(carry as u128) {
                Some(high) => Some(Self { high, low }),
                None => None,
            },
            None => None,
        }
    }

    /// How far two numbers are apart.
    pub fn abs_diff(self, other: Self) -> Self {
        let (a, b) = if self < other { (other, self) } else { (self, other) };
        let (low, borrow) = a.low.overflowing_sub(b.low);
        Self { high: a.high - b.high - u128::from(borrow), low }
    }

    /// The nearest f64 but for the last place.
    pub fn to_f64(self) -> f64 {
        self.high as f64 * 2f64.powi(128) + self.low as f64
    }
}

/// The product of two numbers of 128 bits.
fn full(a: u128, b: u128) -> U256 {
    if let Some(low) = a.checked_mul(b) {
        return U256::from(low);
    }
    const HALF: u128 = u64::MAX as u128;
    let (a1, a0, b1, b0) = (a >> 64, a & HALF, b >> 64, b & HALF);
    let (low, middle, cross, high) = (a0 * b0, a1 * b0, a0 * b1, a1 * b1);
    // Three halves below 2^64 each: no carry gets lost.
    let carry = (low >> 64) + (middle & HALF) + (cross & HALF);
    U256 { high: high + (middle >> 64) + (cross >> 64) + (carry >> 64), low: carry << 64 | low & HALF }
}

/// `a * 2^p` and `b * 2^q` with the same power of two, if their leading ones stand at the same place or side by side (two numbers around a power
/// of two may be as close as any) and there is room; else their order.
pub(super) fn aligned(a: U256, p: i32, b: U256, q: i32) -> Result<(U256, U256, i32), Ordering> {
    let zero = U256::default();
    if a == zero || b == zero {
        return Err(a.cmp(&b));
    }
    let (top_a, top_b) = (p - a.leading_zeros() as i32, q - b.leading_zeros() as i32);
    if top_a.abs_diff(top_b) > 1 {
        return Err(top_a.cmp(&top_b));
    }
    // Without room the leading ones differ: a shift to the same place has it.
    let shifted = |x: U256| x.checked_shl(p.abs_diff(q)).ok_or_else(|| top_a.cmp(&top_b));
    Ok(if p >= q { (shifted(a)?, b, q) } else { (a, shifted(b)?, p) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_and_sums() {
        let all = U256::from(u128::MAX);
        assert_eq!(full(u128::MAX, u128::MAX), U256 { high: u128::MAX - 1, low: 1 });
        assert_eq!(all.checked_mul(3), Some(U256 { high: 2, low: u128::MAX - 2 }));
        assert_eq!(U256 { high: 1 << 127, low: 0 }.checked_mul(2), None);
        assert_eq!(all.checked_add(U256::from(1)), Some(U256 { high: 1, low: 0 }));
        assert_eq!(U256 { high: u128::MAX, low: u128::MAX }.checked_add(U256::from(1)), None);
        assert_eq!(U256 { high: 1, low: 0 }.abs_diff(U256::from(1)), all);
        assert_eq!(U256 { high: 1, low: 0 }.to_f64(), 2f64.powi(128));
    }

    #[test]
    fn shifts_lose_nothing() {
        let three = U256::from(3);
        assert_eq!(three.checked_shl(127), Some(U256 { high: 1, low: 1 << 127 }));
        assert_eq!(three.checked_shl(128), Some(U256 { high: 3, low: 0 }));
        assert_eq!(three.checked_shl(254), Some(U256 { high: 3 << 126, low: 0 }));
        assert_eq!(three.checked_shl(255), None);
        assert_eq!(U256::default().checked_shl(1000), Some(U256::default()));
    }
}
