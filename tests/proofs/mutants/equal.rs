//! Whether a mutant computes the same as its original, for every legal operand: asked of ABC, which Yosys brings along.
use super::aig::TRUE;
use super::blast::{Legal, blast};
use reliefrtl::interp::Netlist;
use std::os::unix::process::ExitStatusExt;
use std::process::Command;

/// What is known of two netlists.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Verdict {
    /// Proved: no operand tells them apart.
    Same,
    /// These operands do: a word for each input, in port order.
    Different(Vec<u64>),
    /// Not within the time.
    Open,
}

/// Compares them for every operand, in at most `seconds` of processor time.
pub fn compare(original: &Netlist, mutant: &Netlist, seconds: u32) -> Verdict {
    compare_legal(original, mutant, &|_, _| TRUE, seconds)
}

/// Compares them for every legal operand.
pub fn compare_legal(original: &Netlist, mutant: &Netlist, legal: Legal, seconds: u32) -> Verdict {
    let dir = tempfile::tempdir().unwrap();
    for (name, net) in [("original", original), ("mutant", mutant)] {
        let (graph, outputs) = blast(net, legal);
        std::fs::write(dir.path().join(format!("{name}.aig")), graph.aiger(&outputs)).unwrap();
    }
    let abc = std::env::var("YOSYS_ABC").unwrap_or_else(|_| "yosys-abc".into());
    // Its own limit is not looked at everywhere.
    let script = format!("ulimit -t {seconds}; exec \"$0\" -q 'cec -n -C 10000000 original.aig mutant.aig'");
    let out = Command::new("sh").args(["-c", &script, &abc]).current_dir(dir.path()).output().unwrap();
    if out.status.signal().is_some() {
        return Verdict::Open;
    }
    let text = String::from_utf8_lossy(&out.stdout);
    match () {
        () if text.contains("Networks are equivalent") => Verdict::Same,
        () if text.contains("NOT EQUIVALENT") => Verdict::Different(example(&text, original)),
        () if text.contains("UNDECIDED") => Verdict::Open,
        () => panic!(
            "yosys-abc said {text:?}, {:?}: `sh tools/test.sh --tools` installs yosys, which brings it",
            String::from_utf8_lossy(&out.stderr)
        ),
    }
}

/// The operands that ABC names (`pi3=1`: bit 3 of all inputs); bits that don't matter are 0.
fn example(text: &str, net: &Netlist) -> Vec<u64> {
    let ones: Vec<u32> =
        text.split_whitespace().filter_map(|w| w.strip_prefix("pi")?.strip_suffix("=1")?.parse().ok()).collect();
    let mut first = 0;
    let word = |slot: u32| {
        let width = net.widths[slot as usize];
        let own = ones.iter().filter(|k| (first..first + width).contains(*k)).map(|k| 1 << (k - first)).sum();
        first += width;
        own
    };
    net.inputs.iter().map(|p| p.slot).map(word).collect()
}
