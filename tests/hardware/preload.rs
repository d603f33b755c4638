//! The map at power-up: `MEM_INIT` names what `vectors` wrote, nothing goes through the load port, and the hits are the same.
use crate::simulators::skip;
use reliefrtl::config::{Config, Profile};
use reliefrtl::project::{Scene, project};
use std::path::Path;
use std::process::Command;

/// A tree whose images of the map stand in another place than the bench would look for them.
fn tree(dir: &Path, sets: &[&str]) -> String {
    // Few registers: what a memory holds does not depend on them.
    let mut c = Config::default();
    c.latency = Profile::Published.latency(c.datapath.kind);
    let few = [
        "traverse.levels=4",
        "vectors.rays=10",
        "vectors.planned=false",
        "vectors.arithmetic=20",
        "traverse.step_limit=500",
    ];
    few.iter().chain(sets).for_each(|set| c.apply_set(set).unwrap());
    c.validate().unwrap();
    let files = project(&c, &Scene::new(&c, None, false).unwrap()).unwrap().files;
    for (path, text) in &files {
        let place = dir.join(path.replace("golden/traverse/memory.hex", "map/memory.hex"));
        std::fs::create_dir_all(place.parent().unwrap()).unwrap();
        std::fs::write(place, text).unwrap();
    }
    c.emit.prefix
}

fn run(dir: &Path, program: &str, args: &[&str]) -> (Option<i32>, String) {
    let out = Command::new(program).args(args).current_dir(dir).output().unwrap_or_else(|e| panic!("{program}: {e}"));
    (out.status.code(), String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr))
}

#[test]
fn a_preloaded_map_is_the_loaded_one() {
    if skip() {
        return;
    }
    for sets in [
        &["latency.memory=1"][..],
        &["latency.memory=2"],
        &["latency.memory=4", "datapath.kind=fixed"],
        &["mode.bilinear=true"],
        &["datapath.kind=published"],
    ] {
        let dir = tempfile::tempdir().unwrap();
        let p = tree(dir.path(), sets);
        let (tb, top) = (format!("testbench/{p}tb_traverse.v"), format!("{p}tb_traverse_top"));
        let top_file = format!("testbench/{top}.v");
        let build = |map: &str| {
            let map = format!("-P{top}.MEM_INIT=\"{map}\"");
            let line = ["-g2005", "-Wall", "-y", "rtl", "-s", &top, &map, "-o", "tb.vvp", &tb, &top_file];
            let (code, said) = run(dir.path(), "iverilog", &line);
            assert!(code == Some(0) && said.is_empty(), "{sets:?}: {said}");
            run(dir.path(), "vvp", &["-n", "tb.vvp"])
        };
        let (code, said) = build("map/memory.hex");
        assert!(code == Some(0) && said.contains("PASS") && said.contains(": 0 of "), "{sets:?}: {said}");
        // Without a map there is nothing to load either.
        assert_eq!(build("").0, Some(2), "{sets:?}");
        // Another map, other hits.
        for name in ["memory.hex", "memory.hex.0"] {
            let place = dir.path().join("map").join(name);
            if let Ok(text) = std::fs::read_to_string(&place) {
                let low: String =
                    text.lines().map(|l| if l.starts_with('/') { l } else { "00" }).map(|l| format!("{l}\n")).collect();
                std::fs::write(&place, low).unwrap();
                let (code, said) = build("map/memory.hex");
                assert_eq!(code, Some(1), "{sets:?} {name}: {said}");
                std::fs::write(&place, text).unwrap();
            }
        }
    }
}

#[test]
fn a_preloaded_map_is_the_loaded_one_in_verilator() {
    if skip() {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    let p = tree(dir.path(), &["mode.bilinear=true"]);
    let (tb, name) = (format!("testbench/{p}tb_traverse.v"), format!("{p}tb_traverse"));
    let head = [
        "--cc",
        "--exe",
        "--build",
        "-Wno-lint",
        "--prefix",
        "Vtb",
        "--output-split",
        "1000000000",
        "-MAKEFLAGS",
        "OPT_FAST=-O0",
        "-MAKEFLAGS",
        "OPT_SLOW=-O0",
    ];
    let rest =
        ["-GMEM_INIT=\"map/memory.hex\"", "--top-module", &name, "-y", "rtl", &tb, "testbench/verilator_main.cpp"];
    let (code, said) = run(dir.path(), "verilator", &[&head[..], &rest].concat());
    assert_eq!(code, Some(0), "{said}");
    let (code, said) = run(dir.path(), "obj_dir/Vtb", &[]);
    assert!(code == Some(0) && said.contains(": 0 of "), "{said}");
}
