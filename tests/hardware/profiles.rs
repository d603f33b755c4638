//! Latencies by name and for a clock: the same hits, in all engines, whatever stands between the units.
use crate::budget::share;
use crate::simulators::skip;
use std::path::Path;
use std::process::{Command, Output};

fn reliefrtl(dir: &Path, line: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_reliefrtl")).args(line).current_dir(dir).output().expect("the program runs")
}

fn ok(dir: &Path, line: &[&str]) -> String {
    let out = reliefrtl(dir, line);
    let said = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
    assert!(out.status.success(), "{line:?}: {said}");
    said
}

/// Every traversal is built, and every vector checked by the interpreter.
#[test]
fn each_profile_traces_the_same_rays_on_each_datapath() {
    let dir = tempfile::tempdir().unwrap();
    for (k, kind) in ["watertight", "fixed", "published"].into_iter().enumerate() {
        let mut hits = Vec::new();
        // In the usual run each datapath at the default latencies and in one of the profiles, each in another.
        let profiles = ["published", "balanced", "fast"].into_iter().skip(k % share(3)).step_by(share(3));
        for profile in std::iter::once(None).chain(profiles.map(Some)) {
            let kind = format!("datapath.kind={kind}");
            let chosen: Vec<&str> = profile.into_iter().flat_map(|p| ["--profile", p]).collect();
            // The published datapath has rays that never end by themselves.
            let few = [
                "traverse.levels=4",
                "vectors.rays=40",
                "vectors.planned=false",
                "vectors.arithmetic=40",
                "traverse.step_limit=500",
                "view.width=64",
                "view.height=48",
                "view.stride=1",
            ];
            let few: Vec<&str> = few.into_iter().flat_map(|s| ["--set", s]).collect();
            let said = ok(dir.path(), &[&["build", "--out", "out", "--set", &kind][..], &few, &chosen].concat());
            assert!(said.contains("traverse         0 of 120 mismatched"), "{said}");
            hits.push(std::fs::read_to_string(dir.path().join("out/golden/traverse/expected.hex")).unwrap());
        }
        assert!(hits.windows(2).all(|w| w[0] == w[1]), "{kind}: another latency, another hit");
    }
}

/// Banks of memory, registers around every choice, and handshakes through registers, in the simulators; with gaps, stalls and flood.
#[test]
fn the_deepest_pipeline_is_the_same_in_the_simulators() {
    if skip() {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    // Two levels: the memory has fewer words than a bank. Verilator takes half a minute to compile one, which is left to the full run.
    let both = &["icarus", "verilator"][..if share(2) == 1 { 2 } else { 1 }];
    // The whole map goes through the load port, clock by clock.
    let levels = if share(2) == 1 { "traverse.levels=6" } else { "traverse.levels=4" };
    for (mode, levels, engines) in [
        (&["--set", "mode.trim=always", "--set", "mode.lod=true"][..], levels, both),
        (&["--set", "mode.bilinear=true"], "traverse.levels=2", &["icarus"]),
    ] {
        let few =
            ["vectors.rays=14", "vectors.planned=false", "vectors.arithmetic=40", "view.width=64", "view.height=48"];
        let few: Vec<&str> = few.into_iter().flat_map(|s| ["--set", s]).collect();
        let design = [&["--profile", "fast", "--set", levels][..], &few, mode].concat();
        ok(dir.path(), &[&["build", "--out", "out"][..], &design].concat());
        for engine in engines {
            let said = ok(dir.path(), &[&["check", "--unit", "traverse", "--engine", engine][..], &design].concat());
            assert!(said.contains("0 of 42 mismatched"), "{said}");
        }
    }
}

/// What a bench says of iterations does not depend on where the pipeline has its registers.
#[test]
fn a_bench_sees_the_iterations_of_each_profile() {
    if skip() {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    for (profile, kind) in
        [("published", "watertight"), ("balanced", "fixed"), ("fast", "watertight"), ("fast", "published")]
    {
        let kind = format!("datapath.kind={kind}");
        let few = [
            "vectors.rays=10",
            "vectors.planned=false",
            "traverse.levels=4",
            "traverse.step_limit=500",
            "view.width=64",
            "view.height=48",
        ];
        let few: Vec<&str> = few.into_iter().flat_map(|s| ["--set", s]).collect();
        let line = ["check", "--unit", "traverse", "--engine", "icarus", "--canary", "flip", "--profile", profile];
        let out = reliefrtl(dir.path(), &[&line[..], &["--set", &kind], &few].concat());
        let said = String::from_utf8_lossy(&out.stderr).into_owned();
        assert_eq!(out.status.code(), Some(1), "{said}");
        assert!(
            said.contains("iterations are right: the fault is in what follows the loop"),
            "{profile}, {kind}: {said}"
        );
    }
}

#[test]
fn a_clock_picks_latencies_and_says_how_sure_it_is() {
    let dir = tempfile::tempdir().unwrap();
    let slow = ok(dir.path(), &["config", "--print", "--clock", "40"]);
    let fast = ok(dir.path(), &["config", "--print", "--clock", "100", "--set", "latency.add=6"]);
    assert!(slow.contains("add = 1") && slow.contains("clock_mhz = 40"), "{slow}");
    assert!(fast.contains("add = 6") && fast.contains("clock_mhz = 100"), "{fast}");
    assert!(fast.contains("other devices were not measured"), "{fast}");
    let slowed = ok(dir.path(), &["config", "--print", "--clock", "100", "--set", "latency.add=1"]);
    assert!(slowed.contains("fp_add in 1 clock, reached ") && slowed.contains("less than 100"), "{slowed}");
    let alone = ok(dir.path(), &["emit", "--unit", "fp_add", "--clock", "200", "--set", "format.exp=8"]);
    assert!(
        alone.contains("fp_add in ")
            && alone.contains(" clocks alone reached 2")
            && alone.contains("nor was this format"),
        "{alone}"
    );
    for (line, words) in [
        (&["config", "--print", "--clock", "900"][..], "at most --clock 1"),
        (&["config", "--print", "--clock", "90", "--profile", "fast"], "cannot be used with"),
        (&["config", "--print", "--profile", "quick"], "published"),
        (&["config", "--print", "--clock", "90", "--set", "emit.clock_mhz=50"], "ask for two clocks"),
        (&["emit", "--unit", "fp_add3", "--clock", "290"], "needs fp_add3 at 290 MHz"),
    ] {
        let out = reliefrtl(dir.path(), line);
        let said = String::from_utf8_lossy(&out.stderr).into_owned();
        assert_eq!(out.status.code(), Some(2), "{said}");
        assert!(said.contains(words), "{said}");
    }
}
