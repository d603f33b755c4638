//! The command line: verbs, shared options, exit codes.
mod args;
mod build;
mod check;
mod config;
mod emit;
mod endless;
mod figures;
mod fit;
mod hard;
mod list;
mod output;
mod prove;
mod rates;
mod refined;
mod render;
mod report;
mod restate;
mod synth;
mod trace;

pub use args::Cli;

use crate::error::{Result, exit};
use args::Verb;
use clap::{CommandFactory, Parser};

/// Runs the command line; returns the exit code (0 ok, 1 mismatch, 2 usage or input, 3 tool missing, 4 tool failed,
/// 5 nothing ran, 6 a result never came, 7 a result too many).
pub fn main() -> i32 {
    // An interrupted run leaves nothing behind. Without a handler it ends all the same.
    let _ = ctrlc::set_handler(|| {
        output::interrupted();
        crate::files::abandon(130)
    });
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(e) => {
            let code = if e.use_stderr() { exit::USAGE } else { exit::OK };
            let _ = e.print();
            return code;
        }
    };
    match run(&cli) {
        Ok(()) => exit::OK,
        Err(e) => {
            output::error(&cli, &e);
            e.exit_code()
        }
    }
}

fn run(cli: &Cli) -> Result<()> {
    match &cli.verb {
        Verb::Build(a) => build::run(cli, a),
        Verb::Emit(a) => emit::run(cli, a),
        Verb::Vectors(a) => build::vectors(cli, a),
        Verb::Check(a) => check::run(cli, a),
        Verb::Prove(a) => prove::run(cli, a),
        Verb::Trace(a) => trace::run(cli, a),
        Verb::Render(a) => render::run(cli, a),
        Verb::Steps(a) => figures::steps(cli, a),
        Verb::Accuracy(a) => figures::accuracy(cli, a),
        Verb::Report(a) => report::run(cli, a),
        Verb::Fit(a) => fit::run(cli, a),
        Verb::Hard(a) => hard::run(cli, a),
        Verb::Bench(a) => figures::bench(cli, a),
        Verb::Synth(a) => synth::run(cli, a),
        Verb::List => list::run(cli),
        Verb::Config(a) => config::run(cli, a),
        Verb::Completions { shell } => {
            clap_complete::generate(*shell, &mut Cli::command(), "reliefrtl", &mut std::io::stdout());
            Ok(())
        }
    }
}
