//! The exact walk against itself in wide integers only, and against a walk in arbitrary rationals.
use crate::budget::share;
use dashu::base::Abs;
use dashu::integer::{IBig, UBig};
use dashu::rational::RBig;
use reliefrtl::config::{Config, DatapathKind, Design};
use reliefrtl::golden::fixed::travel;
use reliefrtl::golden::{RayInput, encode_ray, float};
use reliefrtl::measure::exact_ray;
use reliefrtl::oracle::{ExactHit, ExactMap, Ratio};
use reliefrtl::scene::hard::Case;

/// Texel, wall, parameter, texels visited.
type Answer = (u32, u32, bool, RBig, u64);

fn answer(hit: &ExactHit) -> Answer {
    (hit.i, hit.j, hit.wall, rational(&hit.t), hit.texels)
}

fn power(exp: i32) -> RBig {
    let power = RBig::from(IBig::from(1) << exp.unsigned_abs() as usize);
    if exp < 0 { RBig::ONE / power } else { power }
}

fn rational(t: &Ratio) -> RBig {
    let num = (UBig::from(t.num.high) << 128) + UBig::from(t.num.low);
    RBig::from(num) / RBig::from(t.den) * power(t.exp)
}

/// Entry point and travel in texels.
fn numbers(d: &Design, r: &RayInput) -> [RBig; 4] {
    let side = power(d.traverse.levels as i32);
    let fixed = d.datapath.kind == DatapathKind::Fixed;
    let of = |k: usize, word: u64| {
        let tiles = if fixed {
            let word = if k < 2 { IBig::from(word) } else { IBig::from(travel(d, word)) };
            RBig::from(word) * power(-(d.datapath.fraction_bits as i32))
        } else {
            RBig::try_from(float::to_f64(d.format, word)).expect("finite")
        };
        tiles * &side
    };
    [of(0, r.u), of(1, r.v), of(2, r.du), of(3, r.dv)]
}

/// The walk as the documentation says it, in fractions.
fn reference(d: &Design, texels: &[u32], r: &RayInput) -> Answer {
    let [pu, pv, du, dv] = numbers(d, r);
    let bottom = RBig::from((1u32 << d.traverse.height_bits) - 1);
    let side = 1i64 << d.traverse.levels;
    let floor = |x: &RBig| i64::try_from(x.floor()).unwrap();
    let mut at = [floor(&pu), floor(&pv)];
    let exit = |p: &RBig, d: &RBig, at: i64| {
        (*d != RBig::ZERO).then(|| {
            let plane = RBig::from(if *d < RBig::ZERO { at } else { at + 1 });
            (plane - p).abs() * &bottom / d.clone().abs()
        })
    };
    let mut entry = RBig::ZERO;
    for visited in 1.. {
        let [i, j] = at.map(|x| x.rem_euclid(side));
        let top = &bottom - RBig::from(texels[(j * side + i) as usize]);
        let (u, v) = (exit(&pu, &du, at[0]), exit(&pv, &dv, at[1]));
        let u_first = match (&u, &v) {
            (Some(u), Some(v)) => u <= v,
            (u, _) => u.is_some(),
        };
        let out = if u_first { u } else { v };
        let ends = out.as_ref().is_none_or(|out| top < *out && entry < *out);
        if ends {
            let wall = top < entry;
            return (i as u32, j as u32, wall, if wall { entry } else { top }, visited);
        }
        entry = out.unwrap();
        let (axis, travel) = if u_first { (0, &du) } else { (1, &dv) };
        at[axis] += if *travel < RBig::ZERO { -1 } else { 1 };
    }
    unreachable!()
}

/// So many rays of each case, or of one in so many cases.
fn check(sets: &[&str], rays: usize, step: usize) {
    let mut c = Config::default();
    sets.iter().for_each(|set| c.apply_set(set).unwrap());
    c.validate().unwrap();
    let (mut total, mut in_fractions, mut ties) = (0, 0, 0);
    for case in Case::all().step_by(step) {
        let scene = case.scene(&c.design(), rays, 7);
        let t = scene.design.traverse;
        if (Config { traverse: t, ..c.clone() }).validate().is_err() || t.levels > c.traverse.levels.max(8) {
            continue;
        }
        let map = ExactMap { levels: t.levels, height_bits: t.height_bits, texels: &scene.texels };
        for ray in &scene.rays {
            let ray = encode_ray(&scene.design, *ray);
            let exact = exact_ray(&scene.design, &ray).unwrap();
            let (fast, wide) = (map.trace(&exact).unwrap(), map.trace_wide(&exact).unwrap());
            assert_eq!(answer(&fast), answer(&wide), "{} {ray:x?}", case.name);
            let near = |a: f64, b: f64| a == b || (a - b).abs() <= 1e-12 || (a / b - 1.0).abs() < 1e-3;
            assert!(near(fast.margin, wide.margin) && near(fast.wall_margin, wide.wall_margin), "{fast:?} {wide:?}");
            assert_eq!((fast.margin == 0.0, fast.wall_margin == 0.0), (wide.margin == 0.0, wide.wall_margin == 0.0));
            total += 1;
            ties += u32::from(fast.margin == 0.0);
            // Fractions of so many digits take their time.
            if fast.texels < 400 {
                assert_eq!(answer(&fast), reference(&scene.design, &scene.texels, &ray), "{} {ray:x?}", case.name);
                in_fractions += 1;
            }
        }
    }
    println!("{sets:?}: 0 of {total} rays differ from wide integers, 0 of {in_fractions} from fractions; {ties} ties");
    assert!(in_fractions > total / 2 && ties > 0);
}

#[test]
fn the_default_format() {
    check(&[], 20, 1);
}

#[test]
fn the_widest_float() {
    check(&["format.exp=8", "format.man=23", "traverse.height_bits=16", "traverse.tile_bits=8"], 10, 1);
}

#[test]
fn the_widest_float_on_the_largest_map() {
    check(&["format.exp=8", "format.man=23", "traverse.height_bits=16", "traverse.levels=12"], 2, share(3));
}

#[test]
fn the_widest_fixed_point() {
    check(&["datapath.kind=fixed", "datapath.fraction_bits=28", "traverse.height_bits=16"], 10, 1);
}
