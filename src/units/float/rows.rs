//! Digit rows in groups, one a stage.
use reliefrtl_ir::{Builder, Expr, plan_stages};

/// What a row takes, in tenths of a nanosecond on ECP5.
const ROW: u32 = 35;

/// Rows in groups, one a stage: group c ends after row `rows * ends[c] / of`, at any number of rows.
pub struct Groups {
    rows: u32,
    ends: Vec<u32>,
    of: u32,
}

impl Groups {
    /// Groups such that rows and the sections before and after them are balanced, or alike where that would ask for longer
    /// fractions than alike groups do: one short group among many long ones is empty at few rows.
    fn of(latency: u32, rows: u32, head: u32, tail: &[(&str, u32)]) -> Self {
        let first = usize::from(head > 0);
        let weights = (0..first).map(|_| head).chain((0..rows).map(|_| ROW)).chain(tail.iter().map(|t| t.1));
        let stages = &plan_stages(latency, &weights.collect::<Vec<u32>>())[first..first + rows as usize];
        let ends = (1..=rows).filter(|r| stages.get(*r as usize) != Some(&stages[*r as usize - 1])).collect();
        let balanced = Self { rows, ends, of: rows };
        let n = balanced.ends.len() as u32;
        if balanced.least_rows() <= n.max(5) { balanced } else { Self { rows, ends: (1..=n).collect(), of: n } }
    }
    /// Groups of `rows` rows, and the plan of a module with these sections before and after them.
    pub fn planned(b: &Builder, latency: u32, rows: u32, head: Option<(&str, u32)>, tail: &[(&str, u32)]) -> Self {
        let groups = Self::of(latency, rows, head.map_or(0, |h| h.1), tail);
        let titles: Vec<String> = (0..groups.len()).map(|c| groups.title(c)).collect();
        let mut plan: Vec<(&str, u32)> = head.into_iter().collect();
        plan.extend(titles.iter().enumerate().map(|(c, t)| (t.as_str(), ROW * groups.size(c))));
        plan.extend(tail);
        b.plan(latency, &plan);
        groups
    }
    /// How many there are.
    pub fn len(&self) -> usize {
        self.ends.len()
    }
    /// Heading of a group.
    pub fn title(&self, c: usize) -> String {
        format!("rows {c}")
    }
    /// Rows of a group.
    fn size(&self, c: usize) -> u32 {
        let end = |c: usize| self.rows * self.ends[c] / self.of;
        if c == 0 { end(0) } else { end(c) - end(c - 1) }
    }
    /// Rows up to the end of a group, of `rows` in all.
    pub fn end(&self, rows: &Expr, c: usize) -> Expr {
        match self.ends[c] {
            last if last == self.of => rows.clone(),
            end => (rows.clone() * i64::from(end)).div(self.of),
        }
    }
    /// Rows of a group, of `rows` in all.
    pub fn count(&self, rows: &Expr, c: usize) -> Expr {
        if c == 0 { self.end(rows, 0) } else { self.end(rows, c) - self.end(rows, c - 1) }
    }
    /// The number of rows from which on no group is empty, 3 or more.
    pub fn least_rows(&self) -> u32 {
        let step = |c: usize| if c == 0 { self.ends[0] } else { self.ends[c] - self.ends[c - 1] };
        let least = (0..self.ends.len()).map(step).min().unwrap_or(1);
        self.of.div_ceil(least).max(3)
    }
}

#[cfg(test)]
mod tests {
    use super::Groups;

    #[test]
    fn every_group_has_a_row() {
        for rows in 5..=31 {
            for latency in 0..=32 {
                let g = Groups::of(latency, rows, 0, &[("pick", 12), ("round", 20), ("select", 18)]);
                assert!(g.ends.len() as u32 <= latency.max(1));
                assert_eq!((0..g.ends.len()).map(|c| g.size(c)).sum::<u32>(), rows);
                assert!((0..g.ends.len()).all(|c| g.size(c) > 0), "{rows} rows, {latency} clocks");
                assert!(g.least_rows() <= latency.clamp(5, rows), "{rows} rows, {latency} clocks");
            }
        }
    }
}
