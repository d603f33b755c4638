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
        broken("stimulus.hex", &|t| t.replacen("\n14\n", "\nzz\n", 1)).unwrap_err().contains("zz is not a hex number")
    );
    assert!(broken("vectors.json", &|t| t.replace("\"schema\": 1", "\"schema\": 9")).unwrap_err().contains("schema 9"));
    assert!(broken("vectors.json", &|_| "{".into()).unwrap_err().contains("not a vector description"));
    assert_eq!(broken("vectors.json", &|t| t.replace("\"blake3\": \"", "\"blake3\": \"0")), Ok(false));
}
