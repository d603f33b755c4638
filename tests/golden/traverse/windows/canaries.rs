//! Each rule is needed: without it, some ray ends in another texel. And a second reading of the rules agrees with the model in every word.
use super::super::fixed::{Kind, ray};
use super::super::scenes::{self, env, map};
use super::designs::{SETS, any_set, any_sizes, pyramid, windows};
use super::plain::{Fault, Found, Plain};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use reliefrtl::config::{Design, Window, WindowSet};
use reliefrtl::golden::fixed::Fixed;
use reliefrtl::golden::{Datapath, Pyramid, RayHit, RayInput, prepare};

const MOST: u32 = 65535;

fn found(hit: &RayHit) -> Found {
    (i64::from(hit.i), i64::from(hit.j), i128::from(hit.t), hit.wall, hit.steps)
}

/// Texel, t and wall.
fn place(found: Option<Found>) -> Option<(i64, i64, i128, bool)> {
    found.map(|(i, j, t, wall, _)| (i, j, t, wall))
}

/// The first of `count` rays of one kind, or of all, on maps of 2^2 to 2^5 texels a side that `fault` leads elsewhere than the model; with the number of rays that it took.
fn astray(sizes: impl Fn(&WindowSet) -> Vec<Window>, fault: Fault, count: u64, seed: u64) -> (u64, Option<String>) {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    for number in 0..count / 100 {
        let numbers = any_sizes(5, &mut rng);
        let set = any_set(numbers.2, &mut rng);
        let d = windows(numbers, set);
        let texels = map(number as usize % scenes::MAPS, numbers.2, numbers.3, number);
        let plain = Plain { design: &d, sizes: &sizes(&set), texels: &texels, fault };
        let fixed = Fixed::prepare(&pyramid(&d)).unwrap();
        let pyramid = Pyramid::build(numbers.2, numbers.3, &texels).unwrap();
        for k in 0..100 {
            let ray = ray(&d, Kind::ALL[k % Kind::ALL.len()], &mut rng);
            let truth = fixed.trace(&pyramid, &ray);
            if place(plain.trace(&fixed, &ray, MOST)) != place(Some(found(&truth))) {
                let told = format!("{numbers:?} {set} {ray:x?}, not {truth:?}");
                return (number * 100 + k as u64 + 1, Some(told));
            }
        }
    }
    (count, None)
}

fn as_they_are(set: &WindowSet) -> Vec<Window> {
    set.sizes().to_vec()
}

#[test]
fn a_second_reading_agrees_in_every_word_and_takes_no_more_iterations_than_the_walk() {
    let (count, seed) = (env("RELIEFRTL_RAYS", 100), env("RELIEFRTL_SEED", 1));
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let (mut rays, mut shorter) = (0u64, 0u64);
    for number in 0..200u64 {
        let numbers = any_sizes(5, &mut rng);
        let set = match SETS.get(number as usize % (2 * SETS.len())).map(|s| s.parse::<WindowSet>().unwrap()) {
            Some(set) if set.misfit(numbers.2).is_none() => set,
            _ => any_set(numbers.2, &mut rng),
        };
        let d = windows(numbers, set);
        let texels = map(number as usize % scenes::MAPS, numbers.2, numbers.3, number);
        let pyramid_map = Pyramid::build(numbers.2, numbers.3, &texels).unwrap();
        let (model, fixed) = (prepare(&d).unwrap(), Fixed::prepare(&pyramid(&d)).unwrap());
        let plain = Plain { design: &d, sizes: set.sizes(), texels: &texels, fault: Fault::None };
        let walk = Plain { sizes: &[Window::TEXEL], ..plain };
        for k in 0..count {
            let ray = ray(&d, Kind::ALL[k as usize % Kind::ALL.len()], &mut rng);
            let hit = model.trace(&pyramid_map, &ray);
            assert_eq!(plain.trace(&fixed, &ray, MOST), Some(found(&hit)), "{numbers:?} {set} {ray:x?}");
            let texels = walk.trace(&fixed, &ray, MOST).unwrap();
            assert_eq!(place(Some(texels)), place(Some(found(&hit))), "{numbers:?} {set} {ray:x?}");
            assert!(hit.steps <= texels.4, "{numbers:?} {set} {ray:x?}: {} iterations, {} texels", hit.steps, texels.4);
            shorter += u64::from(hit.steps < texels.4);
            rays += 1;
        }
    }
    println!(
        "{rays} rays agree with a second reading; {shorter} of them take fewer iterations than texels (seed {seed})"
    );
    assert!(shorter > rays / 10, "{shorter} of {rays}");
}

/// The ray that `docs/windows.md` names.
fn witness() -> (Design, RayInput) {
    let d = windows((14, 10, 5, 2, 7), "1 2@2".parse().unwrap());
    let word = |travel: i64| travel as u64 & ((1 << (14 + 7 + 1)) - 1);
    (d, RayInput { u: 13823, v: 16383, du: word(16384), dv: word(-89091), lod: 0 })
}

#[test]
fn without_the_bias_the_named_ray_goes_astray() {
    let (d, ray) = witness();
    let fixed = Fixed::prepare(&pyramid(&d)).unwrap();
    let (mut with, mut without) = (0, 0);
    for seed in 0..400 {
        let texels = map([0, 1, 5][seed as usize % 3], 5, 2, seed);
        let truth = fixed.trace(&Pyramid::build(5, 2, &texels).unwrap(), &ray);
        for set in SETS.map(|s| s.parse::<WindowSet>().unwrap()) {
            let of = |fault| Plain { design: &d, sizes: set.sizes(), texels: &texels, fault }.trace(&fixed, &ray, MOST);
            with += u32::from(place(of(Fault::None)) != place(Some(found(&truth))));
            without += u32::from(place(of(Fault::NoBias)) != place(Some(found(&truth))));
        }
    }
    println!("the named ray on 400 maps and 9 sets: {with} times astray with the bias, {without} times without");
    assert!(with == 0 && without > 0, "{with} {without}");
}

#[test]
fn every_rule_is_needed() {
    let seed = env("RELIEFRTL_SEED", 1);
    let swapped = |set: &WindowSet| {
        let mut sizes = set.sizes().to_vec();
        sizes.swap(0, 1);
        sizes
    };
    for (what, (rays, witness)) in [
        ("without the bias", astray(as_they_are, Fault::NoBias, 400_000, seed)),
        ("planes rounded apart", astray(as_they_are, Fault::RoundedApart, 40_000, seed)),
        ("the texel's window is not the first", astray(swapped, Fault::None, 40_000, seed)),
    ] {
        println!("{what}: ray {rays} ends elsewhere: {witness:?}");
        assert!(witness.is_some(), "{what}: none of {rays} rays ends elsewhere");
    }
    let (rays, witness) = astray(as_they_are, Fault::None, 4000, seed);
    assert_eq!(witness, None, "{rays}");
}

/// After the first window the order decides nothing but the number of iterations.
#[test]
fn windows_after_the_first_may_stand_in_any_order() {
    let reversed = |set: &WindowSet| {
        let mut sizes = set.sizes().to_vec();
        sizes[1..].reverse();
        sizes
    };
    let (rays, witness) = astray(reversed, Fault::None, 20_000, env("RELIEFRTL_SEED", 1));
    println!("{rays} rays in windows out of order end as they must");
    assert_eq!(witness, None);
}
