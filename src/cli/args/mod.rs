//! What can be typed.
mod figures;
mod scene;
mod values;

pub use figures::*;
pub use scene::{MOST_RAYS, MapArgs, RaysArg, SceneArgs};
use values::{profile, unit_name};

use crate::config::Profile;
use crate::engine::EngineName;
use crate::error::{Error, Result};
use crate::project::Canary;
use crate::vectors::{Campaign, Level, Shard};
use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;

/// Generates Verilog that traces rays against height fields, with golden vectors and an interpreter of the same datapath.
#[derive(Parser, Debug)]
#[command(name = "reliefrtl", version, about, after_help = EXIT_CODES)]
pub struct Cli {
    /// Configuration file (TOML); `reliefrtl config --print` shows every key.
    #[arg(long, global = true, value_name = "FILE.toml")]
    pub config: Option<PathBuf>,
    /// Latencies by name; `--set` can still change single ones.
    #[arg(long, global = true, value_name = "PROFILE", value_parser = profile())]
    pub profile: Option<Profile>,
    /// Picks latencies for this clock from a table of measurements, says how sure it is, and asks for it in flow/.
    #[arg(long, global = true, value_name = "MHZ", conflicts_with = "profile", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub clock: Option<u32>,
    /// Overrides one key of the configuration, e.g. --set traverse.levels=10.
    #[arg(long = "set", global = true, value_name = "KEY=VALUE")]
    pub sets: Vec<String>,
    /// Prints results as JSON, for machines.
    #[arg(long, global = true)]
    pub json: bool,
    /// What to do.
    #[command(subcommand)]
    pub verb: Verb,
}

const EXIT_CODES: &str = "Exit codes: 0 ok, 1 mismatch, 2 usage or input, 3 tool missing, 4 tool failed, 5 nothing ran, \
6 an expected result never came, 7 an unexpected result; 129, 130, 143 ended by SIGHUP, SIGINT (Ctrl-C), SIGTERM; \
141 standard output was closed before all was said (the work was done all the same, files of --out are written).\n\
With --json an error is one JSON object on standard error.\n\
--out of a verb that writes one file: `-` is standard output, a device or FIFO is written to, a link is followed.";

/// Keeps the first of equal ones.
fn once<T: PartialEq>(list: &mut Vec<T>) {
    let mut at = 0;
    while at < list.len() {
        if list[..at].contains(&list[at]) {
            list.remove(at);
        } else {
            at += 1;
        }
    }
}

/// The verbs.
#[derive(Subcommand, Debug)]
pub enum Verb {
    /// Does everything: Verilog, benches, vectors checked by the interpreter, manifest, picture, summary.
    Build(BuildArgs),
    /// Writes the Verilog and manifest.json.
    Emit(EmitArgs),
    /// Writes the golden vectors.
    Vectors(VectorsArgs),
    /// Replays golden vectors in an engine.
    Check(CheckArgs),
    /// Proves the emitted units with SymbiYosys: for every input, not only for the vectors.
    Prove(ProveArgs),
    /// Traces rays from a CSV file.
    Trace(TraceArgs),
    /// Renders the map through the datapath.
    Render(RenderArgs),
    /// Prints iterations per ray for every row of the published table.
    Steps(StepsArgs),
    /// Compares the datapath with the exact oracle: wrong texels with their witnesses.
    Accuracy(AccuracyArgs),
    /// Measures steps and error of every design and writes a page, JSON and CSV about them.
    Report(ReportArgs),
    /// Finds the smallest design that keeps an error budget on a scene, says why, and writes its configuration.
    Fit(FitArgs),
    /// Runs the hard cases: maps and rays on which a traversal is most likely to go wrong.
    Hard(HardArgs),
    /// Measures rays per second of the engines on the same rays, in one run.
    Bench(BenchArgs),
    /// Measures areas and clocks of units with Yosys and nextpnr; exit code 3 where they are not installed.
    Synth(SynthArgs),
    /// Lists the units with their parameters and latency.
    List,
    /// Prints the configuration or its schema.
    Config(ConfigArgs),
    /// Prints a completion script for a shell.
    Completions {
        /// The shell.
        shell: clap_complete::Shell,
    },
}

impl Verb {
    /// Takes what a list names twice once.
    pub fn once(&mut self) {
        match self {
            Self::Vectors(a) => once(&mut a.unit),
            Self::Emit(a) => once(&mut a.unit),
            Self::Check(a) => once(&mut a.unit),
            Self::Hard(a) => once(&mut a.case),
            Self::Synth(a) => {
                once(&mut a.unit);
                once(&mut a.seeds);
                once(&mut a.latency);
                once(&mut a.beside);
            }
            Self::Report(a) => {
                once(&mut a.maps);
                once(&mut a.levels);
                once(&mut a.datapaths);
                once(&mut a.formats);
                once(&mut a.fractions);
                once(&mut a.synth);
            }
            _ => {}
        }
    }

    /// The options about the height map, of verbs that have them.
    pub fn map(&self) -> Option<&MapArgs> {
        match self {
            Self::Build(a) => Some(&a.map),
            Self::Vectors(a) => Some(&a.map),
            Self::Trace(a) => Some(&a.scene.map),
            Self::Render(a) => Some(&a.scene.map),
            Self::Steps(a) => Some(&a.scene.map),
            Self::Accuracy(a) => Some(&a.scene.map),
            Self::Report(a) => Some(&a.scene.map),
            Self::Fit(a) => Some(&a.scene.map),
            Self::Hard(a) => Some(&a.scene.map),
            Self::Bench(a) => Some(&a.scene.map),
            _ => None,
        }
    }
}

/// Options of `build` and `vectors`.
#[derive(Args, Debug)]
pub struct BuildArgs {
    /// Directory to write to.
    #[arg(long, default_value = "out", value_name = "DIR")]
    pub out: PathBuf,
    /// The height map.
    #[command(flatten)]
    pub map: MapArgs,
    /// Says what is taken of the map's file (size, channel, range, texels without data), and builds nothing.
    #[arg(long)]
    pub print_map: bool,
}

/// Options of `vectors`.
#[derive(Args, Debug)]
pub struct VectorsArgs {
    /// Directory to write to.
    #[arg(long, default_value = "out", value_name = "DIR")]
    pub out: PathBuf,
    /// Only these units'; arithmetic at any format, whatever a traversal asks of its own.
    #[arg(long, value_name = "NAME,...", value_delimiter = ',', value_parser = unit_name)]
    pub unit: Vec<String>,
    /// Another value of a parameter of the units' text, as Verilog's -P gives it; any that manifest.json allows.
    #[arg(long, value_name = "NAME=VALUE", requires = "unit")]
    pub param: Vec<String>,
    /// Tables of corners.
    #[command(flatten)]
    pub campaign: CampaignArgs,
    /// The height map.
    #[command(flatten)]
    pub map: MapArgs,
}

/// Which vectors of a unit of arithmetic: the usual choice of corners without these options.
#[derive(Args, Debug)]
pub struct CampaignArgs {
    /// Crosses whole tables of corners, small (1) or large (2), before the random rows; or random rows alone (3), which `check` goes on
    /// with, seed after seed, until it is stopped. Of arithmetic (`--unit`).
    #[arg(long)]
    pub level: Option<Level>,
    /// Only the i-th of n equal parts of these rows: n calls together make the whole, and their counts add up.
    #[arg(long, value_name = "I/N", requires = "level")]
    pub shard: Option<Shard>,
}

impl CampaignArgs {
    /// The campaign that is asked for, of the unit of arithmetic `alone`.
    ///
    /// # Errors
    /// Another unit, or none.
    pub fn campaign(&self, alone: bool) -> Result<Option<Campaign>> {
        let Some(level) = self.level else { return Ok(None) };
        if !alone {
            return Err(Error::input("--level crosses corners of arithmetic: name its units, as --unit fp_add,fp_mul"));
        }
        Ok(Some(Campaign { level, shard: self.shard.unwrap_or(Shard::WHOLE) }))
    }
}

/// Options of `emit`.
#[derive(Args, Debug)]
pub struct EmitArgs {
    /// Directory to write to.
    #[arg(long, default_value = "out", value_name = "DIR")]
    pub out: PathBuf,
    /// Only these units and what they need.
    #[arg(long, value_name = "NAME,...", value_delimiter = ',', value_parser = unit_name)]
    pub unit: Vec<String>,
}

/// Options of `check`.
#[derive(Args, Debug)]
pub struct CheckArgs {
    /// What replays the vectors.
    #[arg(long, default_value = "interp")]
    pub engine: EngineName,
    /// Only these units.
    #[arg(long, value_name = "NAME,...", value_delimiter = ',', value_parser = unit_name)]
    pub unit: Vec<String>,
    /// Another value of a parameter of the units' text, as Verilog's -P gives it; any that manifest.json allows.
    #[arg(long, value_name = "NAME=VALUE", requires = "unit")]
    pub param: Vec<String>,
    /// Tables of corners.
    #[command(flatten)]
    pub campaign: CampaignArgs,
    /// A tree that `build` wrote with the same configuration; without it a fresh one is made and thrown away.
    #[arg(long, value_name = "DIR", conflicts_with = "level")]
    pub dir: Option<PathBuf>,
    /// Ends `--level 3` after so many batches of `vectors.arithmetic` rows instead of when it is stopped.
    #[arg(long, value_name = "N", requires = "level", value_parser = clap::value_parser!(u32).range(1..))]
    pub batches: Option<u32>,
    /// Spoils the vectors on purpose: the check must fail, each fault with its own exit code.
    #[arg(long)]
    pub canary: Option<Canary>,
    /// Where the first mismatch goes as a waveform of the interpreter: the clocks around it, undefined values as x.
    #[arg(long, value_name = "W.fst|W.vcd")]
    pub wave: Option<PathBuf>,
    /// Also counts what the vectors reach (with --engine verilator): branches and bits that change, by file. Of the default configuration a
    /// point that is not reached and has no reason on the list is a failure with exit code 1.
    #[arg(long, conflicts_with_all = ["unit", "level", "canary", "wave"])]
    pub coverage: bool,
}

/// Options of `prove`.
#[derive(Args, Debug)]
pub struct ProveArgs {
    /// Only this proof, by its name in `prove --list`: that of a unit, or of a claim about several.
    #[arg(long, value_name = "NAME")]
    pub unit: Option<String>,
    /// A tree that `build` wrote with the same configuration; without it a fresh one is made and thrown away.
    #[arg(long, value_name = "DIR")]
    pub dir: Option<PathBuf>,
    /// Lists the proofs and what they claim, and runs none.
    #[arg(long)]
    pub list: bool,
}

/// Options of `config`.
#[derive(Args, Debug)]
pub struct ConfigArgs {
    /// The complete configuration with a comment a key.
    #[arg(long, conflicts_with = "schema")]
    pub print: bool,
    /// Its JSON schema.
    #[arg(long)]
    pub schema: bool,
}

/// Options of `trace`.
#[derive(Args, Debug)]
pub struct TraceArgs {
    /// Map and rays; of a camera file every pixel's, of a view every `view.stride`-th. A number after `--rays` takes so many of each view.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// What traces them.
    #[arg(long, default_value = "interp")]
    pub engine: EngineName,
    /// Where the hits go.
    #[arg(long, value_name = "H.csv")]
    pub out: PathBuf,
    /// Also writes a waveform of one ray through the interpreter, undefined values as x.
    #[arg(long, value_name = "W.fst|W.vcd")]
    pub wave: Option<PathBuf>,
    /// The ray of the waveform, counted from 0.
    #[arg(long, default_value_t = 0, requires = "wave")]
    pub wave_ray: usize,
}

/// Options of `render`.
#[derive(Args, Debug)]
pub struct RenderArgs {
    /// Map and view; oblique without `--view`. Of several views, each picture has the view's name after that of `--out`. A table of rays is
    /// drawn on the map from above.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// What traces the pixels.
    #[arg(long, default_value = "interp")]
    pub engine: EngineName,
    /// Where the picture goes.
    #[arg(long, default_value = "render.png", value_name = "FILE.png")]
    pub out: PathBuf,
    /// Colours the iterations per pixel instead of the surface.
    #[arg(long)]
    pub steps: bool,
}
