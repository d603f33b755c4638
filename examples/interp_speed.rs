//! Lane-cycles per second of the interpreter on `traverse`, and its results against the golden model.
//!
//! `cargo run --release --example interp_speed -- [RAYS] [LANES] [THREADS] [all]`
use rand::{Rng, SeedableRng};
use reliefrtl::config::{Design, LevelUp, ModeConfig};
use reliefrtl::golden::{Datapath, Pyramid, RayInput, Watertight};
use reliefrtl::interp::Traffic;
use reliefrtl::ir::Binding;
use reliefrtl::trace::{Pipeline, hit};
use std::time::Instant;

fn main() {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let number = |i: usize, default: usize| args.get(i).and_then(|s| s.parse().ok()).unwrap_or(default);
    let (rays, lanes, threads) = (number(0, 10_000), number(1, 128), number(2, 1));
    let mut modes = vec![ModeConfig::default()];
    if args.get(3).is_some_and(|a| a == "all") {
        modes.clear();
        for level_up in LevelUp::ALL {
            for (start_level, levels_down) in [(false, 1), (true, 2), (true, 4)] {
                modes.push(ModeConfig { start_level, levels_down, level_up, ..ModeConfig::default() });
            }
        }
    }
    modes.into_iter().for_each(|mode| measure(mode, rays, lanes, threads));
}

fn measure(mode: ModeConfig, rays: usize, lanes: usize, threads: usize) {
    let mut d = Design { mode, ..Design::default() };
    d.traverse.levels = 6;
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(1);
    let texel =
        |r: &mut rand_chacha::ChaCha8Rng| u32::from(r.random::<u8>()) / if r.random::<u8>() < 20 { 1 } else { 8 };
    let texels: Vec<u32> = (0..1 << (2 * d.traverse.levels)).map(|_| texel(&mut rng)).collect();
    let pyramid = Pyramid::build(d.traverse.levels, d.traverse.height_bits, &texels).expect("texels are codes");
    let mut real = |scale: f64, shift: f64| (rng.random::<f64>() - shift) * scale;
    let ins: Vec<RayInput> = (0..rays)
        .map(|_| RayInput::from_f64(d.format, real(1.0, 0.0), real(1.0, 0.0), real(4.0, 0.5), real(0.5, 0.5)))
        .collect();
    let golden = Watertight::prepare(&d).expect("legal design");
    let pipeline = Pipeline::new(&d, &Binding::new()).expect("legal design");
    let (start, busy) = (Instant::now(), processor_seconds());
    let run = pipeline.run_parallel(&pyramid, &ins, lanes, threads, Traffic::default()).expect("every ray comes out");
    let seconds = start.elapsed().as_secs_f64();
    let busy = processor_seconds() - busy;
    let wrong = ins.iter().zip(&run.results).filter(|(r, h)| golden.trace(&pyramid, r) != hit(&d, h)).count();
    let lane_cycles = run.cycles as f64 * lanes as f64 * threads as f64;
    println!(
        "{mode:?}: {wrong} of {rays} differ from golden; {} ops, {} registers, {} clocks; {:.2} M lane-cycles/s, {:.0} rays/s, {:.2} M lane-cycles per processor second",
        pipeline.net.ops.len(),
        pipeline.net.regs.len(),
        run.cycles,
        lane_cycles / seconds / 1e6,
        rays as f64 / seconds,
        lane_cycles / busy / 1e6
    );
}

/// Time that the main thread has had a processor: tells the speed on a machine that does other work, too.
fn processor_seconds() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/schedstat").unwrap_or_default();
    stat.split_whitespace().next().and_then(|s| s.parse::<f64>().ok()).map_or(f64::NAN, |ns| ns / 1e9)
}
