//! The golden traversal in fixed point: every mode finds the same texel, no ray is given up, and what `docs/fixed.md` argues with holds.
use super::scenes::{self, env, map};
use super::{answer, modes};
use rand::seq::IndexedRandom;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use reliefrtl::config::{DatapathConfig, DatapathKind, Design, ModeConfig, TraverseConfig};
use reliefrtl::golden::fixed::{Fixed, FixedAxis};
use reliefrtl::golden::{Datapath, Pyramid, RayHit, RayInput, decode_time, encode_ray, prepare};
use reliefrtl::measure::exact_ray;
use reliefrtl::oracle::ExactMap;

/// A fixed-point design.
pub fn design(f: u32, w: u32, levels: u32, height_bits: u32, tile_bits: u32) -> Design {
    let datapath =
        DatapathConfig { kind: DatapathKind::Fixed, fraction_bits: f, reciprocal_bits: w, ..DatapathConfig::default() };
    let traverse = TraverseConfig { levels, height_bits, tile_bits, ..TraverseConfig::default() };
    Design { datapath, traverse, ..Design::default() }
}

/// Kinds of rays; all but the first are hard in some way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Generic,
    /// Entry and travel are multiples of an eighth of a texel or more.
    Lattice,
    AxisParallel,
    Down,
    /// Enters on a texel border or a few units beside it.
    Border,
    /// Travels a few units only.
    Tiny,
    /// Travels nearly as far as it may.
    Long,
    /// |du| = |dv|.
    Diagonal,
    /// Any words.
    Words,
}

impl Kind {
    pub const ALL: [Self; 9] = [
        Self::Generic,
        Self::Lattice,
        Self::AxisParallel,
        Self::Down,
        Self::Border,
        Self::Tiny,
        Self::Long,
        Self::Diagonal,
        Self::Words,
    ];
}

/// A valid ray of a kind.
pub fn ray(d: &Design, kind: Kind, rng: &mut ChaCha8Rng) -> RayInput {
    let (f, n, tile) = (d.datapath.fraction_bits, d.traverse.levels, d.traverse.tile_bits);
    let (one, far) = (1i64 << f, 1i64 << (f + tile));
    let texel = 1i64 << (f - n);
    let mut p = [rng.random_range(0..one), rng.random_range(0..one)];
    let mut v = [0, 1].map(|_| rng.random_range(-one..=one) >> rng.random_range(0..6));
    let on_grid = |x: i64, rng: &mut ChaCha8Rng| x & -(texel << rng.random_range(0..n) >> 3.min(f - n));
    let border = |rng: &mut ChaCha8Rng| (rng.random_range(0..one) & -texel) + rng.random_range(-2..=2);
    let which = rng.random_range(0..2);
    match kind {
        Kind::Generic => {}
        Kind::Lattice => {
            p = p.map(|x| on_grid(x, rng));
            v = v.map(|x| on_grid(x << rng.random_range(0..tile), rng));
        }
        Kind::AxisParallel => {
            p[which] = border(rng);
            v[which] = 0;
        }
        Kind::Down => {
            p[which] = border(rng);
            v = [0, 0];
        }
        Kind::Border => {
            p = [border(rng), border(rng)];
            v[which] = on_grid(v[which], rng);
        }
        Kind::Tiny => {
            p[which] = border(rng);
            v = [0, 1].map(|_| rng.random_range(-40i64..=40) >> rng.random_range(0..6));
        }
        Kind::Long => v = [0, 1].map(|_| (far - 1 - rng.random_range(0..4)) * [1, -1].choose(rng).expect("two signs")),
        Kind::Diagonal => {
            p = p.map(|x| on_grid(x, rng));
            v[1] = v[0] * [1, -1].choose(rng).expect("two signs");
        }
        Kind::Words => v = [0, 1].map(|_| rng.random_range(1 - far..far)),
    }
    let v = v.map(|x| x.clamp(1 - far, far - 1) as u64 & (2 * far as u64 - 1));
    let p = p.map(|x| x.rem_euclid(one) as u64);
    RayInput { u: p[0], v: p[1], du: v[0], dv: v[1], lod: 0 }
}

/// All 120 modes: there is no format that a trim does not fit.
fn every_mode() -> Vec<ModeConfig> {
    let all = modes(reliefrtl::format::FloatFormat::FP24);
    assert_eq!(all.len(), 120);
    all
}

/// Traces `count` rays over a map in all modes; returns rays, those on which a mode disagrees, those given up, and a witness.
fn disagreements(base: Design, kind: usize, count: u64, seed: u64) -> (u64, u64, u64, String) {
    let (n, h) = (base.traverse.levels, base.traverse.height_bits);
    let pyramid = Pyramid::build(n, h, &map(kind, n, h, seed)).unwrap();
    let tracers: Vec<Fixed> =
        every_mode().into_iter().map(|mode| Fixed::prepare(&Design { mode, ..base }).unwrap()).collect();
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let (mut wrong, mut limits, mut witness) = (0, 0, String::new());
    for number in 0..count {
        let of = Kind::ALL[number as usize % Kind::ALL.len()];
        // Every second ray ends at a finest level of its own, some above the root.
        let lod = if number % 2 == 0 { 0 } else { (number / 2 % u64::from(n + 3)) as u32 };
        let ray = RayInput { lod, ..ray(&base, of, &mut rng) };
        let plain = tracers[0].trace(&pyramid, &ray);
        limits += u64::from(plain.limit);
        let other = tracers[1..].iter().find(|t| answer(&t.trace(&pyramid, &ray)) != answer(&plain));
        wrong += u64::from(other.is_some());
        if let Some(t) = other.filter(|_| witness.is_empty()) {
            let (path, hit) = (base.datapath, t.trace(&pyramid, &ray));
            witness = format!(
                "{path:?} n {n} h {h} map {kind} seed {seed} {of:?} {ray:x?}: {:?} {hit:?}, plain {plain:?}",
                t.design().mode
            );
        }
    }
    (count, wrong, limits, witness)
}

/// Fraction bits, reciprocal bits, levels, height bits, tile bits: usual ones, and the ends of what is legal.
pub const SIZES: [(u32, u32, u32, u32, u32); 14] = [
    (24, 24, 8, 8, 4),
    (24, 18, 6, 16, 4),
    (20, 18, 5, 8, 4),
    (20, 24, 7, 16, 2),
    (12, 10, 4, 8, 4),
    (12, 10, 12, 8, 1),
    (8, 8, 8, 8, 4),
    (8, 32, 2, 2, 8),
    (28, 31, 5, 16, 4),
    (28, 8, 3, 2, 1),
    (16, 16, 3, 12, 8),
    (24, 30, 2, 8, 8),
    (16, 8, 6, 16, 3),
    (12, 31, 4, 12, 4),
];

#[test]
fn every_mode_returns_the_same_hit_in_fixed_point() {
    let (count, seed) = (env("RELIEFRTL_RAYS", 1300), env("RELIEFRTL_SEED", 1));
    let (mut total, mut wrong, mut limits, mut first) = (0, 0, 0, String::new());
    for (f, w, n, h, tile) in SIZES {
        // A map of 4096 texels to the side is slow to build; one kind of it is enough.
        for kind in 0..if n > 8 { 1 } else { scenes::MAPS } {
            let (t, x, l, witness) = disagreements(design(f, w, n, h, tile), kind, count, seed);
            (total, wrong, limits) = (total + t, wrong + x, limits + l);
            first = if first.is_empty() { witness } else { first };
        }
    }
    println!("fixed: {wrong} of {total} rays depend on the mode, {limits} given up (120 modes, seed {seed})");
    assert!(total > 0 && limits == 0, "{limits} of {total} rays were given up");
    assert_eq!(wrong, 0, "{first}");
}

/// Rays as an iteration sees them: an estimate is never ahead of its plane parameters, which grow with the plane.
#[test]
fn estimates_are_never_ahead_and_planes_come_in_order() {
    let (count, seed) = (env("RELIEFRTL_RAYS", 3000), env("RELIEFRTL_SEED", 1));
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let (mut checked, mut exact) = (0, 0);
    for (f, w, n, h, tile) in SIZES {
        let d = design(f, w, n, h, tile);
        let g = Fixed::prepare(&d).unwrap();
        let texel = 1i64 << (f - n);
        let bottom = ((1u64 << h) - 1) << (f + 2 - h);
        for k in 0..count {
            let r = ray(&d, Kind::ALL[k as usize % 9], &mut rng);
            let a = g.setup(&r).u;
            let time = |b: i64| g.plane_time((b * texel - a.p as i64).unsigned_abs(), a.r, a.z);
            let m = rng.random_range(0..=bottom) >> if rng.random() { 0 } else { rng.random_range(0..f) };
            let e = g.estimate(&a, m);
            // The last plane before the estimated texel was met at m or before, if it is one that the ray meets.
            let (met, passed) = if a.neg { (e + 1, e < a.x) } else { (e, e > a.x) };
            assert!(!passed || time(met) <= m, "{d:?} {r:x?} m {m:x}: texel {e}");
            exact += u64::from(passed);
            let b = if a.neg { a.x } else { a.x + 1 };
            let next = if a.neg { b - 1 } else { b + 1 };
            assert!(time(b) <= time(next), "{d:?} {r:x?}: planes {b} and {next}");
            checked += 1;
        }
    }
    println!("{checked} estimates, {exact} of them beyond a plane (seed {seed})");
    assert!(exact * 4 > checked);
}

/// Whether a chord's end and the end of the ray lie beyond plane `b`, if the ray meets it; `None` if it does not. `late`: how much later the ray
/// leaves than it meets the plane.
fn passed(g: &Fixed, a: &FixedAxis, b: i64, late: u64) -> Option<[bool; 2]> {
    let (f, n, h) = (g.design().datapath.fraction_bits, g.design().traverse.levels, g.design().traverse.height_bits);
    let bottom = ((1u64 << h) - 1) << (f + 2 - h);
    let t = g.plane_time(((b << (f - n)) - a.p as i64).unsigned_abs(), a.r, a.z);
    // A plane at a lower index is passed only when the ray is in front of it.
    let beyond = |at: i64| if a.neg { at < b } else { at >= b };
    (t <= bottom).then(|| [beyond(g.chord_end(a, t.saturating_add(late).min(bottom))), beyond(a.le)])
}

/// A map whose texels are the units of a position: each travel, each plane that it meets, both ways. What is greater than a plane's own
/// parameter brings the chord no less far, so nothing else needs a look.
#[test]
fn no_chord_ends_before_a_plane_that_is_met_exhaustively() {
    let mut met = 0u64;
    for (w, h, tile) in [(8, 2, 1), (8, 8, 1), (9, 3, 2), (12, 2, 2), (8, 4, 3), (32, 2, 1)] {
        let g = Fixed::prepare(&design(8, w, 8, h, tile)).unwrap();
        for d in 1 - (1i64 << (8 + tile))..1 << (8 + tile) {
            let word = d as u64 & ((2 << (8 + tile)) - 1);
            let a = g.setup(&RayInput { u: 77, v: 0, du: word, dv: 0, lod: 0 }).u;
            let ahead = |k: i64| if a.neg { 77 - k } else { 77 + k };
            for k in 0..=d.abs() + d.abs() / 16 + 2 {
                let Some(passed) = passed(&g, &a, ahead(k), 0) else { break };
                assert_eq!(passed, [true; 2], "w {w} h {h} T {tile}: travel {d}, plane {k} ahead");
                met += 1;
            }
        }
    }
    println!("{met} planes, none beyond its chord's end or the ray's");
    assert!(met > 3_000_000);
}

/// As above where nothing can be exhausted: any sizes, planes near and far, also where the other axis' plane is met later.
#[test]
fn no_chord_ends_before_a_plane_that_is_met() {
    let (count, seed) = (env("RELIEFRTL_RAYS", 20000), env("RELIEFRTL_SEED", 1));
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let (mut checked, mut tight) = (0u64, 0u64);
    for (f, w, n, h, tile) in SIZES {
        let d = design(f, w, n, h, tile);
        let g = Fixed::prepare(&d).unwrap();
        for k in 0..count {
            let r = ray(&d, Kind::ALL[k as usize % 9], &mut rng);
            let a = g.setup(&r).u;
            let b = rng.random_range(a.x.min(a.xa)..=a.x.max(a.xa)) + i64::from(!a.neg);
            let late = if rng.random() { 0 } else { rng.random_range(0..1 << f) };
            let Some(both) = passed(&g, &a, b, late) else { continue };
            assert_eq!(both, [true; 2], "{d:?} {r:x?}: plane {b}");
            checked += 1;
            // The trim is of use: the end is the very texel beyond the plane.
            let t = g.plane_time(((b << (f - n)) - a.p as i64).unsigned_abs(), a.r, a.z);
            tight += u64::from(g.chord_end(&a, t) == if a.neg { b - 1 } else { b });
        }
    }
    println!("{checked} planes, at {tight} the chord ends in the texel beyond the plane (seed {seed})");
    assert!(checked > 4 * count && tight * 2 > checked, "{tight} of {checked}");
}

#[test]
fn the_hit_in_fixed_point_is_the_exact_one() {
    let (count, seed) = (env("RELIEFRTL_RAYS", 2000), env("RELIEFRTL_SEED", 1));
    for (f, w, most) in [(24, 24, 0.0002), (28, 31, 0.0001), (24, 18, 0.001), (20, 18, 0.002), (12, 10, 0.3)] {
        let (mut total, mut wrong, mut worst) = (0u64, 0u64, 0f64);
        for (n, h) in [(4, 8), (6, 12), (8, 8)] {
            for scene in 0..scenes::MAPS {
                let d = design(f, w, n, h, 4);
                let texels = map(scene, n, h, seed);
                let pyramid = Pyramid::build(n, h, &texels).unwrap();
                let golden = prepare(&d).unwrap();
                let mut rng = ChaCha8Rng::seed_from_u64(seed + 1000 * scene as u64);
                for _ in 0..count / 18 {
                    let ray = ray(&d, Kind::Generic, &mut rng);
                    let hit = golden.trace(&pyramid, &ray);
                    let truth = ExactMap { levels: n, height_bits: h, texels: &texels };
                    let truth = truth.trace(&exact_ray(&d, &ray).unwrap()).unwrap();
                    assert!(!hit.limit);
                    total += 1;
                    if (hit.i, hit.j) == (truth.i, truth.j) {
                        worst = worst.max((decode_time(&d, hit.t) - truth.t_f64).abs());
                    } else {
                        wrong += 1;
                    }
                }
            }
        }
        println!(
            "Q.{f}/{w}: {wrong} of {total} in the wrong texel, largest error of t {worst:.2e} codes (seed {seed})"
        );
        assert!(total > 0 && wrong as f64 <= most * total as f64, "{wrong} of {total} in Q.{f}/{w}");
    }
}

#[test]
fn words_of_fixed_point_rays() {
    let d = design(12, 10, 4, 8, 4);
    let pyramid = Pyramid::build(4, 8, &map(0, 4, 8, 1)).unwrap();
    let golden = Fixed::prepare(&d).unwrap();
    let nothing = RayHit { limit: true, ..RayHit::default() };
    let r = encode_ray(&d, [0.25, 1.75, 0.5, -0.5]);
    assert_eq!(r, RayInput { u: 0x400, v: 0xc00, du: 0x800, dv: 0x1f800, lod: 0 });
    assert!(!golden.trace(&pyramid, &r).limit);
    // The entry point wraps, also where it rounds up to 1; travels that are too long are the word that no ray may have.
    assert_eq!(encode_ray(&d, [-0.25, 0.999_99, 0.0, 0.0]), RayInput { u: 0xc00, v: 0, du: 0, dv: 0, lod: 0 });
    for far in [16.0, -16.0, 1e30, -1e30, 15.999_99] {
        let r = encode_ray(&d, [0.0, 0.0, far, 0.0]);
        assert_eq!(r.du, 0x10000, "{far}");
        assert_eq!(golden.trace(&pyramid, &r), nothing);
        assert_eq!(golden.trace(&pyramid, &RayInput { du: 0, dv: r.du, ..r }), nothing);
    }
    for longest in [0xffff, 0x10001] {
        assert!(!golden.trace(&pyramid, &RayInput { u: 1, v: 2, du: longest, dv: 0x10001, lod: 0 }).limit);
    }
}

#[test]
fn illegal_sizes_are_refused() {
    let bad = [(12, 10, 12, 16, 1), (8, 8, 9, 8, 1), (28, 24, 8, 8, 5), (28, 32, 8, 8, 4), (24, 24, 12, 8, 11)];
    for (f, w, n, h, tile) in bad {
        assert!(Fixed::prepare(&design(f, w, n, h, tile)).is_err(), "{f} {w} {n} {h} {tile}");
    }
    for (f, w, n, h, tile) in SIZES {
        assert!(Fixed::prepare(&design(f, w, n, h, tile)).is_ok(), "{f} {w} {n} {h} {tile}");
    }
}
