//! The search: one dimension after the other, each to the least that keeps the budget.
use super::trial::{Budget, Trial, Truth, name};
use crate::config::{DatapathKind, Design, LevelUp, ModeConfig, Trim};
use crate::error::{Error, Result};
use crate::golden::Tracer;

/// What the search may change.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// The map itself: fewer levels, fewer bits a height.
    pub resample: bool,
}

/// A design that was tried and not taken.
#[derive(Clone, Debug)]
pub struct Rejected {
    /// What it would have changed.
    pub what: String,
    /// What it would have broken, or cost.
    pub why: String,
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
    let mut s = Search { truth, budget, seen, reasons: Vec::new(), rejected: Vec::new(), tried: 0 };
    let mut d = *base;
    (d.traverse.levels, d.traverse.height_bits) = (truth.levels, truth.height_bits);
    s.tiles(&mut d)?;
    let mut best = s.numbers(&d)?;
    if limits.resample {
        best = s.map(best)?;
    } else {
        s.reasons.push(format!("map kept: {0} x {0} texels of {1} bits", 1u32 << truth.levels, truth.height_bits));
    }
    best = s.modes(best)?;
    best = s.rest(best)?;
    Ok(Fit { chosen: best, reasons: s.reasons, rejected: s.rejected, tried: s.tried })
}

impl Search<'_> {
    fn run(&mut self, d: &Design) -> Result<Trial> {
        self.tried += 1;
        (self.seen)(&name(d));
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
        self.rejected.push(Rejected { what, why });
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
        for ladder in [floats(d), fixed(d)] {
            let mut before: Option<Trial> = None;
            for candidate in ladder {
                if Tracer::new(&candidate).is_err() {
                    continue;
                }
                let t = self.run(&candidate)?;
                if t.keeps_surely(self.budget) {
                    if let Some(b) = &before {
                        self.reject(b, name(&b.design));
                    }
                    found.push(t);
                    break;
                }
                before = Some(t);
            }
            last = before.or(last);
        }
        found = found.into_iter().map(|t| self.reciprocal(t)).collect::<Result<_>>()?;
        found.sort_by_key(|t| t.cost.bits());
        let mut found = found.into_iter();
        let Some(best) = found.next() else {
            let best = last.map_or_else(
                || "no design is legal here".to_string(),
                |t| format!("{}: {}", name(&t.design), t.figure(self.budget)),
            );
            return Err(Error::mismatch(format!("no design keeps the budget; the widest one is {best}")));
        };
        for other in found {
            self.reject(&other, name(&other.design));
        }
        self.reasons.push(format!("{}: {}, {} bits", name(&best.design), best.figure(self.budget), best.cost.bits()));
        Ok(best)
    }

    /// A fixed-point design may do with fewer bits of the reciprocal.
    fn reciprocal(&mut self, mut best: Trial) -> Result<Trial> {
        while best.design.datapath.kind == DatapathKind::Fixed && best.design.datapath.reciprocal_bits > 8 {
            let mut d = best.design;
            d.datapath.reciprocal_bits -= 1;
            let t = self.run(&d)?;
            if !t.keeps_surely(self.budget) {
                self.reject(&t, name(&d));
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

    /// The modes with the least bits times cycles; they never change a hit of the watertight and fixed datapaths.
    fn modes(&mut self, best: Trial) -> Result<Trial> {
        let mut all: Vec<Trial> = Vec::new();
        for mode in modes() {
            let d = Design { mode, ..best.design };
            if Tracer::new(&d).is_ok() {
                all.push(self.run(&d)?);
            }
        }
        let product = |t: &Trial| t.cost.bits() as f64 * t.steps.mean;
        all.retain(|t| t.keeps_surely(self.budget));
        all.sort_by(|a, b| product(a).total_cmp(&product(b)));
        let plain = all.iter().find(|t| t.design.mode == plain()).cloned();
        let mut all = all.into_iter();
        let Some(chosen) = all.next() else { return Ok(best) };
        if let Some(next) = all.next() {
            let why = format!("{:.2} steps, {} bits", next.steps.mean, next.cost.bits());
            self.rejected.push(Rejected { what: mode_name(&next.design.mode), why });
        }
        let against =
            plain.map_or(String::new(), |p| format!("; without any {:.2} steps, {} bits", p.steps.mean, p.cost.bits()));
        self.reasons.push(format!(
            "modes {}: {:.2} steps a ray (max {} at ray {}), {} bits{against}",
            mode_name(&chosen.design.mode),
            chosen.steps.mean,
            chosen.steps.max,
            chosen.steps.witness,
            chosen.cost.bits()
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

/// Floating-point designs, narrow to wide, each with the fewest exponent bits that hold the map.
fn floats(d: &Design) -> Vec<Design> {
    let of = |man: u32| {
        (5..=8).map(move |exp| {
            let mut d = *d;
            d.datapath.kind = DatapathKind::Watertight;
            d.format = crate::format::FloatFormat::new(exp, man);
            d
        })
    };
    (7..=23).filter_map(|man| of(man).find(|d| Tracer::new(d).is_ok())).collect()
}

/// Fixed-point designs, narrow to wide.
fn fixed(d: &Design) -> Vec<Design> {
    let of = |bits: u32| {
        let mut d = *d;
        d.datapath.kind = DatapathKind::Fixed;
        (d.datapath.fraction_bits, d.datapath.reciprocal_bits) = (bits, bits);
        d
    };
    (8..=28).map(of).collect()
}

fn plain() -> ModeConfig {
    ModeConfig {
        start_level: false,
        levels_down: 1,
        level_up: LevelUp::None,
        trim: Trim::None,
        lod: false,
        bilinear: false,
    }
}

fn modes() -> Vec<ModeConfig> {
    let mut all = Vec::new();
    for trim in Trim::ALL {
        for start_level in [false, true] {
            for levels_down in [1, 2, 3] {
                all.extend(LevelUp::ALL.map(|level_up| ModeConfig {
                    start_level,
                    levels_down,
                    level_up,
                    trim,
                    lod: false,
                    bilinear: false,
                }));
            }
        }
    }
    all
}

fn mode_name(m: &ModeConfig) -> String {
    let start = if m.start_level { "start level" } else { "from the root" };
    format!("{start}, {} down, up {:?}, trim {:?}", m.levels_down, m.level_up, m.trim).to_lowercase()
}
