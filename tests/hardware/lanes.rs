//! The fast interpreter computes what `eval` says, at every width, and what is left out of a netlist is not missed.
use super::one_op::{KINDS, one_op, shapes, word};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use reliefrtl::config::{Design, LevelUp, ModeConfig};
use reliefrtl::interp::{BLOCK, Lanes, Slot, elaborate, eval};
use reliefrtl::ir::Binding;

#[test]
fn every_operation_at_every_width() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let mut checked = 0;
    for kind in KINDS {
        for w in 1..=64 {
            for (args, width, aux) in shapes(kind, w, &mut rng) {
                let net = one_op(kind, args, width, aux);
                // Few lanes stand in a block of their own size.
                for lanes in [BLOCK + 3, 11] {
                    let mut sim = Lanes::new(&net, lanes);
                    for lane in 0..lanes {
                        (0..3).for_each(|i| sim.set(i as Slot, lane, word(&mut rng, args[i])));
                    }
                    sim.eval();
                    for lane in 0..lanes {
                        let [a, b, c] = [0, 1, 2].map(|i| sim.get(i, lane));
                        let want = eval(&net.ops[0], a, b, c);
                        let got = sim.get(3, lane);
                        assert_eq!(got, want, "{kind:?} of {args:?} to {width} bits, {aux}: {a:x} {b:x} {c:x}");
                        checked += 1;
                    }
                }
            }
        }
    }
    println!("0 of {checked} results differ (seed 1)");
    assert!(checked > 150_000, "only {checked} results were checked");
}

/// Random inputs for some clocks: every output of the netlist as it is, laid out for ports, and optimized.
#[test]
fn nothing_that_was_left_out_is_missed() {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    let mut checked = 0;
    for level_up in LevelUp::ALL {
        let d = Design { mode: ModeConfig { level_up, ..ModeConfig::default() }, ..Design::default() };
        for m in reliefrtl::catalogue::units(&d) {
            let net = elaborate(&m, &Binding::new()).unwrap();
            let small = net.optimized();
            assert!(small.ops.len() <= net.ops.len() && small.regs.len() <= net.regs.len());
            let mut sims =
                [Lanes::new(&net, 8), Lanes::of_ports(&net, 8), Lanes::new(&small, 8), Lanes::of_ports(&small, 8)];
            for clock in 0..120 {
                for p in &net.inputs {
                    // Memories are shared by the lanes, so all write the same.
                    let shared = word(&mut rng, p.width);
                    for lane in 0..8 {
                        let v = match p.name.as_str() {
                            "rst" => u64::from(clock == 0),
                            "write_en" | "write_addr" | "write_data" | "load_en" | "load_addr" | "load_data" => shared,
                            _ => word(&mut rng, p.width),
                        };
                        sims[..2].iter_mut().for_each(|s| s.set(p.slot, lane, v));
                        sims[2..].iter_mut().for_each(|s| s.set(small.input(&p.name), lane, v));
                    }
                }
                sims.iter_mut().for_each(Lanes::eval);
                for p in &net.outputs {
                    for lane in 0..8 {
                        let want = sims[0].get(p.slot, lane);
                        let slots = [p.slot, p.slot, small.output(&p.name), small.output(&p.name)];
                        for (sim, slot) in sims.iter().zip(slots).skip(1) {
                            assert_eq!(sim.get(slot, lane), want, "{}.{} in clock {clock}", m.name, p.name);
                            checked += 1;
                        }
                    }
                }
                sims.iter_mut().for_each(Lanes::clock);
            }
        }
    }
    assert!(checked > 100_000, "only {checked} words were compared");
}

/// Registers that read each other, and one that reads itself: all see what was there before the clock.
#[test]
fn registers_in_rings() {
    use reliefrtl::ir::{BIT, BITS, Builder};
    let b = Builder::new("rings", file!(), "three registers that hand a word round");
    b.clock();
    b.reset();
    let data = b.input_static("data", 8, BITS, "comes in while load is set");
    let load = b.input_static("load", 1, BIT, "take the word");
    let out = b.output("out", 24, BITS, "all three");
    let [x, y, z] = ["x", "y", "z"].map(|n| b.loop_reg(n, 8, false));
    let own = b.loop_reg("own", 1, true);
    let next = load.mux(data, z).rebase_stage(0).named("next");
    b.drive(out, b.cat(&[x, y, z]));
    b.unused(own);
    b.close(&[(x, next), (y, x), (z, y), (own, own)]);
    let m = b.finish_streams(&[]);
    let net = elaborate(&m, &Binding::new()).unwrap();
    let mut sim = Lanes::new(&net, 2);
    let mut want = [[0u64; 3]; 2];
    for clock in 0..20u64 {
        for (lane, w) in want.iter_mut().enumerate() {
            let (data, load) = (clock * 7 + lane as u64, u64::from(clock % 5 == lane as u64));
            sim.set(net.input("data"), lane, data);
            sim.set(net.input("load"), lane, load);
            *w = [if load == 1 { data } else { w[2] }, w[0], w[1]];
        }
        sim.eval();
        sim.clock();
        sim.eval();
        for (lane, w) in want.iter().enumerate() {
            assert_eq!(sim.get(net.output("out"), lane), (w[0] << 16) | (w[1] << 8) | w[2], "clock {clock}");
        }
    }
}
