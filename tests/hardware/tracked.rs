//! Undefined values: what is claimed known is known; the traverse unit from power-up; waveforms that read back.
use super::one_op::{KINDS, one_op, shapes, word};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use reliefrtl::config::Design;
use reliefrtl::golden::{Datapath, Pyramid, RayInput, Watertight};
use reliefrtl::interp::{Kind, Lanes, Tracked, Wave, elaborate, eval};
use reliefrtl::ir::Binding;
use reliefrtl::trace::{Pipeline, Window, record, record_mismatch, record_ray};

fn scene(d: &Design, seed: u64) -> (Pyramid, Vec<RayInput>) {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let n = d.traverse.levels;
    let texels: Vec<u32> =
        (0..1usize << (2 * n)).map(|_| rng.random_range(0..=255u32) >> rng.random_range(0..4)).collect();
    let mut far = || (rng.random::<f64>() - 0.5) * 3.0;
    let rays: Vec<[f64; 2]> = (0..50).map(|_| [far(), far()]).collect();
    let rays =
        rays.iter().map(|[a, b]| RayInput::from_f64(d.format, (a + 1.5) / 3.1, (b + 1.5) / 3.1, *a, *b)).collect();
    (Pyramid::build(n, 8, &texels).unwrap(), rays)
}

/// The bits of `open`, one by one, up to a number that can be tried out.
fn some_unknown(rng: &mut ChaCha8Rng, widths: [u32; 3]) -> [u64; 3] {
    let mut open = [0; 3];
    for _ in 0..rng.random_range(0..=6) {
        let k = rng.random_range(0..3usize);
        open[k] |= 1 << rng.random_range(0..widths[k]);
    }
    open
}

/// Puts the low bits of `choice` into the places of `open`.
fn fill(open: u64, choice: &mut u64) -> u64 {
    let mut v = 0;
    for i in (0..64).filter(|i| (open >> i) & 1 == 1) {
        v |= (*choice & 1) << i;
        *choice >>= 1;
    }
    v
}

/// One operation, at most six unknown bits: all their values are tried out. No bit that changes is claimed known, and for
/// all but arithmetic and shifts by unknown amounts every bit that never changes is.
#[test]
fn known_bits_of_every_operation() {
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    let (mut tried, mut claimed) = (0u64, 0u64);
    for kind in KINDS {
        for w in 1..=64 {
            for (widths, width, aux) in shapes(kind, w, &mut rng) {
                let net = one_op(kind, widths, width, aux);
                let mut t = Tracked::new(&net);
                for _ in 0..12 {
                    let open = some_unknown(&mut rng, widths);
                    let known = [0, 1, 2].map(|k| word(&mut rng, widths[k]) & !open[k]);
                    (0..3).for_each(|k| t.set_bits(k as u32, (known[k], open[k])));
                    t.eval();
                    let (v, x) = t.get(3);
                    let (mut ones, mut zeros) = (u64::MAX, u64::MAX);
                    for choice in 0..1u64 << open.iter().map(|o| o.count_ones()).sum::<u32>() {
                        let mut choice = choice;
                        let [a, b, c] = [0, 1, 2].map(|k| known[k] | fill(open[k], &mut choice));
                        let y = eval(&net.ops[0], a, b, c);
                        assert_eq!(y & !x, v, "{kind:?} {widths:?} {aux}: {a:x} {b:x} {c:x}, open {open:x?}");
                        (ones, zeros) = (ones & y, zeros & !y);
                        tried += 1;
                    }
                    let constant = (ones | zeros) & reliefrtl::bits::mask(width);
                    claimed += u64::from((!x & constant).count_ones());
                    let rough = matches!(kind, Kind::Add | Kind::Sub | Kind::Mul | Kind::DivRem | Kind::DivQuot)
                        || (matches!(kind, Kind::Shl | Kind::Shr | Kind::Sar) && open[1] != 0)
                        || matches!(kind, Kind::Lzc | Kind::RecipTable);
                    assert!(rough || x & constant == 0, "{kind:?} {widths:?}: {known:x?} open {open:x?} gives {x:x}");
                }
            }
        }
    }
    println!("{tried} operations, {claimed} bits known (seed 11)");
    assert!(tried > 100_000 && claimed > 100_000);
}

/// Every unit, some input bits unknown: replaced by any known bits, the known result bits stay. Registers that take an unknown bit for 0 or 1, as an
/// `if` of Verilog does, keep it unknown here.
#[test]
fn known_bits_are_sound() {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let mut known = 0u64;
    for m in reliefrtl::catalogue::units(&Design::default()) {
        let mut net = elaborate(&m, &Binding::new()).unwrap();
        net.regs.iter_mut().for_each(|r| r.unknown = None);
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
                (0..16).for_each(|l| lanes.set(p.slot, l, (word & !open) | (rng.random::<u64>() & open)));
            }
            for _ in 0..=m.latency().unwrap_or(0) {
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
                for lane in (0..16).map(|l| lanes.get(p.slot, l)) {
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
    let g = Watertight::prepare(&d).unwrap();
    for (k, r) in rays.iter().enumerate() {
        let (hit, _) = record(&d, &pyramid, r).unwrap_or_else(|e| panic!("ray {k}: {e}"));
        assert_eq!(hit, g.trace(&pyramid, r), "ray {k}");
    }
    assert_eq!(rays.len(), 50);
}

/// Bits of a net in a wave file, at the end of each clock.
fn read_net(path: &std::path::Path, scope: &[&str], net: &str, clocks: std::ops::Range<u64>) -> Vec<String> {
    let mut w = wellen::simple::read(path).unwrap();
    let mut full = vec!["traverse"];
    full.extend(scope);
    let h = w.hierarchy();
    // A reader takes the bits of a part of a wide net, `name[high:low]`, for an index of its own.
    let part = || {
        let (base, bits) = net.strip_suffix(']')?.split_once('[')?;
        let (high, low) = bits.split_once(':')?;
        h.lookup_var_with_index(&full, base, &Some(wellen::VarIndex::new(high.parse().ok()?, low.parse().ok()?)))
    };
    let var = h.lookup_var(&full, net).or_else(part).unwrap_or_else(|| panic!("{net} is not in {}", path.display()));
    let signal = w.hierarchy()[var].signal_ref();
    w.load_signals(&[signal]);
    let times = w.time_table().to_vec();
    let changes: Vec<(u64, String)> = w
        .get_signal(signal)
        .unwrap()
        .iter_changes()
        .map(|(t, v)| (times[t as usize], v.to_bit_string().unwrap()))
        .collect();
    clocks.map(|c| changes.iter().rfind(|(t, _)| *t <= c * 10 + 9).unwrap().1.clone()).collect()
}

fn text((v, x): (u64, u64), width: u32) -> String {
    let bit = |i: u32| if (x >> i) & 1 == 1 { 'x' } else { char::from(b'0' + ((v >> i) & 1) as u8) };
    (0..width).rev().map(bit).collect()
}

#[test]
fn waves_read_back() {
    let mut d = Design::default();
    d.traverse.levels = 4;
    let (pyramid, rays) = scene(&d, 2);
    let (hit, wave) = record(&d, &pyramid, &rays[0]).unwrap();
    let p = Pipeline::new(&d, &Binding::new()).unwrap();
    let dir = tempfile::tempdir().unwrap();
    for name in ["ray.vcd", "ray.fst"] {
        let path = dir.path().join(name);
        wave.save(&path, "traverse").unwrap();
        let clocks = 0..wave.clocks() as u64;
        let steps = read_net(&path, &[], "out_steps", clocks.clone());
        assert_eq!(u32::from_str_radix(steps.last().unwrap(), 2).unwrap(), hit.steps, "{name}");
        let mut compared = 0;
        let deep = p.net.names.keys().filter(|n| n.contains('.')).step_by(41);
        for full in p.net.names.keys().filter(|n| !n.contains('.')).step_by(7).chain(deep) {
            let mut scope: Vec<&str> = full.split('.').collect();
            let net = scope.pop().unwrap();
            let width = p.net.widths[p.net.names[full] as usize];
            for (clock, bits) in clocks.clone().zip(read_net(&path, &scope, net, clocks.clone())) {
                assert_eq!(bits, text(wave.get(full, clock).unwrap(), width), "{name} {full} in clock {clock}");
                compared += 1;
            }
        }
        assert!(compared > 1000, "only {compared} values were compared");
        let undefined = read_net(&path, &[], "in_u", 0..1);
        assert!(undefined[0].chars().all(|c| c == 'x'), "an input that is not driven is x");
    }
    assert!(wave.save(&dir.path().join("ray.txt"), "traverse").is_err());
}

#[test]
fn windows_hold_what_was_asked_for() {
    let mut d = Design::default();
    d.traverse.levels = 4;
    let (pyramid, rays) = scene(&d, 2);
    let (_, all) = record(&d, &pyramid, &rays[1]).unwrap();
    let p = Pipeline::new(&d, &Binding::new()).unwrap();
    let names = ["s0_loop_level_q", "s0_loop_x_q", "out_valid", "in_ready"];
    for (at, before, after, first, clocks) in [(20, 6, 4, 15, 10), (2, 9, 0, 0, 3), (30, 1, 1, 30, 2)] {
        let wave = Wave::of(&p.net, |n| names.contains(&n));
        assert_eq!(wave.names().count(), names.len());
        let window = Window { at, before, after };
        let (_, wave) = record_ray(&p, &d, &pyramid, &rays[1], wave, Some(window)).unwrap();
        assert_eq!((wave.first_clock(), wave.clocks()), (first, clocks), "around clock {at}");
        let dir = tempfile::tempdir().unwrap();
        for name in ["part.vcd", "part.fst"] {
            let path = dir.path().join(name);
            wave.save(&path, "traverse").unwrap();
            let span = first..first + clocks as u64;
            for net in names {
                let s = p.net.names.get(net).copied().unwrap_or_else(|| p.net.output(net));
                for (clock, bits) in span.clone().zip(read_net(&path, &[], net, span.clone())) {
                    assert_eq!(wave.get(net, clock), all.get(net, clock));
                    assert_eq!(
                        bits,
                        text(all.get(net, clock).unwrap(), p.net.widths[s as usize]),
                        "{name} {net} {clock}"
                    );
                }
            }
        }
        assert_eq!(wave.get("s0_loop_level_q", first + clocks as u64), None);
    }
    assert!(record_mismatch(&d, &pyramid, &rays[1], 5, 5).unwrap().is_none(), "model and pipeline agree");
}
