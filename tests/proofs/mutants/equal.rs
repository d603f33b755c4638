//! Whether a mutant computes the same as its original, for every input: asked of ABC, which Yosys brings along.
use super::aig::Aig;
use super::blast::blast;
use reliefrtl::interp::Netlist;
use std::process::Command;

/// What is known of two netlists.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Verdict {
    /// Proved: no input tells them apart.
    Same,
    /// Some input does.
    Different,
    /// Not within the time.
    Open,
}

/// Compares them, in at most `seconds` or so.
pub fn compare(original: &Netlist, mutant: &Netlist, seconds: u32) -> Verdict {
    let dir = tempfile::tempdir().unwrap();
    for (name, net) in [("original", original), ("mutant", mutant)] {
        let (graph, outputs): (Aig, _) = blast(net);
        std::fs::write(dir.path().join(format!("{name}.aig")), graph.aiger(&outputs)).unwrap();
    }
    let abc = std::env::var("YOSYS_ABC").unwrap_or_else(|_| "yosys-abc".into());
    let script = format!("cec -n -T {seconds} -C 10000000 original.aig mutant.aig");
    let out = Command::new(abc).args(["-q", &script]).current_dir(dir.path()).output();
    let out = out.expect("yosys-abc is not installed: `sh tools/test.sh --tools` installs yosys, which brings it");
    let text = String::from_utf8_lossy(&out.stdout);
    match () {
        () if text.contains("Networks are equivalent") => Verdict::Same,
        () if text.contains("NOT EQUIVALENT") => Verdict::Different,
        () if text.contains("UNDECIDED") => Verdict::Open,
        () => panic!("yosys-abc said {text:?}, {:?}", String::from_utf8_lossy(&out.stderr)),
    }
}
