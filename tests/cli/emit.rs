//! `emit`: arithmetic alone, at every choice and format.
use super::{refused, run, said};

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
        let verilog = std::fs::read_to_string(dir.path().join(format!("{unit}/rtl/relief_{unit}.v"))).unwrap();
        let told = verilog.replace("\n//            ", " ");
        assert!(
            told.contains("rounding down, subnormals gradual") && told.contains("rounded toward minus infinity"),
            "{verilog}"
        );
        let manifest = std::fs::read_to_string(dir.path().join(format!("{unit}/manifest.json"))).unwrap();
        assert!(manifest.contains(&format!("\"name\": \"relief_{unit}\"")));
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

/// Streams, whose rows are clocks: each engine sees a flipped bit, and other parameter values have vectors, too.
#[test]
fn streams_stand_alone() {
    let dir = tempfile::tempdir().unwrap();
    let ask = |args: &[&str]| said(dir.path(), args);
    for (unit, param) in [("fifo", "DEPTH=64"), ("arbiter", "W=16")] {
        for part in ["emit", "vectors"] {
            assert_eq!(ask(&[part, "--unit", unit, "--out", unit]).0, Some(0));
        }
        let bench = std::fs::read_to_string(dir.path().join(format!("{unit}/testbench/relief_tb_{unit}.v"))).unwrap();
        assert!(bench.contains(".rst(rst)") && !bench.contains("lfsr") && !bench.contains(".ce("), "{bench}");
        let mut engines = vec!["interp"];
        if std::env::var("RELIEFRTL_NO_SIMULATORS").as_deref() != Ok("1") {
            engines.extend(["icarus", "verilator"]);
        }
        for engine in engines {
            let check = ["check", "--unit", unit, "--dir", unit, "--engine", engine];
            let (code, text) = ask(&check);
            assert!(code == Some(0) && text.contains("0 of 2000 mismatched"), "{engine}: {text}");
            let (code, text) = ask(&[&check[..], &["--canary", "flip"]].concat());
            assert!(code == Some(1) && text.contains("first: vector 1000"), "{engine}: {text}");
        }
        let (code, text) = ask(&["check", "--unit", unit, "--param", param]);
        assert_eq!(code, Some(0), "{text}");
    }
}

#[test]
fn arithmetic_stands_alone_at_formats_that_no_map_fits() {
    let dir = tempfile::tempdir().unwrap();
    let format = ["--set", "format.exp=4", "--set", "format.man=3"];
    let (code, text) = said(dir.path(), &[&["emit", "--unit", "fp_add"][..], &format].concat());
    assert_eq!(code, Some(0), "{text}");
    let emitted = std::fs::read_to_string(dir.path().join("out/rtl/relief_fp_add.v")).unwrap();
    assert!(emitted.contains("EXP_W   = 4,") && emitted.contains("MAN_W   = 3,"), "{emitted}");
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

/// One tree for some units of the same choice: one list of files, a flow for each, vectors and benches beside.
#[test]
fn several_units_share_a_tree() {
    let dir = tempfile::tempdir().unwrap();
    let units = ["--unit", "fp_add,fp_lt,fp_sqrt", "--set", "format.rounding=up", "--set", "vectors.arithmetic=100"];
    for part in ["emit", "vectors"] {
        let (code, text) = said(dir.path(), &[&[part][..], &units].concat());
        assert_eq!(code, Some(0), "{text}");
    }
    let list = std::fs::read_to_string(dir.path().join("out/rtl/filelist.f")).unwrap();
    for unit in ["fp_add", "fp_lt", "fp_sqrt"] {
        assert!(list.contains(&format!("{unit}.v")), "{list}");
        for file in [
            format!("flow/relief_{unit}/ecp5.sh"),
            format!("flow/relief_{unit}/relief_{unit}.sdc"),
            format!("testbench/relief_tb_{unit}.v"),
        ] {
            assert!(dir.path().join("out").join(&file).is_file(), "{file}");
        }
    }
    let (code, text) = said(dir.path(), &[&["check", "--dir", "out"][..], &units].concat());
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("3 units, 0 of") && text.contains("fp_sqrt"), "{text}");
    let (code, text) = said(dir.path(), &[&["check", "--level", "1", "--shard", "3/9"][..], &units].concat());
    assert_eq!(code, Some(0), "{text}");
    refused(&["check", "--unit", "fp_add,fp_lt", "--level", "3"], "name one unit");
    refused(&["check", "--unit", "fp_add,fp_addd", "--level", "1"], "no unit is named fp_addd");
}
