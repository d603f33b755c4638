//! Operands: every edge of a format, and random ones.
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use reliefrtl::format::FloatFormat;

/// Codes at every edge of the format, of both signs.
pub fn corners(fmt: FloatFormat) -> Vec<u64> {
    let (bias, top, man) = (fmt.bias() as u64, fmt.exp_max(), u64::from(fmt.man));
    let mut fields =
        vec![0, 1, 2, bias / 2, bias / 2 + 1, bias - man - 2, bias - man - 1, bias - man, bias - 2, bias - 1];
    fields.extend([
        bias,
        bias + 1,
        bias + 2,
        bias + man / 2,
        bias + man,
        bias + man + 1,
        bias * 3 / 2,
        top - 2,
        top - 1,
        top,
    ]);
    let mask = fmt.man_mask();
    let half = 1 << (fmt.man - 1);
    let fractions = [0, 1, 2, half - 1, half, half + 1, mask / 3, mask / 3 * 2, mask - 1, mask];
    let mut all = Vec::new();
    for field in fields.into_iter().map(|f| f.min(top)) {
        for fraction in fractions {
            all.extend([0, fmt.sign_bit()].map(|sign| sign | (field << fmt.man) | fraction));
        }
    }
    all.sort_unstable();
    all.dedup();
    all
}

/// Operands with random fields, and one in two pairs with neighbouring exponents, where sums cancel.
pub fn random_pairs(fmt: FloatFormat, seed: u64, count: u64) -> impl Iterator<Item = (u64, u64)> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    (0..count).map(move |at| {
        let mask = u64::MAX >> (64 - fmt.width());
        let a = rng.random::<u64>() & mask;
        let mut b = rng.random::<u64>() & mask;
        if at % 2 == 0 {
            let near = ((a >> fmt.man) & fmt.exp_max()) as i64 + rng.random_range(-(fmt.man as i64) - 3..=2);
            let field = near.clamp(0, fmt.exp_max() as i64) as u64;
            b = (b & !(fmt.exp_max() << fmt.man)) | (field << fmt.man);
        }
        (a, b)
    })
}
