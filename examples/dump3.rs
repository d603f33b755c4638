use rand::{Rng, SeedableRng};
use reliefrtl::{config::*, golden::*, interp::*, ir::Binding, units::traversal::*};
use std::sync::Arc;
use std::time::Instant;
fn main() {
    let mut d = Design::default();
    let rays: usize = std::env::args().nth(1).map(|s| s.parse().unwrap()).unwrap_or(2000);
    let lanes: usize = std::env::args().nth(2).map(|s| s.parse().unwrap()).unwrap_or(64);
    d.traverse.levels = 6;
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(1);
    for up in LevelUp::ALL {
        for down in [1, 2, 4] {
            for start in [false, true] {
                d.mode = ModeConfig { start_level: start, levels_down: down, level_up: up };
                let n = d.traverse.levels;
                let tex: Vec<u32> = (0..1 << (2 * n))
                    .map(|_| {
                        if rng.random::<u8>() < 20 { rng.random::<u8>() as u32 } else { rng.random::<u8>() as u32 / 8 }
                    })
                    .collect();
                let pyr = Pyramid::build(n, 8, &tex).unwrap();
                let g = Golden::new(&d).unwrap();
                let image = Arc::new(pyr.memory().iter().map(|w| *w as u64).collect::<Vec<_>>());
                let ins: Vec<RayInput> = (0..rays)
                    .map(|_| {
                        RayInput::from_f64(
                            d.format,
                            rng.random::<f64>(),
                            rng.random::<f64>(),
                            (rng.random::<f64>() - 0.5) * 4.0,
                            (rng.random::<f64>() - 0.5) * 0.5,
                        )
                    })
                    .collect();
                let t = traverse(&d);
                let net = elaborate(&t.module, &Binding::new()).unwrap();
                let s = Stream::new(
                    &net,
                    &["in_u", "in_v", "in_du", "in_dv"],
                    &[
                        "out_i",
                        "out_j",
                        "out_fu",
                        "out_fv",
                        "out_t",
                        "out_wall",
                        "out_limit",
                        "out_steps",
                        "out_crossings",
                        "out_ups",
                    ],
                    30,
                );
                let items: Vec<Vec<u64>> = ins.iter().map(|r| vec![r.u, r.v, r.du, r.dv]).collect();
                let t0 = Instant::now();
                let run = s.run(&items, &image, lanes, Traffic::default()).unwrap();
                let dt = t0.elapsed().as_secs_f64();
                let t0 = Instant::now();
                let want: Vec<Vec<u64>> = ins
                    .iter()
                    .map(|r| {
                        let h = g.trace(&pyr, r);
                        vec![
                            h.i as u64,
                            h.j as u64,
                            h.fu as u64,
                            h.fv as u64,
                            h.t,
                            h.wall as u64,
                            h.limit as u64,
                            h.steps as u64,
                            h.crossings as u64,
                            h.ups as u64,
                        ]
                    })
                    .collect();
                let dg = t0.elapsed().as_secs_f64();
                let bad = want.iter().zip(&run.results).filter(|(a, b)| a != b).count();
                if let Some((a, b)) = want.iter().zip(&run.results).find(|(a, b)| a != b) {
                    println!("{a:?}\n{b:?}");
                }
                let steps: u64 = want.iter().map(|w| w[7]).sum();
                println!(
                    "{up:?} {down} {start}: {bad} of {rays}; slots {} cycles {} ops {} regs {} steps {:.2} busy {:.3} interp {:.0} rays/s {:.2} Mcyc/s golden {:.0} rays/s",
                    t.slots,
                    run.cycles,
                    net.ops.len(),
                    net.regs.len(),
                    steps as f64 / rays as f64,
                    run.busy as f64 / run.loaded as f64,
                    rays as f64 / dt,
                    run.cycles as f64 * lanes as f64 / dt / 1e6,
                    rays as f64 / dg
                );
            }
        }
    }
}
