//! Rays in and hits out of one `traverse`, clock by clock, with every promise of its ports held against what happens.
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use reliefrtl::interp::Lanes;
use reliefrtl::trace::Pipeline;
use std::sync::Arc;

/// Copies of the unit that run beside each other, each with its share of the rays.
const LANES: usize = 8;

/// What happens at the ports.
#[derive(Clone, Copy, Debug)]
pub struct Ports {
    /// Chance, in eighths, that no ray is valid in a clock.
    pub gaps: u32,
    /// Chance, in eighths, that no result is taken in a clock.
    pub stalls: u32,
    /// A reset of one clock; the rays inside are sent again.
    pub reset_at: Option<u64>,
    /// Clocks without any result after which rays count as stuck.
    pub patience: u64,
    /// Seed of gaps and stalls.
    pub seed: u64,
}

/// A lane's bookkeeping: rays to send, the last one next, and rays inside by their tag.
struct Share {
    waiting: Vec<usize>,
    inside: Vec<Option<usize>>,
    tag: usize,
    valid: bool,
    ready: bool,
}

impl Share {
    fn count(&self) -> usize {
        self.inside.iter().flatten().count()
    }
    /// A tag that no ray inside has, kept as long as its ray is not taken.
    fn next_tag(&mut self) -> Option<usize> {
        let n = self.inside.len();
        let free = (0..n).map(|k| (self.tag + k) % n).find(|t| self.inside[*t].is_none())?;
        self.tag = free;
        Some(free)
    }
}

/// The row of outputs of each ray, and the clocks that it took; or what was wrong.
pub fn drive(
    p: &Pipeline,
    image: &[Arc<Vec<u64>>],
    rays: &[Vec<u64>],
    ports: Ports,
) -> Result<(Vec<Vec<u64>>, u64), String> {
    let net = p.net.optimized();
    let mut sim = Lanes::of_ports(&net, LANES);
    image.iter().enumerate().for_each(|(i, words)| sim.load(i, words.clone()));
    let [rst, in_valid, in_tag, out_ready] = ["rst", "in_valid", "in_tag", "out_ready"].map(|n| net.input(n));
    let [in_ready, out_valid, out_tag, idle] = ["in_ready", "out_valid", "out_tag", "idle"].map(|n| net.output(n));
    let ins: Vec<_> = p.inputs.iter().map(|n| net.input(n)).collect();
    let outs: Vec<_> = p.outputs.iter().map(|n| net.output(n)).collect();
    let tags = 1usize << net.inputs.iter().find(|q| q.name == "in_tag").expect("a tag").width.min(8);
    let share = |lane: usize| (0..rays.len()).filter(|k| k % LANES == lane).rev().collect();
    let mut lanes: Vec<Share> = (0..LANES)
        .map(|l| Share { waiting: share(l), inside: vec![None; tags], tag: 0, valid: false, ready: false })
        .collect();
    let mut rng = ChaCha8Rng::seed_from_u64(ports.seed);
    let mut results: Vec<Option<Vec<u64>>> = vec![None; rays.len()];
    let (mut left, mut quiet, mut clock, mut resting) = (rays.len(), 0, 0u64, 0);
    sim.fill(rst, 1);
    sim.eval();
    sim.clock();
    // A few clocks more than it takes the last transfer to count.
    while left > 0 || resting < 4 {
        let reset = ports.reset_at == Some(clock);
        sim.fill(rst, u64::from(reset));
        for (l, c) in lanes.iter_mut().enumerate() {
            // A ray that was not taken stays valid.
            let held = c.valid && c.waiting.last().is_some();
            c.valid = held || (!c.waiting.is_empty() && rng.random_range(0..8) >= ports.gaps && c.next_tag().is_some());
            c.ready = rng.random_range(0..8) >= ports.stalls;
            if let Some(ray) = c.waiting.last().filter(|_| c.valid) {
                sim.set(in_tag, l, c.tag as u64);
                ins.iter().zip(&rays[*ray]).for_each(|(s, v)| sim.set(*s, l, *v));
            }
            sim.set(in_valid, l, u64::from(c.valid));
            sim.set(out_ready, l, u64::from(c.ready));
        }
        sim.eval();
        for (l, c) in lanes.iter_mut().enumerate().filter(|_| !reset) {
            if c.count() > 0 && sim.get(idle, l) == 1 {
                return Err(format!("clock {clock}: idle with {} rays inside", c.count()));
            }
            if sim.get(out_valid, l) == 1 && c.ready {
                let tag = sim.get(out_tag, l) as usize;
                let ray = c.inside.get_mut(tag).and_then(Option::take);
                let ray = ray.ok_or_else(|| format!("clock {clock}: a result of tag {tag}, which is not inside"))?;
                let row = outs.iter().map(|s| sim.get(*s, l)).collect();
                if results[ray].replace(row).is_some() {
                    return Err(format!("clock {clock}: a second result of ray {ray}"));
                }
                (left, quiet) = (left - 1, 0);
            }
            if c.valid && sim.get(in_ready, l) == 1 {
                c.inside[c.tag] = c.waiting.pop();
                (c.tag, c.valid) = ((c.tag + 1) % tags, false);
            }
        }
        if reset {
            for c in &mut lanes {
                let lost: Vec<usize> = c.inside.iter_mut().filter_map(Option::take).collect();
                c.waiting.extend(lost);
                c.valid = false;
            }
        }
        sim.clock();
        (clock, quiet) = (clock + 1, quiet + 1);
        resting = if left == 0 { resting + 1 } else { 0 };
        if quiet > ports.patience {
            return Err(format!("clock {clock}: {left} rays are stuck"));
        }
    }
    sim.eval();
    if (0..LANES).any(|l| sim.get(idle, l) == 0 || sim.get(out_valid, l) == 1) {
        return Err("not idle at the end".into());
    }
    Ok((results.into_iter().map(|r| r.expect("none is left")).collect(), clock))
}
