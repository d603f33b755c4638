//! The configuration: defaults, TOML, `--set`, and the sentences of its errors.
use proptest::prelude::*;
use reliefrtl::config::{Config, DatapathKind, LevelUp, MapKind, MapRange, Profile, View, keys};
use reliefrtl::error::Error;

fn sentence<T: std::fmt::Debug>(result: Result<T, Error>) -> String {
    let error = result.expect_err("it must be refused");
    assert_eq!(error.exit_code(), 2);
    error.to_string()
}

fn parse(text: &str) -> String {
    sentence(Config::from_toml(text, "config.toml"))
}

fn set(assignment: &str) -> String {
    let mut config = Config::default();
    let text = sentence(config.apply_set(assignment));
    assert_eq!(config, Config::default(), "a refused --set changes nothing");
    text
}

fn with(assignments: &[&str]) -> Config {
    let mut config = Config::default();
    for assignment in assignments {
        config.apply_set(assignment).unwrap();
    }
    config
}

#[test]
fn the_default_is_valid_and_the_published_design() {
    let config = Config::default();
    config.validate().unwrap();
    assert_eq!(config.design(), reliefrtl::config::Design::default());
    assert_eq!(Config::from_toml("", "empty.toml").unwrap(), config);
}

/// What `config --print` wrote when the defaults had the published pipeline: every key stands there, and means what it meant.
#[test]
fn the_printed_default_of_before_is_read_as_it_stands() {
    let text = include_str!("../data/default-8b845fe.toml");
    let config = Config::from_toml(text, "default-8b845fe.toml").unwrap();
    config.validate().unwrap();
    assert_eq!(config.latency, Profile::Published.latency(DatapathKind::Published));
    assert_eq!((config.emit.prefix.as_str(), config.emit.clock_mhz), ("", 84));
    assert_ne!(config.latency, Config::default().latency);
}

#[test]
fn the_commented_file_reads_back() {
    let text = Config::default().to_commented_toml();
    assert_eq!(Config::from_toml(&text, "default.toml").unwrap(), Config::default());
    for key in keys::KEYS {
        let name = key.path.split('.').next_back().unwrap();
        assert!(text.contains(&format!("\n{name} = ")) || text.contains(&format!("\n# {name} = ")), "{}", key.path);
    }
    let other =
        with(&["map.kind=file", "map.file=a \"b\"\\c.png", "map.scale=0.1", "view.names=grazing", "emit.prefix=a_"]);
    assert_eq!(Config::from_toml(&other.to_commented_toml(), "other.toml").unwrap(), other);
}

#[test]
fn the_key_table_is_the_configuration() {
    // Keys without a value, and those that are only written where they are not the default.
    let config = with(&[
        "map.file=map.png",
        "map.range=auto",
        "map.nodata=-9999",
        "map.fill=0",
        "map.channel=Y",
        "map.part=0",
        "map.size=4,8",
        "map.byte_order=big",
        "map.max_texels=5",
        "map.lossy=true",
        "map.crop=true",
        "map.pad=true",
        "datapath.kind=fixed",
        "datapath.search=windows",
        "windows.set=1 4@2",
        "fetch.cells=4",
        "mode.levels_down_after=1",
        "emit.counters=steps",
    ]);
    let json = serde_json::to_value(&config).unwrap();
    let mut fields = Vec::new();
    for (section, entries) in json.as_object().unwrap() {
        fields.extend(entries.as_object().unwrap().keys().map(|name| format!("{section}.{name}")));
    }
    let mut table: Vec<String> = keys::KEYS.iter().map(|key| key.path.to_owned()).collect();
    fields.sort();
    table.sort();
    assert_eq!(fields, table);
    // Every word of the table is one the types know.
    for key in keys::KEYS {
        if let keys::Legal::Word(words) | keys::Legal::Words(words) = key.legal {
            for word in words {
                with(&[&format!("{}={word}", key.path)]);
            }
        }
    }
}

#[test]
fn how_a_map_is_read() {
    let config = with(&["map.range=[-10, 873.5]", "map.size=1201,1201", "map.part=1", "map.nodata=-9999"]);
    assert_eq!(config.map.range, Some(MapRange::Limits([-10.0, 873.5])));
    assert_eq!(
        (config.map.size, config.map.part.as_deref(), config.map.nodata),
        (Some([1201; 2]), Some("1"), Some(-9999.0))
    );
    assert_eq!(Config::from_toml(&config.to_commented_toml(), "c.toml").unwrap(), config);
    assert_eq!(with(&["map.range=-1,1"]).map.range, Some(MapRange::Limits([-1.0, 1.0])));
    assert_eq!(with(&["map.range=auto", "map.range=none"]).map.range, None);
    let legal = "[low, high] with low below high, or \"auto\" is legal";
    for value in ["[1, 1]", "[2, 1]", "[0]", "[0, nan]", "[0, 1, 2]", "[-1e308, 1e308]", "\"full\"", "5"] {
        let told = parse(&format!("[map]\nrange = {value}"));
        assert!(told.starts_with("map.range = ") && told.contains(legal), "{told}");
    }
    for (line, what) in [
        ("size = [0, 4]", "is no size"),
        ("size = [4]", "is no size"),
        ("nodata = nan", "is not a number, or inf for both infinities"),
        ("fill = \"0\"", "is not a finite number"),
        ("channel = \"\"", "is not a text in quotes"),
        ("part = 1", "is not a text in quotes"),
        ("byte_order = \"middle\"", "is not one of little, big"),
        ("max_texels = 0", "is too small"),
    ] {
        let told = parse(&format!("[map]\n{line}"));
        assert!(told.contains(what), "{line}: {told}");
    }
    let told = sentence(with(&["map.range=0,1", "map.fill=2"]).validate());
    assert_eq!(told, "map.fill = 2 lies outside map.range = [0, 1]: a height in it is needed");
}

#[test]
fn unknown_keys_name_the_nearest() {
    assert_eq!(
        parse("[traverse]\nlevel = 8"),
        "unknown key traverse.level (config.toml, line 2): did you mean traverse.levels?"
    );
    assert_eq!(parse("\n\nlevels = 8"), "unknown key levels (config.toml, line 3): did you mean traverse.levels?");
    assert_eq!(parse("[formt]\nexp = 7"), "unknown section [formt] (config.toml, line 1): did you mean [format]?");
    assert_eq!(
        parse("format = 3"),
        "format = 3 is not a section: write [format] and its keys below (config.toml, line 1)"
    );
    assert_eq!(set("mode.levelup=tevs"), "unknown key mode.levelup (--set): did you mean mode.level_up?");
    assert_eq!(set("mode.dwn=2"), "unknown key mode.dwn (--set): did you mean mode.levels_down?");
    assert_eq!(set("mode.up=tevs"), "unknown key mode.up (--set): did you mean mode.level_up?");
    assert_eq!(set("map.scales=1"), "unknown key map.scales (--set): did you mean map.scale?");
    assert_eq!(set("traverse"), "--set traverse has no value: write --set key=value");
    assert_eq!(set("=3"), "--set =3 names no key: write --set key=value");
}

#[test]
fn out_of_range_names_key_value_and_range() {
    assert_eq!(parse("[format]\nexp = 1"), "format.exp = 1 is too small: 2 to 8 are legal (config.toml, line 2)");
    assert_eq!(set("traverse.levels=13"), "traverse.levels = 13 is too large: 2 to 12 are legal (--set)");
    assert_eq!(set("traverse.levels=-1"), "traverse.levels = -1 is too small: 2 to 12 are legal (--set)");
    assert_eq!(
        set("traverse.levels=eight"),
        "traverse.levels = \"eight\" is not a whole number: 2 to 12 are legal (--set)"
    );
    assert_eq!(set("traverse.levels=8.0"), "traverse.levels = 8.0 is not a whole number: 2 to 12 are legal (--set)");
    assert_eq!(set("map.scale=nan"), "map.scale = NaN is not a number: 0 to 1000 are legal (--set)");
    assert_eq!(set("map.scale=inf"), "map.scale = inf is too large: 0 to 1000 are legal (--set)");
    assert_eq!(set("mode.start_level=1"), "mode.start_level = 1 is neither true nor false (--set)");
    assert_eq!(
        set("mode.level_up=coherant"),
        "mode.level_up = \"coherant\" is not one of none, tevs, selective, coherent, always; did you mean \"coherent\"? (--set)"
    );
    assert_eq!(
        set("format.rounding=upward"),
        "format.rounding = \"upward\" is not one of nearest-even, nearest-away, toward-zero, up, down (--set)"
    );
    assert_eq!(set("view.names=front,front"), "view.names names \"front\" twice: once is enough (--set)");
    assert_eq!(set("view.names=[]"), "view.names is empty: at least one of front, oblique, grazing is needed (--set)");
    assert_eq!(
        set("emit.prefix=1a"),
        "emit.prefix = \"1a\" can't stand before a module's name: empty, or letters, digits and _ with no digit first, at most 32 (--set)"
    );
    assert_eq!(parse("[map]\nfile = 3"), "map.file = 3 is not a path in quotes (config.toml, line 2)");
}

#[test]
fn all_problems_come_at_once() {
    assert_eq!(
        parse("[format]\nexp = 9\n[map]\nsede = 3\nscale = -1.5\n"),
        "3 problems:\n  - format.exp = 9 is too large: 2 to 8 are legal (config.toml, line 2)\n  - map.scale = -1.5 is too small: 0 to 1000 are legal (config.toml, line 5)\n  - unknown key map.sede (config.toml, line 4): did you mean map.seed?"
    );
    let mut config = Config::default();
    config.latency.div = 33;
    config.latency.decision = 0;
    config.view.names.clear();
    assert_eq!(
        sentence(config.validate()),
        "3 problems:\n  - latency.div = 33 is too large: 0 to 32 are legal\n  - latency.decision = 0 is too small: 1 to 5 are legal\n  - view.names is empty: at least one of front, oblique, grazing is needed"
    );
}

#[test]
fn trim_and_level_of_detail_need_planes() {
    for set in ["mode.trim=always", "mode.trim=descent", "mode.lod=true"] {
        with(&["datapath.kind=fixed", set]).validate().unwrap();
        with(&[set]).validate().unwrap();
        let text = sentence(with(&["datapath.kind=published", set]).validate());
        let key = set.split('=').next().unwrap();
        assert_eq!(text, format!("{key} is set, but datapath.kind = \"published\" does not have it"));
    }
}

#[test]
fn the_refinement_is_refused_where_it_is_not() {
    with(&["mode.bilinear=true"]).validate().unwrap();
    with(&["mode.bilinear=true", "mode.trim=always"]).validate().unwrap();
    let refused = |more: &[&str]| sentence(with(&[&["mode.bilinear=true"], more].concat()).validate());
    for kind in ["published", "fixed"] {
        assert_eq!(
            refused(&[&format!("datapath.kind={kind}")]),
            format!(
                "mode.bilinear = true and datapath.kind = \"{kind}\" exclude each other: the refinement needs datapath.kind = \"watertight\""
            )
        );
    }
    assert_eq!(
        refused(&["mode.lod=true"]),
        "mode.bilinear = true and mode.lod = true exclude each other: a hit in a node of a coarser level has no texels to interpolate, so one of them must be false"
    );
    assert_eq!(
        refused(&["format.exp=8", "format.man=23", "traverse.frac_bits=15", "traverse.tile_bits=4"]),
        "traverse.frac_bits = 15 is too large for mode.bilinear with traverse.height_bits = 8 and format.man = 23: height_bits + 2 * frac_bits + man = 61 may be at most 60"
    );
    with(&["mode.bilinear=true", "format.exp=8", "format.man=22", "traverse.frac_bits=15"]).validate().unwrap();
}

#[test]
fn what_holds_between_keys() {
    let refused = |assignments: &[&str]| sentence(with(assignments).validate());
    assert_eq!(
        refused(&["format.man=6", "traverse.height_bits=7"]),
        "format.man = 6 is too small for the traverse unit: 7 to 23 are legal"
    );
    assert_eq!(
        refused(&["traverse.height_bits=16", "format.man=14"]),
        "traverse.height_bits = 16 is too large for format.man = 14: at most format.man + 1 = 15 is legal, so that a height code is exact"
    );
    with(&["traverse.height_bits=16", "format.man=15"]).validate().unwrap();
    assert_eq!(
        refused(&["format.exp=4", "format.man=10", "traverse.height_bits=4"]),
        "format.exp = 4 is too small for traverse.levels = 8 and traverse.tile_bits = 4: levels + tile_bits + 1 = 13 may be at most 2^(exp-1) - 1 = 7"
    );
    with(&["format.exp=5"]).validate().unwrap();
    with(&["traverse.levels=12", "traverse.tile_bits=8"]).validate().unwrap();
    assert_eq!(refused(&["map.kind=file"]), "map.kind = \"file\" needs an image: set map.file");
    assert_eq!(
        refused(&["map.file=a.png"]),
        "map.file is set but map.kind = \"rocks\" does not read it: set map.kind = \"file\" or remove map.file"
    );
    with(&["map.file=a.png", "map.file=none"]).validate().unwrap();
    let mut config = Config::default();
    config.map.seed = u64::MAX;
    assert_eq!(sentence(config.validate()), "map.seed = 18446744073709551615 is too large: 0 to 2^63 - 1 are legal");
}

#[test]
fn set_takes_toml_and_bare_words() {
    let config = with(&[
        "mode.level_up=tevs",
        "map.kind=\"dunes\"",
        "map.scale=10",
        "view.names=grazing, front",
        "traverse.levels = 0x9",
        "map.file=1.png",
    ]);
    assert_eq!(config.mode.level_up, LevelUp::Tevs);
    assert_eq!(config.map.kind, MapKind::Dunes);
    assert_eq!(config.map.scale, 10.0);
    assert_eq!(config.view.names, [View::Grazing, View::Front]);
    assert_eq!(config.traverse.levels, 9);
    assert_eq!(with(&["view.names=[\"oblique\"]"]).view.names, [View::Oblique]);
    assert_eq!(with(&["emit.prefix=true"]).emit.prefix, "true");
}

#[test]
fn broken_files() {
    assert_eq!(parse("[format\nexp = 7"), "not TOML (config.toml, line 1): unclosed table, expected `]`");
    let repeated = parse("[format]\nexp = 7\nexp = 7\n");
    assert!(repeated.starts_with("not TOML (config.toml, line 3): duplicate key"), "{repeated}");
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("config.toml");
    let missing = sentence(Config::load(&path));
    assert!(missing.starts_with("cannot read ") && missing.contains("config.toml: No such file"), "{missing}");
    std::fs::write(&path, b"[map]\nkind = \"\xff\"\n").unwrap();
    assert!(
        sentence(Config::load(&path))
            .ends_with("config.toml is not UTF-8 text: the byte at offset 14 is no part of it")
    );
    std::fs::write(&path, "[map]\nkind = \"file\"\nfile = \"a.png\"\n").unwrap();
    assert_eq!(Config::load(&path).unwrap().map.file, Some(directory.path().join("a.png")));
}

#[test]
fn the_hash_names_the_configuration_and_not_the_directory() {
    let one = Config::default();
    assert_eq!(one.hash(), Config::default().hash());
    assert_eq!(one.hash().len(), 12);
    assert_ne!(one.hash(), with(&["format.man=15"]).hash());
    assert_eq!(with(&["map.file=/a/x.png"]).hash(), with(&["map.file=/b/x.png"]).hash());
}

#[test]
fn the_schema_has_the_ranges() {
    let schema = Config::schema();
    assert_eq!(schema["$defs"]["FormatConfig"]["properties"]["exp"]["maximum"], 8);
    assert_eq!(schema["$defs"]["TraverseConfig"]["properties"]["levels"]["minimum"], 2);
    assert_eq!(schema["$defs"]["EmitConfig"]["properties"]["prefix"]["pattern"], "^([A-Za-z_][A-Za-z0-9_]{0,31})?$");
    for key in keys::KEYS {
        let (section, name) = key.path.split_once('.').unwrap();
        let reference = schema["properties"][section]["$ref"].as_str().unwrap();
        assert!(schema.pointer(&format!("{}/properties/{name}", &reference[1..])).is_some(), "{}", key.path);
    }
}

proptest! {
    /// Whatever is typed, it is refused in words or accepted; and what is accepted reads back.
    #[test]
    fn no_text_panics(text in "(\\[(format|map|view|x)\\]\n)?((exp|seed|names|kind|y) ?= ?[a-z0-9\"\\[\\].-]{0,6}\n){0,3}") {
        if let Ok(config) = Config::from_toml(&text, "f") {
            prop_assert_eq!(Config::from_toml(&config.to_commented_toml(), "g").unwrap(), config);
        }
    }

    #[test]
    fn no_assignment_panics(text in "([a-z]{1,8}\\.)?[a-z_]{0,8}=?.{0,12}") {
        let mut config = Config::default();
        let _ = config.apply_set(&text);
        let _ = config.validate();
    }
}
