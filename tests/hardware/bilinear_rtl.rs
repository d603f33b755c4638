//! The bilinear refinement in the emitted hardware (`docs/bilinear.md`): the interpreter, Icarus and Verilator against the golden model.
//! A missing simulator fails these tests (`tools/test.sh` installs them) unless RELIEFRTL_NO_SIMULATORS=1.
use crate::files::write;
use crate::simulators::skip;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use reliefrtl::bench::{Simulator, run_bench};
use reliefrtl::catalogue::{check_netlist, find, ray_set, vector_set};
use reliefrtl::config::{Config, Design, Trim};
use reliefrtl::format::FloatFormat;
use reliefrtl::golden::{Patch, Pyramid, RayInput, prepare};
use reliefrtl::interp::{Traffic, elaborate};
use reliefrtl::ir::Binding;
use reliefrtl::project::hardware;
use reliefrtl::trace::{Pipeline, hit, hit_row, record};
use reliefrtl::vectors::{Plan, set_files};

fn design((exp, man): (u32, u32), levels: u32, height: u32) -> Design {
    let mut d = Design { format: FloatFormat::new(exp, man), ..Design::default() };
    (d.traverse.levels, d.traverse.height_bits, d.traverse.tile_bits) = (levels, height, 3);
    (d.mode.bilinear, d.traverse.frac_bits) = (true, if height > 8 { 8 } else { 12 });
    d
}

/// A map with spikes and plateaus, and rays along axes, diagonals, borders and centres of texels, straight down, and not at all.
fn hard(d: &Design, seed: u64) -> (Pyramid, Vec<RayInput>) {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let (n, most) = (d.traverse.levels, (1u32 << d.traverse.height_bits) - 1);
    let code = |rng: &mut ChaCha8Rng| match rng.random_range(0..5) {
        0 => most,
        1 => 0,
        2 => most / 2,
        _ => rng.random_range(0..=most) >> rng.random_range(0..4),
    };
    let texels: Vec<u32> = (0..1usize << (2 * n)).map(|_| code(&mut rng)).collect();
    let ray = |k: usize, rng: &mut ChaCha8Rng| {
        let half = f64::from(2u32 << n);
        let far = |rng: &mut ChaCha8Rng| (rng.random::<f64>() - 0.5) * 12.0;
        // Borders and centres of texels.
        let grid = |rng: &mut ChaCha8Rng| f64::from(rng.random_range(0..2u32 << n)) / half;
        match k % 7 {
            0 => [grid(rng), grid(rng), far(rng), far(rng)],
            1 => [grid(rng), rng.random_range(0.0..0.99), 0.0, far(rng)],
            2 => [grid(rng), grid(rng), 0.25, -0.25],
            3 => [rng.random_range(0.0..0.99), grid(rng), far(rng) / 50.0, 0.0],
            4 => [rng.random_range(0.0..0.99), grid(rng), 0.0, 0.0],
            5 => [rng.random_range(0.0..0.99), rng.random_range(0.0..0.99), 1e-3, far(rng) * 1.5],
            _ => [rng.random_range(0.0..0.99), rng.random_range(0.0..0.99), far(rng), far(rng) / 9.0],
        }
    };
    let rays =
        (0..420).map(|k| ray(k, &mut rng)).map(|[u, v, a, b]| RayInput::from_f64(d.format, u, v, a, b)).collect();
    (Pyramid::build(n, d.traverse.height_bits, &texels).unwrap(), rays)
}

const SIZES: [((u32, u32), u32, u32); 7] = [
    ((7, 16), 2, 8),
    ((7, 16), 5, 8),
    ((7, 16), 8, 16),
    ((5, 10), 3, 8),
    ((5, 10), 6, 2),
    ((8, 23), 4, 8),
    ((8, 23), 9, 16),
];

#[test]
fn the_interpreter_equals_golden_at_formats_and_level_counts() {
    let mut seen = [0; 4];
    for (k, (format, levels, height)) in SIZES.into_iter().enumerate() {
        for traffic in [Traffic::default(), Traffic { gaps: 60, stalls: 120, resets: 2, seed: k as u64 }] {
            let mut d = design(format, levels, height);
            d.traverse.step_limit = if k == 1 { 9 } else { 65535 };
            let (pyramid, rays) = hard(&d, k as u64);
            let (g, p) = (prepare(&d).unwrap(), Pipeline::new(&d, &Binding::new()).unwrap());
            // Few lanes: the refinement's pipeline is full.
            let run = p.run(&pyramid, &rays, 2, traffic).unwrap();
            for (n, (row, r)) in run.results.iter().zip(&rays).enumerate() {
                let want = g.trace(&pyramid, r);
                assert_eq!((hit(&d, row), row), (want, &hit_row(&d, &want)), "ray {n} of {format:?}, {levels} levels");
                seen[want.bilinear.map_or(0, |b| b.patch.code() as usize)] += 1;
            }
        }
    }
    assert!(seen.iter().all(|n| *n > 30), "none, hit, above, below: {seen:?}");
}

#[test]
fn clocks_and_trims_change_no_refined_hit() {
    let base = design((7, 16), 5, 8);
    let (pyramid, rays) = hard(&base, 11);
    let golden = prepare(&base).unwrap();
    for (l, trim) in [(0, Trim::Always), (1, Trim::None), (3, Trim::Descent), (5, Trim::Always)] {
        let mut d = base;
        d.mode.trim = trim;
        (d.latency.add, d.latency.mul, d.latency.div, d.latency.compare) = (l, l, 2 * l, l);
        (d.latency.from_int, d.latency.to_int) = (l, l / 2);
        let run = Pipeline::new(&d, &Binding::new()).unwrap().run(&pyramid, &rays, 4, Traffic::default()).unwrap();
        for (row, r) in run.results.iter().zip(&rays) {
            assert_eq!(hit(&d, row).bilinear, golden.trace(&pyramid, r).bilinear, "{l} clocks, {trim:?}, {r:?}");
        }
    }
}

/// From power-up, with undefined bits tracked: what was never loaded or sent never reaches the outputs.
#[test]
fn nothing_undefined_comes_out() {
    let d = design((7, 16), 4, 8);
    let (pyramid, rays) = hard(&d, 5);
    let golden = prepare(&d).unwrap();
    let some: Vec<&RayInput> = rays.iter().step_by(60).collect();
    let hits = some.iter().map(|r| record(&d, &pyramid, r).unwrap().0);
    assert!(hits.zip(&some).all(|(h, r)| h == golden.trace(&pyramid, r)));
    assert!(some.len() > 5);
}

/// One bit of any constant of the units' arithmetic, or a constant of one bit left out, is noticed by the vectors.
#[test]
fn a_wrong_constant_is_noticed() {
    let d = design((7, 16), 8, 8);
    let mut flipped = 0;
    for name in ["bilinear_window", "patch_corner", "surface_gap", "secant_step"] {
        let m = find(&d, name).unwrap();
        let set = vector_set(&d, &m, &Binding::new(), Plan { rows: 2000, seed: 1 });
        let net = elaborate(&m, &Binding::new()).unwrap();
        let live = |k: usize, bit: u32| {
            let mut other = net.clone();
            other.consts[k].1 ^= 1 << bit;
            check_netlist(&other, m.latency().unwrap() as usize, &set).unwrap().mismatched == 0
        };
        // The constants that the unit itself has; those of the arithmetic units are theirs.
        let own = |k: &usize| net.names.iter().any(|(n, s)| *s == net.consts[*k].0 && !n.contains('.'));
        for k in (0..net.consts.len()).filter(own) {
            for bit in 0..net.widths[net.consts[k].0 as usize] {
                assert!(!live(k, bit), "{name}: bit {bit} of constant {k} of {}", net.consts.len());
                flipped += 1;
            }
        }
    }
    assert!(flipped >= 20, "{flipped}");
}

fn simulated(sim: Simulator, sizes: &[((u32, u32), u32, u32)], plusargs: &[&str]) {
    for (format, levels, height) in sizes {
        let mut c = Config::default();
        let d = design(*format, *levels, *height);
        (c.format.exp, c.format.man) = *format;
        (c.traverse, c.mode) = (d.traverse, d.mode);
        let (pyramid, rays) = hard(&d, 3);
        let set = ray_set(&d, &pyramid, &rays, 3).unwrap();
        let p = hardware(&c).unwrap();
        let t = &p.traverse;
        let mut files = p.files;
        files.extend(reliefrtl::bench::bench_files(&[], Some((&c.design(), t)), "relief_"));
        files.extend(set_files(&set.set).into_iter().map(|(n, text)| (format!("golden/traverse/{n}"), text)));
        files.insert("golden/traverse/memory.hex".into(), set.memory);
        let dir = tempfile::tempdir().unwrap();
        write(dir.path(), &files);
        let args: Vec<String> = plusargs.iter().map(|s| s.to_string()).collect();
        let o = run_bench(sim, dir.path(), "traverse", &Binding::new(), &args)
            .unwrap_or_else(|e| panic!("{format:?}, {levels} levels: {e}"));
        assert_eq!(o.checked, rays.len());
    }
}

#[test]
fn icarus_equals_golden() {
    if !skip() {
        simulated(Simulator::Icarus, &SIZES[1..2], &["gaps", "stalls", "flood"]);
        simulated(Simulator::Icarus, &SIZES[3..4], &[]);
    }
}

#[test]
fn verilator_equals_golden() {
    if !skip() {
        simulated(Simulator::Verilator, &[SIZES[2], SIZES[5]], &["gaps", "stalls"]);
    }
}

/// All that a patch can be has its code and its word.
#[test]
fn patches_have_codes_and_words() {
    assert_eq!(Patch::ALL.map(|p| (p.code(), p.word())), [(1, "hit"), (2, "above"), (3, "below")]);
}
