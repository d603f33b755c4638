//! Drives a valid/ready design in the interpreter: many lanes, each with its own share of the items.
use super::lanes::Lanes;
use super::netlist::{Netlist, Slot};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use reliefrtl_base::error::{Error, Result};
use std::sync::Arc;

/// How the bench behaves on both sides of the design.
#[derive(Clone, Copy, Debug, Default)]
pub struct Traffic {
    /// Chance, in 256ths, that in_valid is 0 in a clock though an item is there.
    pub gaps: u8,
    /// Chance, in 256ths, that out_ready is 0 in a clock.
    pub stalls: u8,
    /// Resets of one clock while items are on their way; what is lost is sent again. Twice before the first one, for [`FLOOD`] clocks,
    /// out_ready is 0, so that every stage is full: what is inside comes out after the first flood, and is lost in a reset after the second.
    pub resets: u32,
    /// Seed of all (ChaCha8).
    pub seed: u64,
}

impl Traffic {
    /// Everything at once: in_valid 0 in half of the clocks, out_ready 0 in half of the clocks, floods, and resets in between.
    pub const fn rough(seed: u64) -> Self {
        Self { gaps: 128, stalls: 128, resets: 12, seed }
    }
}

/// Clocks of a flood, and between the two before the first reset.
pub const FLOOD: u64 = 200;
/// Clocks between two resets, at most.
const BETWEEN_RESETS: u64 = 200;

/// What a run gave.
#[derive(Clone, Debug, Default)]
pub struct StreamRun {
    /// Results of each item, in the order of `columns`.
    pub results: Vec<Vec<u64>>,
    /// Clocks that passed.
    pub cycles: u64,
    /// Clocks, summed over the lanes, in which items were waiting and the pipeline had been filled once.
    pub loaded: u64,
    /// Of these, clocks in which `slot_busy` was set.
    pub busy: u64,
}

/// Clocks without any result after which outstanding items count as lost: more than the longest path, 65535 iterations, takes.
const PATIENCE: u64 = 65_600;

/// A stream design: ports `in_valid`, `in_ready`, `in_tag`, `out_valid`, `out_ready`, `out_tag`, `slot_busy`, `rst`.
pub struct Stream {
    net: Netlist,
    ins: Vec<Slot>,
    outs: Vec<Slot>,
    tags: usize,
    warm_up: u64,
    patience: u64,
}

impl Stream {
    /// Names the data ports; `warm_up` is the number of clocks until the pipeline can be full.
    pub fn new(net: &Netlist, ins: &[&str], outs: &[&str], warm_up: u64) -> Self {
        let net = net.optimized();
        let tag = net.inputs.iter().find(|p| p.name == "in_tag").map_or(1, |p| p.width);
        let ins = ins.iter().map(|n| net.input(n)).collect();
        let outs = outs.iter().map(|n| net.output(n)).collect();
        Self { net, ins, outs, tags: 1 << tag.min(16), warm_up, patience: PATIENCE }
    }

    /// The same for items that take at most `iterations` each, so that one that got lost is missed earlier.
    pub fn patient(self, iterations: u64) -> Self {
        Self { patience: iterations + 16, ..self }
    }

    /// As [`Stream::run`], with the items split over `threads` threads of `lanes` lanes each. Results come in the order
    /// of the items and do not depend on timing; clocks are those of the thread with the most.
    ///
    /// # Errors
    /// As [`Stream::run`].
    ///
    /// # Panics
    /// If threads can't be started.
    pub fn run_parallel(
        &self,
        items: &[Vec<u64>],
        images: &[Arc<Vec<u64>>],
        lanes: usize,
        threads: usize,
        traffic: Traffic,
    ) -> Result<StreamRun> {
        let share = items.len().div_ceil(threads.max(1)).max(1);
        let part = |(i, part): (usize, &[Vec<u64>])| {
            self.run(part, images, lanes, Traffic { seed: traffic.seed.wrapping_add(i as u64), ..traffic })
        };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads can be started");
        let parts: Vec<Result<StreamRun>> = pool.install(|| items.par_chunks(share).enumerate().map(part).collect());
        let mut all = StreamRun::default();
        for part in parts {
            let part = part?;
            all.results.extend(part.results);
            all.cycles = all.cycles.max(part.cycles);
            all.loaded += part.loaded;
            all.busy += part.busy;
        }
        Ok(all)
    }

    /// Runs `items` (rows of `ins`) through `lanes` copies; `images` are the contents of the memories, in their order.
    ///
    /// # Errors
    /// A result that never comes, or one that is not waited for.
    pub fn run(
        &self,
        items: &[Vec<u64>],
        images: &[Arc<Vec<u64>>],
        lanes: usize,
        traffic: Traffic,
    ) -> Result<StreamRun> {
        self.run_until(items, images, lanes, traffic, |_, _| false)
    }

    /// As [`Stream::run`]; ends with the first result of which `ends` (number of the item, words of `outs`) is true. What was not there by then has no words.
    ///
    /// # Errors
    /// As [`Stream::run`].
    pub fn run_until(
        &self,
        items: &[Vec<u64>],
        images: &[Arc<Vec<u64>>],
        lanes: usize,
        traffic: Traffic,
        ends: impl Fn(usize, &[u64]) -> bool,
    ) -> Result<StreamRun> {
        let lanes = lanes.clamp(1, items.len().max(1));
        let mut sim = self.after_reset(images, lanes);
        let mut lane: Vec<Lane> = (0..lanes).map(|l| Lane::new(l, self.tags)).collect();
        let mut rng = ChaCha8Rng::seed_from_u64(traffic.seed);
        let mut run = StreamRun { results: vec![Vec::new(); items.len()], ..StreamRun::default() };
        let (mut left, mut quiet) = (items.len(), 0);
        let [rst, iv, it, or] = ["rst", "in_valid", "in_tag", "out_ready"].map(|n| self.net.input(n));
        let [ir, ov, ot, busy] = ["in_ready", "out_valid", "out_tag", "slot_busy"].map(|n| self.net.output(n));
        let mut seen = [(); 3].map(|()| vec![0u64; lanes]);
        sim.fill(or, 1);
        let (mut resets, mut reset_at) = (traffic.resets, 3 * FLOOD);
        while left > 0 {
            let reset = resets > 0 && run.cycles == reset_at;
            let flood = traffic.resets > 0 && matches!(run.cycles / FLOOD, 0 | 2);
            if traffic.resets > 0 {
                sim.fill(rst, u64::from(reset));
            }
            for (l, state) in lane.iter_mut().enumerate() {
                let hold = traffic.gaps > 0 && rng.random::<u8>() < traffic.gaps && !flood;
                state.ready = (traffic.stalls == 0 || rng.random::<u8>() >= traffic.stalls) && !flood;
                if traffic.stalls > 0 || traffic.resets > 0 {
                    sim.set(or, l, u64::from(state.ready));
                }
                // An item that was not accepted stays on the inputs, so there is mostly nothing to write.
                if state.driven.is_none() {
                    state.driven = state.next_item(items.len()).and_then(|item| Some((state.free_tag()?, item)));
                    if let Some((tag, item)) = state.driven {
                        sim.set(it, l, tag as u64);
                        self.ins.iter().zip(&items[item]).for_each(|(s, v)| sim.set(*s, l, *v));
                    }
                }
                let valid = state.driven.is_some() && !hold;
                if valid != state.valid {
                    sim.set(iv, l, u64::from(valid));
                    state.valid = valid;
                }
            }
            sim.eval();
            quiet += 1;
            let [ready, valid, load] = &mut seen;
            sim.read(ir, ready);
            sim.read(ov, valid);
            sim.read(busy, load);
            // What a reset meets is lost, and so is a transfer in its clock.
            for (l, state) in lane.iter_mut().enumerate().filter(|_| !reset) {
                if state.next_item(items.len()).is_some() && run.cycles >= self.warm_up {
                    run.loaded += 1;
                    run.busy += load[l];
                }
                if let Some((tag, item)) = state.driven.take_if(|_| state.valid && ready[l] == 1) {
                    state.tags[tag] = Some(item);
                    if state.again.pop().is_none() {
                        state.next += lanes;
                    }
                }
                if valid[l] == 1 && state.ready {
                    let tag = sim.get(ot, l) as usize;
                    let Some(item) = state.tags[tag].take() else {
                        return Err(Error::Extra(format!(
                            "a result with tag {tag} came that no ray waits for (lane {l})"
                        )));
                    };
                    run.results[item] = self.outs.iter().map(|s| sim.get(*s, l)).collect();
                    if ends(item, &run.results[item]) {
                        return Ok(run);
                    }
                    left -= 1;
                    quiet = 0;
                }
            }
            if reset {
                lane.iter_mut().for_each(Lane::lose);
                quiet = 0;
                resets -= 1;
                reset_at = run.cycles + rng.random_range(1..=BETWEEN_RESETS);
            }
            if quiet > self.patience * self.warm_up.max(4) {
                let lost = lane.iter().flat_map(|s| s.tags.iter().flatten()).min().copied().unwrap_or(0);
                return Err(Error::Dropped(format!(
                    "ray {lost} went in and never came out ({left} of {} missing)",
                    items.len()
                )));
            }
            sim.clock();
            run.cycles += 1;
        }
        Ok(run)
    }

    /// `lanes` copies whose memories are loaded, one clock after a reset.
    fn after_reset(&self, images: &[Arc<Vec<u64>>], lanes: usize) -> Lanes {
        let mut sim = Lanes::of_ports(&self.net, lanes);
        images.iter().enumerate().for_each(|(i, words)| sim.load(i, words.clone()));
        let rst = self.net.input("rst");
        sim.fill(rst, 1);
        sim.eval();
        sim.clock();
        sim.fill(rst, 0);
        sim
    }
}

/// One lane's bookkeeping.
struct Lane {
    next: usize,
    /// Items that a reset lost: they go first, the last one of them before the others.
    again: Vec<usize>,
    tags: Vec<Option<usize>>,
    last_tag: usize,
    /// Tag and item on the inputs.
    driven: Option<(usize, usize)>,
    valid: bool,
    ready: bool,
}

impl Lane {
    fn new(first: usize, tags: usize) -> Self {
        let tags = vec![None; tags];
        Self { next: first, again: Vec::new(), tags, last_tag: 0, driven: None, valid: false, ready: true }
    }
    fn next_item(&self, items: usize) -> Option<usize> {
        self.again.last().copied().or(Some(self.next).filter(|n| *n < items))
    }
    /// A reset: what was on its way is lost, and so is the item on the inputs, unless it is driven again.
    fn lose(&mut self) {
        self.again.extend(self.tags.iter_mut().filter_map(Option::take));
        self.again.sort_unstable_by(|a, b| b.cmp(a));
        self.driven = None;
    }
    fn free_tag(&mut self) -> Option<usize> {
        let n = self.tags.len();
        let tag = (1..=n).map(|k| (self.last_tag + k) % n).find(|t| self.tags[*t].is_none())?;
        self.last_tag = tag;
        Some(tag)
    }
}
