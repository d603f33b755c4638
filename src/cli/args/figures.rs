//! Options of the verbs that measure.
use super::scene::SceneArgs;
use super::values::unit_name;
use crate::config::{DatapathKind, MapKind};
use crate::engine::EngineName;
use crate::format::FloatFormat;
use crate::report::ModeSet;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// Options of `steps`.
#[derive(Args, Debug)]
pub struct StepsArgs {
    /// Map, views and rays; the configured ones without. A number after `--rays` takes so many of each view.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Directory with rocks.png, stones.png, four.png, saints.png: prints them beside the published means.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["map", "resample", "view", "rays"])]
    pub scenes: Option<PathBuf>,
}

/// Options of `accuracy`.
#[derive(Args, Debug)]
pub struct AccuracyArgs {
    /// Map, views and rays; all own maps and the configured views without. A number after `--rays` takes so many of each view.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Directory with rocks.png, stones.png, four.png, saints.png: rates over all of them, of the floating-point and the fixed-point
    /// datapath (of the published one with `datapath.kind=published`), as they are and resampled to 2048 x 2048.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["map", "resample", "view", "rays"])]
    pub scenes: Option<PathBuf>,
}

/// Options of `report`. What is not chosen is a selection of all there is.
#[derive(Args, Debug)]
pub struct ReportArgs {
    /// Directory to write to; measurements already in it are taken over, so that a run can be stopped and resumed.
    #[arg(long, default_value = "report", value_name = "DIR")]
    pub out: PathBuf,
    /// Map, views and rays, instead of own maps and the configured views. A number after `--rays` takes at most so many of each view.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Own maps: rocks, bricks, dunes, spikes, stairs, flat, spike, pit, checker.
    #[arg(long, value_delimiter = ',', value_name = "KIND,...", conflicts_with = "map")]
    pub maps: Vec<MapKind>,
    /// Directory with rocks.png, stones.png, four.png, saints.png: measures them too, beside the published tables.
    #[arg(long, value_name = "DIR")]
    pub scenes: Option<PathBuf>,
    /// Sizes of the maps, as log2 of their side; designs are compared at the first.
    #[arg(long, value_delimiter = ',', value_name = "N,...", value_parser = clap::value_parser!(u32).range(2..=12))]
    pub levels: Vec<u32>,
    /// Datapaths: watertight, fixed, published.
    #[arg(long, value_delimiter = ',', value_name = "KIND,...")]
    pub datapaths: Vec<DatapathKind>,
    /// Floating-point formats, exponent bits / fraction bits: 7/16.
    #[arg(long, value_delimiter = ',', value_name = "E/M,...", value_parser = float)]
    pub formats: Vec<FloatFormat>,
    /// Fraction bits of fixed point; the reciprocal is as wide.
    #[arg(long, value_delimiter = ',', value_name = "BITS,...", value_parser = clap::value_parser!(u32).range(8..=28))]
    pub fractions: Vec<u32>,
    /// Modes that are compared, on one format of each datapath.
    #[arg(long, value_name = "SET")]
    pub modes: Option<ModeSet>,
    /// Areas and clocks as `synth --out FILE.json` wrote them: a table of the units, and cells times clock of whole traverse units.
    #[arg(long, value_delimiter = ',', value_name = "FILE.json,...")]
    pub synth: Vec<PathBuf>,
    /// Every width and every mode, not a selection.
    #[arg(long)]
    pub full: bool,
}

/// Reads "7/16".
fn float(text: &str) -> Result<FloatFormat, String> {
    let wrong = || format!("{text:?} is no format: exponent bits / fraction bits, 4/3 to 8/23, as in 7/16");
    let (exp, man) = text.split_once('/').ok_or_else(wrong)?;
    match (exp.parse(), man.parse()) {
        (Ok(exp @ 4..=8), Ok(man @ 3..=23)) => Ok(FloatFormat::new(exp, man)),
        _ => Err(wrong()),
    }
}

/// Reads a number of block memories.
fn block_memories(text: &str) -> Result<u64, String> {
    let found = text.parse().ok().filter(|n| *n > 0);
    found.ok_or_else(|| "a whole number of block memories is needed, 1 or more, as 208".to_owned())
}

/// Options of `fit`.
#[derive(Args, Debug)]
pub struct FitArgs {
    /// Map, views and rays; the configured ones without. A number after `--rays`: rays of each view to search with (6000 without), and as many
    /// to check with; a share of wrong texels needs at least 3 / SHARE to search with. A table of rays is dealt into four parts, one to search
    /// with, so it has at least 12 / SHARE.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Budget: the share of rays that may end in another texel than the ray as given, 0 to 1.
    #[arg(long, value_name = "SHARE", allow_negative_numbers = true, conflicts_with = "max_uv_error")]
    pub max_wrong_texel: Option<f64>,
    /// Budget: how far 99 % of the hits may lie from the exact ones, in texels; of all views together.
    #[arg(long, value_name = "TEXELS", allow_negative_numbers = true)]
    pub max_uv_error: Option<f64>,
    /// The map itself may become coarser: fewer levels, fewer bits a height.
    #[arg(long)]
    pub allow_resample: bool,
    /// Block memories of 18 kbit that the heights may take, at most (an ECP5-85 has 208)
    #[arg(long, value_name = "N", value_parser = block_memories, allow_negative_numbers = true)]
    pub block_memories: Option<u64>,
    /// Where the configuration of the design goes.
    #[arg(long, value_name = "FILE.toml")]
    pub out: Option<PathBuf>,
}

/// Options of `hard`.
#[derive(Args, Debug)]
pub struct HardArgs {
    /// A map: the cases' rays on it, instead of on maps of their own. Views and rays: these on the map (the configured one without), instead of
    /// the cases, or beside those of `--case`. A number after `--rays`: rays of each case and view (200 without).
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Lists the cases and what they aim at, and runs none.
    #[arg(long)]
    pub list: bool,
    /// Only these cases.
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    pub case: Vec<String>,
    /// Seed of maps and rays.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Asks one thing only, of this many rays in all: does every ray end? They are dealt over the cases, and in each over all modes.
    #[arg(long, value_name = "RAYS", conflicts_with_all = ["pictures", "engine"])]
    pub endure: Option<usize>,
    /// What traces the rays beside the golden model, whose hits it must equal.
    #[arg(long, default_value = "golden")]
    pub engine: EngineName,
    /// Writes a picture of each case into this directory.
    #[arg(long, value_name = "DIR")]
    pub pictures: Option<PathBuf>,
}

/// Options of `bench`.
#[derive(Args, Debug)]
pub struct BenchArgs {
    /// How often each engine is measured, in turns with the others.
    #[arg(long, default_value_t = 5, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub turns: u32,
    /// Map, views and rays; the configured map and the oblique view without. A number after `--rays`: how many rays in all (20000 without);
    /// fewer are taken over and over.
    #[command(flatten)]
    pub scene: SceneArgs,
}

/// Options of `synth`.
#[derive(Args, Debug)]
pub struct SynthArgs {
    /// Units, or all.
    #[arg(long, default_value = "all", value_delimiter = ',', value_name = "NAME", value_parser = unit_name)]
    pub unit: Vec<String>,
    /// What they are mapped to; ecp5, or where `--liberty` names cells, those.
    #[arg(long)]
    pub target: Option<SynthTarget>,
    /// The cells they are mapped to.
    #[arg(long, value_name = "FILE.lib")]
    pub liberty: Option<PathBuf>,
    /// Seeds of the placer; the median counts.
    #[arg(long, default_value = "1,2,3", value_delimiter = ',', value_name = "N")]
    pub seeds: Vec<u32>,
    /// Clock that the placer is asked for, in MHz.
    #[arg(long, default_value_t = 300, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub freq: u32,
    /// How much the placer cares for time rather than for the length of wires; nextpnr's own is 10.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub timing_weight: Option<u32>,
    /// How many of a unit stand beside each other; what joins their outputs counts with them.
    #[arg(long, default_value_t = 1, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=16))]
    pub copies: u32,
    /// Measures each unit of arithmetic at these latencies instead of the configured one.
    #[arg(long, value_delimiter = ',', value_name = "CLOCKS")]
    pub latency: Vec<u32>,
    /// Foreign Verilog in the same run: the module TOP, with registers of its own around what counts, of the files in DIR.
    #[arg(long, value_delimiter = ',', value_name = "TOP=DIR")]
    pub beside: Vec<String>,
    /// Where the figures go, each with the call that measures it again, the tools' versions, and a digest of the text that was measured.
    #[arg(long, default_value = "synth.json", value_name = "FILE.json")]
    pub out: PathBuf,
    /// Measures nothing, and lists the figures of a file that are of another text than the one that is emitted now; exit code 1 if there are any.
    #[arg(long, value_name = "FILE.json", conflicts_with = "refresh")]
    pub stale: Option<PathBuf>,
    /// Measures again what `--stale` lists (of the units of `--unit`), one after the other, in the file itself; a run that was stopped goes on.
    #[arg(long, value_name = "FILE.json")]
    pub refresh: Option<PathBuf>,
}

/// What a unit is mapped to.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum SynthTarget {
    /// Lattice ECP5: area and clock.
    Ecp5,
    /// Lattice iCE40: area.
    Ice40,
    /// Xilinx Virtex-6: area and depth.
    Xilinx,
    /// The cells of a Liberty file: area and depth.
    Liberty,
}
