//! Functions cut out of the emitted text of `traverse`, and texels altered in its memory image: the shipped vectors have to notice.
//! A missing simulator fails these tests (`tools/test.sh` installs them) unless RELIEFRTL_NO_SIMULATORS=1.
use crate::budget::share;
use crate::files::write;
use crate::simulators::skip;
use rayon::prelude::*;
use reliefrtl::bench::Simulator;
use reliefrtl::catalogue::planned_rays;
use reliefrtl::config::{Config, DatapathKind, LatencyConfig, ModeConfig, Trim};
use reliefrtl::golden::{address, prepare};
use reliefrtl::interp::Traffic;
use reliefrtl::ir::Binding;
use reliefrtl::project::{Scene, check_tree, project, ray_sets};
use reliefrtl::trace::{Pipeline, images, row};
use std::path::Path;

/// A map of 16 x 16 and a short pipeline.
fn small(handshake: u32) -> Config {
    let mut c = Config::default();
    (c.traverse.levels, c.vectors.arithmetic, c.vectors.rays) = (4, 60, 20);
    c.latency = LatencyConfig { add: 1, mul: 1, div: 1, compare: 1, from_int: 1, to_int: 1, handshake, ..short() };
    c
}

fn short() -> LatencyConfig {
    LatencyConfig { decision: 1, node: 1, memory: 1, select: 0, setup: 0, hit: 0, delay_line: 0, ..Default::default() }
}

fn tree(c: &Config) -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), project(c, &Scene::new(c, None, false).unwrap()).unwrap().files);
    dir
}

/// Changes the one line of a file below `dir` that holds `mark`: `from` becomes `to`.
fn edit(dir: &Path, file: &str, mark: &str, from: &str, to: &str) {
    let place = dir.join(file);
    let text = std::fs::read_to_string(&place).unwrap();
    assert_eq!(text.lines().filter(|l| l.contains(mark)).count(), 1, "{mark} in {file}");
    let lines = text.lines().map(|l| {
        assert!(!l.contains(mark) || l.contains(from), "{l}");
        if l.contains(mark) { l.replace(from, to) } else { l.to_string() }
    });
    std::fs::write(place, lines.collect::<Vec<_>>().join("\n") + "\n").unwrap();
}

/// In a file, the reset of the register that comes after `mark`.
fn keep_at_reset(dir: &Path, file: &str, mark: &str) {
    let place = dir.join(file);
    let text = std::fs::read_to_string(&place).unwrap();
    let at = text.find(mark).unwrap_or_else(|| panic!("{mark} in {file}"));
    let block = text[..at].rfind("if (rst)").expect("a reset");
    std::fs::write(place, format!("{}if (1'b0){}", &text[..block], &text[block + "if (rst)".len()..])).unwrap();
}

/// What is cut out, and how: the tree, and the handshake that it has.
type Cut = (&'static str, fn(&Path, u32));
const CUTS: &[Cut] = &[
    ("nothing", |_, _| ()),
    ("refusal of what is no ray", |dir, _| {
        edit(dir, "rtl/relief_traverse.v", "s0_new_refused =", "~new_ok", "1'b0");
    }),
    ("step limit", |dir, _| edit(dir, "rtl/relief_traverse.v", "_ends_now =", "_last_step;", "_last_step & 1'b0;")),
    ("back-pressure", |dir, handshake| match handshake {
        0 => edit(dir, "rtl/relief_traverse.v", "hit_ce =", "| out_ready", "| 1'b1"),
        _ => edit(dir, "rtl/relief_traverse.v", ".out_ready(out_ready)", "(out_ready)", "(1'b1)"),
    }),
    ("reset of the loop's valid bit", |dir, _| {
        let text = std::fs::read_to_string(dir.join("rtl/relief_traverse.v")).unwrap();
        let goes_on = text.lines().find(|l| l.contains("s0_loop_valid_q ") && l.contains("<= s")).unwrap();
        let cleared = text.lines().find(|l| l.contains("s0_loop_valid_q ") && l.contains("<= 1'b0;")).unwrap();
        edit(dir, "rtl/relief_traverse.v", cleared, cleared, goes_on);
    }),
    ("reset of the first stage of setup", |dir, _| keep_at_reset(dir, "rtl/relief_setup_delay.v", "s1_valid <= 1'b0;")),
    ("reset of the last stage of setup", |dir, _| {
        let text = std::fs::read_to_string(dir.join("rtl/relief_setup_delay.v")).unwrap();
        let last = text.rfind("_valid <= 1'b0;").unwrap();
        keep_at_reset(dir, "rtl/relief_setup_delay.v", &text[last - 3..last + "_valid <= 1'b0;".len()]);
    }),
    ("reset of the first stage of results", |dir, _| {
        keep_at_reset(dir, "rtl/relief_hit_delay.v", "s1_valid <= 1'b0;");
    }),
    ("all heights read as the same", |dir, _| {
        edit(dir, "rtl/relief_traverse.v", ".write_en(load_en)", "(load_en)", "(1'b0)");
    }),
    ("slot_busy where rays are", |dir, _| slot_busy(dir, "1'b0")),
    ("slot_busy where none is", |dir, _| slot_busy(dir, "1'b1")),
];

/// Ties the output that counts busy slots.
fn slot_busy(dir: &Path, value: &str) {
    let text = std::fs::read_to_string(dir.join("rtl/relief_traverse.v")).unwrap();
    let line = text.lines().find(|l| l.contains("assign slot_busy")).unwrap();
    edit(dir, "rtl/relief_traverse.v", line, line, &format!("  assign slot_busy = {value};"));
}

/// Every cut in `sim`, at a handshake.
fn cuts(sim: Simulator, handshake: u32, which: &[usize]) {
    if skip() {
        return;
    }
    let c = small(handshake);
    let whole = tree(&c);
    for (what, cut) in which.iter().map(|k| &CUTS[*k]) {
        for file in ["traverse", "setup_delay", "hit_delay"].map(|n| format!("rtl/relief_{n}.v")) {
            let kept = whole.path().join(&file).with_extension("kept");
            if !kept.exists() {
                std::fs::copy(whole.path().join(&file), &kept).unwrap();
            }
            std::fs::copy(&kept, whole.path().join(&file)).unwrap();
        }
        cut(whole.path(), handshake);
        let got = check_tree(&c, whole.path(), sim.into(), &["traverse".into()], None, None, &|_| ());
        let got = got.map(|done| done.iter().map(|x| x.rows).sum::<usize>());
        match (*what == "nothing", &got) {
            (true, Ok(rows)) => assert!(*rows > 900, "{rows} rows"),
            (true, Err(e)) => panic!("{} at handshake {handshake}: {e}", sim.name()),
            (false, Ok(_)) => panic!("{what} cut out, and {} notices nothing at handshake {handshake}", sim.name()),
            (false, Err(e)) => assert!([1, 6, 7].contains(&e.exit_code()), "{what}: {e}"),
        }
    }
}

/// One in so many of these: cuts at handshakes.
fn some(sim: Simulator, step: usize, all: &[(u32, usize)]) {
    let some: Vec<_> = all.iter().step_by(step).collect();
    for handshake in [0, 1] {
        let which: Vec<usize> = some.iter().filter(|c| c.0 == handshake).map(|c| c.1).collect();
        cuts(sim, handshake, &which);
    }
}

/// What a check has to notice in every engine; resets, rays that never end, and that the text as it is passes, in the quicker one alone.
#[test]
fn icarus_notices_what_is_cut_out() {
    some(Simulator::Icarus, share(2), &[(0, 1), (0, 8), (1, 3)]);
}

#[test]
fn verilator_notices_what_is_cut_out() {
    let first = (0..CUTS.len()).map(|k| (0, k));
    let all: Vec<(u32, usize)> = first.chain([0, 3, 5, 6, 7].map(|k| (1, k))).collect();
    some(Simulator::Verilator, share(2), &all);
}

/// Texels that decide a planned ray: it ends on their top, so that with any other height it ends elsewhere or is a wall's.
fn decided(c: &Config) -> Vec<(u32, u32)> {
    let d = c.design();
    let pyramid = Scene::new(c, None, false).unwrap().pyramid;
    let g = prepare(&d).unwrap();
    let rays = planned_rays(&d, &pyramid, c.vectors.seed).unwrap();
    let hits = rays.iter().map(|r| g.trace(&pyramid, r)).filter(|h| !h.wall && !h.limit);
    hits.map(|h| (h.i, h.j)).collect()
}

/// Of a large map, whatever 256th of the texels is altered, in the order of the memory or of the rows: some ray decides by one of them.
#[test]
fn every_256th_texel_decides_some_ray() {
    for levels in [6, 8, 9, 11] {
        let mut c = Config::default();
        c.traverse.levels = levels;
        let texels = decided(&c);
        for first in 0..256 {
            let memory = |&(i, j): &(u32, u32)| address(levels, 0, i, j) % 256 == first;
            let rows = |&(i, j): &(u32, u32)| ((j << levels) + i) % 256 == first as u32;
            assert!(texels.iter().filter(|t| memory(t)).count() > 1, "{levels} levels: word {first} of 256");
            assert!(texels.iter().filter(|t| rows(t)).count() > 1, "{levels} levels: texel {first} of 256");
        }
    }
}

/// Of a small map each texel, in each datapath and with what the modes add.
#[test]
fn every_texel_of_a_small_map_decides_some_ray() {
    let mode = |trim, lod, bilinear| ModeConfig { trim, lod, bilinear, ..ModeConfig::default() };
    for kind in DatapathKind::ALL {
        for (trim, lod, bilinear) in
            [(Trim::None, false, false), (Trim::Always, true, false), (Trim::Descent, false, true)]
        {
            let mut c = Config::default();
            c.traverse.levels = 4;
            c.datapath.kind = kind;
            if kind != DatapathKind::Published {
                c.mode = mode(trim, lod, bilinear && kind == DatapathKind::Watertight);
            }
            let mut texels = decided(&c);
            texels.sort_unstable();
            texels.dedup();
            assert_eq!(texels.len(), 256, "{kind:?}, {trim:?}, lod {lod}");
        }
    }
}

/// In the pipeline itself, with the memory altered: every fifth texel of 16 x 16 by itself, and of a larger map every 256th at once.
#[test]
fn altered_texels_are_noticed() {
    let c = small(0);
    let sets = ray_sets(&c, &Scene::new(&c, None, false).unwrap()).unwrap();
    let set = &sets[0].1.set;
    let words: Vec<u64> = sets[0].1.memory.lines().filter_map(|l| u64::from_str_radix(l, 16).ok()).collect();
    let image = &words[words.len() - 341..];
    let (d, p) = (c.design(), Pipeline::new(&c.design(), &Binding::new()).unwrap());
    let stream = p.stream();
    let run = |image: &[u64], rows: &[Vec<u64>]| {
        stream.run(rows, &images(&p.net, image), 128, Traffic::default()).unwrap().results
    };
    assert_eq!(run(image, &set.stimulus), set.expected);
    let noticed = |texel: usize| {
        let mut other = image.to_vec();
        other[texel] ^= 1;
        // The texels' rays come first, in the order of the rows.
        run(&other, &set.stimulus[..256]) != set.expected[..256]
    };
    let missed: Vec<usize> = (0..256).into_par_iter().step_by(5).filter(|t| !noticed(*t)).collect();
    assert!(missed.is_empty(), "nothing notices texels {missed:?}");

    let mut c = small(0);
    c.traverse.levels = 7;
    let pyramid = Scene::new(&c, None, false).unwrap().pyramid;
    let d7 = c.design();
    let rays = planned_rays(&d7, &pyramid, 1).unwrap();
    let p = Pipeline::new(&d, &Binding::from([("LEVELS".into(), 7)])).unwrap();
    let rows: Vec<Vec<u64>> = rays.iter().map(|r| row(&p.inputs, r)).collect();
    let image: Vec<u64> = pyramid.memory().iter().map(|w| u64::from(*w)).collect();
    let run = |image: &[u64]| p.stream().run(&rows, &images(&p.net, image), 128, Traffic::default()).unwrap().results;
    let right = run(&image);
    for first in [0, 77, 255] {
        let mut other = image.clone();
        other[..1 << 14].iter_mut().skip(first).step_by(256).for_each(|w| *w ^= 1);
        let wrong = run(&other).iter().zip(&right).filter(|(a, b)| a != b).count();
        assert!(wrong >= 4, "every 256th texel from {first} on: {wrong} rays notice");
    }
}

/// The set that the default tree ships reaches all that it counts.
#[test]
fn shipped_rays_reach_every_kind() {
    let c = Config::default();
    let sets = ray_sets(&c, &Scene::new(&c, None, false).unwrap()).unwrap();
    let kinds = [
        "refused: not a ray",
        "hit in the first step",
        "hit on a top",
        "hit on a wall",
        "moves along no axis",
        "moves along one axis",
        "goes up levels",
    ];
    for kind in kinds {
        assert!(sets[0].1.set.events.get(kind).is_some_and(|n| *n >= 20), "{kind}: {:?}", sets[0].1.set.events);
    }
    for (place, set) in &sets[1..] {
        for kind in ["given up at the step limit", "hit in the last step before the limit"] {
            assert!(set.set.events.get(kind).is_some_and(|n| *n >= 3), "{place}, {kind}: {:?}", set.set.events);
        }
    }
    assert_eq!(sets[2].1.set.params["STEP_LIMIT"], 1);
    assert!(sets[1].1.set.params["STEP_LIMIT"] > 2);
}
