//! Waveforms of a run: every named net, undefined bits as x, as VCD or FST.
use super::netlist::{Netlist, Slot};
use super::tracked::{Bits, Tracked};
use crate::error::{Error, Result};
use fst_writer::{FstFileType, FstInfo, FstScopeType, FstSignalType, FstVarDirection, FstVarType, open_fst};
use std::fmt::Write;
use std::path::Path;

/// Recorded nets, clock by clock.
pub struct Wave {
    signals: Vec<(String, Slot, u32)>,
    samples: Vec<Vec<Bits>>,
}

impl Wave {
    /// Records every named net of `net`.
    pub fn new(net: &Netlist) -> Self {
        let signals = net.names.iter().map(|(n, s)| (n.clone(), *s, net.widths[*s as usize])).collect();
        Self { signals, samples: Vec::new() }
    }
    /// Adds the state after `eval`.
    pub fn sample(&mut self, t: &Tracked<'_>) {
        self.samples.push(self.signals.iter().map(|s| t.get(s.1)).collect());
    }
    /// Clocks recorded.
    pub fn clocks(&self) -> usize {
        self.samples.len()
    }

    /// Writes the wave; the ending chooses the format: `.vcd` or `.fst`.
    ///
    /// # Errors
    /// Another ending, or a file that can't be written.
    pub fn save(&self, path: &Path, top: &str) -> Result<()> {
        match path.extension().and_then(|e| e.to_str()) {
            Some("vcd") => crate::files::write_atomic(path, self.vcd(top).as_bytes()),
            Some("fst") => self.fst(path, top),
            _ => Err(Error::input(format!("{}: a waveform ends in .vcd or .fst", path.display()))),
        }
    }

    /// Signals grouped by scope: scope path, then (net, index).
    fn scopes(&self) -> Vec<(Vec<&str>, &str, usize)> {
        let mut all: Vec<_> = (0..self.signals.len())
            .map(|i| {
                let mut path: Vec<&str> = self.signals[i].0.split('.').collect();
                let net = path.pop().unwrap_or_default();
                (path, net, i)
            })
            .collect();
        all.sort();
        all
    }

    fn vcd(&self, top: &str) -> String {
        let mut out = format!("$timescale 1ns $end\n$scope module {top} $end\n");
        let mut here: Vec<&str> = Vec::new();
        for (path, net, i) in self.scopes() {
            enter(&mut here, &path, |step| {
                out += &match step {
                    Some(name) => format!("$scope module {name} $end\n"),
                    None => "$upscope $end\n".into(),
                };
            });
            writeln!(out, "$var wire {} s{i} {net} $end", self.signals[i].2).expect("writing to a string can't fail");
        }
        here.iter().for_each(|_| out += "$upscope $end\n");
        out += "$upscope $end\n$enddefinitions $end\n";
        self.changes(|time, i, text| {
            if i == 0 {
                writeln!(out, "#{time}").expect("writing to a string can't fail");
            }
            if let Some(text) = text {
                writeln!(out, "b{text} s{i}").expect("writing to a string can't fail");
            }
            Ok(())
        })
        .expect("nothing fails in memory");
        writeln!(out, "#{}", self.samples.len() * 10).expect("writing to a string can't fail");
        out
    }

    /// Calls `f` for every clock and signal, with the text where it changed; a clock takes 10 units.
    fn changes(&self, mut f: impl FnMut(usize, usize, Option<String>) -> Result<()>) -> Result<()> {
        for (t, row) in self.samples.iter().enumerate() {
            for (i, v) in row.iter().enumerate() {
                let changed = t == 0 || self.samples[t - 1][i] != *v;
                f(t * 10, i, changed.then(|| text(*v, self.signals[i].2)))?;
            }
        }
        Ok(())
    }

    fn fst(&self, path: &Path, top: &str) -> Result<()> {
        let beside = path.with_extension("fst.part");
        let failed = |e: fst_writer::FstWriteError| Error::input(format!("cannot write {}: {e}", path.display()));
        let info = FstInfo {
            start_time: 0,
            timescale_exponent: -9,
            version: "reliefrtl".into(),
            date: String::new(),
            file_type: FstFileType::Verilog,
        };
        let mut h = open_fst(&beside, &info).map_err(failed)?;
        h.scope(top, "", FstScopeType::Module).map_err(failed)?;
        let mut here: Vec<&str> = Vec::new();
        let mut ids = vec![None; self.signals.len()];
        for (scope, net, i) in self.scopes() {
            let mut steps = Vec::new();
            enter(&mut here, &scope, |s| steps.push(s.map(str::to_string)));
            for s in steps {
                match s {
                    Some(name) => h.scope(name, "", FstScopeType::Module).map_err(failed)?,
                    None => h.up_scope().map_err(failed)?,
                }
            }
            let kind = FstSignalType::bit_vec(self.signals[i].2);
            ids[i] = Some(h.var(net, kind, FstVarType::Wire, FstVarDirection::Implicit, None).map_err(failed)?);
        }
        for _ in 0..=here.len() {
            h.up_scope().map_err(failed)?;
        }
        let mut body = h.finish().map_err(failed)?;
        self.changes(|time, i, text| {
            if i == 0 {
                body.time_change(time as u64).map_err(failed)?;
            }
            if let (Some(text), Some(id)) = (text, ids[i]) {
                body.signal_change(id, text.as_bytes()).map_err(failed)?;
            }
            Ok(())
        })?;
        body.finish().map_err(failed)?;
        std::fs::rename(&beside, path).map_err(|e| Error::file("write", path, e))
    }
}

/// Leaves and enters scopes on the way from `here` to `path`; `None` is a step up.
fn enter<'a>(here: &mut Vec<&'a str>, path: &[&'a str], mut step: impl FnMut(Option<&str>)) {
    let same = here.iter().zip(path).take_while(|(a, b)| a == b).count();
    while here.len() > same {
        here.pop();
        step(None);
    }
    for name in &path[same..] {
        here.push(name);
        step(Some(name));
    }
}

fn text((v, x): Bits, width: u32) -> String {
    let bit = |i: u32| match (v >> i & 1, x >> i & 1) {
        (_, 1) => 'x',
        (1, _) => '1',
        _ => '0',
    };
    (0..width).rev().map(bit).collect()
}
