//! Vector sets as files: everything reads back; what is broken is refused in one sentence.
use crate::simulators::skip;
use reliefrtl::catalogue::{units, vector_set};
use reliefrtl::config::Design;
use reliefrtl::ir::Binding;
use reliefrtl::vectors::{Plan, read_csv, read_json, read_set, set_files};

#[test]
fn sets_read_back() {
    let d = Design::default();
    let mut rows = 0;
    for m in units(&d) {
        let set = vector_set(&d, &m, &Binding::new(), Plan { rows: 200, seed: 4 });
        assert_eq!(set, vector_set(&d, &m, &Binding::new(), Plan { rows: 200, seed: 4 }), "same seed, same rows");
        let files = set_files(&set);
        let dir = tempfile::tempdir().unwrap();
        files.iter().for_each(|(n, t)| std::fs::write(dir.path().join(n), t).unwrap());
        assert_eq!(read_set(dir.path()).unwrap(), (set.clone(), true), "{}", m.name);
        let same = (set.stimulus.clone(), set.expected.clone());
        assert_eq!(read_csv(&files["vectors.csv"], &set.inputs, &set.outputs).unwrap(), same);
        assert_eq!(read_json(&files["rows.json"], &set.inputs, &set.outputs).unwrap(), same);
        rows += set.stimulus.len();
    }
    assert!(rows > 4000, "only {rows} rows");
}

#[test]
fn broken_sets_are_refused() {
    let d = Design::default();
    let m = reliefrtl::catalogue::find(&d, "fp_add").unwrap();
    let set = vector_set(&d, &m, &Binding::new(), Plan { rows: 20, seed: 4 });
    let broken = |name: &str, change: &dyn Fn(&str) -> String| {
        let dir = tempfile::tempdir().unwrap();
        for (n, t) in set_files(&set) {
            std::fs::write(dir.path().join(&n), if n == name { change(&t) } else { t }).unwrap();
        }
        read_set(dir.path()).map(|r| r.1).map_err(|e| e.to_string())
    };
    let cut = |t: &str| t.lines().take(10).collect::<Vec<_>>().join("\n");
    assert!(broken("stimulus.hex", &cut).unwrap_err().contains("announces 20 rows and has"));
    assert!(
        broken("stimulus.hex", &|t| t.replacen("\n14 30\n", "\nzz 30\n", 1))
            .unwrap_err()
            .contains("zz is not a hex number")
    );
    let bits = broken("stimulus.hex", &|t| t.replacen("\n14 30\n", "\n14 20\n", 1)).unwrap_err();
    assert!(bits.contains("announces rows of 32 bits, vectors.json describes 48"), "{bits}");
    assert!(broken("vectors.json", &|t| t.replace("\"schema\": 2", "\"schema\": 9")).unwrap_err().contains("schema 9"));
    assert!(broken("vectors.json", &|_| "{".into()).unwrap_err().contains("not a vector description"));
    assert_eq!(broken("vectors.json", &|t| t.replace("\"blake3\": \"", "\"blake3\": \"0")), Ok(false));
}

/// Edited descriptions are refused in one sentence, by whoever replays them; none of them may panic.
#[test]
fn sets_of_another_unit_are_refused() {
    let d = Design::default();
    let m = reliefrtl::catalogue::find(&d, "fp_add").unwrap();
    let set = vector_set(&d, &m, &Binding::new(), Plan { rows: 20, seed: 4 });
    let mut n = 0;
    let mut refused = |change: &dyn Fn(&mut reliefrtl::vectors::VectorSet), words: &str| {
        let mut other = set.clone();
        change(&mut other);
        let e = reliefrtl::catalogue::check_interp(&m, &other).unwrap_err();
        assert_eq!(e.exit_code(), 2, "{e}");
        assert!(e.to_string().contains(words), "{e}");
        n += 1;
    };
    refused(&|s| s.unit = "fp_mul".into(), "those of fp_mul, not of fp_add");
    refused(&|s| s.inputs[0].name = "c".into(), "inputs c[24] b[24], the unit has a[24] b[24]");
    refused(&|s| s.outputs[0].width = 25, "outputs result[25], the unit has result[24]");
    refused(&|s| s.inputs.truncate(1), "inputs a[24], the unit has");
    refused(
        &|s| {
            s.params.insert("MAN".into(), 3);
        },
        "no parameter MAN",
    );
    assert_eq!(n, 5);
}

/// Every class of operands meets every other in the committed number of rows.
#[test]
fn classes_meet() {
    let d = Design::default();
    let f = d.format;
    let class = |v: u64| {
        let (e, m) = ((v >> f.man) & f.exp_max(), v & f.man_mask());
        let kind = match (e, m) {
            (0, 0) => 0,
            (0, _) => 1,
            (e, 0) if e == f.exp_max() => 2,
            (e, _) if e == f.exp_max() => 3,
            _ => 4,
        };
        (kind, v & f.sign_bit() != 0)
    };
    for name in ["fp_add", "fp_mul", "fp_div", "fp_lt"] {
        let m = reliefrtl::catalogue::find(&d, name).unwrap();
        let set = vector_set(&d, &m, &Binding::new(), Plan { rows: 2000, seed: 1 });
        let pairs: std::collections::BTreeSet<_> = set.stimulus.iter().map(|r| (class(r[0]), class(r[1]))).collect();
        assert_eq!(pairs.len(), 100, "{name}: zero, subnormal, infinity, NaN, number, of both signs");
    }
}

/// Any legal parameter value of a unit's text, by `--param`; of conversions alone also by keys.
#[test]
fn units_at_other_parameters() {
    let dir = tempfile::tempdir().unwrap();
    let run = |line: &[&str]| {
        let out = std::process::Command::new(env!("CARGO_BIN_EXE_reliefrtl"))
            .args(line)
            .current_dir(dir.path())
            .output()
            .expect("the program runs");
        let said = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
        (out.status.code().unwrap(), said)
    };
    let (code, said) = run(&["vectors", "--unit", "lzc", "--param", "W=13", "--out", "a"]);
    assert_eq!(code, 0, "{said}");
    let text = std::fs::read_to_string(dir.path().join("a/golden/lzc/vectors.json")).unwrap();
    assert!(text.contains("\"W\": 13"), "{text}");
    let gradual = ["--set", "format.subnormals=gradual"];
    let small = ["--param", "EXP_W=2", "--param", "MAN_W=3", "--param", "INT_W=4", "--param", "FRAC_W=4"];
    let mut engines = vec!["interp"];
    if skip() {
        println!("skipped in Icarus: RELIEFRTL_NO_SIMULATORS=1");
    } else {
        engines.push("icarus");
    }
    for engine in engines {
        let head = ["check", "--engine", engine];
        for rest in [
            [&["--unit", "fp_to_fixed"][..], &small, &gradual].concat(),
            vec!["--unit", "div_rows", "--param", "W=9", "--param", "ROWS=3"],
            vec!["--unit", "node_planes", "--param", "LEVELS=5", "--param", "IDX_W=11", "--set", "traverse.levels=3"],
            vec!["--unit", "traverse", "--param", "LEVELS=4", "--param", "TAG_W=3", "--set", "vectors.rays=20"],
            vec!["--unit", "fp_to_fixed", "--set", "convert.int_bits=20", "--set", "convert.frac_bits=3"],
        ] {
            let (code, said) = run(&[&head[..], &rest].concat());
            assert!(code == 0 && said.contains("1 unit, 0 of "), "{engine} {rest:?}: {said}");
        }
        let spoiled = ["--canary", "flip"];
        let (code, said) = run(&[&head[..], &["--unit", "fp_to_fixed"], &small, &gradual, &spoiled].concat());
        assert_eq!(code, 1, "{said}");
    }
    let text = {
        let (code, said) = run(&[
            "emit",
            "--unit",
            "fp_from_fixed",
            "--set",
            "convert.int_bits=20",
            "--set",
            "convert.frac_bits=3",
            "--out",
            "b",
        ]);
        assert_eq!(code, 0, "{said}");
        std::fs::read_to_string(dir.path().join("b/rtl/relief_fp_from_fixed.v")).unwrap()
    };
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("integer INT_W = 20,") && words.contains("integer FRAC_W = 3"), "{text}");
    for (line, words) in [
        (&["vectors", "--unit", "lzc", "--param", "W=65"][..], "lzc needs W <= 64"),
        (&["vectors", "--unit", "lzc", "--param", "X=5"], "lzc has no parameter X; it has the parameters W"),
        (&["vectors", "--unit", "lzc", "--param", "W=w"], "is not NAME=VALUE"),
        (&["vectors", "--unit", "lzc", "--param", "W=5", "--param", "W=6"], "gives W twice"),
        (&["vectors", "--param", "W=5"], "--unit"),
        (&["check", "--unit", "fp_to_int", "--set", "convert.int_bits=1"], "convert.int_bits = 1 is too small"),
        (&["check", "--unit", "fp_to_int", "--set", "convert.int_bits=50"], "at most 61 - format.man = 45"),
        (&["check", "--unit", "fp_to_fixed", "--set", "convert.frac_bits=5"], "needs convert.int_bits"),
        (&["build", "--set", "convert.int_bits=20"], "is for conversions alone"),
    ] {
        let (code, said) = run(line);
        let words = words.replace("at most 61 - format.man = 45", "2 to 61 - format.man = 45 are legal");
        assert!(code == 2 && said.contains(&words), "{line:?}: {code} {said}");
    }
}
