//! The command line as a user meets it: sentences, exit codes, nothing half-written, equal bytes from the engines.
use std::path::Path;
use std::process::{Command, Output};

fn run(dir: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_reliefrtl")).args(args).current_dir(dir).output().unwrap()
}

fn refused(args: &[&str], sentence: &str) {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("broken.png"), b"\x89PNG\r\n\x1a\nnot a png").unwrap();
    std::fs::write(dir.path().join("miss.csv"), "u,v,du\n0,0,0\n").unwrap();
    std::fs::write(dir.path().join("let.csv"), "u,v,du,dv\n0,x,0,0\n").unwrap();
    let out = run(dir.path(), args);
    let text = String::from_utf8_lossy(&out.stderr).into_owned();
    assert_eq!(out.status.code(), Some(2), "{args:?}: {text}");
    assert!(text.contains(sentence), "{args:?}: {text}");
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 3, "{args:?} left files behind");
}

#[test]
fn bad_input_gets_one_sentence() {
    refused(&["build", "--map", "broken.png"], "broken.png: not a readable PNG");
    refused(&["build", "--set", "format.expp=3"], "unknown key format.expp (--set): did you mean format.exp?");
    refused(&["build", "--set", "format.exp=1"], "format.exp = 1 is too small: 2 to 8 are legal");
    refused(&["build", "--set", "traverse.levels=13"], "traverse.levels = 13 is too large: 2 to 12 are legal");
    refused(&["trace", "--rays", "miss.csv", "--out", "h.csv"], "no column dv");
    refused(&["trace", "--rays", "let.csv", "--out", "h.csv"], "column v: \"x\" is not a number");
    refused(&["emit", "--unit", "traverze"], "did you mean traverse?");
    refused(&["render", "--view", "side"], "none of front, oblique, grazing");
}

#[test]
fn build_says_what_it_did() {
    let dir = tempfile::tempdir().unwrap();
    let out = run(
        dir.path(),
        &["build", "--set", "vectors.arithmetic=100", "--set", "vectors.rays=20", "--set", "view.stride=16"],
    );
    assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
    let text = String::from_utf8_lossy(&out.stdout).into_owned();
    for part in ["a loop of 8 slots", "traverse         0 of 60 mismatched", "oblique", "iverilog -g2005"] {
        assert!(text.contains(part), "{part} is missing in:\n{text}");
    }
    for file in [
        "rtl/traverse.v",
        "rtl/filelist.f",
        "testbench/tb_traverse.v",
        "golden/fp_add/vectors.json",
        "manifest.json",
        "preview.png",
    ] {
        assert!(dir.path().join("out").join(file).is_file(), "{file}");
    }
}

/// The engines that are there.
fn engines() -> Vec<&'static str> {
    let mut engines = vec!["golden", "interp"];
    if !std::env::var("RELIEFRTL_NO_SIMULATORS").is_ok_and(|v| v == "1") {
        engines.extend(["icarus", "verilator"]);
    }
    engines
}

/// Traces a file of rays with each of the engines and returns what all of them wrote.
fn same_bytes(rays: &str, engines: &[&str], sets: &[&str]) -> String {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("r.csv"), rays).unwrap();
    let sets: Vec<&str> = sets.iter().flat_map(|s| ["--set", s]).collect();
    let mut all = Vec::new();
    for e in engines {
        let out =
            run(dir.path(), &[&["trace", "--rays", "r.csv", "--engine", e, "--out", "h.csv"], &sets[..]].concat());
        assert_eq!(out.status.code(), Some(0), "{e}: {}", String::from_utf8_lossy(&out.stderr));
        all.push(std::fs::read_to_string(dir.path().join("h.csv")).unwrap());
    }
    assert!(all.iter().all(|h| h == &all[0]), "{sets:?}: {all:?}");
    let refined = if sets.contains(&"mode.bilinear=true") { ",bi,bj,bu,bv,bt,patch" } else { "" };
    let header = all[0].lines().next();
    assert_eq!(header, Some(format!("ray,i,j,u,v,t,steps,crossings,ups,wall,limit{refined}").as_str()));
    assert_eq!(all[0].lines().count(), rays.lines().count());
    all.remove(0)
}

#[test]
fn engines_write_the_same_bytes() {
    same_bytes("u,v,du,dv\n0.1,0.2,0.3,-0.4\n0.99999999,0.5,-1.5,0.25\n0.5,0.5,0,0\n0.3,0.3,20,0\n", &engines(), &[]);
}

/// Refined hits stand beside the same block hits as without a refinement; rays that end above, below and nowhere are among them.
#[test]
fn engines_write_the_same_bytes_with_the_refinement() {
    let mut rays = "u,v,du,dv\n0.1,0.2,0.3,-0.4\n0.99999999,0.5,-1.5,0.25\n0.5,0.5,0,0\n0.3,0.3,20,0\n".to_string();
    for k in 0..60 {
        let turn = f64::from(k) * 0.61803;
        rays += &format!("{:.6},{:.6},{:.6},{:.6}\n", turn.fract(), (turn * 1.7).fract(), turn.sin() * 3.0, turn.cos());
    }
    let sets = ["traverse.levels=5", "map.kind=spikes", "mode.bilinear=true"];
    let plain = same_bytes(&rays, &["golden"], &sets[..2]);
    let refined = same_bytes(&rays, &engines(), &sets);
    let mut words = std::collections::BTreeSet::new();
    for (a, b) in plain.lines().zip(refined.lines()).skip(1) {
        let cells: Vec<&str> = b.split(',').collect();
        assert_eq!(cells.len(), 17, "{b}");
        assert_eq!(a, cells[..11].join(","));
        let block = [cells[1], cells[2], cells[3], cells[4], cells[5]];
        assert_eq!(cells[16] != "hit", cells[11..16] == block, "{b}");
        words.insert(cells[16].to_owned());
    }
    assert_eq!(words.into_iter().collect::<Vec<_>>(), ["above", "below", "hit", "none"]);
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("r.csv"), &rays).unwrap();
    let (code, text) = said(dir.path(), &["list", "--set", "mode.bilinear=true"]);
    assert_eq!(code, Some(0));
    for unit in ["bilinear_window", "patch_memory", "surface_gap", "secant_step", "bilinear_hit"] {
        assert!(text.contains(unit), "{unit} is missing in:\n{text}");
    }
}

/// Rays with finest levels of their own, one above the root; and the same hits as without a trim, in fewer iterations.
#[test]
fn engines_write_the_same_bytes_with_trim_and_level_of_detail() {
    let mut rays =
        "u,v,du,dv,lod\n0.1,0.2,0.3,-0.4,0\n0.99999999,0.5,-1.5,0.25,2\n0.5,0.5,0,0,1\n0.3,0.3,20,0,0\n".to_string();
    for k in 0..60 {
        let turn = f64::from(k) * 0.61803;
        rays += &format!(
            "{:.6},{:.6},{:.6},{:.6},{}\n",
            turn.fract(),
            (turn * 1.7).fract(),
            turn.sin() * 3.0,
            turn.cos(),
            k % 8
        );
    }
    for (kind, trim) in [("watertight", "always"), ("fixed", "always"), ("fixed", "descent")] {
        let kind = format!("datapath.kind={kind}");
        let of = |trim: &str, engines: &[&str]| {
            let mode = format!("mode.trim={trim}");
            same_bytes(&rays, engines, &[&kind, "mode.lod=true", &mode, "traverse.levels=6"])
        };
        let (plain, trimmed) = (of("none", &["golden"]), of(trim, &engines()));
        // ray, i, j, u, v, t; then steps, crossings and ups; then wall and limit.
        let place = |row: &str| {
            row.split(',').enumerate().filter(|(k, _)| !(6..9).contains(k)).map(|c| c.1.to_owned()).collect::<Vec<_>>()
        };
        assert!(plain.lines().map(place).eq(trimmed.lines().map(place)), "{kind} {trim}");
        let steps = |text: &str| {
            text.lines().skip(1).map(|l| l.split(',').nth(6).unwrap().parse::<u32>().unwrap()).sum::<u32>()
        };
        assert!(steps(&trimmed) < steps(&plain), "{kind} {trim}: {} of {}", steps(&trimmed), steps(&plain));
    }
}

/// Means over a bricks map and three views, relative to the best published row; each datapath has the rows that it can have.
#[test]
fn trims_take_fewer_iterations() {
    let dir = tempfile::tempdir().unwrap();
    for (kind, rows) in [("watertight", 9), ("fixed", 9), ("published", 7)] {
        let kind = format!("datapath.kind={kind}");
        let (code, text) = said(
            dir.path(),
            &["steps", "--json", "--set", &kind, "--set", "view.stride=8", "--set", "map.kind=bricks"],
        );
        assert_eq!(code, Some(0), "{text}");
        let cells: serde_json::Value = serde_json::from_str(&text).unwrap();
        let cells = cells.as_array().unwrap();
        assert_eq!(cells.len(), 3 * rows, "{text}");
        let mean = |name: &str| -> f64 {
            cells.iter().filter(|c| c["row"] == name).map(|c| c["mean"].as_f64().unwrap()).sum()
        };
        let relative = |name: &str| mean(name) / mean("a + b + c1");
        if rows == 9 {
            let [after, always] = [relative("  + trim after descents"), relative("  + trim always")];
            println!("{kind}: after descents {after:.3}, always {always:.3}");
            assert!(after <= 0.94 && always <= 0.91 && always < after, "{kind}: {after} {always}");
        }
    }
}

#[test]
fn the_first_mismatch_is_a_waveform() {
    let small = ["--set", "vectors.arithmetic=100", "--set", "vectors.rays=20", "--set", "view.stride=16"];
    for (unit, output, told) in
        [("fp_add", "result", "output result (stage 2): expected hex"), ("traverse", "out_valid", "output out_i")]
    {
        let dir = tempfile::tempdir().unwrap();
        let args = ["check", "--unit", unit, "--canary", "flip", "--wave", "w.vcd"];
        let out = run(dir.path(), &[&args[..], &small[..]].concat());
        let text = String::from_utf8_lossy(&out.stderr).into_owned();
        assert_eq!(out.status.code(), Some(1), "{text}");
        assert!(text.contains(told), "{text}");
        let wave = wellen::simple::read(dir.path().join("w.vcd")).unwrap();
        assert!(wave.time_table().len() > 8, "{unit}: {} changes", wave.time_table().len());
        let names: Vec<String> = wave.hierarchy().iter_vars().map(|v| v.full_name(wave.hierarchy())).collect();
        assert!(names.contains(&format!("{unit}.{output}")), "{names:?}");
    }
    let dir = tempfile::tempdir().unwrap();
    let out = run(dir.path(), &["check", "--engine", "icarus", "--wave", "w.vcd"]);
    assert_eq!(out.status.code(), Some(2));
}

#[test]
fn arithmetic_stands_alone_with_every_choice() {
    let dir = tempfile::tempdir().unwrap();
    let ask = |args: &[&str]| {
        let out = run(dir.path(), args);
        let text = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
        (out.status.code(), text)
    };
    let (code, text) = ask(&["build", "--set", "format.rounding=up"]);
    assert_eq!(code, Some(2));
    assert!(text.contains("a traversal needs \"nearest-even\""), "{text}");
    for unit in ["fp_add", "fp_div", "fp_sqrt", "fp_add3", "fp_compare"] {
        let choice = ["--set", "format.rounding=down", "--set", "format.subnormals=gradual", "--set", "format.exp=8"];
        for part in ["emit", "vectors"] {
            let (code, text) = ask(&[&[part, "--unit", unit, "--out", unit], &choice[..]].concat());
            assert_eq!(code, Some(0), "{text}");
        }
        let verilog = std::fs::read_to_string(dir.path().join(format!("{unit}/rtl/{unit}.v"))).unwrap();
        let told = verilog.replace("\n//            ", " ");
        assert!(
            told.contains("float 8/16 down gradual") && told.contains("rounded toward minus infinity"),
            "{verilog}"
        );
        let manifest = std::fs::read_to_string(dir.path().join(format!("{unit}/manifest.json"))).unwrap();
        assert!(manifest.contains(&format!("\"name\": \"{unit}\"")));
        let (code, text) = ask(&[&["check", "--unit", unit, "--dir", unit], &choice[..]].concat());
        assert_eq!(code, Some(0), "{text}");
        assert!(text.contains("0 of 2000 mismatched"), "{text}");
        let (code, text) = ask(&[&["check", "--unit", unit, "--canary", "flip"], &choice[..]].concat());
        assert_eq!(code, Some(1), "{text}");
    }
    let (code, text) = ask(&["list"]);
    assert_eq!(code, Some(0));
    let (given, more) = text.split_once("available").expect("list says what could be emitted");
    assert!(!given.contains("fp_sqrt") && more.contains("fp_sqrt"), "{text}");
    let (_, text) = ask(&["list", "--set", "emit.units=fp_sqrt,fp_add3"]);
    let (given, more) = text.split_once("available").expect("list says what could be emitted");
    assert!(given.contains("fp_sqrt") && !more.contains("fp_add3") && more.contains("fp_recip"), "{text}");
    refused(&["emit", "--set", "emit.units=fp_squirt"], "did you mean \"fp_sqrt\"?");
}

/// Parts of a campaign are written and replayed one by one; their counts add up.
#[test]
fn corners_are_crossed_in_parts() {
    let dir = tempfile::tempdir().unwrap();
    let counted = |args: &[&str]| {
        let (code, text) = said(
            dir.path(),
            &[&["vectors", "--unit", "fp_mul", "--level", "1", "--set", "vectors.arithmetic=100"][..], args].concat(),
        );
        assert_eq!(code, Some(0), "{text}");
        let text = std::fs::read_to_string(dir.path().join("out/golden/fp_mul/vectors.json")).unwrap();
        let d: serde_json::Value = serde_json::from_str(&text).unwrap();
        (d["rows"].as_u64().unwrap(), d["events"]["tie"].as_u64().unwrap())
    };
    let whole = counted(&[]);
    let (one, two) = (counted(&["--shard", "1/2"]), counted(&["--shard", "2/2"]));
    assert_eq!((one.0 + two.0, one.1 + two.1), whole);
    let part = ["check", "--unit", "fp_mul", "--level", "1", "--shard", "2/9"];
    let (code, text) = said(dir.path(), &part);
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("1 unit, 0 of"), "{text}");
    refused(&["vectors", "--unit", "fp_mul", "--level", "1", "--shard", "3/2"], "3/16 is the third of 16 parts");
    refused(&["vectors", "--unit", "level_up", "--level", "1"], "name one of its units, as --unit fp_add");
    refused(&["check", "--unit", "fp_mul", "--shard", "1/2"], "--level");
}

const SMALL: [&str; 6] = ["--set", "vectors.arithmetic=100", "--set", "vectors.rays=20", "--set", "view.stride=16"];

/// Runs and returns exit code and both outputs.
fn said(dir: &Path, args: &[&str]) -> (Option<i32>, String) {
    let out = run(dir, args);
    (out.status.code(), String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr))
}

#[test]
fn an_output_never_replaces_an_input() {
    let dir = tempfile::tempdir().unwrap();
    let rays = "u,v,du,dv\n0.5,0.5,0.1,0.2\n";
    std::fs::write(dir.path().join("r.csv"), rays).unwrap();
    let (code, text) = said(dir.path(), &["trace", "--engine", "golden", "--rays", "r.csv", "--out", "./r.csv"]);
    assert_eq!(code, Some(2), "{text}");
    assert!(text.contains("would replace the input"), "{text}");
    assert_eq!(std::fs::read_to_string(dir.path().join("r.csv")).unwrap(), rays);
    let (code, _) = said(dir.path(), &["render", "--engine", "golden", "--out", "m.png", "--set", "view.stride=16"]);
    assert_eq!(code, Some(0));
    let before = std::fs::read(dir.path().join("m.png")).unwrap();
    let again = ["render", "--engine", "golden", "--map", "m.png", "--resample", "--out", "m.png"];
    assert_eq!(said(dir.path(), &again).0, Some(2));
    assert_eq!(std::fs::read(dir.path().join("m.png")).unwrap(), before);
}

#[test]
fn rays_without_a_hit_are_told() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("far.csv"), "u,v,du,dv\n0.5,0.5,100,0.2\n").unwrap();
    let args = ["trace", "--engine", "golden", "--rays", "far.csv", "--out", "h.csv"];
    let (code, text) = said(dir.path(), &args);
    assert_eq!(code, Some(5), "{text}");
    assert!(text.contains("1 of 1 can't be traced by this design"), "{text}");
    std::fs::write(dir.path().join("two.csv"), "u,v,du,dv\n0.5,0.5,100,0.2\n0.5,0.5,0.1,0.2\n").unwrap();
    let args = ["trace", "--engine", "golden", "--rays", "two.csv", "--out", "h.csv"];
    let (code, text) = said(dir.path(), &args);
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("1 of 2 can't be traced by this design"), "{text}");
}

#[test]
fn a_tree_that_was_edited_is_not_checked_by_the_interpreter() {
    let dir = tempfile::tempdir().unwrap();
    assert_eq!(said(dir.path(), &[&["build"][..], &SMALL].concat()).0, Some(0));
    let file = dir.path().join("out/rtl/level_up.v");
    let text = std::fs::read_to_string(&file).unwrap();
    let check = [&["check", "--dir", "out", "--unit", "level_up"][..], &SMALL].concat();
    assert_eq!(said(dir.path(), &check).0, Some(0));
    std::fs::write(&file, text.replacen(" & ", " | ", 1)).unwrap();
    let (code, told) = said(dir.path(), &check);
    assert_eq!(code, Some(2), "{told}");
    assert!(told.contains("level_up.v is not what this configuration emits"), "{told}");
}

/// A simulator would run the tree's text and say nothing of the latency that was asked for.
#[test]
fn a_tree_of_other_latencies_is_not_checked_by_a_simulator() {
    let dir = tempfile::tempdir().unwrap();
    assert_eq!(said(dir.path(), &[&["build"][..], &SMALL, &["--set", "latency.mul=2"]].concat()).0, Some(0));
    let check = ["check", "--dir", "out", "--unit", "fp_mul", "--engine", "icarus", "--set", "latency.mul=3"];
    let (code, told) = said(dir.path(), &[&check[..], &SMALL].concat());
    assert_eq!(code, Some(2), "{told}");
    assert!(told.contains("out was emitted with latency.mul = 2, and 3 is asked for"), "{told}");
    // Nor would either engine say that it is another mode.
    for engine in ["interp", "icarus"] {
        let check =
            ["check", "--dir", "out", "--engine", engine, "--set", "latency.mul=2", "--set", "mode.levels_down=3"];
        let (code, told) = said(dir.path(), &[&check[..], &SMALL].concat());
        assert_eq!(code, Some(2), "{told}");
        assert!(told.contains("out was emitted with mode.levels_down = 2, and 3 is asked for"), "{told}");
    }
}

#[test]
fn exports_that_differ_from_the_hex_files_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    assert_eq!(said(dir.path(), &[&["build"][..], &SMALL].concat()).0, Some(0));
    let check = [&["check", "--dir", "out", "--unit", "lzc"][..], &SMALL].concat();
    assert_eq!(said(dir.path(), &check).0, Some(0));
    for (name, from, to) in [("vectors.csv", "\n2,6\n", "\n2,5\n"), ("rows.json", "\"bits\":\"2\"", "\"bits\":\"3\"")] {
        let file = dir.path().join("out/golden/lzc").join(name);
        let text = std::fs::read_to_string(&file).unwrap();
        assert!(text.contains(from), "{name}: {text}");
        std::fs::write(&file, text.replacen(from, to, 1)).unwrap();
        let (code, told) = said(dir.path(), &check);
        assert_eq!(code, Some(2), "{told}");
        assert!(told.contains(&format!("{name} and the hex files differ in row 2")), "{told}");
        std::fs::write(&file, text).unwrap();
    }
}

/// The interpreter knows its own iterations; a simulator's come from the bench, whatever was done to the text.
#[test]
fn a_simulator_names_the_first_wrong_iteration() {
    if std::env::var("RELIEFRTL_NO_SIMULATORS").is_ok_and(|v| v == "1") {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    // What is spoiled may well go round for ever.
    let small = [&SMALL[..], &["--set", "traverse.step_limit=100"]].concat();
    assert_eq!(said(dir.path(), &[&["build"][..], &small].concat()).0, Some(0));
    let file = dir.path().join("out/rtl/multi_level_down.v");
    let text = std::fs::read_to_string(&file).unwrap();
    let right = "y_child = y_before ? y_low : y_behind";
    assert!(text.contains(right), "{text}");
    std::fs::write(&file, text.replace(right, "y_child = (y_hit[2:0] == 3'd5) ? y_low : y_behind")).unwrap();
    for engine in ["icarus", "verilator"] {
        let args = ["check", "--dir", "out", "--unit", "traverse", "--engine", engine];
        let (code, told) = said(dir.path(), &[&args[..], &small].concat());
        assert_eq!(code, Some(1), "{told}");
        assert!(told.contains("first wrong iteration: "), "{told}");
        assert!(told.contains(", y where it enters the loop: expected "), "{told}");
        assert!(told.contains("should have decided Descend"), "{told}");
    }
    // A wrong expected row is no fault of any iteration.
    let args = ["check", "--unit", "traverse", "--canary", "flip", "--engine", "icarus"];
    let (code, told) = said(dir.path(), &[&args[..], &small].concat());
    assert_eq!(code, Some(1), "{told}");
    assert!(told.contains("iterations are right: the fault is in what follows the loop"), "{told}");
}

#[test]
fn a_simulators_mismatch_is_told_as_the_interpreters() {
    if std::env::var("RELIEFRTL_NO_SIMULATORS").is_ok_and(|v| v == "1") {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    let args = [&["check", "--unit", "fp_add", "--canary", "flip", "--engine"][..], &["icarus"], &SMALL].concat();
    let (code, icarus) = said(dir.path(), &args);
    let interp =
        said(dir.path(), &args.iter().map(|a| if *a == "icarus" { "interp" } else { *a }).collect::<Vec<_>>()).1;
    assert_eq!(code, Some(1), "{icarus}");
    assert!(icarus.contains("(stage 2): expected hex") && icarus.contains("(a hex "), "{icarus}");
    assert_eq!(icarus.replace("icarus", "interp"), interp);
}

#[test]
fn a_row_that_was_changed_is_told_from_a_wrong_unit() {
    let dir = tempfile::tempdir().unwrap();
    assert_eq!(said(dir.path(), &[&["build"][..], &SMALL].concat()).0, Some(0));
    let file = dir.path().join("out/golden/fp_add/expected.hex");
    let text = std::fs::read_to_string(&file).unwrap();
    let last = text.lines().last().unwrap();
    let other = if last.ends_with('0') { '1' } else { '0' };
    std::fs::write(&file, format!("{}{other}\n", text.trim_end().strip_suffix(|_: char| true).unwrap())).unwrap();
    let args = ["check", "--dir", "out", "--unit", "fp_add"];
    let (code, told) = said(dir.path(), &[&args[..], &SMALL].concat());
    assert_eq!(code, Some(1), "{told}");
    let (code, json) = said(dir.path(), &[&args[..], &SMALL, &["--json"]].concat());
    let json: serde_json::Value = serde_json::from_str(json.trim()).unwrap();
    assert_eq!((code, &json["exit_code"]), (Some(1), &1.into()));
    let first = &json["first"];
    assert_eq!((&first["unit"], &first["output"], &first["stage"]), (&"fp_add".into(), &"result".into(), &2.into()));
    assert_ne!(first["expected"], first["got"]);
    assert!(
        told.contains("fp_add: 1 of ") && told.contains("does not hold the rows that vectors.json describes"),
        "{told}"
    );
}

#[test]
fn arithmetic_stands_alone_at_formats_that_no_map_fits() {
    let dir = tempfile::tempdir().unwrap();
    let format = ["--set", "format.exp=4", "--set", "format.man=3"];
    let (code, text) = said(dir.path(), &[&["emit", "--unit", "fp_add"][..], &format].concat());
    assert_eq!(code, Some(0), "{text}");
    let emitted = std::fs::read_to_string(dir.path().join("out/rtl/fp_add.v")).unwrap();
    assert!(emitted.contains("EXP_W = 4") && emitted.contains("MAN_W = 3"), "{emitted}");
    assert_eq!(said(dir.path(), &[&["emit"][..], &format].concat()).0, Some(2));
    // All pairs of 8-bit operands, as files and replayed.
    assert_eq!(said(dir.path(), &[&["vectors", "--unit", "fp_add"][..], &format].concat()).0, Some(0));
    let rows = std::fs::read_to_string(dir.path().join("out/golden/fp_add/vectors.csv")).unwrap();
    assert_eq!(rows.lines().count(), 1 + (1 << 16));
    let (code, text) = said(dir.path(), &[&["check", "--unit", "fp_add"][..], &format].concat());
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("0 of 65536 vectors mismatched"), "{text}");
    assert_eq!(said(dir.path(), &[&["check", "--unit", "level_up"][..], &format].concat()).0, Some(2));
    // What holds between keys is a sentence, never a panic of the units.
    let wide = ["format.exp=8", "format.man=23", "traverse.levels=12", "traverse.tile_bits=8", "traverse.frac_bits=16"];
    let sets: Vec<&str> = wide.iter().flat_map(|s| ["--set", s]).collect();
    let (code, text) = said(dir.path(), &[&["list"][..], &sets].concat());
    assert_eq!(code, Some(2), "{text}");
    assert!(text.contains("traverse.frac_bits = 16 is too large"), "{text}");
}

#[test]
fn a_closed_pipe_ends_quietly() {
    let dir = tempfile::tempdir().unwrap();
    let mut child = Command::new(env!("CARGO_BIN_EXE_reliefrtl"))
        .args(["config", "--print"])
        .current_dir(dir.path())
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let out = child.wait_with_output().unwrap();
    assert_eq!(out.status.code(), Some(0));
    assert!(out.stderr.is_empty(), "{}", String::from_utf8_lossy(&out.stderr));
}

/// Level 3 goes from seed to seed, a part takes every n-th of them, and few inputs end it.
#[test]
fn random_rows_until_stopped() {
    let dir = tempfile::tempdir().unwrap();
    let lines = |more: &[&str]| -> Vec<String> {
        let line = [&["check", "--unit", "fp_lt", "--level", "3", "--set", "vectors.arithmetic=50"][..], more].concat();
        let out = Command::new(env!("CARGO_BIN_EXE_reliefrtl")).args(line).current_dir(dir.path()).output().unwrap();
        assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
        String::from_utf8_lossy(&out.stdout).lines().map(str::to_string).collect()
    };
    let whole = lines(&["--batches", "4"]);
    assert_eq!(whole.len(), 4);
    assert!(whole[3].ends_with("seed 4: 0 of 50 mismatched; 0 of 200 so far"), "{whole:?}");
    let part = lines(&["--batches", "2", "--shard", "2/3"]);
    assert!(part[0].contains("seed 2:") && part[1].contains("seed 5:"), "{part:?}");
    let few = lines(&["--set", "format.exp=4", "--set", "format.man=3"]);
    assert!(few.len() == 2 && few[0].contains("0 of 65536") && few[1].contains("all inputs"), "{few:?}");
    for (line, says) in [
        (["--level", "1", "--batches", "2"], "--batches ends --level 3"),
        (["--level", "3", "--canary", "flip"], "no --wave and no --canary"),
    ] {
        let line = [&["check", "--unit", "fp_lt"][..], &line].concat();
        let out = Command::new(env!("CARGO_BIN_EXE_reliefrtl")).args(line).current_dir(dir.path()).output().unwrap();
        assert!(out.status.code() == Some(2) && String::from_utf8_lossy(&out.stderr).contains(says));
    }
}
