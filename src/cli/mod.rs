//! The command line: verbs, shared options, exit codes.
#[macro_use]
mod print;
mod accuracy;
mod args;
mod bench;
mod build;
mod check;
mod checked;
mod config;
mod emit;
mod fit;
mod hard;
mod interrupt;
mod list;
mod load;
mod lost;
mod output;
mod prove;
mod render;
mod report;
mod shell;
mod steps;
mod synth;
mod trace;
mod vectors;
mod views;

pub use args::Cli;

use crate::error::{Error, Result, exit};
use crate::files::STANDARD_OUTPUT;
use args::Verb;
use clap::{CommandFactory, Parser};
use std::io::IsTerminal;

/// Runs the command line; returns the exit code (0 ok, 1 mismatch, 2 usage or input, 3 tool missing, 4 tool failed,
/// 5 nothing ran, 6 a result never came, 7 a result too many, 128 and the number of a signal that ended it, 141 standard output was closed before its
/// end).
pub fn main() -> i32 {
    interrupt::watch();
    output::for_machines(std::env::args_os().skip(1).take_while(|a| a != "--").any(|a| a == "--json"));
    let mut cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(e) => {
            if e.use_stderr() {
                output::usage(&e);
                return exit::USAGE;
            } else {
                let coloured =
                    std::io::stdout().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|no| no.is_empty());
                if coloured {
                    print!("{}", e.render().ansi());
                } else {
                    print!("{}", e.render());
                }
                return print::finish(exit::OK, output::error);
            }
        }
    };
    cli.verb.once();
    let code = match run(&cli) {
        Ok(()) => exit::OK,
        // Whoever read standard output (`--out - | head`) has gone, and did not get all of the result.
        Err(Error::File { path, source, .. })
            if path.as_os_str() == STANDARD_OUTPUT && source.kind() == std::io::ErrorKind::BrokenPipe =>
        {
            exit::READER_GONE
        }
        Err(e) => {
            output::error(&e);
            e.exit_code()
        }
    };
    let code = print::finish(code, output::error);
    // Its handler ends the process, with another code.
    while crate::process::stopping() {
        std::thread::sleep(std::time::Duration::from_secs(1));
    }
    crate::process::end();
    code
}

fn run(cli: &Cli) -> Result<()> {
    match &cli.verb {
        Verb::Build(a) => build::run(cli, a),
        Verb::Emit(a) => emit::run(cli, a),
        Verb::Vectors(a) => vectors::run(cli, a),
        Verb::Check(a) => check::run(cli, a),
        Verb::Prove(a) => prove::run(cli, a),
        Verb::Trace(a) => trace::run(cli, a),
        Verb::Render(a) => render::run(cli, a),
        Verb::Steps(a) => steps::run(cli, a),
        Verb::Accuracy(a) => accuracy::run(cli, a),
        Verb::Report(a) => report::run(cli, a),
        Verb::Fit(a) => fit::run(cli, a),
        Verb::Hard(a) => hard::run(cli, a),
        Verb::Bench(a) => bench::run(cli, a),
        Verb::Synth(a) => synth::run(cli, a),
        Verb::List => list::run(cli),
        Verb::Config(a) => config::run(cli, a),
        Verb::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(*shell, &mut Cli::command(), "reliefrtl", &mut script);
            print!("{}", String::from_utf8_lossy(&script));
            Ok(())
        }
    }
}
