//! `check`: what a mismatch, an edited tree and a changed row are told as.
use super::{SMALL, run, said};
use crate::simulators::skip;

/// A unit that another configuration has is no misspelt one.
#[test]
fn a_unit_of_another_configuration_says_what_brings_it() {
    let dir = tempfile::tempdir().unwrap();
    for (unit, setting) in [
        ("delay_line", "latency.delay_line=3"),
        ("chord_end", "mode.trim=always"),
        ("exit_plane", "datapath.kind=published"),
    ] {
        let run = |more: &[&str]| {
            let line = [&["check", "--unit", unit, "--set", "vectors.arithmetic=40"][..], more].concat();
            let out = std::process::Command::new(env!("CARGO_BIN_EXE_reliefrtl"))
                .args(line)
                .current_dir(dir.path())
                .output()
                .unwrap();
            (out.status.code(), String::from_utf8_lossy(&out.stderr).into_owned())
        };
        let (code, said) = run(&[]);
        assert!(code == Some(2) && said.contains(&format!("it comes with --set {setting}")), "{unit}: {said}");
        // What is advised works.
        let (code, said) = run(&["--set", setting]);
        assert_eq!(code, Some(0), "{unit}: {said}");
    }
}

/// What checks a unit that has no vectors is said by each verb, and `list` marks it.
#[test]
fn a_unit_without_vectors_says_what_checks_it() {
    let dir = tempfile::tempdir().unwrap();
    let told = "height_banks has no vectors of its own: rays through traverse check it (`check --unit traverse`)";
    let small = ["--set", "vectors.planned=false", "--set", "vectors.arithmetic=20", "--set", "vectors.rays=5"];
    for args in [
        &["check", "--unit", "height_banks"][..],
        &["check", "--unit", "height_banks", "--param", "BANK_W=1"],
        &["vectors", "--unit", "height_banks"],
    ] {
        let (code, text) = said(dir.path(), &[args, &small].concat());
        assert_eq!(code, Some(5), "{text}");
        assert!(text.contains(told), "{text}");
    }
    let (_, text) = said(dir.path(), &["list", "--json"]);
    let list: serde_json::Value = serde_json::from_str(&text).unwrap();
    let own = |name: &str| {
        let unit = list["units"].as_array().unwrap().iter().find(|u| u["unit"] == name).unwrap();
        unit["vectors"].as_bool().unwrap()
    };
    assert!(!own("height_banks") && own("fp_add") && own("traverse"));
    let (_, text) = said(dir.path(), &["list"]);
    let column = |name: &str| {
        let line = text.lines().find(|l| l.split_whitespace().next() == Some(name)).unwrap();
        line.split_whitespace().nth(2).unwrap().to_owned()
    };
    assert_eq!(
        (column("height_banks"), column("fp_add"), column("fp_sqrt")),
        ("traverse".into(), "own".into(), "own".into())
    );
}

#[test]
fn the_first_mismatch_is_a_waveform() {
    let small = ["--set", "vectors.arithmetic=100", "--set", "vectors.planned=false"];
    let clocks = reliefrtl::config::Design::default().latency.add;
    let result = format!("output result (stage {clocks}): expected hex");
    for (unit, output, told) in [("fp_add", "result", result.as_str()), ("traverse", "out_valid", "output out_i")] {
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
fn a_tree_that_was_edited_is_not_checked_by_the_interpreter() {
    let dir = tempfile::tempdir().unwrap();
    assert_eq!(said(dir.path(), &[&["build"][..], &SMALL].concat()).0, Some(0));
    let file = dir.path().join("out/rtl/relief_level_up.v");
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
    if skip() {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    // What is spoiled may well go round for ever.
    let few = ["--profile", "published", "--set", "traverse.step_limit=100", "--set", "traverse.levels=5"];
    let small = [&SMALL[..], &few].concat();
    assert_eq!(said(dir.path(), &[&["build"][..], &small].concat()).0, Some(0));
    let file = dir.path().join("out/rtl/relief_multi_level_down.v");
    let text = std::fs::read_to_string(&file).unwrap();
    let right = "y_child = y_is_below ? y_low : (y_is_above ? y_high";
    assert!(text.contains(right), "{text}");
    std::fs::write(&file, text.replace(right, "y_child = (y_hit[2:0] == 3'd5) ? y_low : (y_is_above ? y_high"))
        .unwrap();
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
    if skip() {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    let args = [&["check", "--unit", "fp_add", "--canary", "flip", "--engine"][..], &["icarus"], &SMALL].concat();
    let (code, icarus) = said(dir.path(), &args);
    let interp =
        said(dir.path(), &args.iter().map(|a| if *a == "icarus" { "interp" } else { *a }).collect::<Vec<_>>()).1;
    assert_eq!(code, Some(1), "{icarus}");
    let stage = format!("(stage {}): expected hex", reliefrtl::config::Config::default().latency.add);
    assert!(icarus.contains(&stage) && icarus.contains("(a hex "), "{icarus}");
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
    assert_eq!((code, &json["error"]["code"]), (Some(1), &1.into()));
    let first = &json["error"]["place"];
    let clocks = reliefrtl::config::Design::default().latency.add;
    assert_eq!((&first["unit"], &first["output"]), (&"fp_add".into(), &"result".into()));
    assert_eq!(first["stage"], clocks);
    assert_ne!(first["expected"], first["got"]);
    assert!(
        told.contains("fp_add: 1 of ") && told.contains("does not hold the rows that vectors.json describes"),
        "{told}"
    );
}

/// A list counts each of its names once.
#[test]
fn what_is_named_twice_is_taken_once() {
    let dir = tempfile::tempdir().unwrap();
    let rows = |verb: &[&str]| said(dir.path(), &[verb, &["--set", "vectors.arithmetic=20"]].concat());
    for list in [&["--unit", "lzc,lzc"][..], &["--unit", "lzc", "--unit", " lzc"]] {
        assert_eq!(rows(&[&["check"], list].concat()), rows(&["check", "--unit", "lzc"]));
        let (code, text) = rows(&[&["emit"], list].concat());
        assert_eq!(code, Some(0), "{text}");
    }
    let hard = |cases: &str| rows(&["hard", "--rays", "4", "--engine", "golden", "--case", cases]);
    assert_eq!(hard("floor").0, Some(0));
    assert_eq!(hard("floor,floor"), hard("floor"));
    let steps = |views: &str| rows(&["steps", "--set", "view.stride=64", "--views", views]);
    assert_eq!(steps("front,front"), steps("front"));
}

/// Every file of a unit's vectors is under a digest, and every word of the description.
#[test]
fn whatever_was_edited_beside_the_rows_is_named() {
    let dir = tempfile::tempdir().unwrap();
    let small = [&SMALL[..], &["--set", "traverse.levels=3"]].concat();
    assert_eq!(said(dir.path(), &[&["build"][..], &small].concat()).0, Some(0));
    let check = |unit: &str| said(dir.path(), &[&["check", "--dir", "out", "--unit", unit][..], &small].concat());
    for unit in ["traverse", "fp_add"] {
        let (code, told) = check(unit);
        assert_eq!(code, Some(0), "{told}");
    }
    let edits: [(&str, &str, &str, &str); 9] = [
        ("fp_add", "vectors.json", "\"seed\": 1", "\"seed\": 2"),
        ("fp_add", "vectors.json", "ChaCha8", "ChaCha9"),
        ("fp_add", "vectors.json", "\"policy\": \"", "\"policy\": \"all "),
        ("fp_add", "vectors.json", "\"events\": {", "\"events\": {\n    \"one more\": 7,"),
        ("fp_add", "rows.json", "\n]", "\n ]"),
        ("fp_add", "digests.txt", "rows.json", "rows.jsom"),
        ("traverse", "trace.csv", ",step,", ",stop,"),
        ("traverse", "memory.hex", "//", "// edited,"),
        ("traverse", "vectors.json", "\"seed\": 1", "\"seed\": 3"),
    ];
    for (unit, file, from, to) in edits {
        let path = dir.path().join(format!("out/golden/{unit}/{file}"));
        let text = std::fs::read_to_string(&path).unwrap();
        assert!(text.contains(from), "{file} holds {from:?}");
        std::fs::write(&path, text.replacen(from, to, 1)).unwrap();
        let (code, told) = check(unit);
        assert!(code == Some(2) && told.contains(&format!("golden/{unit}/")), "{file}, {to:?}: {code:?} {told}");
        assert!(told.contains(if file == "digests.txt" { "rows.jso" } else { file }), "{file}: {told}");
        std::fs::write(&path, text).unwrap();
    }
    let digests = dir.path().join("out/golden/fp_add/digests.txt");
    let text = std::fs::read_to_string(&digests).unwrap();
    std::fs::remove_file(&digests).unwrap();
    let (code, told) = check("fp_add");
    assert!(code == Some(2) && told.contains("digests.txt is not there"), "{told}");
    std::fs::write(&digests, text).unwrap();
    // Text that an engine does read is said, not refused.
    let main = dir.path().join("out/testbench/verilator_main.cpp");
    std::fs::write(&main, std::fs::read_to_string(&main).unwrap() + "// mine\n").unwrap();
    let (code, told) = check("fp_add");
    assert!(code == Some(0) && told.contains("verilator_main.cpp was edited since it was generated"), "{told}");
}
