//! The interpreter's own tracking of unknown bits: every mode of every datapath, with what stands in the way of ready.
use super::{LEVELS, config, scene, unknown_bits};
use crate::budget::share;
use rayon::prelude::*;
use reliefrtl::config::{Config, Design, ModeConfig, Profile};
use reliefrtl::golden::{RayHit, prepare};
use reliefrtl::interp::Tracked;
use reliefrtl::ir::Binding;
use reliefrtl::measure::soak::modes;
use reliefrtl::trace::{Pipeline, hit_row, images, row};

/// How much of the memory is loaded.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Loaded {
    Nothing,
    Half,
    All,
}

/// Runs the rays; returns how many were given up, of how many.
fn run(c: &Config, loaded: Loaded, rays: usize) -> (usize, usize) {
    let d = c.design();
    let (pyramid, list) = scene(c, rays);
    let hits: Vec<RayHit> = list.iter().map(|r| prepare(&d).unwrap().trace(&pyramid, r)).collect();
    let p = Pipeline::new(&d, &Binding::new()).unwrap();
    let mut sim = Tracked::new(&p.net);
    if loaded != Loaded::Nothing {
        let image: Vec<u64> = pyramid.memory().iter().map(|w| u64::from(*w)).collect();
        for (k, words) in images(&p.net, &image).iter().enumerate() {
            let keep = if loaded == Loaded::Half { words.len() / 2 } else { words.len() };
            sim.load(k, &words[..keep]);
        }
    }
    let known = |name: &str, sim: &Tracked<'_>, clock: usize| {
        let (v, x) = sim.get(p.net.output(name));
        assert_eq!(x, 0, "{name} in clock {clock} of {:?} {:?} {:?} {loaded:?}", d.mode, d.datapath.kind, d.latency);
        v
    };
    let width = |name: &str| p.net.inputs.iter().find(|q| q.name == name).unwrap().width;
    // Of no interest while their enable is 0: never driven.
    for (name, v) in [("rst", 1), ("in_valid", 0), ("out_ready", 0), ("load_en", 0)] {
        sim.set(p.net.input(name), v);
    }
    sim.eval();
    sim.clock();
    sim.set(p.net.input("rst"), 0);
    let (mut sent, mut given_up, mut clock) = (0, 0, 0);
    let mut back = vec![false; rays];
    let limit = 4000 * rays;
    loop {
        let driven = sent < rays && clock % 7 != 3;
        sim.set(p.net.input("in_valid"), u64::from(driven));
        sim.set(p.net.input("out_ready"), u64::from(clock % 5 != 1));
        let words = row(&p.inputs, &list[sent.min(rays - 1)]);
        for (k, (name, v)) in p.inputs.iter().zip(&words).enumerate() {
            let x =
                if driven { unknown_bits(sent, k, words.len(), width(name)) } else { u64::MAX >> (64 - width(name)) };
            sim.set_bits(p.net.input(name), (v & !x, x));
        }
        let tag = if driven { (sent as u64, 0) } else { (0, 255) };
        sim.set_bits(p.net.input("in_tag"), tag);
        sim.eval();
        let [ready, valid, _, idle] = ["in_ready", "out_valid", "slot_busy", "idle"].map(|n| known(n, &sim, clock));
        assert!(!(idle == 1 && back.iter().filter(|b| **b).count() < sent), "idle with a ray inside");
        if valid == 1 && clock % 5 != 1 {
            let tag = known("out_tag", &sim, clock) as usize;
            assert!(!std::mem::replace(&mut back[tag], true), "ray {tag} came twice");
            let limit = known("out_limit", &sim, clock) == 1;
            known("out_steps", &sim, clock);
            given_up += usize::from(limit);
            let good = tag % 5 < 2;
            let got: Vec<(u64, u64)> = p.outputs.iter().map(|n| sim.get(p.net.output(n))).collect();
            let whole = got.iter().all(|w| w.1 == 0);
            if good && (loaded == Loaded::All || (whole && !limit)) {
                let got: Vec<u64> = got.iter().map(|w| w.0).collect();
                assert!(whole && got == hit_row(&d, &hits[tag]), "ray {tag}: {got:x?}, {:?} {:?}", d.mode, d.latency);
            }
            assert!(tag % 5 != 2 || limit, "nothing of ray {tag} is known, but it was not given up");
            assert!(loaded != Loaded::Nothing || limit, "no height is known, but ray {tag} was not given up");
        }
        sent += usize::from(driven && ready == 1);
        sim.clock();
        clock += 1;
        if sent == rays && idle == 1 && back.iter().all(|b| *b) {
            return (given_up, rays);
        }
        assert!(clock < limit, "{} of {rays} rays left within {limit} clocks", back.iter().filter(|b| **b).count());
    }
}

/// `sets` and a profile, in each state of the memory.
fn in_each_state(c: &Config, rays: usize) {
    for loaded in [Loaded::Nothing, Loaded::Half, Loaded::All] {
        let (given_up, of) = run(c, loaded, rays);
        assert!(given_up > 0 && (loaded != Loaded::All || given_up < of), "{given_up} of {of} {loaded:?}");
    }
}

#[test]
fn unknown_values_reach_no_handshake_in_any_mode() {
    assert_eq!(LEVELS, 3);
    for kind in ["watertight", "fixed", "published"] {
        let c = config(&[&format!("datapath.kind={kind}")], None);
        let all: Vec<ModeConfig> = modes(&c.design())
            .into_iter()
            .map(|d| d.mode)
            .filter(|mode| {
                let c = Config { mode: *mode, ..c.clone() };
                c.validate().is_ok()
            })
            .collect();
        assert!(all.len() >= 40, "{}", all.len());
        // In the usual run one in seven, which divides no number of choices that a mode has; the handshakes take turns among these.
        let some: Vec<(usize, ModeConfig)> = all.into_iter().step_by(share(7)).enumerate().collect();
        some.into_par_iter().for_each(|(k, mode)| {
            let mut c = Config { mode, ..c.clone() };
            c.latency.handshake = k as u32 % 4;
            in_each_state(&c, 8);
        });
    }
}

#[test]
fn unknown_values_reach_no_handshake_at_any_latency() {
    let kinds = ["datapath.kind=watertight", "datapath.kind=fixed", "datapath.kind=published"];
    let mut list: Vec<Config> = Vec::new();
    for kind in kinds {
        list.extend(Profile::ALL.map(|p| config(&[kind], Some(p))));
        list.extend((0..4).map(|k| config(&[kind, &format!("latency.handshake={k}")], None)));
    }
    for k in 1..=5 {
        list.push(config(&[&format!("latency.decision={k}"), &format!("latency.node={}", k % 4)], None));
    }
    list.extend((0..4).map(|k| {
        config(&["mode.bilinear=true", &format!("latency.handshake={k}"), &format!("latency.memory={}", k + 1)], None)
    }));
    list.push(config(&["mode.lod=true", "mode.trim=always", "latency.delay_line=3"], Some(Profile::Fast)));
    list.par_iter().for_each(|c| in_each_state(c, 10));
    assert!(list.len() > 25);
}

/// A decision that took an unknown bit as it comes would be seen: the same run on a netlist without decisions.
#[test]
fn without_decisions_the_handshake_is_lost() {
    let c = config(&[], None);
    let d: Design = c.design();
    let p = Pipeline::new(&d, &Binding::new()).unwrap();
    let mut net = p.net.clone();
    let decisions = net.regs.iter().filter(|r| r.unknown.is_some()).count();
    assert_eq!(decisions, 3, "whether a ray is one, whether it is done, whether it was given up");
    net.regs.iter_mut().for_each(|r| r.unknown = None);
    let mut sim = Tracked::new(&net);
    for (name, v) in [("rst", 1), ("in_valid", 1), ("out_ready", 1), ("load_en", 0)] {
        sim.set(net.input(name), v);
    }
    let lost = (0..200).any(|_| {
        sim.eval();
        sim.clock();
        sim.set(net.input("rst"), 0);
        sim.eval();
        sim.get(net.output("out_valid")).1 != 0
    });
    assert!(lost);
}
