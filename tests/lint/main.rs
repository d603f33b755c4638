//! Every emitted file against simulators, a synthesizer, linters, a parser and our own rules of style.
//!
//! One run per tool and configuration covers all of that configuration's files. `sh tools/test.sh` installs the tools;
//! `RELIEFRTL_NO_SIMULATORS=1` leaves these checks out.
mod benches;
mod configs;
mod elaboration;
mod linters;
mod names;
mod parse;
mod style;
mod text;
mod tools;
mod trees;

#[path = "../support/budget.rs"]
mod budget;
#[path = "../support/files.rs"]
mod files;
#[path = "../support/simulators.rs"]
mod simulators;

/// Fails with the first problems of a long list, all of them counted.
pub fn no_problems(problems: &[String]) {
    let shown: Vec<&str> = problems.iter().take(25).map(String::as_str).collect();
    assert!(problems.is_empty(), "{} problems, among them\n{}", problems.len(), shown.join("\n"));
}
