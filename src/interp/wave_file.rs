//! Waveforms as files: VCD, written here, and FST.
use super::tracked::Bits;
use super::wave::Wave;
use fst_writer::{
    FstFileType, FstInfo, FstScopeType, FstSignalId, FstSignalType, FstVarDirection, FstVarType, open_fst,
};
use reliefrtl_base::error::{Error, Result};
use reliefrtl_base::files::{Scratch, Sink};
use std::path::Path;

/// Units of time in a clock; the clock rises at its start and falls in its middle.
const CLOCK: u64 = 10;

/// Format of a waveform.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WaveFormat {
    /// Value change dump, text.
    Vcd,
    /// Fast signal trace.
    Fst,
}

impl WaveFormat {
    /// By the ending of a name, `.vcd` or `.fst`; VCD for standard output (`-`), and for a device or FIFO without such an ending.
    ///
    /// # Errors
    /// Another ending.
    pub fn of(path: &Path) -> Result<Self> {
        match path.extension().and_then(|e| e.to_str()) {
            Some("vcd") => Ok(Self::Vcd),
            Some("fst") => Ok(Self::Fst),
            _ if matches!(Sink::new(path), Ok(Sink::Standard | Sink::Stream(_))) => Ok(Self::Vcd),
            _ => Err(Error::input(format!("{}: a waveform ends in .vcd or .fst", path.display()))),
        }
    }
}

/// The way through the hierarchy.
enum Entry<'a> {
    Enter(&'a str),
    Leave,
    /// Name in its scope, and index.
    Signal(&'a str, usize),
}

impl Wave {
    /// Writes the wave; the ending chooses the format, as [`WaveFormat::of`]. All nets stand below the scope `top`, beside a clock `clk`.
    ///
    /// # Errors
    /// Another ending, or a file that can't be written.
    pub fn save(&self, path: &Path, top: &str) -> Result<()> {
        self.write(&Sink::new(path)?, WaveFormat::of(path)?, top)
    }

    /// Writes the wave as [`Wave::save`], in a chosen format.
    ///
    /// # Errors
    /// If it can't be written.
    pub fn write(&self, to: &Sink, format: WaveFormat, top: &str) -> Result<()> {
        match format {
            WaveFormat::Vcd => to.write(self.vcd(top).as_bytes()),
            WaveFormat::Fst => {
                // The writer wants a file of its own; no reader shall see half of it.
                let work = Scratch::new()?;
                let file = work.path().join("wave.fst");
                self.fst(&file, top).map_err(|e| Error::input(format!("cannot write a waveform: {e}")))?;
                to.write(&std::fs::read(&file).map_err(|e| Error::file("read", &file, e))?)
            }
        }
    }

    /// The signals grouped by scope.
    fn walk(&self) -> Vec<Entry<'_>> {
        let mut all: Vec<(Vec<&str>, &str, usize)> = Vec::new();
        for (i, s) in self.signals.iter().enumerate() {
            let mut path: Vec<&str> = s.name.split('.').collect();
            let net = path.pop().unwrap_or_default();
            all.push((path, net, i));
        }
        all.sort_unstable();
        let (mut entries, mut here) = (Vec::new(), Vec::new());
        for (path, net, i) in all {
            let same = here.iter().zip(&path).take_while(|(a, b)| a == b).count();
            entries.extend(here.drain(same..).map(|_: &str| Entry::Leave));
            entries.extend(path[same..].iter().map(|name| Entry::Enter(name)));
            here.extend(&path[same..]);
            entries.push(Entry::Signal(net, i));
        }
        entries.extend(here.iter().map(|_| Entry::Leave));
        entries
    }

    /// Calls `f` with the time and the changes of every clock: first all values, then what changed.
    fn play<E>(
        &self,
        mut f: impl FnMut(u64, &[(u32, Bits)]) -> std::result::Result<(), E>,
    ) -> std::result::Result<(), E> {
        let mut all: Vec<(u32, Bits)> = self.before.iter().enumerate().map(|(i, v)| (i as u32, *v)).collect();
        for (n, row) in self.rows.iter().enumerate() {
            let time = (self.first + n as u64) * CLOCK;
            if n == 0 {
                row.iter().for_each(|(i, v)| all[*i as usize].1 = *v);
                f(time, &all)?;
            } else {
                f(time, row)?;
            }
        }
        Ok(())
    }

    fn end(&self) -> u64 {
        (self.first + self.rows.len() as u64) * CLOCK
    }

    fn vcd(&self, top: &str) -> String {
        let mut out = format!("$timescale 1ns $end\n$scope module {top} $end\n");
        out += &format!("$var wire 1 {} clk $end\n", code(self.signals.len()));
        for entry in self.walk() {
            out += &match entry {
                Entry::Enter(name) => format!("$scope module {name} $end\n"),
                Entry::Leave => "$upscope $end\n".to_string(),
                Entry::Signal(net, i) => format!("$var wire {} {} {net} $end\n", self.signals[i].width, code(i)),
            };
        }
        out += "$upscope $end\n$enddefinitions $end\n";
        let clk = code(self.signals.len());
        let Ok(()) = self.play(|time, changes| {
            out += &format!("#{time}\n1{clk}\n");
            for (i, v) in changes {
                let width = self.signals[*i as usize].width;
                let blank = if width == 1 { "" } else { " " };
                let base = if width == 1 { "" } else { "b" };
                out += &format!("{base}{}{blank}{}\n", text(*v, width), code(*i as usize));
            }
            out += &format!("#{}\n0{clk}\n", time + CLOCK / 2);
            Ok::<(), std::convert::Infallible>(())
        });
        out + &format!("#{}\n", self.end())
    }

    fn fst(&self, path: &Path, top: &str) -> std::result::Result<(), fst_writer::FstWriteError> {
        let info = FstInfo {
            start_time: self.first * CLOCK,
            timescale_exponent: -9,
            version: "reliefrtl".into(),
            date: String::new(),
            file_type: FstFileType::Verilog,
        };
        let mut h = open_fst(path, &info)?;
        h.scope(top, "", FstScopeType::Module)?;
        let wire = |width| FstSignalType::bit_vec(width);
        let clk = h.var("clk", wire(1), FstVarType::Wire, FstVarDirection::Implicit, None)?;
        let mut ids: Vec<Option<FstSignalId>> = vec![None; self.signals.len()];
        for entry in self.walk() {
            match entry {
                Entry::Enter(name) => h.scope(name, "", FstScopeType::Module)?,
                Entry::Leave => h.up_scope()?,
                Entry::Signal(net, i) => {
                    let kind = wire(self.signals[i].width);
                    ids[i] = Some(h.var(net, kind, FstVarType::Wire, FstVarDirection::Implicit, None)?);
                }
            }
        }
        h.up_scope()?;
        let mut body = h.finish()?;
        self.play(|time, changes| {
            body.time_change(time)?;
            body.signal_change(clk, b"1")?;
            for (i, v) in changes {
                if let Some(id) = ids[*i as usize] {
                    body.signal_change(id, text(*v, self.signals[*i as usize].width).as_bytes())?;
                }
            }
            body.time_change(time + CLOCK / 2)?;
            body.signal_change(clk, b"0")
        })?;
        body.time_change(self.end())?;
        body.finish()
    }
}

/// A short identifier of printable characters.
fn code(mut i: usize) -> String {
    let mut out = String::new();
    loop {
        out.push(char::from(b'!' + (i % 94) as u8));
        i /= 94;
        if i == 0 {
            return out;
        }
        i -= 1;
    }
}

/// Binary digits, x where nothing is known.
fn text((v, x): Bits, width: u32) -> String {
    let bit = |i: u32| match ((v >> i) & 1, (x >> i) & 1) {
        (_, 1) => 'x',
        (1, _) => '1',
        _ => '0',
    };
    (0..width).rev().map(bit).collect()
}
