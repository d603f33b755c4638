//! How wrong the published datapath is, and how many rays it never ends: with its nudge and without, on procedural maps.
use super::scenes::{design, hard};
use crate::budget;
use reliefrtl::config::{Config, DatapathKind, LevelUp, MapKind, ModeConfig, View};
use reliefrtl::golden::{Decision, Pyramid, RayInput, prepare};
use reliefrtl::interp::{FlatOp, Kind, Traffic};
use reliefrtl::ir::Binding;
use reliefrtl::measure::accuracy;
use reliefrtl::project::{Scene, encode};
use reliefrtl::trace::{Pipeline, diagnose_in, hit, trace_golden};

/// Rays, those given up, those in the wrong texel: over the maps and all three views, every 16th pixel, seed 1.
fn measure(nudge: u32, mode: ModeConfig) -> (usize, usize, usize) {
    let mut sum = (0, 0, 0);
    for kind in [MapKind::Rocks, MapKind::Bricks, MapKind::Dunes, MapKind::Spikes, MapKind::Stairs] {
        let mut c = Config { mode, ..Config::default() };
        (c.map.kind, c.datapath.kind, c.datapath.nudge_bits) = (kind, DatapathKind::Published, nudge);
        (c.traverse.step_limit, c.view.stride) = (1000, 16);
        let scene = Scene::new(&c, None, false).unwrap();
        for view in View::ALL {
            let rays: Vec<RayInput> =
                scene.view(&c, view, c.view.stride).unwrap().iter().map(|x| encode(&c, x)).collect();
            let hits = trace_golden(&c.design(), &scene.pyramid, &rays).unwrap();
            let a = accuracy(&c.design(), &scene.texels, &rays, &hits).unwrap();
            sum = (sum.0 + a.rays, sum.1 + a.limits, sum.2 + a.wrong.len());
        }
    }
    sum
}

#[test]
fn rays_end_with_the_nudge_and_mostly_not_without() {
    let plain = ModeConfig { start_level: false, levels_down: 1, level_up: LevelUp::None, ..ModeConfig::default() };
    let modes = [("start level, two down, selective", ModeConfig::default()), ("baseline", plain)];
    let all = modes.into_iter().flat_map(|mode| [0, 7, 9].map(|nudge| (mode, nudge)));
    // In the usual run each nudge in one of the modes.
    for ((name, mode), nudge) in all.step_by(budget::share(2)) {
        let (rays, limits, wrong) = measure(nudge, mode);
        let share = |k: usize| 100.0 * k as f64 / rays as f64;
        println!(
            "{name}, nudge_bits {nudge}: {limits} of {rays} never end ({:.3} %), {wrong} in the wrong texel ({:.3} %)",
            share(limits),
            share(wrong)
        );
        assert!(rays > 10_000, "{rays} rays");
        match nudge {
            0 => assert!(limits * 2 > rays, "{limits} of {rays}: without a nudge most rays never end"),
            7 => assert!(limits * 500 <= rays && wrong * 100 <= rays, "{limits}, {wrong} of {rays}"),
            _ => assert!(limits * 50 <= rays && wrong * 200 <= rays, "{limits}, {wrong} of {rays}"),
        }
    }
}

/// Toward smaller coordinates the plane itself belongs to the node that the ray should leave.
#[test]
fn a_ray_that_never_ends() {
    let mut d = design(4);
    let mut texels = vec![0; 256];
    texels[2] = 255;
    let pyramid = Pyramid::build(4, 8, &texels).unwrap();
    let ray = RayInput::from_f64(d.format, 0.5, 0.0, -0.5, 0.0);
    for (nudge, ends) in [(0, false), (7, true)] {
        d.datapath.nudge_bits = nudge;
        let mut seen = Vec::new();
        let hit = prepare(&d).unwrap().trace_with(&pyramid, &ray, Some(&mut |i| seen.push(*i)));
        assert_eq!(hit.limit, !ends, "nudge_bits {nudge}: {hit:?}");
        if ends {
            assert_eq!((hit.i, hit.j, hit.wall), (2, 0, true));
        } else {
            assert_eq!(hit.steps, d.traverse.step_limit);
            let last = seen.last().unwrap();
            assert_eq!((last.decision, last.next_x, last.next_t), (Decision::CrossX, last.x, last.t));
        }
    }
}

/// A fault in the pipeline is found at the signal where it first shows.
#[test]
fn faults_are_diagnosed() {
    let d = design(4);
    let (pyramid, rays) = hard(&d, 64, 5);
    let g = prepare(&d).unwrap();
    let sound = Pipeline::new(&d, &Binding::new()).unwrap();
    assert!(rays.iter().all(|r| diagnose_in(&sound, &d, &pyramid, r).unwrap().is_none()), "no fault, no divergence");
    let (mut wrong, mut stages) = (0, std::collections::BTreeSet::new());
    for at in (0..sound.net.ops.len()).step_by(sound.net.ops.len() / 50) {
        let mut p = Pipeline::new(&d, &Binding::new()).unwrap();
        let op = p.net.ops[at];
        p.net.ops[at] = match op.kind {
            Kind::And => FlatOp { kind: Kind::Or, ..op },
            Kind::Or | Kind::Xor => FlatOp { kind: Kind::And, ..op },
            Kind::Add => FlatOp { kind: Kind::Sub, ..op },
            Kind::Sub => FlatOp { kind: Kind::Add, ..op },
            Kind::Mux => FlatOp { args: [op.args[0], op.args[2], op.args[1]], ..op },
            _ => continue,
        };
        // A fault may lose rays; those that come out wrong are diagnosed.
        let Ok(run) = p.run(&pyramid, &rays, 16, Traffic::default()) else { continue };
        let Some(k) = (0..rays.len()).find(|k| hit(&d, &run.results[*k]).steps != g.trace(&pyramid, &rays[*k]).steps)
        else {
            continue;
        };
        wrong += 1;
        stages.extend(diagnose_in(&p, &d, &pyramid, &rays[k]).unwrap().map(|x| (x.stage, x.signal)));
    }
    println!("{wrong} faults change the way of a ray; first wrong signals: {stages:?}");
    assert!(wrong > 5 && stages.len() > 3, "{wrong} faults, {stages:?}");
}
