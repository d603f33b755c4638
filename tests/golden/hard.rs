//! The hard cases: no ray is given up, no mode finds something else, and a wrong texel is a matter of the last places.
//!
//! `RELIEFRTL_RAYS` sets the rays a case; `RELIEFRTL_SEED` their seed.
use crate::budget::share;
use crate::run;
use reliefrtl::config::{Config, DatapathKind, Design, Trim};
use reliefrtl::golden::float;
use reliefrtl::measure::corner_cases::{HardFigures, modes};
use reliefrtl::scene::hard::Case;
use std::collections::BTreeSet;
use std::path::Path;

fn env(name: &str, default: u64) -> u64 {
    std::env::var(name).map_or(default, |v| v.parse().unwrap_or_else(|_| panic!("{name}={v} is not a number")))
}

fn config(sets: &[&str]) -> Config {
    let mut c = Config::default();
    sets.iter().for_each(|set| c.apply_set(set).unwrap());
    c.validate().unwrap();
    c
}

/// How far from another texel an exact decision may be that the design takes otherwise, over the height range. A compared parameter
/// passes three roundings in floating point, and two parameters are compared; in fixed point the reciprocal is rounded, and the product.
fn bound(d: &Design) -> f64 {
    match d.datapath.kind {
        DatapathKind::Fixed => {
            4.0 * (0.5f64.powi(d.datapath.reciprocal_bits as i32) + 0.5f64.powi(d.datapath.fraction_bits as i32))
        }
        _ => 8.0 * 0.5f64.powi(d.format.man as i32 + 1),
    }
}

/// An axis of a travel so small that its reciprocal is infinite: it never crosses, not even the border that the ray enters on
/// (`docs/datapath.md`). Such a ray is less than 2^(h - bias) of a texel away from the exact one.
fn stands(f: &HardFigures, ray: usize) -> bool {
    let (d, r) = (&f.design, &f.rays[ray]);
    let most = 2f64.powi(d.traverse.height_bits as i32 - d.format.bias() - d.traverse.levels as i32);
    let small = |word| (-most..0.0).contains(&float::to_f64(d.format, word));
    d.datapath.kind == DatapathKind::Watertight && (small(r.du) || small(r.dv))
}

/// Runs every case that is legal for the configuration; `largest` skips the largest maps.
fn every_case(c: &Config, largest: u32) {
    let (rays, seed) = (env("RELIEFRTL_RAYS", 20) as usize, env("RELIEFRTL_SEED", 1));
    let (mut ran, mut total, mut wrong, mut ties, mut tied, mut limits, mut differ) = (0, 0, 0, 0, 0, 0, 0);
    for case in Case::all() {
        let scene = case.scene(&c.design(), rays, seed);
        let own = Config { traverse: scene.design.traverse, ..c.clone() };
        if own.validate().is_err() || scene.design.traverse.levels > largest {
            continue;
        }
        let f = HardFigures::of_scene(&scene, case.limit).unwrap();
        if !f.accuracy.wrong.is_empty() {
            let (k, margin) = (f.accuracy.wrong.len(), f.largest_margin());
            println!("{}: {k} of {rays} wrong texels, {} on a tie, margin up to {margin:.1e}", case.name, f.ties);
        }
        let all = match (c.fetch.blocks(), c.mode.trim) {
            // Itself, one cell, and 36 a trim.
            (true, trim) => 2 + if trim == Trim::None { 36 } else { 72 },
            (false, Trim::None) => 40,
            (false, _) => 80,
        };
        assert_eq!(f.modes, all);
        assert!(f.keeps_promises(), "{}: {:?} {:?}", case.name, f.differ.first(), f.accuracy);
        for w in &f.accuracy.wrong {
            assert!(w.margin <= bound(&f.design) || stands(&f, w.ray), "{}: {w:?} {:x?}", case.name, f.rays[w.ray]);
        }
        // An invalid ray leaves without a step: the cases are made of rays that the design takes.
        assert!(f.hits.iter().all(|hit| hit.steps > 0), "{}", case.name);
        ran += 1;
        total += f.rays.len();
        wrong += f.accuracy.wrong.len() - f.ties;
        ties += f.ties;
        tied += f.tied;
        limits += f.accuracy.limits;
        differ += f.differ.len();
    }
    println!(
        "{ran} cases, {total} rays, seed {seed}: {limits} by the step limit, {differ} depend on the mode, {wrong} wrong texels, and {ties} of {tied} tied"
    );
    assert!(ran >= 35 && tied > 0 && wrong * 50 <= total, "{wrong} of {total} in {ran} cases");
}

#[test]
fn the_default_design() {
    every_case(&config(&[]), 12);
}

#[test]
fn few_bits() {
    every_case(&config(&["format.exp=5", "format.man=10", "traverse.levels=6", "traverse.height_bits=6"]), 9);
}

#[test]
fn single_precision_and_high_maps() {
    every_case(&config(&["format.exp=8", "format.man=23", "traverse.height_bits=16", "traverse.tile_bits=2"]), 10);
}

#[test]
fn fixed_point() {
    every_case(&config(&["datapath.kind=fixed"]), 9);
    every_case(&config(&["datapath.kind=fixed", "datapath.fraction_bits=28", "datapath.reciprocal_bits=30"]), 9);
}

#[test]
fn chord_trims() {
    let few = ["datapath.kind=fixed", "datapath.fraction_bits=16", "datapath.reciprocal_bits=12"];
    let arithmetic = [&[][..], &few[..1], &few];
    let all = ["mode.trim=descent", "mode.trim=always"].into_iter().flat_map(|trim| arithmetic.map(|a| (trim, a)));
    // In the usual run one in two: both trims, and each arithmetic with one of them.
    for (trim, sets) in all.step_by(share(2)) {
        every_case(&config(&[sets, &[trim]].concat()), 9);
    }
}

/// Beside the walk by one cell.
#[test]
fn four_cells() {
    every_case(&config(&["fetch.cells=4"]), 9);
    every_case(&config(&["fetch.cells=4", "datapath.kind=fixed", "mode.trim=always"]), 9);
}

#[test]
fn names_are_unique_and_scenes_repeat() {
    let names: BTreeSet<&str> = Case::all().map(|case| case.name).collect();
    assert_eq!(names.len(), Case::all().count());
    assert_eq!(modes(&Design::default()).len(), 40);
    let docs = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/hard-cases.md")).unwrap();
    let mut d = Design::default();
    d.traverse.levels = 5;
    for case in Case::all() {
        assert!(docs.contains(&format!("| `{}` |", case.name)), "docs/hard-cases.md has no {}", case.name);
        if case.name.len() < 8 {
            let (a, b, other) = (case.scene(&d, 9, 4), case.scene(&d, 9, 4), case.scene(&d, 9, 5));
            assert_eq!((&a.texels, &a.rays), (&b.texels, &b.rays));
            assert_ne!(a.rays, other.rays, "{}", case.name);
        }
    }
}

#[test]
fn the_command_line() {
    let dir = tempfile::tempdir().unwrap();
    let (code, list, _) = run(dir.path(), &["hard", "--list"]);
    assert_eq!((code, list.lines().count()), (0, Case::all().count() + 1));
    let (code, text, _) = run(dir.path(), &["hard", "--case", "step-limit", "--rays", "20", "--pictures", "p"]);
    assert_eq!(code, 0);
    assert!(text.contains("0 of 40 end wrongly") && text.contains("20 rays, seed 1: "), "{text}");
    let picture = image::open(dir.path().join("p/step-limit.png")).unwrap();
    assert!(picture.width() > 500 && picture.height() > 650);
    let (code, json, _) = run(dir.path(), &["hard", "--case", "slope-equal", "--rays", "20", "--json"]);
    let value: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!((code, value["given_up"].as_u64(), value["ties"].as_u64()), (0, Some(0), Some(20)), "{json}");
    let (code, _, told) = run(dir.path(), &["hard", "--case", "spikes"]);
    assert!(code == 2 && told.contains("did you mean spike?"), "{told}");
    let short = ["hard", "--case", "noise", "--rays", "20", "--set", "traverse.step_limit=3"];
    let (code, text, told) = run(dir.path(), &short);
    assert!(code == 1 && text.contains("given up") && told.contains("in 1 of 1 cases: noise"), "{text}{told}");
    assert_eq!(run(dir.path(), &["hard", "--rays", "0"]).0, 5);
}
