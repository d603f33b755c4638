//! `bench`: figures as numbers, in turns.
use std::process::Command;

/// Without Verilator the rest is measured all the same, and nothing stands beside nothing; every figure is a number of the JSON.
#[test]
fn figures_are_numbers_and_turns_are_counted() {
    let dir = tempfile::tempdir().unwrap();
    let args = ["bench", "--json", "--rays", "60", "--turns", "3", "--view", "front", "--set", "traverse.levels=4"];
    let out = Command::new(env!("CARGO_BIN_EXE_reliefrtl"))
        .args(args)
        .current_dir(dir.path())
        .env("VERILATOR", "no-such-verilator")
        .output()
        .unwrap();
    let told = String::from_utf8_lossy(&out.stderr).into_owned();
    assert_eq!(out.status.code(), Some(0), "{told}");
    assert!(told.contains("left out: no-such-verilator is not installed"), "{told}");
    let json: serde_json::Value = serde_json::from_slice(&out.stdout).unwrap();
    assert_eq!((json["rays"].as_u64(), json["views"][0].as_str()), (Some(60), Some("front")));
    assert!(json["iterations"].as_u64().unwrap() >= 60 && json["compared_with"].is_null(), "{json}");
    let engines = json["engines"].as_array().unwrap();
    assert!(engines.len() >= 3);
    for e in &engines[..3] {
        assert_eq!(
            (e["rays"].as_u64(), e["turns"].as_u64(), e["compared"].as_u64()),
            (Some(60), Some(3), Some(180)),
            "{e}"
        );
        let [min, median, max] = ["min", "median", "max"].map(|key| e["run_s"][key].as_f64().unwrap());
        assert!(0.0 <= min && min <= median && median <= max && max > 0.0, "{e}");
        assert!(e["build_s"].is_f64() && e["of_verilator"].is_null(), "{e}");
    }
    let times: Vec<&str> = engines[..3].iter().map(|e| e["time"].as_str().unwrap()).collect();
    assert_eq!(times, ["processor", "processor", "wall"]);
}
