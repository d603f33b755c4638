//! Units whose outputs depend on the clocks before: a row of their vectors is a clock, the first of which follows reset. The model is clocked,
//! too, and the stimulus keeps to the protocol: what is valid stays as it is until it transfers.
use super::row::{Context, Row};
use crate::bits::mask;
use crate::interp::{Lanes, Netlist};
use crate::ir::Module;
use crate::vectors::{Plan, VectorSet};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// One clock of a model: writes the outputs that a row of inputs has in this clock, and goes on to the next.
pub type Step = Box<dyn FnMut(&Row<'_>, &mut Row<'_>)>;
/// A model in the state that reset leaves.
pub type Clocked = fn(&Context<'_>) -> Step;

/// Clocks in which valid and ready come equally often, at least and at most.
const PHASE: std::ops::Range<usize> = 20..60;
/// How often a bit of a handshake is 1, in eighths.
const OFTEN: [u32; 5] = [0, 1, 4, 7, 8];

/// Stimulus and results of `plan.rows` clocks, in which the load of each side changes from time to time.
pub(super) fn clocks(m: &Module, c: &Context<'_>, model: Clocked, plan: Plan) -> (Vec<Vec<u64>>, Vec<Vec<u64>>) {
    let inputs: Vec<(&str, u32)> =
        m.data_inputs().map(|(_, p)| (p.name.as_str(), p.width.eval(c.binding) as u32)).collect();
    let names: Vec<&str> = inputs.iter().map(|i| i.0).collect();
    let outputs: Vec<&str> = m.data_outputs().map(|(_, p)| p.name.as_str()).collect();
    let (mut rng, mut step) = (ChaCha8Rng::seed_from_u64(plan.seed), model(c));
    let (mut stimulus, mut expected): (Vec<Vec<u64>>, Vec<Vec<u64>>) = (vec![], vec![]);
    let (mut often, mut left) = (vec![], 0);
    let mut held = Row::blank(&names);
    // Which bits of in_valid are still to transfer.
    let mut waiting = 0;
    while stimulus.len() < plan.rows {
        if left == 0 {
            often = inputs.iter().map(|_| OFTEN[rng.random_range(0..OFTEN.len())]).collect();
            left = rng.random_range(PHASE);
        }
        left -= 1;
        let mut row = Row::blank(&names);
        for ((name, width), often) in inputs.iter().zip(&often) {
            let handshake = name.ends_with("_valid") || name.ends_with("_ready");
            row[*name] = match handshake {
                true => (0..*width).fold(0, |w, k| w | u64::from(rng.random_range(0..8) < *often) << k),
                false => rng.random::<u64>() & mask(*width),
            };
        }
        keep(&inputs, waiting, &held, &mut row);
        let mut out = Row::blank(&outputs);
        step(&row, &mut out);
        if let Some(port) = out.unwritten().next() {
            panic!("the model of {} says nothing about {port}", m.name);
        }
        waiting = row["in_valid"] & !out["in_ready"];
        stimulus.push(row.words().to_vec());
        expected.push(out.into_words());
        held = row;
    }
    (stimulus, expected)
}

/// Lets the inputs of `in_valid` that wait have the words that they had.
fn keep(inputs: &[(&str, u32)], waiting: u64, held: &Row<'_>, row: &mut Row<'_>) {
    let width = |name: &str| inputs.iter().find(|i| i.0 == name).map_or(0, |i| i.1);
    let streams = width("in_valid");
    let word = width("in_data") / streams;
    for k in (0..streams).filter(|k| waiting >> k & 1 == 1) {
        let bits = mask(word) << (k * word);
        row["in_valid"] |= 1 << k;
        row["in_data"] = row["in_data"] & !bits | held["in_data"] & bits;
    }
}

/// The results of the set's clocks in an elaborated unit, from the second clock after reset on.
pub(super) fn replay(net: &Netlist, m: &Module, set: &VectorSet) -> Vec<Vec<u64>> {
    let mut sim = Lanes::new(net, 1);
    let ins: Vec<_> = set.inputs.iter().map(|c| net.input(&c.name)).collect();
    let out = |name: &str| (net.output(name), m.valid_of(name).map(|valid| net.output(&valid.name)));
    let outs: Vec<_> = set.outputs.iter().map(|c| out(&c.name)).collect();
    for reset in [1, 0] {
        sim.set(net.input("rst"), 0, reset);
        sim.eval();
        sim.clock();
    }
    let clock = |row: &Vec<u64>| {
        ins.iter().zip(row).for_each(|(s, v)| sim.set(*s, 0, *v));
        sim.eval();
        let counts = |valid: Option<u32>| valid.is_none_or(|v| sim.get(v, 0) == 1);
        let words = outs.iter().map(|(s, valid)| if counts(*valid) { sim.get(*s, 0) } else { 0 }).collect();
        sim.clock();
        words
    };
    set.stimulus.iter().map(clock).collect()
}
