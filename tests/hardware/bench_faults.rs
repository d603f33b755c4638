//! Faults put into the hardware, not into the vectors: a wrapper around the emitted unit loses, repeats, marks or spoils a result, and
//! the emitted bench must end with the code of just that fault.
use crate::budget::share;
use crate::files::write;
use crate::simulators::skip;
use reliefrtl::bench::{Simulator, run_bench};
use reliefrtl::catalogue::{design_at, find, ray_set, vector_set};
use reliefrtl::config::{Config, Profile};
use reliefrtl::golden::{Pyramid, RayInput};
use reliefrtl::ir::{Binding, Dir, Module};
use reliefrtl::project::{Scene, project};
use reliefrtl::vectors::{Plan, set_files};
use std::fmt::Write;
use std::path::Path;

/// Puts a wrapper in the place of `m`: `body` drives what `taken` takes away from the real unit (its ports are then `inner_<port>`).
fn wrap(dir: &Path, m: &Module, taken: &[&str], body: &str) {
    let rtl = dir.join("rtl");
    let name = format!("relief_{}", m.name);
    let place = rtl.join(format!("{name}.v"));
    let text = std::fs::read_to_string(&place).unwrap();
    let inner = format!("{name}_inner");
    let head = format!("module {name} ");
    assert!(text.contains(&head));
    std::fs::write(rtl.join(format!("{inner}.v")), text.replacen(&head, &format!("module {inner} "), 1)).unwrap();
    let terms = m.contract().into_iter().map(|t| (t.name.to_string(), t.literal()));
    let params = m.params.iter().map(|p| (p.name.clone(), p.default.to_string())).chain(terms);
    let numbers = params.map(|(name, value)| (format!("parameter integer {name} = {value}"), name));
    let files = m.files.iter().map(|f| (format!("parameter {} = \"\"", f.name), f.name.clone()));
    let (params, passed): (Vec<String>, Vec<String>) =
        numbers.chain(files).map(|(text, name)| (text, format!(".{name}({name})"))).unzip();
    let range = |w: &reliefrtl::ir::Expr| format!("[{}:0]", w.expanded() - 1);
    let port = |p: &reliefrtl::ir::Port| {
        let dir = if p.dir == Dir::In { "input" } else { "output" };
        format!("{dir} wire {} {}", range(&p.width), p.name)
    };
    let ports: Vec<String> = m.ports.iter().map(port).collect();
    let mut out = format!("module {name} #({}) ({});\n", params.join(", "), ports.join(", "));
    for p in m.ports.iter().filter(|p| taken.contains(&p.name.as_str())) {
        writeln!(out, "wire {} inner_{};", range(&p.width), p.name).unwrap();
    }
    let net = |n: &str| if taken.contains(&n) { format!("inner_{n}") } else { n.to_string() };
    let pins: Vec<String> = m.ports.iter().map(|p| format!(".{}({})", p.name, net(&p.name))).collect();
    writeln!(out, "{inner} #({}) inner ({});\n{body}\nendmodule", passed.join(", "), pins.join(", ")).unwrap();
    std::fs::write(place, out).unwrap();
}

/// `leaves` is one clock long for each result; `fifth` marks the fifth.
const COUNT: &str = "wire leaves = out_valid & out_ready; reg [15:0] n; wire fifth = n == 4;
always @(posedge clk) if (rst) n <= 0; else if (leaves === 1'b1) n <= n + 1;";

/// Fault, ports that the wrapper takes over, its body, plusargs, exit code, and whether only a simulator with X can see it.
type Fault = (&'static str, &'static [&'static str], &'static str, &'static [&'static str], i32, bool);
const FAULTS: &[Fault] = &[
    ("none", &[], "", &[], 0, false),
    ("none, with traffic", &[], "", &["gaps", "stalls", "flood"], 0, false),
    (
        "a result is lost",
        &["out_valid", "out_ready"],
        "reg [15:0] k; wire lose = k == 4; assign out_valid = inner_out_valid & ~lose; assign inner_out_ready = out_ready | lose;
         always @(posedge clk) if (rst) k <= 0; else if (inner_out_valid & inner_out_ready) k <= k + 1;",
        &[],
        6,
        false,
    ),
    (
        "no ray is taken any more",
        &["in_ready", "in_valid"],
        "assign in_ready = inner_in_ready & ~(n > 4); assign inner_in_valid = in_valid & ~(n > 4);",
        &[],
        6,
        false,
    ),
    (
        "a result comes twice",
        &["out_valid", "out_ready", "out_tag"],
        "reg again; reg done; reg [TAG_W-1:0] tag; assign out_valid = inner_out_valid | again; assign inner_out_ready = out_ready & ~again;
         assign out_tag = again ? tag : inner_out_tag;
         always @(posedge clk) begin tag <= out_tag;
           if (rst) begin again <= 0; done <= 0; end
           else if (leaves) begin again <= fifth & ~done; done <= done | fifth; end end",
        &[],
        7,
        false,
    ),
    (
        "a high bit of a tag is wrong",
        &["out_tag"],
        "assign out_tag = inner_out_tag ^ {fifth, {(TAG_W-1){1'b0}}};",
        &[],
        7,
        false,
    ),
    ("a bit of a result is wrong", &["out_fv"], "assign out_fv = inner_out_fv ^ fifth;", &[], 1, false),
    ("a bit of a result is undefined", &["out_t"], "assign out_t = fifth ? {(1 + EXP_W + MAN_W){1'bx}} : inner_out_t;", &[], 1, true),
    ("out_valid is undefined", &["out_valid"], "assign out_valid = fifth ? 1'bx : inner_out_valid;", &[], 1, true),
    (
        "rays outlive a reset",
        &["rst"],
        "reg up; assign inner_rst = rst & (up !== 1'b1); always @(posedge clk) if (load_en) up <= 1'b1;",
        &["flood"],
        7,
        true,
    ),
];

#[test]
fn faults_of_the_stream_are_told_apart() {
    if skip() {
        return;
    }
    // The faults are of the stream: a pipeline of few registers is compiled sooner.
    let mut c = Config::default();
    c.latency = Profile::Published.latency(c.datapath.kind);
    (c.vectors.arithmetic, c.vectors.rays) = (60, 10);
    c.vectors.planned = false;
    let files = project(&c, &Scene::new(&c, None, false).unwrap()).unwrap().files;
    let over: Binding = [("LEVELS", 4), ("TAG_W", 12)].map(|(k, v)| (k.to_string(), v)).into();
    let d = design_at(&c.design(), &over);
    let texels: Vec<u32> = (0..256u32).map(|k| (k * 37 + k * k) % 256).collect();
    let pyramid = Pyramid::build(4, 8, &texels).unwrap();
    let at = |k: u32, m: f64| (f64::from(k) * m).fract();
    let rays: Vec<RayInput> = (0..80)
        .map(|k| RayInput::from_f64(d.format, at(k, 0.618), at(k, 0.414), 3.0 * at(k, 0.3), -2.0 * at(k, 0.7)))
        .collect();
    let m = find(&c.design(), "traverse").unwrap();
    let set = ray_set(&d, &pyramid, &rays, 1).unwrap();
    for sim in [Simulator::Icarus, Simulator::Verilator] {
        let seen: Vec<&Fault> = FAULTS.iter().filter(|f| !f.5 || sim == Simulator::Icarus).collect();
        // Icarus gets all; what Verilator builds for each takes longer.
        let step = if sim == Simulator::Icarus { 1 } else { share(2) };
        for (fault, taken, body, plusargs, code, _) in seen.into_iter().step_by(step) {
            let dir = tempfile::tempdir().unwrap();
            let vectors = set_files(&set.set).into_iter().map(|(n, t)| (format!("v/{n}"), t));
            let hardware = files.iter().filter(|(p, _)| !p.starts_with("golden/")).map(|(p, t)| (p.clone(), t.clone()));
            write(dir.path(), hardware.chain(vectors).chain([("v/memory.hex".to_string(), set.memory.clone())]));
            if !body.is_empty() {
                wrap(dir.path(), &m, taken, &format!("{COUNT}\n{body}"));
            }
            let mut args = vec!["vectors=v".to_string()];
            args.extend(plusargs.iter().map(|s| s.to_string()));
            let got = match run_bench(sim, dir.path(), "traverse", &over, &args) {
                Ok(o) => {
                    assert_eq!(o.checked, rays.len());
                    (0, String::new())
                }
                Err(e) => (e.exit_code(), e.to_string()),
            };
            assert_eq!(got.0, *code, "{fault} in {}: {}", sim.name(), got.1);
        }
    }
}

#[test]
fn faults_of_a_pipeline_are_mismatches() {
    if skip() {
        return;
    }
    let c = Config::default();
    let d = c.design();
    let m = find(&d, "fp_add").unwrap();
    let set = vector_set(&d, &m, &Binding::new(), Plan { rows: 300, seed: 1 });
    let rtl = reliefrtl::project::hardware(&c).unwrap().files;
    let benches = reliefrtl::bench::bench_files(std::slice::from_ref(&m), None, "relief_");
    let faults: &[(&str, &[&str], &str, i32)] = &[
        ("none", &[], "", 0),
        ("the clock enable is not connected", &["ce"], "assign inner_ce = 1'b1;", 1),
        (
            "a clock late",
            &["result"],
            "reg [EXP_W+MAN_W:0] q; always @(posedge clk) if (ce) q <= inner_result; assign result = q;",
            1,
        ),
        ("undefined once", &["result"], "assign result = (inner_result == 24'h7f8000) ? 24'hx : inner_result;", 1),
    ];
    for (fault, taken, body, code) in faults {
        let dir = tempfile::tempdir().unwrap();
        let vectors = set_files(&set).into_iter().map(|(n, t)| (format!("golden/fp_add/{n}"), t));
        write(dir.path(), rtl.clone().into_iter().chain(benches.clone()).chain(vectors));
        if !body.is_empty() {
            wrap(dir.path(), &m, taken, body);
        }
        let got = run_bench(Simulator::Icarus, dir.path(), "fp_add", &Binding::new(), &[]);
        let (got, text) = got.map_or_else(|e| (e.exit_code(), e.to_string()), |_| (0, String::new()));
        assert_eq!(got, *code, "{fault}: {text}");
    }
}

/// Rows after those that a file announces: whoever adds one must hear of it.
#[test]
fn rows_too_many_are_noticed() {
    if skip() {
        return;
    }
    let mut c = Config::default();
    (c.vectors.arithmetic, c.vectors.rays, c.traverse.levels) = (60, 10, 4);
    c.vectors.planned = false;
    let files = project(&c, &Scene::new(&c, None, false).unwrap()).unwrap().files;
    let mut runs = 0;
    for (unit, names) in [("fp_add", &["stimulus", "expected"][..]), ("traverse", &["stimulus", "expected", "memory"])]
    {
        for name in names {
            let dir = tempfile::tempdir().unwrap();
            for (path, text) in &files {
                let place = dir.path().join(path);
                std::fs::create_dir_all(place.parent().unwrap()).unwrap();
                let last = text.lines().last().unwrap();
                let spoiled = *path == format!("golden/{unit}/{name}.hex");
                std::fs::write(place, if spoiled { format!("{text}{last}\n") } else { text.clone() }).unwrap();
            }
            for sim in [Simulator::Icarus, Simulator::Verilator] {
                let said = run_bench(sim, dir.path(), unit, &Binding::new(), &[]).map(|o| o.output);
                let e = said.expect_err(&format!("{unit} {name} in {}", sim.name()));
                assert_eq!(e.exit_code(), 2, "{unit} {name} in {}: {e}", sim.name());
                assert!(e.to_string().contains("more rows than"), "{e}");
                runs += 1;
            }
        }
    }
    assert_eq!(runs, 10);
}

/// A file that lost all its text has no vectors, whatever the other one holds.
#[test]
fn an_empty_file_is_no_vectors() {
    if skip() {
        return;
    }
    let mut c = Config::default();
    (c.vectors.arithmetic, c.vectors.rays, c.traverse.levels) = (60, 10, 4);
    c.vectors.planned = false;
    let files = project(&c, &Scene::new(&c, None, false).unwrap()).unwrap().files;
    for (unit, name) in
        [("fp_add", "stimulus"), ("fp_add", "expected"), ("traverse", "stimulus"), ("traverse", "expected")]
    {
        let dir = tempfile::tempdir().unwrap();
        for (path, text) in &files {
            let place = dir.path().join(path);
            std::fs::create_dir_all(place.parent().unwrap()).unwrap();
            let emptied = *path == format!("golden/{unit}/{name}.hex");
            std::fs::write(place, if emptied { "" } else { text }).unwrap();
        }
        let e = run_bench(Simulator::Icarus, dir.path(), unit, &Binding::new(), &[]).unwrap_err();
        assert_eq!(e.exit_code(), 5, "{unit} {name}: {e}");
    }
}

/// A bench of an earlier tree says PASS, and not what it compared: that is no check.
#[test]
fn a_bench_that_does_not_say_what_it_compared_is_named() {
    if skip() {
        return;
    }
    let mut c = Config::default();
    (c.traverse.levels, c.vectors.planned, c.vectors.arithmetic, c.vectors.rays) = (4, false, 20, 2);
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), project(&c, &Scene::new(&c, None, false).unwrap()).unwrap().files);
    let run = || run_bench(Simulator::Icarus, dir.path(), "fp_lt", &Binding::new(), &[]);
    run().unwrap();
    let bench = dir.path().join("testbench/relief_tb_fp_lt.v");
    let text = std::fs::read_to_string(&bench).unwrap();
    std::fs::write(&bench, text.replace("@done", "done")).unwrap();
    let error = run().unwrap_err();
    assert_eq!(error.exit_code(), 5);
    assert!(error.to_string().contains("(no line @done): emit the tree anew"), "{error}");
}
