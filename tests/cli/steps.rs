//! `steps`: what trims save.
use super::said;

/// Means over a bricks map and three views, relative to the best published row; each datapath has the rows that it can have.
#[test]
fn trims_take_fewer_iterations() {
    let dir = tempfile::tempdir().unwrap();
    for (kind, rows) in [("watertight", 9), ("fixed", 9), ("published", 7)] {
        let kind = format!("datapath.kind={kind}");
        let (code, text) = said(
            dir.path(),
            &["steps", "--json", "--set", &kind, "--set", "view.stride=8", "--set", "map.kind=bricks"],
        );
        assert_eq!(code, Some(0), "{text}");
        let cells: serde_json::Value = serde_json::from_str(&text).unwrap();
        let cells = cells.as_array().unwrap();
        assert_eq!(cells.len(), 3 * rows, "{text}");
        let mean = |name: &str| -> f64 {
            cells.iter().filter(|c| c["row"] == name).map(|c| c["mean"].as_f64().unwrap()).sum()
        };
        let relative = |name: &str| mean(name) / mean("a + b + c1");
        if rows == 9 {
            let [after, always] = [relative("a + b + c1 + trim descent"), relative("a + b + c1 + trim always")];
            println!("{kind}: after descents {after:.3}, always {always:.3}");
            assert!(after <= 0.94 && always <= 0.91 && always < after, "{kind}: {after} {always}");
        }
    }
}
