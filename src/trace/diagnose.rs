//! Where a ray goes wrong: the pipeline's signals beside the golden model's, iteration by iteration.
use super::interp::Pipeline;
use crate::config::{Design, Trim};
use crate::error::Result;
use crate::format::{FloatFormat, Words};
use crate::golden::float::to_f64;
use crate::golden::{Iteration, Pyramid, RayInput, decode_time, prepare};
use crate::interp::{Lanes, Netlist, Slot};
use crate::ir::Binding;

/// The first signal that differs from the model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Divergence {
    /// Iteration, counted from 0.
    pub iteration: usize,
    /// Clock in which it stands there when the ray is traced alone; reset is clock 0.
    pub clock: u64,
    /// Pipeline stage in which the signal stands.
    pub stage: u32,
    /// Net name in `traverse`.
    pub signal: String,
    /// What the model has, with its fields decoded.
    pub expected: String,
    /// What the pipeline has.
    pub got: String,
}

impl std::fmt::Display for Divergence {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { iteration, clock: _, stage, signal, expected, got } = self;
        write!(f, "first wrong signal: iteration {iteration}, stage {stage}, {signal}: expected {expected}, got {got}")
    }
}

/// How a signal is shown.
#[derive(Clone, Copy)]
pub(super) enum Shown {
    Integer,
    Time,
}

/// A signal that is compared: its net, how it is shown, and the model's value if it has one.
type Probe = (&'static str, Shown, fn(&Iteration) -> Option<u64>);

/// What the nets of all datapaths mean; which of them one has, and in which order, its facts say ([`crate::config::DatapathFacts::nets`]).
const PROBES: [Probe; 21] = [
    ("level", Shown::Integer, |i| Some(u64::from(i.level))),
    ("x", Shown::Integer, |i| Some(i.x as u64)),
    ("y", Shown::Integer, |i| Some(i.y as u64)),
    ("texel_x", Shown::Integer, |i| Some(i.x as u64)),
    ("texel_y", Shown::Integer, |i| Some(i.y as u64)),
    ("t", Shown::Time, |i| Some(i.t)),
    ("x_plane", Shown::Integer, |i| Some(i.b_x as u64)),
    ("y_plane", Shown::Integer, |i| Some(i.b_y as u64)),
    ("x_chord", Shown::Integer, |i| i.chord.map(|c| c.x as u64)),
    ("y_chord", Shown::Integer, |i| i.chord.map(|c| c.y as u64)),
    ("level_read", Shown::Integer, |i| i.chord.map(|c| u64::from(c.level))),
    ("height", Shown::Integer, |i| Some(u64::from(i.height))),
    ("m", Shown::Time, |i| Some(i.m)),
    ("t_x", Shown::Time, |i| Some(i.t_x)),
    ("t_y", Shown::Time, |i| Some(i.t_y)),
    ("x_hit", Shown::Integer, |i| Some(i.e_x as u64)),
    ("y_hit", Shown::Integer, |i| Some(i.e_y as u64)),
    ("level_next", Shown::Integer, |i| Some(u64::from(i.next_level))),
    ("t_after", Shown::Time, |i| Some(i.next_t)),
    ("x_next", Shown::Integer, |i| Some(i.next_x as u64)),
    ("y_next", Shown::Integer, |i| Some(i.next_y as u64)),
];

/// The probe of a net.
fn probe(net: &str) -> &'static Probe {
    PROBES.iter().find(|p| p.0 == net).unwrap_or_else(|| panic!("no probe says what {net} means"))
}

/// More clocks than the registers of any handshake hold a single ray up.
const WAITS: usize = 16;

/// Nets that exist where the design trims.
const CHORD: [&str; 3] = ["x_chord", "y_chord", "level_read"];

/// Traces one ray in both and returns the first difference; `None` if pipeline and model agree all the way.
///
/// # Errors
/// Illegal parameters.
pub fn diagnose(design: &Design, pyramid: &Pyramid, ray: &RayInput) -> Result<Option<Divergence>> {
    diagnose_in(&Pipeline::new(design, &Binding::new())?, design, pyramid, ray)
}

/// As [`diagnose`], in a pipeline that is there already.
///
/// # Errors
/// Illegal parameters.
pub fn diagnose_in(p: &Pipeline, design: &Design, pyramid: &Pyramid, ray: &RayInput) -> Result<Option<Divergence>> {
    let mut iterations = Vec::new();
    prepare(design)?.trace_with(pyramid, ray, Some(&mut |i| iterations.push(*i)));
    let path = design.datapath.kind;
    let traced = |net: &&&str| design.mode.trim != Trim::None || !CHORD.contains(*net);
    let list: Vec<&Probe> = path.facts().nets.iter().filter(traced).map(|net| probe(net)).collect();
    let probes: Vec<(u32, String, Slot)> = list.iter().map(|q| find(&p.net, q.0)).collect();
    // The trip that finds the start level comes first, and is no iteration.
    let trips = path.start_trips(&design.mode) as usize;
    let clocks = p.depth as usize + (iterations.len() + trips) * p.slots as usize + 2 + WAITS;
    let (log, start) = record(p, pyramid, ray, clocks, &probes);
    let start = start + trips * p.slots as usize;
    for (n, it) in iterations.iter().enumerate() {
        for ((name, shown, model), (k, (stage, net, slot))) in list.iter().zip(probes.iter().enumerate()) {
            let width = p.net.widths[*slot as usize];
            let Some(want) = model(it) else { continue };
            let want = want & crate::bits::mask(width);
            let at = start + n * p.slots as usize + *stage as usize;
            let got = log.get(at).map_or(u64::MAX, |row| row[k]);
            if want != got {
                let show = |v: u64| display(design, *shown, v, width);
                debug_assert!(net.ends_with(name));
                let (expected, got) = (show(want), show(got));
                let (clock, signal) = (at as u64 + 1, net.clone());
                return Ok(Some(Divergence { iteration: n, clock, stage: *stage, signal, expected, got }));
            }
        }
    }
    Ok(None)
}

/// The earliest stage in which a net of that base name stands.
fn find(net: &Netlist, name: &str) -> (u32, String, Slot) {
    let named = |s: u32| format!("s{s}_{name}");
    let hit = (0..256).find_map(|s| net.names.get(&named(s)).map(|slot| (s, named(s), *slot)));
    hit.unwrap_or_else(|| panic!("traverse has no net {name}"))
}

/// Probed values clock by clock, and the clock in which the ray stands in stage 0 for the first time.
fn record(
    p: &Pipeline,
    pyramid: &Pyramid,
    ray: &RayInput,
    clocks: usize,
    probes: &[(u32, String, Slot)],
) -> (Vec<Vec<u64>>, usize) {
    let (net, inputs) = (&p.net, &p.inputs);
    let mut sim = Lanes::new(net, 1);
    p.images(pyramid).into_iter().enumerate().for_each(|(k, words)| sim.load(k, words));
    let set = |sim: &mut Lanes, name: &str, v: u64| sim.set(net.input(name), 0, v);
    set(&mut sim, "rst", 1);
    sim.eval();
    sim.clock();
    set(&mut sim, "rst", 0);
    set(&mut sim, "out_ready", 1);
    set(&mut sim, "in_valid", 1);
    for (name, v) in inputs.iter().zip(super::row(inputs, ray)) {
        set(&mut sim, name, v);
    }
    let (mut log, mut start) = (Vec::new(), None);
    for clock in 0..clocks {
        sim.eval();
        // A handshake through registers is not ready in the first clock: in_valid stays 1 until the transfer.
        let accepted = sim.get(net.output("in_ready"), 0) == 1;
        if start.is_none() && sim.get(net.output("slot_busy"), 0) == 1 {
            start = Some(clock);
        }
        log.push(probes.iter().map(|p| sim.get(p.2, 0)).collect());
        sim.clock();
        if accepted {
            set(&mut sim, "in_valid", 0);
        }
    }
    (log, start.unwrap_or(0))
}

/// A value as a report shows it; `width` is that of an integer.
pub(super) fn display(design: &Design, shown: Shown, v: u64, width: u32) -> String {
    match (shown, design.words()) {
        (Shown::Integer, _) => format!("{} (hex {v:x})", crate::bits::signed(v, width)),
        (Shown::Time, Words::Fixed { .. }) => format!("hex {v:x} ({} height codes)", decode_time(design, v)),
        (Shown::Time, Words::Float(format)) => decode(format, v),
    }
}

/// A float's fields and value: `hex 47f000 = 0 10001111 1100..., 124`.
pub fn decode(format: FloatFormat, v: u64) -> String {
    let sign = u8::from(v & format.sign_bit() != 0);
    let (exp, man) = ((v >> format.man) & format.exp_max(), v & format.man_mask());
    format!("hex {v:x} (sign {sign}, exponent {exp}, fraction {man:x}, value {})", to_f64(format, v))
}
