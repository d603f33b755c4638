//! `fetch.cells = 4`: which levels a descent takes, and what is refused.
use super::said;
use reliefrtl::config::{Config, DatapathKind, Design};

fn with(sets: &[&str]) -> Config {
    let mut c = Config::default();
    sets.iter().for_each(|set| c.apply_set(set).unwrap());
    c
}

fn problem(sets: &[&str]) -> String {
    let error = with(sets).validate().expect_err("it must be refused");
    assert_eq!(error.exit_code(), 2);
    let said = error.to_string();
    assert!(!said.contains('\n'), "one sentence: {said}");
    said
}

/// Levels down before and after the first crossing.
fn down(c: &Config) -> (u32, u32) {
    (c.mode.levels_down, c.design().levels_down_after())
}

#[test]
fn levels_down_follow_the_cells_where_they_are_not_given() {
    let text = "[fetch]\ncells = 4\n";
    let four = Config::from_toml(text, "c.toml").unwrap();
    assert_eq!(four, with(&["fetch.cells=4"]));
    assert_eq!((down(&four), down(&Config::default())), ((3, 2), (2, 1)));
    assert_eq!(down(&with(&["fetch.cells=4", "fetch.cells=1"])), (2, 1));
    assert_eq!(down(&with(&["mode.levels_down=2", "fetch.cells=4"])), (2, 2));
    assert_eq!(down(&with(&["fetch.cells=4", "mode.levels_down=1", "mode.levels_down_after=3"])), (1, 3));
    assert_eq!(down(&Config::from_toml("[mode]\nlevels_down = 2\n[fetch]\ncells = 4\n", "c.toml").unwrap()), (2, 2));
    // With an explicit 1, too.
    for sets in [&["fetch.cells=4"][..], &["fetch.cells=4", "mode.levels_down_after=1", "mode.trim=always"]] {
        let c = with(sets);
        c.validate().unwrap();
        assert_eq!(Config::from_toml(&c.to_commented_toml(), "again.toml").unwrap(), c);
    }
    let mut c = with(&["fetch.cells=4"]);
    c.choose_datapath(DatapathKind::Published);
    c.validate().unwrap();
    assert_eq!(c.mode, Config::default().mode);
    c.fetch.cells = 4;
    c.choose_datapath(DatapathKind::Windows);
    c.validate().unwrap();
    assert_eq!(with(&["fetch.cells=1", "mode.levels_down_after=1"]).design().fetch, Design::default().fetch);
}

#[test]
fn what_does_not_go_with_the_cells_is_refused_by_name() {
    let four = |more: &[&str]| problem(&[&["fetch.cells=4"], more].concat());
    assert_eq!(
        four(&["datapath.kind=published"]),
        "fetch.cells = 4 and datapath.kind = \"published\" exclude each other: four cells need datapath.kind = \"watertight\" or \"fixed\""
    );
    let by_windows = ["datapath.kind=fixed", "datapath.search=windows"];
    assert_eq!(
        four(&by_windows),
        "fetch.cells = 4 and datapath.search = \"windows\" exclude each other: that search reads every window in one iteration, so leave the key out or set datapath.search = \"pyramid\""
    );
    assert!(problem(&[&["fetch.cells=1"], &by_windows[..]].concat()).starts_with("fetch.cells and datapath.search"));
    let after = ["datapath.kind=fixed", "datapath.search=windows", "mode.levels_down_after=2"];
    assert!(problem(&after).starts_with("mode.levels_down_after = 2 and datapath.search"));
    for (set, shown, legal) in [
        ("mode.level_up=none", "mode.level_up = \"none\"", "\"selective\" and \"tevs\" are legal"),
        ("mode.level_up=always", "mode.level_up = \"always\"", "\"selective\" and \"tevs\" are legal"),
        ("mode.level_up=coherent", "mode.level_up = \"coherent\"", "\"selective\" and \"tevs\" are legal"),
        ("mode.trim=descent", "mode.trim = \"descent\"", "\"none\" and \"always\" are legal"),
        ("mode.levels_down=4", "mode.levels_down = 4", "1 to 3 are legal"),
        ("mode.bilinear=true", "mode.bilinear = true", "hits are not refined"),
    ] {
        assert_eq!(four(&[set]), format!("{shown} and fetch.cells = 4 exclude each other: with four cells {legal}"));
    }
    assert_eq!(
        problem(&["mode.levels_down_after=2"]),
        "mode.levels_down_after = 2 and fetch.cells = 1 exclude each other: with one cell a descent after the first crossing goes one level down, so set fetch.cells = 4 or leave the key out"
    );
    for kind in ["watertight", "fixed"] {
        let kind = format!("datapath.kind={kind}");
        for set in ["mode.level_up=tevs", "mode.trim=always", "mode.lod=true", "mode.start_level=false"] {
            with(&["fetch.cells=4", &kind, set]).validate().unwrap();
        }
    }
    for (value, shown) in [("2", "2"), ("0", "0"), ("16", "16"), ("four", "\"four\"")] {
        let said = Config::default().apply_set(&format!("fetch.cells={value}")).unwrap_err().to_string();
        assert_eq!(said, format!("fetch.cells = {shown} is neither of what is legal: 1 and 4 (--set)"));
    }
}

/// The same rays, the same hits, fewer iterations; and the sentence of what is refused comes from every command.
#[test]
fn the_way_is_named() {
    assert_eq!(with(&["fetch.cells=4"]).design().way(), "four cells, start level, 3 then 2 down, up selective");
    let sets = ["fetch.cells=4", "mode.trim=always", "mode.start_level=false", "mode.level_up=tevs"];
    assert_eq!(with(&sets).design().way(), "four cells, from root, 3 then 2 down, up tevs + trim always");
    let steps = |more: &[&str]| {
        let small = ["traverse.levels=5", "view.stride=32"];
        let sets: Vec<String> = small.iter().chain(more).map(|set| format!("--set={set}")).collect();
        let args: Vec<&str> = ["steps"].into_iter().chain(sets.iter().map(String::as_str)).collect();
        let (code, told) = said(std::path::Path::new("."), &args);
        assert_eq!(code, Some(0), "{told}");
        told
    };
    let told = steps(&["fetch.cells=4"]);
    assert!(told.contains("four cells, start level, 3 then 2 down, up selective"), "{told}");
    assert!(!told.contains("PDM baseline"), "{told}");
}
