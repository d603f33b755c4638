//! `emit.counters`: the key, the columns of vectors and of `trace`, and what is said where a verb needs a counter that is left out.
use super::{engines, run, said};
use reliefrtl::config::{Config, Counters};
use std::path::Path;

/// A small design; a map of 32 x 32, of the border that keeps the places of rays apart from their words.
const SMALL: [&str; 6] = ["--set", "traverse.levels=5", "--set", "map.border=mirror", "--set", "traverse.step_limit=4"];

fn with<'a>(verb: &[&'a str], more: &[&'a str]) -> Vec<&'a str> {
    [verb, &SMALL, more].concat()
}

#[test]
fn the_key_is_a_word() {
    for (word, counters) in Counters::WORDS.iter().zip(Counters::ALL) {
        let mut c = Config::default();
        c.apply_set(&format!("emit.counters={word}")).unwrap();
        c.validate().unwrap();
        assert_eq!(c.design().counters, counters);
        assert_eq!(Config::from_toml(&c.to_commented_toml(), "c.toml").unwrap(), c);
        assert_eq!(c.hash() == Config::default().hash(), counters == Counters::All, "{word}");
    }
    let refused = Config::default().apply_set("emit.counters=step").unwrap_err();
    assert_eq!(refused.exit_code(), 2);
    assert_eq!(
        refused.to_string(),
        "emit.counters = \"step\" is not one of all, steps, none; did you mean \"steps\"? (--set)"
    );
    let refused = Config::from_toml("[emit]\ncounters = 3\n", "c.toml").unwrap_err();
    assert_eq!(refused.to_string(), "emit.counters = 3 is not one of all, steps, none (c.toml, line 2)");
    let text = Config::default().to_commented_toml();
    assert!(text.contains("all, steps, none.\n# counters = \"all\"\n"), "{text}");
}

/// Hits, one refused and some given up, by every engine: the same bytes, with the columns that there are.
#[test]
fn every_engine_writes_the_columns_that_there_are() {
    let dir = tempfile::tempdir().unwrap();
    let rays = "u,v,du,dv\n0.1,0.2,0.3,-0.4\n0.9,0.5,-1.5,0.25\n0.5,0.5,0,0\n0.3,0.3,40,0\n0,0,3,3\n";
    std::fs::write(dir.path().join("r.csv"), rays).unwrap();
    let trace = |engine: &str, sets: &[&str]| {
        let args = with(&["trace", "--rays", "r.csv", "--engine", engine, "--out", "h.csv"], sets);
        let (code, text) = said(dir.path(), &args);
        assert_eq!(code, Some(0), "{text}");
        assert!(text.contains("1 of 5 can't be traced by this design"), "{engine}: {text}");
        assert!(text.contains("were given up after 4 iterations"), "{engine}: {text}");
        std::fs::read_to_string(dir.path().join("h.csv")).unwrap()
    };
    for search in ["pyramid", "windows"] {
        let search = format!("datapath.search={search}");
        let sets = ["--set", "datapath.kind=fixed", "--set", &search];
        let whole = trace("golden", &sets);
        assert!(whole.starts_with("ray,i,j,u,v,t,steps,crossings,ups,wall,limit\n"), "{whole}");
        for (counters, columns) in [("all", 3), ("steps", 1), ("none", 0)] {
            let word = format!("emit.counters={counters}");
            let sets = [&sets[..], &["--set", &word]].concat();
            let kept = |line: &str| {
                let cells = line.split(',').enumerate().filter(|(k, _)| !(6 + columns..9).contains(k)).map(|c| c.1);
                cells.collect::<Vec<_>>().join(",") + "\n"
            };
            let expected: String = whole.lines().map(kept).collect();
            for engine in engines() {
                assert_eq!(trace(engine, &sets), expected, "{engine}, {sets:?}");
            }
        }
    }
}

fn head(dir: &Path, file: &str) -> Vec<String> {
    let text = std::fs::read_to_string(dir.join("v/golden/traverse").join(file)).unwrap();
    text.lines().take(2).map(str::to_owned).collect()
}

#[test]
fn vectors_have_the_columns_that_there_are_and_a_tree_of_others_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let few = ["--set", "traverse.levels=4", "--set", "vectors.planned=false", "--set", "vectors.arithmetic=20"];
    let few = [&few[..], &["--set", "vectors.rays=10", "--set", "view.width=64", "--set", "view.height=48"]].concat();
    for (counters, columns, words) in [("steps", "out_limit,out_steps", 2), ("none", "out_wall,out_limit", 4)] {
        let word = format!("emit.counters={counters}");
        let sets = [&few[..], &["--set", &word]].concat();
        let (code, text) = said(dir.path(), &[&["build", "--out", "v"], &sets[..]].concat());
        assert_eq!(code, Some(0), "{text}");
        assert_eq!(text.contains("rays traced through the golden model"), counters == "none", "{text}");
        assert!(head(dir.path(), "vectors.csv")[0].ends_with(columns), "{counters}");
        // A bench that can't read iterations of a result has them in the head.
        assert_eq!(head(dir.path(), "expected.hex")[1].split(' ').count(), words, "{counters}");
        let text = std::fs::read_to_string(dir.path().join("v/golden/traverse/vectors.json")).unwrap();
        assert_eq!(text.contains("\"iterations\""), counters == "none", "{text}");
        let manifest = std::fs::read_to_string(dir.path().join("v/manifest.json")).unwrap();
        assert_eq!(manifest.contains("out_steps"), counters == "steps");
        assert!(!manifest.contains("out_crossings"), "{counters}");
        let check = ["check", "--dir", "v", "--unit", "traverse"];
        let (code, text) = said(dir.path(), &[&check, &sets[..]].concat());
        assert_eq!(code, Some(0), "{text}");
        let (code, text) = said(dir.path(), &[&check, &few[..]].concat());
        assert_eq!(code, Some(2), "{text}");
        assert!(text.contains("emit.counters"), "{text}");
    }
    let place = dir.path().join("v/golden/traverse/expected.hex");
    let text = std::fs::read_to_string(&place).unwrap();
    let line = head(dir.path(), "expected.hex")[1].clone();
    std::fs::write(&place, text.replacen(&line, &format!("{line}1"), 1)).unwrap();
    let (code, text) = said(
        dir.path(),
        &[&["check", "--dir", "v", "--unit", "traverse"], &few[..], &["--set", "emit.counters=none"]].concat(),
    );
    assert_eq!(code, Some(2), "{text}");
    assert!(text.contains("announces the iterations"), "{text}");
}

#[test]
fn a_picture_of_iterations_needs_them() {
    let dir = tempfile::tempdir().unwrap();
    let picture = |more: &[&str]| {
        let size = ["--set", "view.width=64", "--set", "view.height=48", "--set", "traverse.levels=4"];
        run(dir.path(), &[&["render", "--steps", "--out", "p.png"], &size[..], more].concat())
    };
    let none = ["--set", "emit.counters=none"];
    let refused = picture(&[&none[..], &["--engine", "interp"]].concat());
    assert_eq!(refused.status.code(), Some(2));
    assert_eq!(
        String::from_utf8_lossy(&refused.stderr).trim(),
        "reliefrtl: render --steps draws iterations, and emit.counters = \"none\" gives none with a hit: use --engine golden, or another emit.counters"
    );
    let mut pictures = Vec::new();
    for more in [&["--engine", "golden"][..], &["--engine", "golden", "--set", "emit.counters=none"]] {
        assert_eq!(picture(more).status.code(), Some(0));
        pictures.push(std::fs::read(dir.path().join("p.png")).unwrap());
    }
    assert_eq!(pictures[0], pictures[1]);
}

/// What the golden model counts does not depend on the hardware's ports.
#[test]
fn figures_of_the_golden_model_are_the_same() {
    let dir = tempfile::tempdir().unwrap();
    let size = ["--set", "view.width=64", "--set", "view.height=48", "--set", "traverse.levels=4", "--json"];
    for verb in ["steps", "accuracy", "hard"] {
        let of = |more: &[&str]| {
            let out = run(dir.path(), &[&[verb], &size[..], more].concat());
            assert_eq!(out.status.code(), Some(0), "{verb}: {}", String::from_utf8_lossy(&out.stderr));
            String::from_utf8_lossy(&out.stdout).replace(&Config::default().hash(), "")
        };
        let engine: &[&str] = if verb == "hard" { &["--engine", "interp", "--rays", "40"] } else { &[] };
        assert_eq!(of(engine), of(&[engine, &["--set", "emit.counters=none"]].concat()), "{verb}");
    }
}
