//! What can be typed.
use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

/// Generates Verilog that traces rays against height fields, with golden vectors and an interpreter of the same datapath.
#[derive(Parser, Debug)]
#[command(name = "reliefrtl", version, about, after_help = EXIT_CODES)]
pub struct Cli {
    /// Configuration file (TOML); `reliefrtl config --print` shows every key.
    #[arg(long, global = true, value_name = "FILE.toml")]
    pub config: Option<PathBuf>,
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
6 an expected result never came, 7 a result that nobody expected.";

/// The verbs.
#[derive(Subcommand, Debug)]
pub enum Verb {
    /// Writes the Verilog and manifest.json.
    Emit(EmitArgs),
    /// Lists the units with their parameters and latency.
    List,
    /// Prints the configuration or its schema.
    Config(ConfigArgs),
    /// Traces rays from a CSV file.
    Trace(TraceArgs),
    /// Prints a completion script for a shell.
    Completions {
        /// The shell.
        shell: clap_complete::Shell,
    },
}

/// Options of `emit`.
#[derive(Args, Debug)]
pub struct EmitArgs {
    /// Directory to write to.
    #[arg(long, default_value = "out", value_name = "DIR")]
    pub out: PathBuf,
    /// Only this unit and what it needs.
    #[arg(long, value_name = "NAME")]
    pub unit: Option<String>,
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

/// The height map of a verb.
#[derive(Args, Debug)]
pub struct MapArgs {
    /// Height map: PNG, PGM, TIFF or EXR; without it the configured one.
    #[arg(long, value_name = "FILE")]
    pub map: Option<PathBuf>,
    /// Resamples the map (size and bit depth) to what the configuration asks for.
    #[arg(long)]
    pub resample: bool,
}

/// Options of `trace`.
#[derive(Args, Debug)]
pub struct TraceArgs {
    /// The height map.
    #[command(flatten)]
    pub map: MapArgs,
    /// Rays: a CSV file with the columns u, v, du, dv.
    #[arg(long, value_name = "R.csv")]
    pub rays: PathBuf,
    /// What traces them.
    #[arg(long, default_value = "interp")]
    pub engine: Engine,
    /// Where the hits go.
    #[arg(long, value_name = "H.csv")]
    pub out: PathBuf,
}

/// What runs the datapath.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum Engine {
    /// The bit-accurate model.
    Golden,
    /// The embedded interpreter of the emitted datapath.
    Interp,
    /// Icarus Verilog.
    Icarus,
    /// Verilator.
    Verilator,
}
