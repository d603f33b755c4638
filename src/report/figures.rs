//! Cells put together: a dot a design, and how errors and steps go with angle, map size and width.
use super::measurement::Measurement;
use super::plan::{DesignSpec, Plan, Synthesized};
use crate::config::modes::BEST;
use crate::config::{DatapathKind, datapaths};
use crate::measure::Cost;
use crate::measure::spread::{BINS, bound};
use rayon::prelude::*;

/// Cells of one design, put together.
#[derive(Clone, Debug)]
pub struct Aggregate<'a> {
    /// The measurements.
    pub measurements: Vec<&'a Measurement>,
}

impl<'a> Aggregate<'a> {
    /// The measurements that `take` takes.
    pub fn new(measurements: &'a [Measurement], take: impl Fn(&Measurement) -> bool) -> Self {
        Self { measurements: measurements.iter().filter(|c| take(c)).collect() }
    }

    fn sum(&self, f: impl Fn(&Measurement) -> u64) -> u64 {
        self.measurements.iter().map(|c| f(c)).sum()
    }

    /// Rays compared.
    pub fn rays(&self) -> u64 {
        self.sum(Measurement::judged)
    }

    /// Wrong texels.
    pub fn wrong(&self) -> u64 {
        self.sum(|c| c.wrong)
    }

    /// Rays that end in another texel than the ray before its rounding to words.
    pub fn unrounded_wrong(&self) -> u64 {
        self.sum(|c| c.unrounded_wrong)
    }

    /// Rays given up.
    pub fn limits(&self) -> u64 {
        self.sum(|c| c.limits)
    }

    /// Part of the rays with a wrong texel or none.
    pub fn rate(&self) -> f64 {
        self.sum(Measurement::failed) as f64 / self.rays().max(1) as f64
    }

    /// [`Aggregate::rate`], or where it is 0, below what it is with 95 % confidence.
    pub fn rate_or_bound(&self) -> (f64, bool) {
        if self.rate() > 0.0 { (self.rate(), false) } else { (bound(self.rays()), true) }
    }

    /// Cycles per ray: the mean over the measurements, so that each view counts alike.
    pub fn cycles(&self) -> f64 {
        self.measurements.iter().map(|c| c.cycles()).sum::<f64>() / self.measurements.len().max(1) as f64
    }

    /// The measurement with the largest value.
    pub fn worst(&self, f: impl Fn(&Measurement) -> f64) -> Option<&'a Measurement> {
        let mut worst: Option<&Measurement> = None;
        for c in &self.measurements {
            if worst.is_none_or(|w| f(c) > f(w)) {
                worst = Some(c);
            }
        }
        worst
    }

    /// The largest value of a measurement.
    pub fn largest(&self, f: impl Fn(&Measurement) -> f64) -> f64 {
        self.worst(&f).map_or(0.0, f)
    }

    /// Rays by octave of their position error: all that ended, or those with the right texel.
    pub fn bins(&self, all: bool) -> Vec<u64> {
        let mut sum = vec![0; BINS];
        for c in &self.measurements {
            let s = if all { &c.uv_all } else { &c.uv_right };
            sum.iter_mut().zip(&s.bins).for_each(|(a, b)| *a += b);
        }
        sum
    }

    /// The decision matrices, added.
    pub fn matrix(&self) -> [[[u64; 2]; 2]; 3] {
        let mut sum = [[[0; 2]; 2]; 3];
        for c in &self.measurements {
            for (at, n) in
                sum.as_flattened_mut().as_flattened_mut().iter_mut().zip(c.matrix.as_flattened().as_flattened())
            {
                *at += n;
            }
        }
        sum
    }
}

/// A design on all maps of the usual size.
#[derive(Clone, Debug)]
pub struct DesignPoint<'a> {
    /// The design.
    pub design: &'a DesignSpec,
    /// Its measurements.
    pub aggregate: Aggregate<'a>,
    /// Counted bits of its hardware without the memory; `None` if there is no hardware for it yet.
    pub size: Option<u64>,
    /// Area and clock, if they were measured; of several the one with the least area times time.
    pub placed: Option<&'a Synthesized>,
    /// No other design is cheaper and at least as often right, or as cheap and more often right.
    pub front_rate: bool,
    /// As `front_rate`, for the 99th percentile of the position error.
    pub front_uv: bool,
}

impl DesignPoint<'_> {
    /// Design and mode.
    pub fn label(&self) -> String {
        format!("{}, {}", self.design.label(), self.design.way())
    }

    /// Cycles count the rays that end. Where more than 1 of 100 does not, they tell nothing, and the design is in no frontier.
    pub fn comparable(&self) -> bool {
        self.aggregate.limits() * 100 <= self.aggregate.rays()
    }

    /// Look-up tables times nanoseconds a ray, if they were measured.
    pub fn area_time(&self) -> Option<f64> {
        self.placed.map(|s| s.area_time(self.aggregate.cycles()))
    }

    /// Largest 99th percentile of a map and view.
    pub fn uv_p99(&self) -> f64 {
        self.aggregate.largest(|c| c.uv_all.p99)
    }
}

/// A dot for every design that was measured, with the frontiers.
pub fn design_points<'a>(plan: &'a Plan, measurements: &'a [Measurement]) -> Vec<DesignPoint<'a>> {
    let levels = plan.config.traverse.levels;
    let aggregate =
        |d: &DesignSpec| Aggregate::new(measurements, |c| c.spec.design == *d && c.spec.map.levels == levels);
    let mut out: Vec<DesignPoint<'a>> = plan
        .designs
        .par_iter()
        .map(|design| (design, aggregate(design)))
        .filter(|(_, aggregate)| !aggregate.measurements.is_empty())
        .map(|(design, aggregate)| {
            let hardware = design.design(&plan.config, levels).and_then(|d| Cost::of(&d));
            let size = hardware.ok().map(|c| c.bits());
            let mine = plan.synthesized.iter().filter(|s| s.is(design, levels));
            let placed = mine.min_by(|a, b| a.area_time(1.0).total_cmp(&b.area_time(1.0)));
            DesignPoint { design, aggregate, size, placed, front_rate: false, front_uv: false }
        })
        .collect();
    let front = |error: &dyn Fn(&DesignPoint<'a>) -> f64| -> Vec<bool> {
        let at: Vec<(f64, f64)> = out.iter().map(|d| (d.aggregate.cycles(), error(d))).collect();
        let rivals: Vec<&(f64, f64)> = at.iter().zip(&out).filter(|x| x.1.comparable()).map(|x| x.0).collect();
        let beaten = |a: &(f64, f64)| rivals.iter().any(|b| b.0 <= a.0 && b.1 <= a.1 && (b.0 < a.0 || b.1 < a.1));
        at.iter().zip(&out).map(|(a, d)| d.comparable() && !beaten(a)).collect()
    };
    // None wrong is better than any, whatever its bound is.
    let (rate, uv) = (front(&|d| d.aggregate.rate()), front(&DesignPoint::uv_p99));
    for (d, (rate, uv)) in out.iter_mut().zip(rate.into_iter().zip(uv)) {
        (d.front_rate, d.front_uv) = (rate, uv);
    }
    out
}

/// A point of a series.
#[derive(Clone, Debug)]
pub struct At<'a> {
    /// Place along the axis.
    pub x: f64,
    /// Cells.
    pub aggregate: Aggregate<'a>,
}

/// One line of a chart.
#[derive(Clone, Debug)]
pub struct Series<'a> {
    /// What varies: `angle`, `size` or `bits`.
    pub by: &'static str,
    /// Design.
    pub name: String,
    /// Points, in the order of the axis.
    pub points: Vec<At<'a>>,
}

/// The lines of all charts; `angles` are the measurements by elevation.
pub fn series<'a>(plan: &'a Plan, measurements: &'a [Measurement], angles: &'a [Measurement]) -> Vec<Series<'a>> {
    let levels = plan.config.traverse.levels;
    let mut out = Vec::new();
    for d in plan.designs.iter().filter(|d| plan.followed(d)) {
        let mine: Vec<&Measurement> = angles.iter().filter(|c| c.spec.design == *d).collect();
        let angle = |c: &&'a Measurement| At {
            x: c.spec.elevation.unwrap_or(0.0),
            aggregate: Aggregate { measurements: vec![*c] },
        };
        out.push(Series { by: "angle", name: d.label(), points: mine.iter().map(angle).collect() });
        // Only a map that is there in several sizes tells what the size does.
        let first = &plan.maps[0].spec;
        let same = plan.maps.iter().filter(|s| s.spec.name == first.name && s.spec.kind == first.kind);
        let mut sizes: Vec<u32> = same.map(|s| s.spec.levels).collect();
        sizes.sort_unstable();
        sizes.dedup();
        let size = |n: &u32| At {
            x: f64::from(*n),
            aggregate: Aggregate::new(measurements, |c| {
                c.spec.design == *d && c.spec.map.levels == *n && c.spec.map.name == first.name
            }),
        };
        let points = if sizes.len() > 1 { sizes.iter().map(size).collect() } else { Vec::new() };
        out.push(Series { by: "size", name: d.label(), points });
    }
    let widths = |kind: DatapathKind, exp: Option<u32>| -> Vec<At<'a>> {
        let same = |d: &&DesignSpec| d.kind == kind && d.exp == exp && d.mode == BEST;
        let mut points: Vec<At<'a>> = plan
            .designs
            .iter()
            .filter(same)
            .map(|d| At {
                x: f64::from(d.man.or(d.fraction_bits).unwrap_or(0)),
                aggregate: Aggregate::new(measurements, |c| c.spec.design == *d && c.spec.map.levels == levels),
            })
            .collect();
        points.sort_by(|a, b| a.x.total_cmp(&b.x));
        points
    };
    // Of a datapath with a nudge only the published width is measured.
    for kind in datapaths().filter(|k| !k.facts().reads.nudge_bits) {
        let exps = if kind.facts().reads.format { vec![Some(5), Some(6), Some(7), Some(8)] } else { vec![None] };
        for exp in exps {
            let width = exp.map_or(String::new(), |exp| format!(" EXP_W {exp}"));
            out.push(Series { by: "bits", name: kind.word().to_owned() + &width, points: widths(kind, exp) });
        }
    }
    for s in &mut out {
        s.points.retain(|p| !p.aggregate.measurements.is_empty());
    }
    out.retain(|s| !s.points.is_empty());
    out
}
