//! Berkeley SoftFloat's operations beside those of the golden model, at 8/23 with subnormal numbers, infinities and NaN.
use rayon::prelude::*;
use reliefrtl::bits::mask;
use reliefrtl::format::{FloatFormat, Rounding, Subnormals};
use reliefrtl::golden::float;
use softfloat_sys::{f32_add, f32_div, f32_lt, f32_mul, f32_sqrt, float32_t, softfloat_roundingMode_write_helper};

/// An operation of the golden model, and SoftFloat's.
pub struct Operation {
    /// Unit that does it.
    pub unit: &'static str,
    /// The golden model's; a unary one ignores its second operand.
    pub golden: fn(FloatFormat, u64, u64) -> u64,
    /// SoftFloat's, on words of 32 bits.
    pub soft: fn(u64, u64) -> u64,
}

/// The operations that both have.
pub const OPERATIONS: [Operation; 5] = [
    Operation { unit: "fp_add", golden: float::add, soft: |a, b| unsafe { f32_add(word(a), word(b)) }.v.into() },
    Operation { unit: "fp_mul", golden: float::mul, soft: |a, b| unsafe { f32_mul(word(a), word(b)) }.v.into() },
    Operation { unit: "fp_div", golden: float::div, soft: |a, b| unsafe { f32_div(word(a), word(b)) }.v.into() },
    Operation {
        unit: "fp_sqrt",
        golden: |f, a, _| float::sqrt(f, a),
        soft: |a, _| unsafe { f32_sqrt(word(a)) }.v.into(),
    },
    Operation {
        unit: "fp_lt",
        golden: |f, a, b| float::lt(f, a, b).into(),
        soft: |a, b| unsafe { f32_lt(word(a), word(b)) }.into(),
    },
];

/// The roundings in SoftFloat's numbers, from 0.
pub const ROUNDINGS: [Rounding; 5] =
    [Rounding::NearestEven, Rounding::TowardZero, Rounding::Down, Rounding::Up, Rounding::NearestAway];

/// The format that both have.
pub fn format(rounding: Rounding) -> FloatFormat {
    FloatFormat { subnormals: Subnormals::Gradual, rounding, ..FloatFormat::new(8, 23) }
}

/// Sets the rounding of this thread by its place in [`ROUNDINGS`]: SoftFloat has one a thread.
pub fn set_rounding(number: usize) {
    unsafe { softfloat_roundingMode_write_helper(number as u8) }
}

/// How many results differ, and the first pair of operands that shows it; NaN is NaN, whatever its fraction says.
pub fn differing(o: &Operation, number: usize, pairs: &[(u64, u64)]) -> (usize, Option<(u64, u64)>) {
    let differs = |&&(a, b): &&(u64, u64)| {
        set_rounding(number);
        let (ours, theirs) = ((o.golden)(format(ROUNDINGS[number]), a, b), (o.soft)(a, b));
        ours != theirs && (o.unit == "fp_lt" || !is_nan(ours) || !is_nan(theirs))
    };
    let wrong: Vec<(u64, u64)> = pairs.par_iter().filter(differs).copied().collect();
    (wrong.len(), wrong.first().copied())
}

fn word(bits: u64) -> float32_t {
    float32_t { v: bits as u32 }
}

fn is_nan(word: u64) -> bool {
    word & mask(31) > 0x7f80_0000
}
