//! The hardware: operations, units and whole traversals in the interpreter, Icarus and Verilator against the golden model.
mod bench_faults;
mod bilinear_rtl;
mod cells;
mod checked;
mod corners;
mod counters;
mod cut_out;
mod engines;
mod exit_status;
mod fixed;
mod hard_rtl;
mod harness;
mod height_source;
mod lanes;
mod module_rules;
mod one_op;
mod ops;
mod preload;
mod profiles;
mod published;
mod streams;
mod tracked;
mod traverse_interp;
mod units_interp;
mod unknown;
mod windows;

#[path = "../support/budget.rs"]
mod budget;
#[path = "../support/files.rs"]
mod files;
#[path = "../support/simulators.rs"]
mod simulators;
