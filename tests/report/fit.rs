//! `fit` finds designs that keep their budget on rays that it has not seen, and says what it left out.
use crate::budget::share;
use crate::program::run;
use std::path::Path;

fn fitted(dir: &Path, args: &[&str]) -> serde_json::Value {
    let out = run(dir, &[&["fit", "--json"], args].concat());
    let text = String::from_utf8_lossy(&out.stdout).into_owned();
    assert_eq!(out.status.code(), Some(0), "{args:?}: {text} {}", String::from_utf8_lossy(&out.stderr));
    serde_json::from_str(&text).unwrap()
}

#[test]
fn a_smooth_and_a_spiky_scene_get_different_hardware() {
    let dir = tempfile::tempdir().unwrap();
    let small = ["--allow-resample", "--set", "view.width=512", "--set", "view.height=384"];
    // The same views and the same budget: what differs is the map alone.
    let of = |kind: &str, view: &str, budget: &str| {
        let kind = format!("map.kind={kind}");
        let found =
            fitted(dir.path(), &[&["--set", &kind, "--views", view, "--max-uv-error", budget], &small[..]].concat());
        assert!(found["fresh"]["rays"].as_u64().unwrap() > 1000, "{found}");
        assert!(found["fresh"]["uv_p99"].as_f64().unwrap() <= budget.parse().unwrap(), "{found}");
        assert_eq!(found["fresh"]["given_up"], 0);
        assert!(found["tried"].as_u64().unwrap() > 30);
        let rejected = found["rejected"].as_array().unwrap();
        assert!(!rejected.is_empty());
        assert!(rejected.iter().all(|r| r["search"]["uv_p99"].is_f64() && r["bits"].is_object()), "{rejected:?}");
        found
    };
    let number = |x: &serde_json::Value, keys: [&str; 2]| x[keys[0]][keys[1]].as_u64().unwrap();
    // From above, the heights of a smooth scene need fewer bits.
    let (smooth, spiky) = (of("dunes", "front", "1"), of("spikes", "front", "1"));
    for keys in [["traverse", "height_bits"], ["bits", "memory"]] {
        assert!(number(&smooth, keys) < number(&spiky, keys), "{keys:?}: {smooth} and {spiky}");
    }
    // From the side, its rays fewer.
    let (smooth, spiky) = (of("dunes", "oblique,grazing", "4"), of("spikes", "oblique,grazing", "4"));
    for keys in [["datapath", "fraction_bits"], ["datapath", "reciprocal_bits"], ["bits", "logic"]] {
        assert!(number(&smooth, keys) < number(&spiky, keys), "{keys:?}: {smooth} and {spiky}");
    }
    assert!(number(&smooth, ["bits", "products"]) * 5 < number(&spiky, ["bits", "products"]) * 4);
}

/// `docs/fit.md`, Which windows.
#[test]
fn three_scenes_get_three_sets() {
    let dir = tempfile::tempdir().unwrap();
    let of = |line: &[&str]| {
        let found = fitted(dir.path(), &[&["--rays", "1000"], line].concat());
        (found["windows"]["set"].as_str().unwrap_or("none").to_owned(), found["bits"]["blocks"].as_u64().unwrap())
    };
    let smooth = ["--views", "front,oblique", "--max-uv-error", "4", "--set", "map.kind=dunes"];
    assert_eq!(of(&smooth), ("1 4 16".into(), 96));
    assert_eq!(of(&[&smooth[..], &["--block-memories", "44"]].concat()), ("1 4@2 16@4".into(), 42));
    let spiky = ["--views", "front,oblique,grazing", "--max-uv-error", "4", "--set", "map.kind=spikes"];
    assert_eq!(of(&spiky), ("1 3 9 27".into(), 128));
    let out = run(dir.path(), &[&["fit", "--rays", "1000", "--block-memories", "40"], &smooth[..]].concat());
    let said = String::from_utf8_lossy(&out.stderr).into_owned();
    assert_eq!(out.status.code(), Some(1), "{said}");
    assert!(said.contains("keeps to 40 block memories: the fewest are 42"), "{said}");
    for wrong in ["-3", "1.5", "0"] {
        let out = run(dir.path(), &["fit", "--block-memories", wrong, "--max-uv-error", "4"]);
        assert_eq!(out.status.code(), Some(2));
        assert!(String::from_utf8_lossy(&out.stderr).contains("1 or more, as 208"), "{wrong}");
    }
    // A map of 1024 texels a side takes as long as all of these.
    if share(2) == 1 {
        let large = ["--views", "front,oblique,grazing", "--max-uv-error", "1", "--set", "map.kind=spikes"];
        let large = [&large[..], &["--set", "traverse.levels=10"]].concat();
        assert_eq!(of(&large), ("1 4@2 12@4 24@8 64@16".into(), 682));
    }
}

#[test]
fn the_configuration_is_what_was_found() {
    let dir = tempfile::tempdir().unwrap();
    let found = fitted(
        dir.path(),
        &["--max-wrong-texel", "0.02", "--views", "oblique", "--set", "map.kind=bricks", "--out", "fit.toml"],
    );
    let out = run(dir.path(), &["--config", "fit.toml", "list", "--json"]);
    assert_eq!(out.status.code(), Some(0));
    let text = std::fs::read_to_string(dir.path().join("fit.toml")).unwrap();
    for (section, key) in [("traverse", "tile_bits"), ("traverse", "frac_bits"), ("traverse", "step_limit")] {
        assert!(text.contains(&format!("\n{key} = {}\n", found[section][key])), "{key} in {text}");
    }
    assert!(text.contains("kind = \"bricks\"") && text.contains("names = [\"oblique\"]"), "{text}");
    // The report judges what was found on other rays, and finds the budget kept.
    let chosen = ["report", "--config", "fit.toml", "--out", "again", "--datapaths", "fixed"];
    let few = ["--maps", "bricks", "--fractions", "24", "--modes", "one", "--levels", "8"];
    let out = run(dir.path(), &[&chosen[..], &few].concat());
    assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
    let report = std::fs::read_to_string(dir.path().join("again/report.json")).unwrap();
    let report: serde_json::Value = serde_json::from_str(&report).unwrap();
    let label = report["worst"][0]["design"].as_str().unwrap();
    let cells = report["cells"].as_array().unwrap();
    let mine: Vec<_> = cells.iter().filter(|c| c["design"] == label).collect();
    assert!(mine.len() == 1 && cells.len() == 2, "{label} and one other: {cells:?}");
    let (wrong, rays) = (mine[0]["unrounded_wrong"].as_u64().unwrap(), mine[0]["rays"].as_u64().unwrap());
    assert!(rays > 5000 && wrong > 0 && wrong as f64 <= 0.02 * rays as f64, "{wrong} of {rays}");
}

#[test]
fn a_budget_that_nothing_keeps_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let small = ["--set", "view.width=128", "--set", "view.height=96"];
    let out = run(dir.path(), &[&["fit", "--max-uv-error", "0.0000001", "--out", "x.toml"], &small[..]].concat());
    assert_eq!(out.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&out.stderr).contains("no design keeps the budget; the widest one is"));
    assert!(!dir.path().join("x.toml").exists());
    let table = |rays: usize| "u,v,du,dv\n".to_owned() + &"0.3,0.4,0.1,0.2\n".repeat(rays);
    std::fs::write(dir.path().join("r.csv"), table(1199)).unwrap();
    std::fs::write(dir.path().join("few.csv"), table(3)).unwrap();
    for (args, told) in [
        (vec!["fit"], "fit needs a budget"),
        (
            vec!["fit", "--max-uv-error", "1", "--set", "datapath.kind=published"],
            "fit chooses datapath.kind itself: leave out --set datapath.kind=published",
        ),
        (vec!["fit", "--max-wrong-texel", "1.5"], "is no share"),
        (vec!["fit", "--max-wrong-texel", "0"], "is no share that rays can show"),
        (
            vec!["fit", "--max-wrong-texel", "1e-320"],
            "--max-wrong-texel 1e-320 is no share that rays can show: at least 3e-10",
        ),
        (
            vec!["fit", "--max-uv-error", "1e300"],
            "--max-uv-error 1e300 is no distance in texels: above 0, at most 4096",
        ),
        (
            vec!["fit", "--max-wrong-texel", "0.0001"],
            "30000 are needed to search with, so give at least --rays 10000 (of each view)",
        ),
        (
            vec!["fit", "--max-wrong-texel", "0.01", "--rays", "r.csv"],
            "at least 1200 rays (a quarter searches, the others check)",
        ),
        (vec!["fit", "--max-wrong-texel", "0.01", "--rays", "few.csv"], "at least 4 are needed"),
        (
            vec![
                "fit",
                "--max-wrong-texel",
                "0.01",
                "--set",
                "view.width=8",
                "--views",
                "front",
                "--set",
                "view.height=8",
            ],
            "let the views' pictures have at least 1200 rays in all",
        ),
        (vec!["fit", "--max-uv-error", "-1"], "--max-uv-error"),
    ] {
        let out = run(dir.path(), &args);
        let text = String::from_utf8_lossy(&out.stderr).into_owned();
        assert_eq!(out.status.code(), Some(2), "{text}");
        assert!(text.contains(told), "{text}");
    }
    // As many as the sentence asks for are enough.
    std::fs::write(dir.path().join("r.csv"), table(1200)).unwrap();
    let flat = ["--set", "map.kind=flat", "--set", "traverse.levels=3"];
    let out = run(dir.path(), &[&["fit", "--max-wrong-texel", "0.01", "--rays", "r.csv"], &flat[..]].concat());
    assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
    // No ray at all is no search.
    assert_eq!(run(dir.path(), &["fit", "--max-uv-error", "1", "--rays", "0"]).status.code(), Some(5));
}
