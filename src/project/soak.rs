//! Whether every ray of the hard cases ends.
use super::corner_cases::{HardGround, HardTask};
use crate::config::{Design, ModeConfig};
use crate::error::{Error, Result};
use crate::golden::RayInput;
use crate::measure::hex_words;
use crate::measure::soak::{Endured, endure, modes};
use serde::Serialize;

/// The ray of a case with the most iterations of those that end.
#[derive(Clone, Debug, Serialize)]
pub struct LongestRay {
    /// Its iterations.
    pub steps: u32,
    /// Its words u, v, du, dv in hex.
    pub words: [String; 4],
    /// The mode that it was traced in.
    pub mode: ModeConfig,
    /// The same in a few words; of a search by windows the set.
    pub way: String,
}

/// What became of a case's rays.
#[derive(Clone, Debug, Serialize)]
pub struct EnduredCase {
    /// The case.
    pub case: String,
    /// Rays traced.
    pub rays: usize,
    /// Rays given up.
    pub given_up: usize,
    /// Rays that the design does not take.
    pub refused: usize,
    /// The longest of the rest.
    pub longest: Option<LongestRay>,
}

/// What became of all.
#[derive(Clone, Debug, Serialize)]
pub struct EnduredSum {
    /// Seed of maps and rays.
    pub seed: u64,
    /// Rays traced.
    pub rays: usize,
    /// Rays given up.
    pub given_up: usize,
    /// Rays that the design does not take.
    pub refused: usize,
    /// Each case.
    pub cases: Vec<EnduredCase>,
    /// The first ray given up, and the design that it was traced in.
    #[serde(skip)]
    pub witness: Option<(RayInput, Design)>,
}

/// Deals `rays` rays over the tasks that fit the design, at most `most` of each, and counts those that end.
///
/// # Errors
/// No ray, or more than `most` of a case.
pub fn endure_cases(
    ground: &HardGround<'_>,
    tasks: &[HardTask<'_>],
    rays: usize,
    most: usize,
    tell: &dyn Fn(String),
) -> Result<EnduredSum> {
    let cases: Vec<&HardTask<'_>> = tasks.iter().filter(|task| ground.scene(task, 0).is_ok()).collect();
    if rays == 0 || cases.is_empty() {
        return Err(Error::NothingRan("hard --endure needs at least one ray and a case that fits this design".into()));
    }
    let share = rays.div_ceil(cases.len());
    if share > most {
        return Err(Error::input(format!(
            "--endure {rays} are {share} rays of each case, more than {most}, the most at once: ask for fewer, and again with another --seed"
        )));
    }
    let (mut list, mut sum) = (Vec::new(), Endured::default());
    for (k, task) in cases.iter().enumerate() {
        let name = task.name();
        tell(format!("{share} rays of hard case {name} ({} of {})", k + 1, cases.len()));
        let mut scene = ground.scene(task, share).map_err(Error::input)?;
        if let HardTask::Set(..) = task {
            // Each ray in every mode, then the next; all over again where there are too few.
            let (given, modes) = (scene.rays, modes(&scene.design).len());
            scene.rays = (0..share).map(|k| given[k / modes % given.len()]).collect();
        }
        let of = endure(&scene)?;
        list.push(EnduredCase {
            case: name.into(),
            rays: of.rays,
            given_up: of.given_up,
            refused: of.refused,
            longest: of.longest.map(|l| LongestRay {
                steps: l.steps,
                words: hex_words(&l.ray),
                mode: l.design.mode,
                way: l.design.way(),
            }),
        });
        sum = sum.and(of);
    }
    let Endured { rays, given_up, refused, witness, .. } = sum;
    Ok(EnduredSum { seed: ground.seed, rays, given_up, refused, cases: list, witness })
}
