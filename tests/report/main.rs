//! Figures: the report, fitted designs, rates over scenes, areas and clocks.
mod coverage;
mod fit;
mod flow;
mod netlist;
mod page;
mod rates;
mod synth;
mod tables;

#[path = "../support/budget.rs"]
mod budget;
#[path = "../support/files.rs"]
mod files;
#[path = "../support/program.rs"]
mod program;
#[path = "../support/simulators.rs"]
mod simulators;
