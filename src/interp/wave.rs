//! Waveforms of a run: named nets clock by clock, undefined bits as x; the whole run or a window of it.
use super::netlist::{Netlist, Slot};
use super::tracked::{Bits, Tracked};
use std::collections::VecDeque;

/// A recorded net.
pub(super) struct Signal {
    /// Hierarchical name.
    pub name: String,
    pub slot: Slot,
    pub width: u32,
}

/// Recorded nets, clock by clock. What is kept are changes.
pub struct Wave {
    pub(super) signals: Vec<Signal>,
    /// The clock of the first row that is kept.
    pub(super) first: u64,
    /// Values before the first row.
    pub(super) before: Vec<Bits>,
    /// For each clock the signals that changed, and what to.
    pub(super) rows: VecDeque<Vec<(u32, Bits)>>,
    last: Vec<Bits>,
    /// Rows kept until the trigger, in a recording of a window.
    window: Option<usize>,
    /// Rows still to come, after the trigger.
    left: Option<usize>,
}

impl Wave {
    /// Records every named net and every port of `net`, all clocks.
    pub fn new(net: &Netlist) -> Self {
        Self::of(net, |_| true)
    }
    /// Records the nets whose hierarchical names (`u_setup.s1_exp`) `keep` accepts, all clocks.
    pub fn of(net: &Netlist, keep: impl Fn(&str) -> bool) -> Self {
        let outputs = net.outputs.iter().filter(|p| !net.names.contains_key(&p.name)).map(|p| (&p.name, &p.slot));
        let named = net.names.iter().chain(outputs).filter(|(name, _)| keep(name));
        let signals: Vec<Signal> = named
            .map(|(name, slot)| Signal { name: name.clone(), slot: *slot, width: net.widths[*slot as usize] })
            .collect();
        let unknown: Vec<Bits> = signals.iter().map(|s| (0, reliefrtl_base::bits::mask(s.width))).collect();
        let (before, last) = (unknown.clone(), unknown);
        Self { signals, first: 0, before, rows: VecDeque::new(), last, window: None, left: None }
    }
    /// Keeps only the last `before` clocks, until [`Wave::trigger`] is called.
    pub fn window(mut self, before: usize) -> Self {
        self.window = Some(before);
        self
    }
    /// Something has been seen in the clock that was sampled last: records `after` more clocks and then no more.
    pub fn trigger(&mut self, after: usize) {
        self.left.get_or_insert(after);
    }
    /// True when the window is complete.
    pub fn is_complete(&self) -> bool {
        self.left == Some(0)
    }
    /// Adds the state after `eval`; does nothing when the window is complete.
    pub fn sample(&mut self, t: &Tracked<'_>) {
        match &mut self.left {
            Some(0) => return,
            Some(left) => *left -= 1,
            None => {}
        }
        let mut row = Vec::new();
        for (i, s) in self.signals.iter().enumerate() {
            let v = t.get(s.slot);
            if self.last[i] != v {
                self.last[i] = v;
                row.push((i as u32, v));
            }
        }
        self.rows.push_back(row);
        if self.left.is_none() && self.window.is_some_and(|n| self.rows.len() > n.max(1)) {
            self.forget();
        }
    }
    /// Leaves out the oldest row.
    fn forget(&mut self) {
        for (i, v) in self.rows.pop_front().unwrap_or_default() {
            self.before[i as usize] = v;
        }
        self.first += 1;
    }

    /// Number of clocks kept.
    pub fn clocks(&self) -> usize {
        self.rows.len()
    }
    /// The first of them; the run's first clock is 0.
    pub fn first_clock(&self) -> u64 {
        self.first
    }
    /// Hierarchical names of the recorded nets.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.signals.iter().map(|s| s.name.as_str())
    }
    /// Value and unknown bits of a net in a clock that was kept.
    pub fn get(&self, name: &str, clock: u64) -> Option<Bits> {
        let i = self.signals.iter().position(|s| s.name == name)?;
        let rows = usize::try_from(clock.checked_sub(self.first)?).ok().filter(|n| *n < self.rows.len())?;
        let mut changes = self.rows.iter().take(rows + 1).flatten();
        Some(changes.rfind(|(k, _)| *k as usize == i).map_or(self.before[i], |(_, v)| *v))
    }
}
