//! Parameters given from outside, as a user's flow would: illegal ones end elaboration with a sentence in a name, and
//! legal ones elaborate as cleanly as the defaults.
use super::configs::{Emitted, extra};
use super::no_problems;
use super::tools::{Said, Tool, run};
use crate::budget::share;
use rayon::prelude::*;
use reliefrtl::ir::{Binding, Module};

const TOOLS: [Tool; 3] = [Tool::Icarus, Tool::Verilator, Tool::VerilatorNew];

/// Elaborates one module of the default configuration with every unit, at other parameters; `None` without tools.
fn elaborate(tool: Tool, m: &Module, values: &Binding) -> Option<Said> {
    let e: &Emitted = extra();
    let mut c = tool.command()?;
    let name = format!("{}{}", e.config.emit.prefix, m.name);
    match tool {
        Tool::Icarus => {
            c.args(values.iter().map(|(k, v)| format!("-P{name}.{k}={v}"))).args(["-s", &name]);
        }
        _ => {
            c.args(values.iter().map(|(k, v)| format!("-G{k}={v}"))).args(["--top-module", &name]);
        }
    }
    Some(run(c.args(["-y", "rtl", &format!("rtl/{name}.v")]), &e.dir))
}

fn binding(values: &[(&str, i64)]) -> Binding {
    values.iter().map(|(k, v)| ((*k).to_owned(), *v)).collect()
}

fn label(m: &Module, values: &Binding) -> String {
    let list: Vec<String> = values.iter().map(|(k, v)| format!("{k}={v}")).collect();
    format!("{} {}", m.name, list.join(" "))
}

fn module(name: &str) -> &'static Module {
    extra().modules.iter().find(|m| m.name == name).unwrap_or_else(|| panic!("no module is named {name}"))
}

/// One value for each condition of a module, chosen so that this condition fails; a single parameter is changed.
fn violations(m: &Module) -> Vec<Binding> {
    let mut out: Vec<Binding> = Vec::new();
    for check in &m.checks {
        let fails = |b: &Binding| {
            let b = m.binding_with(b);
            check.lhs.eval_wide(&b) > check.rhs.eval_wide(&b)
        };
        // The nearest values first: a bound that is off by one must show.
        let near = |p: i64| [p - 1, p + 1].into_iter().chain((0..=64).flat_map(move |k| [p - k, p + k]));
        let tries = m.params.iter().flat_map(|p| near(p.default).chain([0, 1, 65536]).map(move |v| (p, v)));
        let mut found: Vec<(i64, Binding)> =
            tries.map(|(p, v)| ((v - p.default).abs(), binding(&[(&p.name, v)]))).filter(|(_, b)| fails(b)).collect();
        found.sort_by_key(|(distance, _)| *distance);
        let (_, least) = found
            .into_iter()
            .next()
            .unwrap_or_else(|| panic!("{}: no value of one parameter breaks {} <= {}", m.name, check.lhs, check.rhs));
        if !out.contains(&least) {
            out.push(least);
        }
    }
    out
}

#[test]
fn illegal_parameters_end_elaboration_with_the_rule() {
    let named =
        [("fp_add", "EXP_W", 1), ("traverse", "LEVELS", 13), ("fp_mul", "MAN_W", 29), ("traverse", "HEIGHT_W", 1)];
    let named = named.map(|(m, p, v)| (module(m), binding(&[(p, v)])));
    let by_condition = extra().modules.iter().flat_map(|m| violations(m).into_iter().map(move |b| (m.as_ref(), b)));
    let mut problems = Vec::new();
    let mut refused = 0;
    for (i, (m, values)) in named.into_iter().chain(by_condition).enumerate() {
        // Icarus refuses each of them; the slower ones, those that are named above.
        for tool in &TOOLS[..if i < 4 { 3 } else { 1 }] {
            let Some(said) = elaborate(*tool, m, &values) else { return };
            refused += 1;
            if said.ok || !said.text.contains("_must_be_at_") {
                problems.push(said.problem(&label(m, &values)));
            }
        }
    }
    no_problems(&problems);
    println!("{refused} illegal elaborations were refused");
    assert!(refused > 80, "only {refused} elaborations were tried");
}

#[test]
fn the_same_text_elaborates_cleanly_at_other_parameters() {
    let mut cases: Vec<(&Module, Binding)> = Vec::new();
    for m in &extra().modules {
        for (exp, man) in [(5, 10), (8, 23), (4, 3)] {
            let values = binding(&[("EXP_W", exp), ("MAN_W", man)]);
            let has_format = m.params.iter().any(|p| p.name == "EXP_W");
            if has_format && m.failed_checks(&m.binding_with(&values)).is_empty() && m.name != "traverse" {
                cases.push((m, values));
            }
        }
    }
    let arithmetic = cases.iter().filter(|(m, _)| m.name.starts_with("fp_")).count();
    assert_eq!(arithmetic, 12 * 3, "every arithmetic unit at three formats");
    let traverse = module("traverse");
    for levels in 2..=12 {
        for height in [8, 16] {
            cases.push((traverse, binding(&[("LEVELS", levels), ("HEIGHT_W", height)])));
        }
    }
    cases.push((traverse, binding(&[("EXP_W", 8), ("MAN_W", 23), ("LEVELS", 10), ("HEIGHT_W", 12), ("TILE_W", 2)])));
    cases.push((traverse, binding(&[("TAG_W", 1), ("FRAC_W", 1), ("STEP_LIMIT", 1), ("TILE_W", 1)])));
    // Icarus is asked about all; of the slower ones the current Verilator about some, Debian's, which knows less, about fewer.
    let asked = |k: usize, tool: Tool| match tool {
        Tool::Verilator => k.is_multiple_of(share(5)),
        Tool::VerilatorNew => k.is_multiple_of(share(2)),
        _ => true,
    };
    let all = cases.iter().enumerate().flat_map(|(k, case)| TOOLS.map(|tool| (k, tool, case)));
    let runs: Vec<_> = all.filter(|(k, tool, _)| asked(*k, *tool)).map(|(_, tool, case)| (tool, case)).collect();
    let one = |(tool, (m, values)): &(Tool, &(&Module, Binding))| {
        elaborate(*tool, m, values).map(|said| said.unless_silent(&label(m, values)))
    };
    let Some(said) = runs.par_iter().map(one).collect::<Option<Vec<_>>>() else { return };
    no_problems(&said.into_iter().flatten().collect::<Vec<_>>());
    println!("{} elaborations at other parameters, in {} tools", runs.len(), TOOLS.len());
    assert!(cases.len() >= 24 + 22);
}
