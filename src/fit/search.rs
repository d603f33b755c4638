//! The search: one dimension after the other, each to the least that keeps the budget.
use super::trial::{Budget, Trial, Truth};
use super::trial_figures::TrialFigures;
use crate::config::modes::PLAIN;
use crate::config::{Design, Trim, WindowsConfig, datapaths};
use crate::error::{Error, Result};
use crate::golden::prepare;
use crate::measure::Cost;
use serde::Serialize;

/// What the search may change.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// The map itself: fewer levels, fewer bits a height.
    pub resample: bool,
    /// Block memories of 18 kbit that the heights may take; `None`: any.
    pub block_memories: Option<u64>,
}

/// A design that was tried and not taken.
#[derive(Clone, Debug, Serialize)]
pub struct Rejected {
    /// What it would have changed.
    pub what: String,
    /// What it would have broken, or cost.
    pub why: String,
    /// What it does on the rays of the search.
    pub search: TrialFigures,
    /// Its size, in bits.
    pub bits: Cost,
}

impl Rejected {
    fn new(t: &Trial, what: String, why: String) -> Self {
        Self { what, why, search: t.into(), bits: t.cost }
    }
}

/// What was found.
#[derive(Clone, Debug)]
pub struct Fit {
    /// The design, on the rays of the search.
    pub chosen: Trial,
    /// One line for each decision.
    pub reasons: Vec<String>,
    /// The runners-up, dimension by dimension.
    pub rejected: Vec<Rejected>,
    /// Designs tried.
    pub tried: usize,
}

struct Search<'a> {
    truth: &'a Truth,
    budget: Budget,
    limits: Limits,
    seen: &'a dyn Fn(&str),
    reasons: Vec<String>,
    rejected: Vec<Rejected>,
    tried: usize,
}

/// The smallest design that keeps `budget` on `truth`. `seen` is told what is tried.
///
/// # Errors
/// No design keeps the budget; the sentence says what the best one does.
pub fn fit(base: &Design, truth: &Truth, budget: Budget, limits: Limits, seen: &dyn Fn(&str)) -> Result<Fit> {
    let mut s = Search { truth, budget, limits, seen, reasons: Vec::new(), rejected: Vec::new(), tried: 0 };
    let mut d = *base;
    (d.traverse.levels, d.traverse.height_bits) = (truth.levels, truth.height_bits);
    s.tiles(&mut d)?;
    let mut best = s.numbers(&d)?;
    if limits.resample {
        best = s.map(best)?;
    } else {
        s.reasons.push(format!("map kept: {0} x {0} texels of {1} bits", 1u32 << truth.levels, truth.height_bits));
    }
    best = s.ways(best)?;
    best = s.rest(best)?;
    Ok(Fit { chosen: best, reasons: s.reasons, rejected: s.rejected, tried: s.tried })
}

impl Search<'_> {
    fn run(&mut self, d: &Design) -> Result<Trial> {
        self.tried += 1;
        (self.seen)(&d.label());
        Trial::run(d, self.truth)
    }

    fn reject(&mut self, t: &Trial, what: String) {
        let why = if t.keeps_surely(self.budget) {
            format!("keeps the budget, but takes {} bits", t.cost.bits())
        } else if t.keeps(self.budget) {
            format!("{}: too close to the budget for other rays", t.figure(self.budget))
        } else {
            t.figure(self.budget)
        };
        self.rejected.push(Rejected::new(t, what, why));
    }

    /// TILE_W from the longest travel; says whether wrapping is needed at all.
    fn tiles(&mut self, d: &mut Design) -> Result<()> {
        let longest = self.truth.rays.iter().flat_map(|r| [r[2].abs(), r[3].abs()]).fold(0.0, f64::max);
        d.traverse.tile_bits = (1..=8)
            .find(|t| longest < f64::from(1u32 << t))
            .ok_or_else(|| Error::input(format!("a ray travels {longest:.0} tiles: less than 256 are possible")))?;
        let leaves = |r: &[f64; 4], a: usize| !(0.0..1.0).contains(&(r[a].rem_euclid(1.0) + r[a + 2]));
        let out = self.truth.rays.iter().filter(|r| leaves(r, 0) || leaves(r, 1)).count();
        self.reasons.push(format!(
            "tile_bits = {}: the longest travel is {longest:.2} tiles; {out} of {} rays may leave their tile{}",
            d.traverse.tile_bits,
            self.truth.rays.len(),
            if out == 0 { ", so wrapping is never used" } else { "" }
        ));
        Ok(())
    }

    /// The arithmetic: for each datapath the fewest bits that keep the budget, then the smaller of them.
    fn numbers(&mut self, d: &Design) -> Result<Trial> {
        let mut found: Vec<Trial> = Vec::new();
        let mut last: Option<Trial> = None;
        for kind in datapaths().filter(|k| k.facts().modes_agree) {
            let mut before: Option<Trial> = None;
            let mut of = *d;
            of.datapath.kind = kind;
            of.windows = WindowsConfig::default();
            for step in (kind.facts().ladder)(&of) {
                let Some(candidate) = step.into_iter().find(|d| prepare(d).is_ok()) else { continue };
                let t = self.run(&candidate)?;
                if t.keeps_surely(self.budget) {
                    if let Some(b) = &before {
                        self.reject(b, b.design.label());
                    }
                    found.push(t);
                    break;
                }
                before = Some(t);
            }
            last = before.or(last);
        }
        found = found.into_iter().map(|t| self.narrower(t)).collect::<Result<_>>()?;
        found.sort_by_key(|t| t.cost.bits());
        let mut found = found.into_iter();
        let Some(best) = found.next() else {
            let best = last.map_or_else(
                || "no design is legal here".to_string(),
                |t| format!("{}: {}", t.design.label(), t.figure(self.budget)),
            );
            return Err(Error::mismatch(format!("no design keeps the budget; the widest one is {best}")));
        };
        for other in found {
            self.reject(&other, other.design.label());
        }
        self.reasons.push(format!("{}: {}, {} bits", best.design.label(), best.figure(self.budget), best.cost.bits()));
        Ok(best)
    }

    /// A design may do with fewer bits that do not change the words of a ray.
    fn narrower(&mut self, mut best: Trial) -> Result<Trial> {
        while let Some(d) = (best.design.datapath.kind.facts().narrower)(&best.design) {
            let t = self.run(&d)?;
            if !t.keeps_surely(self.budget) {
                self.reject(&t, d.label());
                break;
            }
            best = t;
        }
        Ok(best)
    }

    /// Fewer levels, then fewer bits a height, while the budget is kept.
    fn map(&mut self, mut best: Trial) -> Result<Trial> {
        type Less = fn(&mut Design) -> bool;
        let fewer: [(&str, Less); 2] = [
            ("levels", |d| {
                d.traverse.levels -= 1;
                d.traverse.levels >= 2
            }),
            ("height_bits", |d| {
                d.traverse.height_bits -= 1;
                d.traverse.height_bits >= 2
            }),
        ];
        for (key, less) in fewer {
            loop {
                let mut d = best.design;
                if !less(&mut d) {
                    break;
                }
                let t = self.run(&d)?;
                if !t.keeps_surely(self.budget) {
                    self.reject(&t, format!("{key} one less"));
                    break;
                }
                best = t;
            }
        }
        let t = best.design.traverse;
        self.reasons.push(format!(
            "map: {0} x {0} texels of {1} bits; {2}",
            1u32 << t.levels,
            t.height_bits,
            best.figure(self.budget)
        ));
        Ok(best)
    }

    /// The search with the least bits times iterations, by nodes or by windows, among those that the block memories hold; none changes a hit of
    /// the datapaths that are tried.
    fn ways(&mut self, best: Trial) -> Result<Trial> {
        let (pyramid, others) = (ways(&best.design), (best.design.datapath.kind.facts().searches)(&best.design));
        let mut all: Vec<Trial> = Vec::new();
        for d in pyramid.chain(others) {
            if prepare(&d).is_ok() {
                all.push(self.run(&d)?);
            }
        }
        all.retain(|t| t.keeps_surely(self.budget));
        let most = self.limits.block_memories.unwrap_or(u64::MAX);
        let (mut all, large): (Vec<Trial>, Vec<Trial>) = all.into_iter().partition(|t| t.cost.blocks <= most);
        let fewest = large.iter().map(|t| t.cost.blocks).min();
        // Of modes of the pyramid that are all too large, one says so for them.
        for t in first_of_each(&large) {
            let why = format!("{} block memories, {most} are allowed", t.cost.blocks);
            self.rejected.push(Rejected::new(&t, t.design.way(), why));
        }
        all.sort_by(|a, b| product(a).total_cmp(&product(b)));
        let Some(chosen) = all.first().cloned() else {
            let Some(fewest) = fewest else { return Ok(best) };
            return Err(Error::mismatch(format!(
                "no search of {} keeps to {most} block memories: the fewest are {fewest}; fewer levels take a quarter each (--allow-resample)",
                best.design.label()
            )));
        };
        let plain = all.iter().find(|t| t.design.mode == PLAIN && is_pyramid(t)).cloned();
        for next in first_of_each(&all[1..]).into_iter().filter(|t| t.design.way() != chosen.design.way()) {
            let more = 100.0 * (product(&next) / product(&chosen) - 1.0);
            let why = format!(
                "{:.2} steps, {} bits, {} block memories: {more:.1} % more bits times steps",
                next.steps.mean,
                next.cost.bits(),
                next.cost.blocks
            );
            self.rejected.push(Rejected::new(&next, next.design.way(), why));
        }
        let against =
            plain.map_or(String::new(), |p| format!("; without any {:.2} steps, {} bits", p.steps.mean, p.cost.bits()));
        self.reasons.push(format!(
            "{}: {:.2} steps a ray (max {} at ray {}), {} bits, {} block memories of 18 kbit{against}",
            chosen.design.way(),
            chosen.steps.mean,
            chosen.steps.max,
            chosen.steps.witness,
            chosen.cost.bits(),
            chosen.cost.blocks
        ));
        Ok(chosen)
    }

    /// Fraction bits of the result, and the guard.
    fn rest(&mut self, best: Trial) -> Result<Trial> {
        let mut d = best.design;
        let fraction = match self.budget {
            Budget::UvError(e) => (1..=16).find(|f| 0.5f64.powi(*f as i32) <= e / 4.0).unwrap_or(16),
            Budget::WrongTexel(_) => 4,
        };
        d.traverse.step_limit = (best.steps.max * 8).next_power_of_two().clamp(64, 65535);
        // One bit more is little beside a design that is given up.
        for bits in fraction..=best.design.traverse.frac_bits.max(fraction) {
            d.traverse.frac_bits = bits;
            let t = self.run(&d)?;
            if t.keeps_surely(self.budget) {
                self.reasons.push(format!(
                    "frac_bits = {bits}, step_limit = {} (8 times the most that was seen)",
                    d.traverse.step_limit
                ));
                return Ok(t);
            }
            self.reject(&t, format!("frac_bits = {bits}"));
        }
        Ok(best)
    }
}

/// What a search costs: bits times iterations.
fn product(t: &Trial) -> f64 {
    t.cost.bits() as f64 * t.steps.mean
}

/// Whether a trial reads the nodes of the pyramid.
fn is_pyramid(t: &Trial) -> bool {
    t.design.datapath.kind.facts().reads_nodes
}

/// Of all trials the first one in the pyramid, and every other.
fn first_of_each(all: &[Trial]) -> Vec<Trial> {
    let first = all.iter().position(is_pyramid);
    all.iter().enumerate().filter(|(k, t)| Some(*k) == first || !is_pyramid(t)).map(|(_, t)| t.clone()).collect()
}

/// The modes that are tried; four levels down take more steps than three (PIDM-HW table 3).
fn ways(d: &Design) -> impl Iterator<Item = Design> {
    let all = Design { mode: PLAIN, ..*d }.ways(&Trim::ALL);
    all.into_iter().filter(|way| way.mode.levels_down < 4)
}
