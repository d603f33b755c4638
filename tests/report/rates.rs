//! `accuracy --scenes`: rates over the published scenes, here over maps of the same names.
use crate::program;
use image::{GrayImage, Luma};
use std::path::Path;

fn run(dir: &Path, args: &[&str]) -> (i32, String, String) {
    let out = program::run(dir, args);
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (out.status.code().unwrap(), text(&out.stdout), text(&out.stderr))
}

#[test]
fn rates_of_both_datapaths_at_two_sizes() {
    let dir = tempfile::tempdir().unwrap();
    for (k, name) in ["rocks", "stones", "four", "saints"].iter().enumerate() {
        let height = |x: u32, y: u32| Luma([(x * (37 + k as u32) + y * 101 + x * y * 13) as u8]);
        GrayImage::from_fn(32, 32, height).save(dir.path().join(format!("{name}.png"))).unwrap();
    }
    let small = ["--set", "traverse.levels=5", "--set", "view.stride=32"];
    let args = [&["accuracy", "--scenes", "."][..], &small].concat();
    let (code, json, told) = run(dir.path(), &[&args[..], &["--json"]].concat());
    assert_eq!(code, 0, "{told}");
    let rates: Vec<serde_json::Value> = serde_json::from_str(&json).unwrap();
    let shown: Vec<(u64, &str)> =
        rates.iter().map(|r| (r["texels"].as_u64().unwrap(), r["datapath"].as_str().unwrap())).collect();
    let (float, fixed) = ("watertight 7/16", "fixed Q.24");
    assert_eq!(shown, [(32, float), (32, fixed), (2048, float), (2048, fixed)]);
    for r in &rates {
        let number = |key: &str| r[key].as_f64().unwrap();
        assert!(number("rays") > 4000.0 && number("given_up") == 0.0, "{r}");
        // The bounds of four photographs hold for these maps with room to spare.
        assert!(number("wrong_percent") <= 0.2 && number("uv_p99") <= 0.05, "{r}");
        assert!(number("uv_p99") > 0.0 && r["uv_largest"]["value"].as_f64().unwrap() >= number("uv_p99"), "{r}");
        assert_eq!(r["worst_wrong"].is_null(), r["wrong"] == 0, "{r}");
    }
    // Few bits are seen to be worse; and the table says the same as the JSON.
    let coarse = [
        &args[..],
        &["--set", "format.man=10", "--set", "datapath.fraction_bits=14", "--set", "datapath.reciprocal_bits=12"],
    ]
    .concat();
    let (code, table, told) = run(dir.path(), &coarse);
    assert_eq!(code, 0, "{told}");
    assert!(table.contains("watertight 7/10") && table.contains("fixed Q.14, reciprocal 12"), "{table}");
    assert!(table.contains("the wrong texel farthest from another decision"), "{table}");
    // The published datapath, with and without its nudge: what was asked for is what is measured.
    let published = |more: &[&str]| -> Vec<serde_json::Value> {
        let kind = ["--json", "--set", "datapath.kind=published", "--set", "traverse.step_limit=200"];
        let (code, json, told) = run(dir.path(), &[&args[..], &kind, more].concat());
        assert_eq!(code, 0, "{told}");
        serde_json::from_str(&json).unwrap()
    };
    let (with, without) = (published(&[]), published(&["--set", "datapath.nudge_bits=0"]));
    assert_eq!(with[0]["datapath"], "published 7/16, nudge 2^-7");
    assert_eq!(without[0]["datapath"], "published 7/16, no nudge");
    let lost = |r: &[serde_json::Value]| r[0]["given_up"].as_u64().unwrap();
    assert!(with.len() == 2 && lost(&with) < lost(&without), "{with:?} {without:?}");
    let (code, _, told) = run(dir.path(), &["accuracy", "--scenes", "nowhere"]);
    assert!(code == 2 && told.contains("rocks.png"), "{told}");
    let (code, _, told) = run(dir.path(), &["accuracy", "--scenes", ".", "--set", "map.border=clamp"]);
    assert!(code == 2 && told.contains("the published maps repeat"), "{told}");
}
