//! Vector sets as files: everything reads back; what is broken is refused in one sentence.
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
