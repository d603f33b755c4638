//! `datapath.search = "windows"`: what is refused, by name, and what is said of it.
use super::said;
use reliefrtl::config::{Config, DatapathKind, WindowSet, WindowWidths};

const WINDOWS: [&str; 2] = ["datapath.kind=fixed", "datapath.search=windows"];

fn with(sets: &[&str]) -> Config {
    let mut c = Config::default();
    sets.iter().for_each(|set| c.apply_set(set).unwrap());
    c
}

fn windows(sets: &[&str]) -> Config {
    with(&[&WINDOWS, sets].concat())
}

fn problem(c: &Config) -> String {
    let error = c.validate().expect_err("it must be refused");
    assert_eq!(error.exit_code(), 2);
    error.to_string()
}

#[test]
fn the_search_is_chosen_beside_the_arithmetic_in_either_order() {
    for sets in [WINDOWS, [WINDOWS[1], WINDOWS[0]]] {
        let c = with(&sets);
        c.validate().unwrap();
        assert_eq!(c.datapath.kind, DatapathKind::Windows);
        assert_eq!(c.design().label(), "windows Q.24, 1 4@2 12@4 40@8");
        assert_eq!(c.design().way(), "windows 1 4@2 12@4 40@8");
    }
    assert_eq!(windows(&["datapath.search=pyramid"]).datapath.kind, DatapathKind::Fixed);
    assert_eq!(windows(&["traverse.levels=2"]).design().way(), "windows 1 2@2");
    for kind in ["watertight", "published"] {
        let said = problem(&windows(&[&format!("datapath.kind={kind}")]));
        assert!(said.contains("datapath.search = \"windows\"") && said.contains(kind), "{said}");
        assert!(said.contains("datapath.kind = \"fixed\""), "{said}");
    }
    let said = problem(&with(&["datapath.kind=fixed", "windows.set=1 4@2"]));
    assert!(said.starts_with("windows.set = \"1 4@2\"") && said.contains("datapath.search = \"windows\""), "{said}");
}

/// Also where the value is the default, as a key that is given is meant.
#[test]
fn modes_of_the_pyramid_are_refused_by_name_where_they_are_given() {
    windows(&[]).validate().unwrap();
    for set in [
        "mode.start_level=true",
        "mode.start_level=false",
        "mode.levels_down=2",
        "mode.levels_down=3",
        "mode.level_up=selective",
        "mode.trim=none",
        "mode.trim=always",
        "mode.lod=false",
        "mode.lod=true",
    ] {
        let said = problem(&windows(&[set]));
        let key = set.split_once('=').unwrap().0;
        assert!(said.starts_with(&format!("{key} = ")) && said.contains("datapath.search = \"windows\""), "{said}");
        assert!(!said.contains('\n'), "{set}: one sentence, {said}");
        let text = format!("[datapath]\nkind = \"fixed\"\nsearch = \"windows\"\n[mode]\n{}\n", {
            let (name, value) = set.strip_prefix("mode.").unwrap().split_once('=').unwrap();
            if value.parse::<u32>().is_ok() || ["true", "false"].contains(&value) {
                format!("{name} = {value}")
            } else {
                format!("{name} = {value:?}")
            }
        });
        assert!(problem(&Config::from_toml(&text, "c.toml").unwrap()).starts_with(key), "{text}");
    }
    // Set by code alone.
    let mut c = windows(&[]);
    c.mode.levels_down = 4;
    assert!(problem(&c).starts_with("mode.levels_down = 4"));
    let said = problem(&windows(&["mode.bilinear=true"]));
    assert!(said.contains("mode.bilinear = true and datapath.search = \"windows\""), "{said}");
}

#[test]
fn illegal_sets_are_refused_with_what_would_be_right() {
    for (set, part) in [
        ("", "has 0 windows: 2 to 5"),
        ("1", "has 1 window: 2 to 5"),
        ("1 2 3 4 5 6", "has 6 windows: 2 to 5"),
        ("4@2 12@4", "begins with 4@2: the first window is the texel itself, 1"),
        ("1 6@3", "has 6@3, whose grid is not a power of two"),
        ("1 5@2", "has 5@2, whose side is not a multiple of its grid: 6@2"),
        ("1 64@32", "has 64@32, whose grid is too coarse"),
        ("1 4@2 4@2", "has 4@2 after 4@2: S - g must rise"),
        ("1 12@4 4@2", "has 4@2 after 12@4: S - g must rise"),
        ("1 4@4", "has 4@4 after 1: S - g must rise"),
        ("1 16@8 40@4", "has 40@4 after 16@8: the grid must not become finer"),
        ("1 65", "has 65, which is too large: S - g = 64 may be at most 63"),
        ("1 80@16", "has 80@16, which is too large: S - g = 64 may be at most 63"),
        ("1 four", "has \"four\", which is no window"),
        ("1 4@", "has \"4@\", which is no window"),
        ("1 +4", "has \"+4\", which is no window"),
        ("1 0", "has \"0\", which is no window"),
        ("1 99999999999", "has \"99999999999\", which is no window"),
    ] {
        let mut c = windows(&[]);
        let said = match set {
            "" => Config::from_toml("[windows]\nset = \"\"\n", "c.toml").unwrap_err().to_string(),
            _ => c.apply_set(&format!("windows.set={set}")).unwrap_err().to_string(),
        };
        assert!(said.starts_with(&format!("windows.set = {set:?} {part}")), "{set:?}: {said}");
    }
    for set in ["1 4@2 12@4 40@8", "1 4@2 8@4 16@8 32@16", "1 2 5 17", "1 2@2", "1 79@1", "1 79@16"] {
        let legal = set.parse::<WindowSet>();
        assert_eq!(legal.is_ok(), !set.contains("79"), "{set}: {legal:?}");
    }
    let said = problem(&windows(&["traverse.levels=3", "windows.set=1 32@16"]));
    assert!(said.contains("windows.set = \"1 32@16\" has 32@16") && said.contains("g may be at most 8"), "{said}");
    assert_eq!(windows(&["windows.set=1@1   4@2 16@4"]).design().window_set().to_string(), "1 4@2 16@4");
    assert_eq!(windows(&["windows.set=1 4", "windows.set=none"]).windows.set, None);
}

#[test]
fn the_printed_configuration_reads_back() {
    for sets in [&[][..], &["windows.set=1 4@2 16@4"], &["traverse.levels=2"]] {
        let c = windows(sets);
        let text = c.to_commented_toml();
        let read = Config::from_toml(&text, "printed.toml").unwrap();
        assert_eq!(read, c);
        read.validate().unwrap();
        for line in ["search = \"windows\"", "# start_level = true", "# trim = \"none\"", "# lod = false"] {
            assert!(text.contains(&format!("\n{line}\n")), "{line}\n{text}");
        }
    }
    // What is the default is not written, so that a configuration of before keeps its hash.
    let json = serde_json::to_string(&Config::default()).unwrap();
    assert!(!json.contains("search") && !json.contains("windows"), "{json}");
    assert_ne!(windows(&[]).hash(), with(&["datapath.kind=fixed"]).hash());
}

#[test]
fn widths_follow_from_the_design() {
    let w = WindowWidths::of(&windows(&[]).design());
    assert_eq!((w.estimate_fraction, w.travel, w.time, w.guard, w.plane, w.planes), (6, 18, 18, 10, 36, 13));
    let w = WindowWidths::of(
        &windows(&["datapath.fraction_bits=12", "datapath.reciprocal_bits=32", "traverse.levels=12"]).design(),
    );
    assert_eq!((w.estimate_fraction, w.travel, w.time, w.guard, w.plane), (0, 16, 14, 34, 48));
    let w = WindowWidths::of(
        &windows(&[
            "datapath.fraction_bits=28",
            "datapath.reciprocal_bits=8",
            "traverse.levels=3",
            "traverse.tile_bits=1",
        ])
        .design(),
    );
    assert_eq!((w.estimate_fraction, w.travel, w.guard, w.plane), (14, 18, 0, 30));
}

/// One row a view, and nothing of the published table beside it.
#[test]
fn steps_counts_one_way() {
    let dir = tempfile::tempdir().unwrap();
    let args = ["steps", "--json", "--set", WINDOWS[0], "--set", WINDOWS[1], "--set", "view.stride=8"];
    let (code, text) = said(dir.path(), &args);
    assert_eq!(code, Some(0), "{text}");
    let cells: serde_json::Value = serde_json::from_str(&text).unwrap();
    let cells = cells.as_array().unwrap();
    assert_eq!(cells.len(), 3, "{text}");
    let mean =
        |cells: &[serde_json::Value]| -> f64 { cells.iter().map(|c| c["iterations_per_ray"].as_f64().unwrap()).sum() };
    assert!(cells.iter().all(|c| c["row"] == "windows 1 4@2 12@4 40@8" && c["published"].is_null()), "{text}");
    let (_, pyramid) = said(dir.path(), &["steps", "--json", "--set", WINDOWS[0], "--set", "view.stride=8"]);
    let pyramid: serde_json::Value = serde_json::from_str(&pyramid).unwrap();
    let best: Vec<_> = pyramid.as_array().unwrap().iter().filter(|c| c["row"] == "a + b + c1").cloned().collect();
    let part = mean(cells) / mean(&best);
    println!("windows take {part:.3} of the iterations of the published best");
    assert!(part < 0.7, "{part}");
}

/// Every set, and the pyramid, end in the same texels.
#[test]
fn hard_compares_the_sets_and_the_pyramid() {
    let dir = tempfile::tempdir().unwrap();
    let (code, text) = said(
        dir.path(),
        &[
            "hard",
            "--json",
            "--rays",
            "50",
            "--case",
            "corners,longest,size-2,size-4,step-limit",
            "--set",
            WINDOWS[0],
            "--set",
            WINDOWS[1],
        ],
    );
    assert_eq!(code, Some(0), "{text}");
    let sum: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(
        (&sum["given_up"], &sum["modes_differ"], &sum["limit_wrong"]),
        (&0.into(), &0.into(), &0.into()),
        "{text}"
    );
    assert!(sum["cases"][0]["modes"].as_u64().unwrap() >= 6, "{text}");
}
