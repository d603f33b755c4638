//! The golden traversal: every mode finds the same texel, and it is the texel that exact arithmetic finds.
//!
//! `RELIEFRTL_RAYS` sets the rays per map; `RELIEFRTL_SEED` their seed.
mod cells;
mod fixed;
mod scenes;
mod windows;

use reliefrtl::config::{Design, LevelUp, ModeConfig, TraverseConfig, Trim};
use reliefrtl::format::FloatFormat;
use reliefrtl::golden::{Datapath, Decision, Pyramid, RayHit, RayInput, Watertight, float};
use reliefrtl::oracle::{ExactMap, ExactRay};
use scenes::{Kind, Rays, env, map};

/// All 40 modes with every trim that the format allows; the first one is the plain walk from the root.
fn modes(format: FloatFormat) -> Vec<ModeConfig> {
    let trims = if i64::from(format.man) + 4 <= i64::from(format.bias()) { &Trim::ALL[..] } else { &[Trim::None] };
    let mut all = Vec::new();
    for &trim in trims {
        for start_level in [false, true] {
            for levels_down in 1..=4 {
                let rest = ModeConfig { lod: true, ..ModeConfig::default() };
                let mode = |level_up| ModeConfig { start_level, levels_down, level_up, trim, ..rest };
                all.extend(LevelUp::ALL.map(mode));
            }
        }
    }
    all
}

fn design(format: FloatFormat, levels: u32, height_bits: u32, tile_bits: u32) -> Design {
    let traverse = TraverseConfig { levels, height_bits, tile_bits, ..TraverseConfig::default() };
    Design { format, traverse, ..Design::default() }
}

/// What must not depend on the mode.
fn answer(hit: &RayHit) -> (u32, u32, u32, u32, u64, bool, bool) {
    (hit.i, hit.j, hit.fu, hit.fv, hit.t, hit.wall, hit.limit)
}

/// Traces `count` rays of every kind in every mode; returns rays, and the rays on which some mode disagrees, with a witness.
fn disagreements(base: Design, kind: usize, count: u64, seed: u64) -> (u64, u64, String) {
    let (n, h) = (base.traverse.levels, base.traverse.height_bits);
    let texels = map(kind, n, h, seed);
    let pyramid = Pyramid::build(n, h, &texels).unwrap();
    let tracers: Vec<Watertight> =
        modes(base.format).into_iter().map(|mode| Watertight::prepare(&Design { mode, ..base }).unwrap()).collect();
    let mut rays = Rays::new(base.format, n, base.traverse.tile_bits, seed);
    let (mut total, mut wrong, mut witness) = (0, 0, String::new());
    for number in 0..count {
        let ray_kind = Kind::ALL[(number % Kind::ALL.len() as u64) as usize];
        // Every second ray ends at a finest level of its own, some above the root.
        let lod = if number % 2 == 0 { 0 } else { (number / 2 % u64::from(n + 3)) as u32 };
        let ray = RayInput { lod, ..rays.next(ray_kind) };
        let reference = tracers[0].trace(&pyramid, &ray);
        assert!(!reference.limit, "{ray_kind:?} {ray:x?} ran into the limit: {reference:?}");
        total += 1;
        for tracer in &tracers[1..] {
            let hit = tracer.trace(&pyramid, &ray);
            if answer(&hit) != answer(&reference) {
                wrong += 1;
                if witness.is_empty() {
                    let mode = tracer.design().mode;
                    witness = format!(
                        "format {} n {n} h {h} map {kind} seed {seed} {ray_kind:?} {ray:x?}: {mode:?} {hit:?}, plain {reference:?}",
                        base.format
                    );
                }
                break;
            }
        }
    }
    (total, wrong, witness)
}

fn all_modes_agree(formats: &[FloatFormat], levels: &[u32], heights: &[u32], tiles: &[u32], count: u64) {
    let seed = env("RELIEFRTL_SEED", 1);
    let (mut total, mut wrong, mut first) = (0, 0, String::new());
    for &format in formats {
        for &n in levels {
            for &h in heights {
                for &tile in tiles {
                    for kind in 0..scenes::MAPS {
                        let (t, w, witness) = disagreements(design(format, n, h, tile), kind, count, seed);
                        total += t;
                        wrong += w;
                        if w > 0 {
                            println!("{format} n {n} h {h} T {tile} map {kind}: {w} of {t}: {witness}");
                            first = if first.is_empty() { witness } else { first };
                        }
                    }
                }
            }
        }
    }
    println!("modes: {wrong} of {total} rays depend on the mode (40 modes, each trim, seed {seed})");
    assert!(total > 0, "no rays");
    assert_eq!(wrong, 0, "{first}");
}

#[test]
fn every_mode_returns_the_same_hit() {
    let levels = [2, 3, 4, 5, 6, 7, 8];
    all_modes_agree(&[FloatFormat::FP24], &levels, &[8, 16], &[4], env("RELIEFRTL_RAYS", 63));
}

#[test]
fn every_mode_returns_the_same_hit_in_other_formats() {
    let formats = [FloatFormat::new(5, 10), FloatFormat::new(6, 7), FloatFormat::new(8, 23)];
    all_modes_agree(&formats, &[2, 5], &[2, 8], &[1, 2], env("RELIEFRTL_RAYS", 27));
}

/// The least exponent range at which a map of 256 texels is legal: small travels underflow, their reciprocals overflow.
#[test]
fn every_mode_returns_the_same_hit_at_the_edge_of_the_exponents() {
    let formats = [FloatFormat::new(5, 7), FloatFormat::new(5, 16), FloatFormat::new(5, 23)];
    all_modes_agree(&formats, &[8, 10], &[2, 8], &[4], env("RELIEFRTL_RAYS", 27));
}

/// The exact answer to a ray.
fn exact(d: &Design, texels: &[u32], ray: &RayInput) -> reliefrtl::oracle::ExactHit {
    let map = ExactMap { levels: d.traverse.levels, height_bits: d.traverse.height_bits, texels };
    map.trace(&ExactRay::float(d.format, [ray.u, ray.v], [ray.du, ray.dv]).unwrap()).unwrap()
}

#[test]
fn the_hit_is_the_exact_one() {
    let (count, seed) = (env("RELIEFRTL_RAYS", 2000), env("RELIEFRTL_SEED", 1));
    for kind in Kind::ALL {
        let (mut total, mut wrong, mut walls, mut worst_t) = (0u64, 0u64, 0u64, 0f64);
        let mut witness = String::new();
        for (n, h) in [(4, 8), (6, 16), (8, 8)] {
            for scene in 0..scenes::MAPS {
                let d = design(FloatFormat::FP24, n, h, 4);
                let texels = map(scene, n, h, seed);
                let pyramid = Pyramid::build(n, h, &texels).unwrap();
                let golden = Watertight::prepare(&d).unwrap();
                let mut rays = Rays::new(d.format, n, 4, seed + 1000 * scene as u64);
                for _ in 0..count / 18 {
                    let ray = rays.next(kind);
                    let (hit, truth) = (golden.trace(&pyramid, &ray), exact(&d, &texels, &ray));
                    assert!(!hit.limit);
                    total += 1;
                    if (hit.i, hit.j) == (truth.i, truth.j) {
                        walls += u64::from(hit.wall != truth.wall);
                        worst_t = worst_t.max((float::to_f64(d.format, hit.t) - truth.t_f64).abs());
                    } else {
                        wrong += 1;
                        if witness.is_empty() {
                            witness = format!(", first n {n} map {scene} {ray:x?}: {hit:?}, exact {truth:?}");
                        }
                    }
                }
            }
        }
        println!(
            "{kind:?}: {wrong} of {total} in the wrong texel, {walls} other wall flags, largest error of t {worst_t:.2e} (seed {seed}){witness}"
        );
        assert!(total > 0, "no rays");
        if kind == Kind::Generic {
            assert!(wrong * 1000 < total, "{wrong} of {total} generic rays end in the wrong texel");
        }
        if kind == Kind::Down {
            assert_eq!(wrong + walls, 0, "straight down nothing is rounded");
        }
    }
}

#[test]
fn invalid_rays_leave_at_once() {
    let d = design(FloatFormat::FP24, 4, 8, 4);
    let fmt = d.format;
    let pyramid = Pyramid::build(4, 8, &map(0, 4, 8, 1)).unwrap();
    let golden = Watertight::prepare(&d).unwrap();
    let good = RayInput::from_f64(fmt, 0.25, 0.75, 0.5, -0.5);
    let nothing = RayHit { limit: true, ..RayHit::default() };
    let code = |x| float::from_f64(fmt, x);
    let bad_p = [code(-0.5), code(1.0), code(2.0), fmt.infinity(), fmt.nan(), fmt.infinity() | 1 | fmt.sign_bit()];
    let bad_d = [code(16.0), code(-16.0), code(17.0), fmt.infinity(), fmt.infinity() | fmt.sign_bit(), fmt.nan()];
    for p in bad_p {
        assert_eq!(golden.trace(&pyramid, &RayInput { u: p, ..good }), nothing);
        assert_eq!(golden.trace(&pyramid, &RayInput { v: p, ..good }), nothing);
        assert!(!golden.setup(&RayInput { v: p, ..good }).valid);
    }
    for x in bad_d {
        assert_eq!(golden.trace(&pyramid, &RayInput { du: x, ..good }), nothing);
        assert_eq!(golden.trace(&pyramid, &RayInput { dv: x, ..good }), nothing);
    }
    // The largest legal values, negative zero, and subnormals of either sign, which are zeros.
    let fine_p = [0, code(1.0) - 1, fmt.sign_bit(), 1, fmt.sign_bit() | 1];
    let fine_d = [0, code(16.0) - 1, code(-16.0) - 1, fmt.sign_bit(), 1, fmt.sign_bit() | 1];
    for p in fine_p {
        for x in fine_d {
            assert!(!golden.trace(&pyramid, &RayInput { u: p, du: x, ..good }).limit);
        }
    }
}

#[test]
fn the_step_limit_ends_a_ray() {
    let mut d = design(FloatFormat::FP24, 6, 8, 4);
    let pyramid = Pyramid::build(6, 8, &map(3, 6, 8, 1)).unwrap();
    let ray = RayInput::from_f64(d.format, 0.1, 0.2, 7.3, 5.9);
    let mut full = Vec::new();
    let whole = Watertight::prepare(&d).unwrap().trace_with(&pyramid, &ray, Some(&mut |it| full.push(*it)));
    assert_eq!(whole.steps as usize, full.len());
    assert!(full.len() > 5 && full.last().unwrap().decision == Decision::Hit);
    assert!(full.windows(2).all(|w| (w[0].next_x, w[0].next_y, w[0].next_t) == (w[1].x, w[1].y, w[1].t)));
    for limit in 1..whole.steps {
        d.traverse.step_limit = limit;
        let hit = Watertight::prepare(&d).unwrap().trace(&pyramid, &ray);
        let last = &full[limit as usize - 1];
        assert!(hit.limit && !hit.wall);
        assert_eq!((hit.steps, hit.t), (limit, last.next_t));
        assert_eq!((i64::from(hit.i), i64::from(hit.j)), (last.next_x.rem_euclid(64), last.next_y.rem_euclid(64)));
    }
    d.traverse.step_limit = whole.steps;
    assert_eq!(Watertight::prepare(&d).unwrap().trace(&pyramid, &ray), whole);
}
