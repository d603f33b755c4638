//! Replays a unit's vectors in the interpreter, and compares results with what is expected.
use crate::error::{Error, Finding, Place, Result};
use crate::format::FloatFormat;
use crate::interp::{BLOCK, Lanes, Netlist, elaborate};
use crate::ir::Module;
use crate::trace::decode;
use crate::vectors::{Column, VectorSet};

/// Results that differ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mismatch {
    /// Row.
    pub vector: usize,
    /// Output port.
    pub output: String,
    /// Expected word.
    pub expected: u64,
    /// Word that came.
    pub got: u64,
}

/// What a replay found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CheckReport {
    /// Unit.
    pub unit: String,
    /// `interp`, `icarus` or `verilator`.
    pub engine: String,
    /// Rows compared.
    pub checked: usize,
    /// Rows that differ.
    pub mismatched: usize,
    /// The first difference.
    pub first: Option<Mismatch>,
}

impl CheckReport {
    /// An error that tells the first difference, with its fields decoded where it is a float.
    ///
    /// # Errors
    /// Rows that differ, or no rows.
    pub fn verdict(&self, set: &VectorSet, m: &Module) -> Result<()> {
        if self.checked == 0 {
            return Err(Error::NothingRan(format!("{}: no vectors were checked in {}", self.unit, self.engine)));
        }
        let Some(x) = &self.first else { return Ok(()) };
        let format =
            set.params.get("EXP_W").zip(set.params.get("MAN_W")).map(|(e, f)| FloatFormat::new(*e as u32, *f as u32));
        let port = m.port(&x.output).map(|p| p.1);
        let word = |name: &str, v: u64| match (format, m.port(name).map(|p| p.1)) {
            (Some(f), Some(p)) if p.unit.is_float() => decode(f, v),
            _ => format!("hex {v:x}"),
        };
        let show = |v: u64| word(&x.output, v);
        let ins: Vec<String> = set
            .inputs
            .iter()
            .zip(set.stimulus.get(x.vector).map_or(&[][..], Vec::as_slice))
            .map(|(c, v)| format!("{} {}", c.name, word(&c.name, *v)))
            .collect();
        let place = Place {
            unit: self.unit.clone(),
            engine: self.engine.clone(),
            checked: self.checked,
            mismatched: self.mismatched,
            vector: x.vector,
            output: x.output.clone(),
            stage: port.and_then(|p| p.stage),
            expected: format!("{:x}", x.expected),
            got: format!("{:x}", x.got),
        };
        let text = format!(
            "{}: {} of {} mismatched in {}; first: vector {} ({}), output {}{}: expected {}, got {}",
            self.unit,
            self.mismatched,
            self.checked,
            self.engine,
            x.vector,
            ins.join(", "),
            x.output,
            port.and_then(|p| p.stage).map(|s| format!(" (stage {s})")).unwrap_or_default(),
            show(x.expected),
            show(x.got)
        );
        Err(Error::Mismatch(Finding { text, place: Some(Box::new(place)) }))
    }
}

/// A bench's first mismatch, with fields decoded and operands named as [`CheckReport::verdict`] does; other errors as they are, and so a
/// mismatch of which some bit is unknown.
pub fn decoded(e: Error, set: &VectorSet, m: &Module) -> Error {
    let Error::Mismatch(Finding { place: Some(place), .. }) = &e else { return e };
    let hex = |word: &str| u64::from_str_radix(word, 16).ok();
    let Some((expected, got)) = hex(&place.expected).zip(hex(&place.got)) else { return e };
    let first = Mismatch { vector: place.vector, output: place.output.clone(), expected, got };
    let report = CheckReport {
        unit: place.unit.clone(),
        engine: place.engine.clone(),
        checked: place.checked,
        mismatched: place.mismatched,
        first: Some(first),
    };
    report.verdict(set, m).err().unwrap_or(e)
}

/// Compares rows of results with what is expected.
///
/// # Errors
/// Fewer or more results than expected, or none at all.
pub fn compare(set: &VectorSet, engine: &str, results: &[Vec<u64>]) -> Result<CheckReport> {
    let (n, k) = (set.expected.len(), results.len());
    let unit = &set.unit;
    match () {
        () if n == 0 => return Err(Error::NothingRan(format!("{unit}: the vector set is empty, nothing was checked"))),
        () if k < n => {
            return Err(Error::Dropped(format!(
                "{unit}: vector {k} was expected and never came ({k} of {n} results in {engine})"
            )));
        }
        () if k > n => {
            let more = if k - n == 1 { "1 result".into() } else { format!("{} results", k - n) };
            return Err(Error::Extra(format!(
                "{unit}: {more} came that were not expected ({k} for {n} vectors in {engine})"
            )));
        }
        () => {}
    }
    let mut report = CheckReport { unit: unit.clone(), engine: engine.into(), checked: n, mismatched: 0, first: None };
    for (vector, (want, got)) in set.expected.iter().zip(results).enumerate() {
        if let Some(c) = want.iter().zip(got).position(|(a, b)| a != b) {
            report.mismatched += 1;
            let output = set.outputs[c].name.clone();
            report.first.get_or_insert(Mismatch { vector, output, expected: want[c], got: got[c] });
        }
    }
    Ok(report)
}

/// Whether a set that was read belongs to `m`: its unit, and a column for each data port, of the port's width.
///
/// # Errors
/// One sentence that names what does not fit.
pub fn fits(m: &Module, set: &VectorSet) -> Result<()> {
    if set.unit != m.name {
        return Err(Error::input(format!("the vectors are those of {}, not of {}", set.unit, m.name)));
    }
    let b = m.binding_with(&set.params);
    let (ins, outs) = if super::takes_rays(m) { super::ray_columns(m, &b) } else { super::columns(m, &b) };
    let text = |c: &[Column]| c.iter().map(|c| format!("{}[{}]", c.name, c.width)).collect::<Vec<_>>().join(" ");
    for (what, have, want) in [("inputs", &set.inputs, &ins), ("outputs", &set.outputs, &outs)] {
        if have != want {
            return Err(Error::input(format!(
                "the vectors of {} have the {what} {}, the unit has {}",
                m.name,
                text(have),
                text(want)
            )));
        }
    }
    Ok(())
}

/// Replays `set` in the interpreter at the set's parameter values.
///
/// # Errors
/// Illegal parameters, or as [`compare`].
pub fn check_interp(m: &Module, set: &VectorSet) -> Result<CheckReport> {
    let net = elaborate(m, &set.params)?;
    fits(m, set)?;
    match m.latency() {
        Some(latency) => check_netlist(&net, latency as usize, set),
        None => compare(set, "interp", &super::clocked::replay(&net, m, set)),
    }
}

/// Replays `set` in an elaborated unit of fixed latency.
///
/// # Errors
/// As [`compare`].
pub fn check_netlist(net: &Netlist, latency: usize, set: &VectorSet) -> Result<CheckReport> {
    const LANES: usize = BLOCK;
    let mut sim = Lanes::new(net, LANES);
    if let Some(ce) = net.inputs.iter().find(|p| p.name == "ce") {
        sim.fill(ce.slot, 1);
    }
    let ins: Vec<_> = set.inputs.iter().map(|c| net.input(&c.name)).collect();
    let outs: Vec<_> = set.outputs.iter().map(|c| net.output(&c.name)).collect();
    let blocks = set.stimulus.len().div_ceil(LANES);
    let mut results = Vec::with_capacity(set.stimulus.len());
    // One block of rows enters a clock; its results leave `latency` clocks later.
    for clock in 0..blocks + latency {
        for (lane, row) in set.stimulus.iter().skip(clock * LANES).take(LANES).enumerate() {
            ins.iter().zip(row).for_each(|(s, v)| sim.set(*s, lane, *v));
        }
        sim.eval();
        if clock >= latency {
            let first = (clock - latency) * LANES;
            for lane in 0..LANES.min(set.stimulus.len() - first) {
                results.push(outs.iter().map(|s| sim.get(*s, lane)).collect());
            }
        }
        sim.clock();
    }
    compare(set, "interp", &results)
}
