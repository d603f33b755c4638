//! `emit.counters`: every datapath with each choice of counters gives the golden model's hits, and what is left out is in no port and no register.
//! A missing simulator fails these tests (`tools/test.sh` installs them) unless RELIEFRTL_NO_SIMULATORS=1.
use crate::files::write;
use crate::simulators::skip;
use reliefrtl::bench::{Simulator, harness_text};
use reliefrtl::config::{Config, Counters, Profile, View};
use reliefrtl::engine::EngineName;
use reliefrtl::golden::{RayInput, prepare};
use reliefrtl::interp::Traffic;
use reliefrtl::ir::Binding;
use reliefrtl::measure::Cost;
use reliefrtl::project::{Scene, check_tree, encode, hardware, project};
use reliefrtl::trace::{Pipeline, hit, hit_row, refused, said};
use reliefrtl::units::traversal::traverse;

/// Datapaths and modes: those that carry each word that says whether a ray crossed, and those that carry none.
const DESIGNS: [&str; 13] = [
    "",
    "mode.levels_down=1",
    "mode.levels_down=1 mode.level_up=none",
    "mode.level_up=coherent",
    "mode.trim=always mode.lod=true",
    "mode.trim=descent mode.level_up=none mode.levels_down=1",
    "mode.bilinear=true",
    "datapath.kind=published",
    "datapath.kind=published mode.levels_down=1 mode.start_level=false",
    "datapath.kind=fixed",
    "fetch.cells=4",
    "datapath.kind=fixed fetch.cells=4 mode.trim=always mode.levels_down=1 mode.levels_down_after=1",
    "datapath.kind=fixed datapath.search=windows",
];

fn config(sets: &str, counters: Counters) -> Config {
    let mut c = Config::default();
    sets.split_whitespace().chain(["traverse.levels=4"]).for_each(|set| c.apply_set(set).unwrap());
    c.latency = Profile::Published.latency_for(&c.design());
    c.emit.counters = counters;
    (c.view.width, c.view.height, c.view.stride) = (64, 48, 2);
    (c.vectors.arithmetic, c.vectors.rays) = (60, 30);
    c.validate().unwrap();
    c
}

/// Rays of a view, some that are refused, and some that end at the step limit.
fn rays(c: &Config, scene: &Scene) -> Vec<RayInput> {
    let rays: Vec<RayInput> =
        scene.view(c, View::Grazing, c.view.stride).unwrap().iter().map(|r| encode(c, r)).collect();
    let far = if c.design().words().float().is_some() { u64::MAX } else { 1 << 63 };
    let m = traverse(&c.design()).module;
    let width = 64 - m.port("in_du").unwrap().1.width.eval(&m.default_binding());
    let none: Vec<RayInput> = rays.iter().take(4).map(|r| RayInput { du: far >> width, ..*r }).collect();
    [rays, none].concat()
}

#[test]
fn each_choice_gives_the_same_hits_with_fewer_words() {
    let mut compared = 0;
    for sets in DESIGNS {
        let mut whole: Vec<Vec<u64>> = Vec::new();
        for counters in Counters::ALL {
            let mut c = config(sets, counters);
            c.traverse.step_limit = 9;
            let d = c.design();
            let scene = Scene::new(&c, None, false).unwrap();
            let rays = rays(&c, &scene);
            let golden = prepare(&d).unwrap();
            let p = Pipeline::new(&d, &Binding::new()).unwrap();
            let ports = ["out_steps", "out_crossings", "out_ups"].map(|port| p.outputs.contains(&port));
            let levels = d.datapath.kind.facts().counts_levels && counters == Counters::All;
            assert_eq!(ports, [counters != Counters::None, levels, levels], "{sets} {counters}");
            let traffic = Traffic { gaps: 60, stalls: 90, resets: 2, seed: 5 };
            let run = p.run(&scene.pyramid, &rays, 16, traffic).unwrap();
            let hits: Vec<_> = rays.iter().map(|r| golden.trace(&scene.pyramid, r)).collect();
            for (k, (row, h)) in run.results.iter().zip(&hits).enumerate() {
                assert_eq!((row, hit(&d, row)), (&hit_row(&d, h), said(&d, h)), "ray {k}, {sets} {counters}");
            }
            // Which were refused is known without steps, too.
            let told: Vec<_> = run.results.iter().map(|row| hit(&d, row)).collect();
            let none = refused(&d, &scene.pyramid, &rays, &told).unwrap();
            assert!(none.iter().zip(&hits).all(|(r, h)| *r == (h.steps == 0)), "{sets} {counters}");
            let given_up = hits.iter().filter(|h| h.limit && h.steps > 0).count();
            assert!(none.iter().filter(|r| **r).count() >= 4 && given_up > 0, "{sets}: {given_up} given up");
            // All other words are those of the design with all counters.
            let at = |names: &[&str], name: &str| names.iter().position(|n| *n == name).unwrap();
            let all = Pipeline::new(&config(sets, Counters::All).design(), &Binding::new()).unwrap().outputs;
            if whole.is_empty() {
                whole.clone_from(&run.results);
            }
            for name in &p.outputs {
                let (here, there) = (at(&p.outputs, name), at(&all, name));
                assert!(
                    run.results.iter().zip(&whole).all(|(a, b)| a[here] == b[there]),
                    "{name} of {sets} {counters}"
                );
            }
            compared += rays.len();
        }
    }
    println!("0 of {compared} mismatched");
    assert!(compared > 39 * 20);
}

/// Bits of registers in the default design with each choice: those of `docs/traverse.md`.
#[test]
fn what_is_left_out_has_no_registers() {
    let registers = Counters::ALL.map(|counters| {
        let d = reliefrtl::config::Design { counters, ..Default::default() };
        Cost::of(&d).unwrap().registers
    });
    println!("{registers:?}");
    let page = include_str!("../../docs/traverse.md");
    for (counters, bits) in Counters::WORDS.iter().zip(registers) {
        let line = page.lines().find(|l| l.starts_with(&format!("| `\"{counters}\"`"))).unwrap_or_default();
        let share = 100.0 - 100.0 * bits as f64 / registers[0] as f64;
        let told = if share > 0.0 { format!("| {bits} ({share:.1} % fewer) |") } else { format!("| {bits} |") };
        assert!(line.contains(&told), "{counters}: {told} is not in {line:?}");
    }
}

/// Two trees in both simulators, in which no result says how long its ray took: under full load, and with gaps, stalls and resets.
#[test]
fn benches_without_steps_pass_in_both_simulators() {
    if skip() {
        return;
    }
    for sets in ["datapath.kind=published mode.levels_down=1", "datapath.kind=fixed datapath.search=windows"] {
        let c = config(sets, Counters::None);
        let dir = tempfile::tempdir().unwrap();
        write(dir.path(), &project(&c, &Scene::new(&c, None, false).unwrap()).unwrap().files);
        for sim in [Simulator::Icarus, Simulator::Verilator] {
            let done = check_tree(&c, dir.path(), sim.into(), &["traverse".into()], None, None, &|_| ()).unwrap();
            assert!(done.len() == 1 && done[0].rows > 300 && done[0].slots.is_some(), "{sets}");
        }
        // slot_busy is held against the iterations of the whole set: one that is 0 is noticed.
        let place = dir.path().join("rtl/relief_traverse.v");
        let text = std::fs::read_to_string(&place).unwrap();
        let line = text.lines().find(|l| l.contains("assign slot_busy")).unwrap();
        std::fs::write(&place, text.replace(line, "  assign slot_busy = 1'b0;")).unwrap();
        let icarus = EngineName::Icarus;
        let error = check_tree(&c, dir.path(), icarus, &["traverse".into()], None, None, &|_| ()).unwrap_err();
        assert!(error.to_string().contains("slot_busy was 0 while a ray was in its slot"), "{error}");
    }
}

/// With steps alone, the bench counts as ever.
#[test]
fn benches_with_steps_alone_pass_in_both_simulators() {
    if skip() {
        return;
    }
    for sets in ["mode.trim=always", "fetch.cells=4"] {
        let mut c = config(sets, Counters::Steps);
        c.vectors.planned = false;
        let dir = tempfile::tempdir().unwrap();
        write(dir.path(), &project(&c, &Scene::new(&c, None, false).unwrap()).unwrap().files);
        for sim in [Simulator::Icarus, Simulator::Verilator] {
            let done = check_tree(&c, dir.path(), sim.into(), &["traverse".into()], None, None, &|_| ()).unwrap();
            assert!(done[0].rows > 30 && done[0].slots.is_some(), "{sets}");
        }
    }
}

/// What `bench` compares with reads the outputs that there are.
#[test]
fn the_harness_reads_no_counter_that_is_left_out() {
    for (counters, names) in [(Counters::All, 3), (Counters::Steps, 1), (Counters::None, 0)] {
        let c = config("", counters);
        let h = hardware(&c).unwrap();
        let text = harness_text(&c.design(), &h.traverse.module, "relief_traverse");
        let there = ["out_steps", "out_crossings", "out_ups"].iter().filter(|n| text.contains(**n)).count();
        assert_eq!((there, text.contains("out_limit")), (names, true), "{counters}");
    }
}
