//! `build`: what it says and writes.
use super::run;

#[test]
fn build_says_what_it_did() {
    let dir = tempfile::tempdir().unwrap();
    let out = run(
        dir.path(),
        &["build", "--set", "vectors.arithmetic=100", "--set", "vectors.rays=20", "--set", "view.stride=16"],
    );
    assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
    let text = String::from_utf8_lossy(&out.stdout).into_owned();
    let t = reliefrtl::units::traversal::traverse(&reliefrtl::config::Config::default().design());
    let slots = format!("a loop of {} slots", t.slots);
    let rtl = std::fs::read_dir(dir.path().join("out/rtl")).unwrap();
    let modules = rtl.filter(|e| e.as_ref().unwrap().path().extension().is_some_and(|x| x == "v")).count();
    let units = std::fs::read_dir(dir.path().join("out/golden"))
        .unwrap()
        .filter(|e| e.as_ref().unwrap().path().is_dir())
        .count();
    assert!(units < modules);
    let parts = format!(
        "{modules} modules in out/rtl, {units} of them units with vectors of their own, the others checked inside of these"
    );
    for part in [slots.as_str(), "\ntraverse         0 of ", "oblique", "iverilog -g2005", &parts] {
        assert!(text.contains(part), "{part} is missing in:\n{text}");
    }
    for file in [
        "rtl/relief_traverse.v",
        "rtl/filelist.f",
        "testbench/relief_tb_traverse.v",
        "golden/fp_add/vectors.json",
        "manifest.json",
        "preview.png",
    ] {
        assert!(dir.path().join("out").join(file).is_file(), "{file}");
    }
}
