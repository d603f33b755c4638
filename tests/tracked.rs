//! Undefined values: what is claimed known is known; the traverse unit from power-up; waveforms that read back.
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use reliefrtl::config::Design;
use reliefrtl::golden::{Golden, Pyramid, RayInput};
use reliefrtl::interp::{Lanes, Tracked, elaborate};
use reliefrtl::ir::Binding;
use reliefrtl::trace::record;

fn scene(d: &Design, seed: u64) -> (Pyramid, Vec<RayInput>) {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let n = d.traverse.levels;
    let texels: Vec<u32> =
        (0..1usize << (2 * n)).map(|_| rng.random_range(0..=255u32) >> rng.random_range(0..4)).collect();
    let mut far = || (rng.random::<f64>() - 0.5) * 3.0;
    let rays: Vec<[f64; 2]> = (0..40).map(|_| [far(), far()]).collect();
    let rays =
        rays.iter().map(|[a, b]| RayInput::from_f64(d.format, (a + 1.5) / 3.1, (b + 1.5) / 3.1, *a, *b)).collect();
    (Pyramid::build(n, 8, &texels).unwrap(), rays)
}

/// Every unit, some input bits unknown: replaced by any known bits, the known result bits stay.
#[test]
fn known_bits_are_sound() {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let mut known = 0u64;
    for m in reliefrtl::catalogue::units(&Design::default()) {
        let net = elaborate(&m, &Binding::new()).unwrap();
        for _ in 0..40 {
            let mut t = Tracked::new(&net);
            let mut lanes = Lanes::new(&net, 16);
            for p in &net.inputs {
                let word: u64 = rng.random::<u64>() & reliefrtl::bits::mask(p.width);
                let open = if p.name != "ce" && rng.random_range(0..3) == 0 {
                    rng.random::<u64>() & reliefrtl::bits::mask(p.width)
                } else {
                    0
                };
                let word = if p.name == "ce" { 1 } else { word };
                t.set_bits(p.slot, (word & !open, open));
                lanes.set(p.slot).iter_mut().for_each(|l| *l = (word & !open) | (rng.random::<u64>() & open));
            }
            for _ in 0..=m.latency.unwrap_or(0) {
                t.eval();
                lanes.eval();
                t.clock();
                lanes.clock();
            }
            t.eval();
            lanes.eval();
            for p in &net.outputs {
                let (v, x) = t.get(p.slot);
                known += u64::from((reliefrtl::bits::mask(p.width) & !x).count_ones());
                for lane in lanes.get(p.slot) {
                    assert_eq!(lane & !x, v & !x, "{}.{}", m.name, p.name);
                }
            }
        }
    }
    assert!(known > 1000, "only {known} bits were known");
}

#[test]
fn traverse_from_power_up_is_defined_and_right() {
    let mut d = Design::default();
    d.traverse.levels = 5;
    let (pyramid, rays) = scene(&d, 9);
    let g = Golden::new(&d).unwrap();
    for (k, r) in rays.iter().enumerate() {
        let (hit, _) = record(&d, &pyramid, r).unwrap_or_else(|e| panic!("ray {k}: {e}"));
        assert_eq!(hit, g.trace(&pyramid, r), "ray {k}");
    }
    assert_eq!(rays.len(), 40);
}

#[test]
fn waves_read_back() {
    let mut d = Design::default();
    d.traverse.levels = 4;
    let (pyramid, rays) = scene(&d, 2);
    let (hit, wave) = record(&d, &pyramid, &rays[0]).unwrap();
    let dir = tempfile::tempdir().unwrap();
    for name in ["ray.vcd", "ray.fst"] {
        let path = dir.path().join(name);
        wave.save(&path, "traverse").unwrap();
        let mut w = wellen::simple::read(&path).unwrap();
        let var = w
            .hierarchy()
            .lookup_var(&["traverse"], "out_steps")
            .or_else(|| w.hierarchy().lookup_var(&["traverse"], "hit_steps"));
        let signal = w.hierarchy()[var.expect("the net is in the wave")].signal_ref();
        w.load_signals(&[signal]);
        let last = w.get_signal(signal).unwrap().iter_changes().last().unwrap().1.to_bit_string().unwrap();
        assert_eq!(u32::from_str_radix(&last, 2).unwrap(), hit.steps, "{name}");
    }
    assert!(wave.save(&dir.path().join("ray.txt"), "traverse").is_err());
}
