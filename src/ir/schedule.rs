//! Where a unit's sections are cut for a given latency.

/// Stage of each section: contiguous groups, at most `latency` of them, with the heaviest group as light as possible.
///
/// `weights` are LUT hops on the section's longest path. With a latency of 0 or 1 everything stands in stage 0
/// (one register after it); more stages than sections leave registers at the end.
pub fn plan_stages(latency: u32, weights: &[u32]) -> Vec<u32> {
    let groups = latency.clamp(1, weights.len().max(1) as u32);
    let fits = |cap: u32| {
        let (mut stage, mut sum, mut out) = (0u32, 0u32, Vec::new());
        for w in weights {
            if sum > 0 && sum + w > cap {
                stage += 1;
                sum = 0;
            }
            sum += w;
            out.push(stage);
        }
        (stage < groups).then_some(out)
    };
    let low = weights.iter().copied().max().unwrap_or(0);
    let high = weights.iter().sum::<u32>();
    (low..=high).find_map(fits).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::plan_stages;

    #[test]
    fn balances() {
        assert_eq!(plan_stages(0, &[3, 2, 4]), [0, 0, 0]);
        assert_eq!(plan_stages(1, &[3, 2, 4]), [0, 0, 0]);
        assert_eq!(plan_stages(2, &[3, 2, 4]), [0, 0, 1]);
        assert_eq!(plan_stages(3, &[3, 2, 4]), [0, 1, 2]);
        assert_eq!(plan_stages(9, &[3, 2, 4]), [0, 1, 2]);
    }
}
