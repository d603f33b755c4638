//! Times that were measured in turns (A B A B ...): what else a machine does meets both, so that ratios are taken turn by turn.

/// Times of turns, compared.
pub struct Turns;

/// The least, the middle and the largest value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread3 {
    /// Least.
    pub min: f64,
    /// Median; of an even number the mean of the two in the middle.
    pub median: f64,
    /// Largest.
    pub max: f64,
    /// How many values.
    pub count: usize,
}

impl Turns {
    /// Least, median and largest of values.
    ///
    /// # Panics
    /// Without a value.
    pub fn spread(values: &[f64]) -> Spread3 {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let n = sorted.len();
        let median = f64::midpoint(sorted[(n - 1) / 2], sorted[n / 2]);
        Spread3 { min: sorted[0], median, max: sorted[n - 1], count: n }
    }

    /// The median of values.
    ///
    /// # Panics
    /// Without a value.
    pub fn median(values: &[f64]) -> f64 {
        Self::spread(values).median
    }

    /// How many times as fast as `base` another one is: in each turn the ratio of their rates (work over seconds), and of these the spread. Where
    /// one has fewer turns, those that both have; `None` if there is none.
    pub fn pairs(base: (&[f64], usize), other: (&[f64], usize)) -> Option<Spread3> {
        let ratio = |(b, o): (&f64, &f64)| (other.1 as f64 / o) / (base.1 as f64 / b);
        let ratios: Vec<f64> = base.0.iter().zip(other.0).map(ratio).collect();
        (!ratios.is_empty()).then(|| Self::spread(&ratios))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_are_taken_turn_by_turn() {
        // A machine that slows down threefold: the times differ, the ratio does not.
        let (base, other) = ([1.0, 2.0, 3.0], [0.5, 1.0, 1.5]);
        let r = Turns::pairs((&base, 100), (&other, 100)).unwrap();
        assert_eq!(r, Spread3 { min: 2.0, median: 2.0, max: 2.0, count: 3 });
        // A tenth of the rays in the same time is a tenth of the rate; one turn is one pair.
        let slow = Turns::pairs((&base, 100), (&[1.0], 10)).unwrap();
        assert_eq!((slow.median, slow.count), (0.1, 1));
        // One slow turn moves neither median nor the other pairs, as it would move a mean.
        let r = Turns::pairs((&[1.0, 1.0, 1.0], 1), (&[1.0, 10.0, 0.5], 1)).unwrap();
        assert_eq!((r.min, r.median, r.max), (0.1, 1.0, 2.0));
        assert_eq!(Turns::median(&[4.0, 1.0, 3.0, 2.0]), 2.5);
        assert_eq!(Turns::pairs((&[], 1), (&[1.0], 1)), None);
    }
}
