//! The bilinear refinement against the exact surface between texel centres (`docs/bilinear.md`).
use reliefrtl::config::{Config, MapKind, View};
use reliefrtl::golden::{Datapath, Patch, Pyramid, RayInput, Refined, Watertight, float};
use reliefrtl::measure::exact_ray;
use reliefrtl::oracle::{Dyadic, ExactMap, ExactRay};
use reliefrtl::project::Scene;

const FORMATS: [(u32, u32); 3] = [(7, 16), (8, 23), (5, 10)];

fn config((exp, man): (u32, u32), kind: MapKind) -> Config {
    let mut c = Config::default();
    (c.format.exp, c.format.man) = (exp, man);
    (c.traverse.levels, c.traverse.height_bits, c.traverse.tile_bits) = (6, 8, 3);
    (c.map.kind, c.vectors.rays) = (kind, 200);
    c
}

/// A refined ray and what judges it.
struct Case {
    ray: RayInput,
    exact: ExactRay,
    block: f64,
    refined: Refined,
}

fn cases(c: &Config, scene: &Scene) -> Vec<Case> {
    let d = c.design();
    let golden = Watertight::prepare(&d).unwrap();
    let one = |ray: RayInput| {
        let hit = golden.trace(&scene.pyramid, &ray);
        let refined = golden.refine(&scene.pyramid, &ray, &hit)?;
        let block = float::to_f64(d.format, hit.t);
        Some(Case { ray, exact: exact_ray(&d, &ray).unwrap(), block, refined })
    };
    scene.sample(c).unwrap().into_iter().filter_map(one).collect()
}

fn exact_map<'a>(c: &Config, texels: &'a [u32]) -> ExactMap<'a> {
    ExactMap { levels: c.traverse.levels, height_bits: c.traverse.height_bits, texels }
}

fn dyadic(c: &Config, t: u64) -> Dyadic {
    Dyadic::read(t, c.format.exp, c.format.man).expect("finite")
}

/// What rounding may do to a gap: the position's error times the steepest step of the map, and that of the depth and the difference.
fn gap_bound(c: &Config, texels: &[u32], x: &ExactRay) -> f64 {
    let side = 1usize << c.traverse.levels;
    let code = |i: usize, j: usize| f64::from(texels[(j % side) * side + i % side]);
    let step = |i, j| (code(i + 1, j) - code(i, j)).abs().max((code(i, j + 1) - code(i, j)).abs());
    let steepest = (0..side * side).map(|k| step(k % side, k / side)).fold(0.0, f64::max);
    let u = 0.5 / 2f64.powi(c.format.man as i32);
    let off = |d: &Dyadic| u * 5.0 * side as f64 * (d.to_f64().abs() + 1.0) + 0.5f64.powi(c.traverse.frac_bits as i32);
    let codes = 2f64.powi(c.traverse.height_bits as i32);
    steepest * (off(&x.d[0]) + off(&x.d[1])) + 3.0 * u * codes
}

#[test]
fn gaps_and_their_signs_are_those_of_the_exact_surface() {
    let mut seen = [0; 3];
    for format in FORMATS {
        for kind in [MapKind::Rocks, MapKind::Bricks, MapKind::Spikes, MapKind::Checker] {
            let c = config(format, kind);
            let scene = Scene::new(&c, None, false).unwrap();
            let map = exact_map(&c, &scene.texels);
            for x in cases(&c, &scene) {
                let bound = gap_bound(&c, &scene.texels, &x.exact);
                let exact = x.refined.window.map(|t| map.bilinear_gap(&x.exact, &dyadic(&c, t)).unwrap());
                for (got, want) in x.refined.gaps.iter().zip(exact) {
                    let got = float::to_f64(c.design().format, *got);
                    assert!((got - want).abs() <= bound, "{format:?} {kind}: {:?} {got} {want} {bound}", x.ray);
                }
                if exact.iter().all(|g| g.abs() > bound) {
                    let want = match (exact[0] < 0.0, exact[1] > 0.0) {
                        (true, _) => Patch::Below,
                        (_, true) => Patch::Above,
                        _ => Patch::Hit,
                    };
                    assert_eq!(x.refined.patch, want, "{format:?} {kind}: {:?}", x.ray);
                    seen[want as usize] += 1;
                }
            }
        }
    }
    assert!(seen.iter().all(|n| *n > 20), "hit, above, below: {seen:?}");
}

#[test]
fn the_step_is_the_secant_of_its_gaps() {
    for format in FORMATS {
        let c = config(format, MapKind::Rocks);
        let scene = Scene::new(&c, None, false).unwrap();
        let f = c.design().format;
        let mut hits = 0;
        for x in cases(&c, &scene).iter().filter(|x| x.refined.patch == Patch::Hit) {
            let [from, to] = x.refined.window.map(|t| float::to_f64(f, t));
            let [a, b] = x.refined.gaps.map(|g| float::to_f64(f, g));
            let want = if a == 0.0 { from } else { from + (to - from) * a / (a - b) };
            let u = 0.5 / 2f64.powi(c.format.man as i32);
            let got = float::to_f64(f, x.refined.t);
            assert!((got - want).abs() <= u * (5.0 * (to - from) + want), "{:?}: {got} {want}", x.ray);
            assert!(from <= got && got <= to);
            hits += 1;
        }
        assert!(hits > 30, "{hits}");
    }
}

/// The first root: the surface is met there, and nowhere before on a fine grid.
#[test]
fn the_exact_root_is_the_first() {
    let c = config((7, 16), MapKind::Spikes);
    let scene = Scene::new(&c, None, false).unwrap();
    let map = exact_map(&c, &scene.texels);
    let (mut roots, mut misses) = (0, 0);
    for x in cases(&c, &scene) {
        let ends = x.refined.window.map(|t| dyadic(&c, t));
        let at = |t: f64| map.bilinear_gap(&x.exact, &Dyadic::new(false, (t * 2f64.powi(44)) as u128, -44)).unwrap();
        let [from, to] = [0, 1].map(|k: usize| ends[k].to_f64());
        let root = map.bilinear_root(&x.exact, [&ends[0], &ends[1]], 30).unwrap();
        let until = root.map_or(to, |r| r.low);
        let above = (0..=32).all(|k| at(from + (until - from) * f64::from(k) / 32.0) > -1e-7);
        match root {
            Some(r) => {
                assert!(above && r.high - r.low <= 2f64.powi(-30), "{:?}", x.ray);
                // Both ends were rounded to f64; gaps of steep rays change by far less than this in so little.
                assert!(at(r.low) > -1e-6 && at(r.high) < 1e-6, "{:?} {r:?}", x.ray);
                roots += 1;
            }
            None => {
                assert!(above || at(from) < 0.0, "{:?}", x.ray);
                misses += 1;
            }
        }
    }
    assert!(roots > 50 && misses > 10, "{roots} roots, {misses} misses");
}

/// On a plane the secant is the root: what is left is rounding.
#[test]
fn a_plane_is_met_where_it_is() {
    for format in FORMATS {
        let c = config(format, MapKind::Flat);
        let d = c.design();
        let texels: Vec<u32> = (0..64 * 64).map(|k| 2 * (k % 64)).collect();
        let pyramid = Pyramid::build(6, 8, &texels).unwrap();
        let map = exact_map(&c, &texels);
        let golden = Watertight::prepare(&d).unwrap();
        let mut met = 0;
        for k in 0..400 {
            // The ramp rises along the ray, and is met long before the map repeats.
            let s = f64::from(k) / 400.0;
            let ray = RayInput::from_f64(d.format, 0.1 + 0.2 * s, (s * 37.0).fract(), 0.3 + 0.2 * s, s - 0.5);
            let hit = golden.trace(&pyramid, &ray);
            let r = golden.refine(&pyramid, &ray, &hit).unwrap();
            if r.patch != Patch::Hit {
                continue;
            }
            let x = exact_ray(&d, &ray).unwrap();
            let ends = r.window.map(|t| dyadic(&c, t));
            // Gaps fall faster than the ray does, so an error of a gap is none larger of the parameter.
            let bound = gap_bound(&c, &[0, 2, 4, 6].repeat(1024), &x) + 512.0 / 2f64.powi(c.format.man as i32);
            let got = float::to_f64(d.format, r.t);
            if let Some(root) = map.bilinear_root(&x, [&ends[0], &ends[1]], 30).unwrap() {
                assert!((got - root.low).abs() <= 2.0 * bound, "{format:?} {ray:?}: {got} {root:?} {bound}");
                met += 1;
            }
        }
        assert!(met > 200, "{met}");
    }
}

/// The refined parameter is nearer to the root than the block's, by median; figures with the witness of the maximum.
#[test]
fn the_refinement_comes_nearer_to_the_root() {
    for format in FORMATS {
        let mut c = config(format, MapKind::Rocks);
        c.view.names = vec![View::Front, View::Oblique];
        let scene = Scene::new(&c, None, false).unwrap();
        let map = exact_map(&c, &scene.texels);
        let (mut refined, mut block) = (Vec::new(), Vec::new());
        for x in cases(&c, &scene).iter().filter(|x| x.refined.patch == Patch::Hit) {
            let ends = x.refined.window.map(|t| dyadic(&c, t));
            let Some(root) = map.bilinear_root(&x.exact, [&ends[0], &ends[1]], 30).unwrap() else { continue };
            refined.push(((float::to_f64(c.design().format, x.refined.t) - root.low).abs(), x.ray));
            block.push((x.block - root.low).abs());
        }
        refined.sort_by(|a, b| a.0.total_cmp(&b.0));
        block.sort_by(f64::total_cmp);
        let n = refined.len();
        let [p50, p99] = [n / 2, n * 99 / 100].map(|k| refined[k].0);
        let (max, witness) = refined[n - 1];
        println!("{format:?}: {n} roots, error p50 {p50:.2e} p99 {p99:.2e} max {max:.2e} codes at {witness:x?}");
        println!("  block p50 {:.2e} p99 {:.2e} max {:.2e}", block[n / 2], block[n * 99 / 100], block[n - 1]);
        assert!(n > 50 && p50 * 2.0 < block[n / 2], "{format:?}");
    }
}
