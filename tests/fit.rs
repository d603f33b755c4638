//! `fit` finds designs that keep their budget on rays that it has not seen, and says what it left out.
use std::path::Path;
use std::process::{Command, Output};

fn run(dir: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_reliefrtl")).args(args).current_dir(dir).output().unwrap()
}

fn fitted(dir: &Path, args: &[&str]) -> serde_json::Value {
    let out = run(dir, &[&["fit", "--json"], args].concat());
    let text = String::from_utf8_lossy(&out.stdout).into_owned();
    assert_eq!(out.status.code(), Some(0), "{args:?}: {text} {}", String::from_utf8_lossy(&out.stderr));
    serde_json::from_str(&text).unwrap()
}

#[test]
fn a_smooth_and_a_spiky_scene_get_different_hardware() {
    let dir = tempfile::tempdir().unwrap();
    let common = ["--max-uv-error", "1", "--allow-resample", "--set", "view.width=512", "--set", "view.height=384"];
    let of = |kind: &str, view: &str| {
        let kind = format!("map.kind={kind}");
        fitted(dir.path(), &[&["--set", &kind, "--views", view], &common[..]].concat())
    };
    let (smooth, spiky) = (of("dunes", "front"), of("spikes", "grazing"));
    for found in [&smooth, &spiky] {
        assert!(found["fresh"]["rays"].as_u64().unwrap() > 1000, "{found}");
        assert!(found["fresh"]["uv_p99"].as_f64().unwrap() <= 1.0, "{found}");
        assert_eq!(found["fresh"]["given_up"], 0);
        assert!(found["tried"].as_u64().unwrap() > 30);
        assert!(!found["rejected"].as_array().unwrap().is_empty());
    }
    let bits = |x: &serde_json::Value| x["bits"]["logic"].as_u64().unwrap() + x["bits"]["memory"].as_u64().unwrap();
    assert!(bits(&smooth) < bits(&spiky), "{} and {}", smooth["bits"], spiky["bits"]);
    assert_ne!(smooth["traverse"], spiky["traverse"]);
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
    assert!(text.contains("kind = \"bricks\""));
}

#[test]
fn a_budget_that_nothing_keeps_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let small = ["--set", "view.width=128", "--set", "view.height=96"];
    let out = run(dir.path(), &[&["fit", "--max-uv-error", "0.0000001", "--out", "x.toml"], &small[..]].concat());
    assert_eq!(out.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&out.stderr).contains("no design keeps the budget; the widest one is"));
    assert!(!dir.path().join("x.toml").exists());
    for (args, told) in [
        (vec!["fit"], "fit needs a budget"),
        (vec!["fit", "--max-wrong-texel", "1.5"], "is no share"),
        (vec!["fit", "--max-uv-error", "-1"], "--max-uv-error"),
    ] {
        let out = run(dir.path(), &args);
        let text = String::from_utf8_lossy(&out.stderr).into_owned();
        assert_eq!(out.status.code(), Some(2), "{text}");
        assert!(text.contains(told), "{text}");
    }
}
