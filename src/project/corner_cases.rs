//! The hard cases, or rays of the user's in their place, on the configured design.
use super::Scene;
use crate::config::{Config, Design, ModeConfig, TraverseConfig};
use crate::engine::EngineName;
use crate::error::{Error, Result};
use crate::golden::{Pyramid, RayHit};
use crate::measure::corner_cases::HardFigures;
use crate::measure::{RayEnd, hex_words};
use crate::scene::hard::{Case, HardScene};
use crate::scene::{RaySet, ViewRay};
use crate::trace::said;
use serde::Serialize;

/// What is run: a case, or rays of the user's.
pub enum HardTask<'a> {
    /// A named case, on its own map or on that of the user's.
    Case(&'static Case),
    /// A view or a table of rays on a map, in tiles of the design.
    Set(&'a RaySet, &'a [ViewRay]),
}

impl HardTask<'_> {
    /// Name of the case or the set.
    pub fn name(&self) -> &str {
        match self {
            Self::Case(case) => case.name,
            Self::Set(set, _) => &set.name,
        }
    }

    /// Whether a step limit of exactly what the rays need is asked for, too.
    const fn limit(&self) -> bool {
        match self {
            Self::Case(case) => case.limit,
            Self::Set(..) => true,
        }
    }
}

/// What all tasks share.
pub struct HardGround<'a> {
    /// The configuration.
    pub c: &'a Config,
    /// The user's map, if there is one.
    pub own: Option<&'a Scene>,
    /// Seed of maps and rays.
    pub seed: u64,
}

impl HardGround<'_> {
    /// A task's map and rays; or why it has none in this design.
    pub(super) fn scene(&self, task: &HardTask<'_>, rays: usize) -> std::result::Result<HardScene, String> {
        let design = self.c.design();
        let scene = match (task, self.own) {
            (HardTask::Case(case), None) => case.scene(&design, rays, self.seed),
            (HardTask::Case(case), Some(own)) => case
                .over(&design, &own.texels, rays, self.seed)
                .ok_or("its map has a size of its own, so its rays don't go over another")?,
            (HardTask::Set(_, rays), own) => {
                let texels = own.map_or_else(Vec::new, |own| own.texels.clone());
                HardScene { design, texels, rays: rays.iter().map(|r| [r.u, r.v, r.du, r.dv]).collect() }
            }
        };
        illegal(self.c, scene.design.traverse).map_or(Ok(scene), Err)
    }
}

/// What is wrong with the configuration at the case's sizes.
fn illegal(c: &Config, traverse: TraverseConfig) -> Option<String> {
    let mut c = c.clone();
    c.traverse = traverse;
    c.validate().err().map(|e| e.to_string())
}

/// A wrong texel.
#[derive(Clone, Debug, Serialize)]
pub struct HardWrong {
    /// Index of the ray.
    pub ray: usize,
    /// Its words u, v, du, dv in hex.
    pub words: [String; 4],
    /// The texel that the datapath returned.
    pub got: (u32, u32),
    /// That of the exact walk.
    pub exact: (u32, u32),
    /// How close the exact decision was, over the height range.
    pub margin: f64,
}

/// A ray that ends differently in another mode.
#[derive(Clone, Debug, Serialize)]
pub struct HardDiffers {
    /// Index of the ray.
    pub ray: usize,
    /// Its words u, v, du, dv in hex.
    pub words: [String; 4],
    /// The other mode.
    pub mode: ModeConfig,
    /// The same in a few words; of a search by windows the other set, or the pyramid's mode.
    pub way: String,
    /// Where it ends in that.
    pub got: RayEnd,
    /// Where it ends in the configured mode.
    pub expected: RayEnd,
}

/// A ray that was given up.
#[derive(Clone, Debug)]
pub struct HardGivenUp {
    /// Index of the ray.
    pub ray: usize,
    /// Its words u, v, du, dv in hex.
    pub words: [String; 4],
    /// Iterations until then.
    pub steps: u32,
}

/// What a design makes of a case.
#[derive(Clone, Debug, Serialize)]
pub struct HardCase {
    /// The case.
    pub case: String,
    /// Texels a side.
    pub texels: u32,
    /// Rays traced.
    pub rays: usize,
    /// Rays in a wrong texel, whose exact walk meets no tie.
    pub wrong: usize,
    /// Of the rays on an exact tie, those in another texel.
    pub wrong_ties: usize,
    /// Rays on an exact tie.
    pub ties: usize,
    /// Rays given up.
    pub given_up: usize,
    /// Modes compared.
    pub modes: usize,
    /// Rays that end differently in some mode.
    pub modes_differ: usize,
    /// Rays that end otherwise than they must at a step limit of what they need, or of one less.
    pub limit_wrong: Option<usize>,
    /// The wrong texel with the largest margin.
    pub worst: Option<HardWrong>,
    /// The first ray that ends differently in another mode.
    pub first_that_differs: Option<HardDiffers>,
    /// The first ray given up.
    #[serde(skip)]
    pub first_given_up: Option<HardGivenUp>,
    /// The largest margin of a wrong texel; 0 without one.
    #[serde(skip)]
    pub largest_margin: f64,
    /// Whether no ray is given up and every mode finds the same, where the datapath promises it.
    #[serde(skip)]
    pub keeps_promises: bool,
}

impl HardCase {
    fn of(case: &str, f: &HardFigures) -> Self {
        let words = |ray: usize| hex_words(&f.rays[ray]);
        let worst = f.accuracy.wrong.iter().max_by(|a, b| a.margin.total_cmp(&b.margin));
        let worst =
            worst.map(|w| HardWrong { ray: w.ray, words: words(w.ray), got: w.got, exact: w.exact, margin: w.margin });
        let differs = f.differ.first().map(|d| HardDiffers {
            ray: d.ray,
            words: words(d.ray),
            mode: d.design.mode,
            way: d.design.way(),
            got: (&d.got).into(),
            expected: (&d.expected).into(),
        });
        let given_up = f.hits.iter().position(|hit| hit.limit);
        Self {
            case: case.into(),
            texels: 1 << f.design.traverse.levels,
            rays: f.rays.len(),
            wrong: f.accuracy.wrong.len() - f.ties,
            wrong_ties: f.ties,
            ties: f.tied,
            given_up: f.accuracy.limits,
            modes: f.modes,
            modes_differ: f.differ.len(),
            limit_wrong: f.limit_wrong,
            worst,
            first_that_differs: differs,
            first_given_up: given_up.map(|ray| HardGivenUp { ray, words: words(ray), steps: f.hits[ray].steps }),
            largest_margin: f.largest_margin(),
            keeps_promises: f.keeps_promises(),
        }
    }
}

/// A task and what came of it.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum HardOutcome {
    /// It was run.
    Run(Box<HardCase>),
    /// It was not, and why.
    LeftOut {
        /// The case.
        case: String,
        /// Why.
        left_out: String,
    },
}

/// All tasks.
#[derive(Clone, Debug, Default, Serialize)]
pub struct HardSum {
    /// Seed of maps and rays.
    pub seed: u64,
    /// Rays of all cases.
    pub rays: usize,
    /// As in [`HardCase`], of all cases.
    pub wrong: usize,
    /// As in [`HardCase`], of all cases.
    pub wrong_ties: usize,
    /// As in [`HardCase`], of all cases.
    pub ties: usize,
    /// As in [`HardCase`], of all cases.
    pub given_up: usize,
    /// As in [`HardCase`], of all cases.
    pub modes_differ: usize,
    /// As in [`HardCase`], of all cases.
    pub limit_wrong: usize,
    /// Each case.
    pub cases: Vec<HardOutcome>,
}

impl HardSum {
    fn add(&mut self, case: HardCase) {
        self.rays += case.rays;
        self.wrong += case.wrong;
        self.wrong_ties += case.wrong_ties;
        self.ties += case.ties;
        self.given_up += case.given_up;
        self.modes_differ += case.modes_differ;
        self.limit_wrong += case.limit_wrong.unwrap_or(0);
        self.cases.push(HardOutcome::Run(Box::new(case)));
    }

    /// The cases that were run.
    pub fn run(&self) -> impl Iterator<Item = &HardCase> {
        self.cases.iter().filter_map(|case| match case {
            HardOutcome::Run(case) => Some(&**case),
            HardOutcome::LeftOut { .. } => None,
        })
    }
}

/// What is told of a case before it is run, and given after.
pub trait HardWatch {
    /// A case is about to be run.
    fn begins(&mut self, case: &str);

    /// It was run.
    ///
    /// # Errors
    /// What is made of it can't be kept.
    fn ends(&mut self, case: &str, scene: &HardScene, design: &Design, hits: &[RayHit]) -> Result<()>;
}

/// Runs `each` rays of every task; the hits of `engine` must be the golden model's.
///
/// # Errors
/// An engine whose hits differ; no case that fits the design.
pub fn hard_cases(
    ground: &HardGround<'_>,
    tasks: &[HardTask<'_>],
    each: usize,
    engine: EngineName,
    watch: &mut dyn HardWatch,
) -> Result<HardSum> {
    let mut sum = HardSum { seed: ground.seed, ..HardSum::default() };
    for task in tasks {
        let name = task.name();
        watch.begins(name);
        let scene = match ground.scene(task, each) {
            Ok(scene) => scene,
            Err(left_out) => {
                sum.cases.push(HardOutcome::LeftOut { case: name.into(), left_out });
                continue;
            }
        };
        let f = HardFigures::of_scene(&scene, task.limit())?;
        if engine != EngineName::Golden {
            equal(ground.c, engine, name, &scene, &f)?;
        }
        watch.ends(name, &scene, &f.design, &f.hits)?;
        sum.add(HardCase::of(name, &f));
    }
    if sum.rays == 0 {
        return Err(Error::NothingRan("no case fits this design".into()));
    }
    Ok(sum)
}

/// The engine's hits are the golden model's.
fn equal(c: &Config, engine: EngineName, name: &str, hard: &HardScene, f: &HardFigures) -> Result<()> {
    let mut c = c.clone();
    c.traverse = f.design.traverse;
    let t = &c.traverse;
    let pyramid = Pyramid::build(t.levels, t.height_bits, &hard.texels)?;
    let hits = engine.engine().trace(&c, &pyramid, &f.rays)?.hits;
    match hits.iter().zip(&f.hits).position(|(got, want)| *got != said(&c.design(), want)) {
        None => Ok(()),
        Some(ray) => Err(Error::mismatch(format!(
            "case {name}, ray {ray} ({}): expected {}, got {}",
            hex_words(&f.rays[ray]).join(" "),
            RayEnd::from(&f.hits[ray]),
            RayEnd::from(&hits[ray])
        ))),
    }
}
