//! The report on a tiny selection: page, JSON and CSV hold the same numbers, and a resumed run writes the same bytes.
use reliefrtl::config::{Config, DatapathKind, LevelUp, MapKind, Trim, View};
use reliefrtl::fit::{Trial, Truth};
use reliefrtl::format::FloatFormat;
use reliefrtl::golden::encode_ray;
use reliefrtl::measure::{Spread, accuracy, uv_given};
use reliefrtl::project::Scene;
use reliefrtl::report::{Extent, ModeSet, Output, Plan, Selection, Work, files, measurements, write};
use reliefrtl::scene::{RaySet, RaySource, RayTable};
use reliefrtl::trace::trace_golden;
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

fn tiny() -> Selection {
    Selection { extent: Extent::Tiny, ..Selection::default() }
}

/// A directory with small maps of the names in the published tables.
fn scenes() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    for (k, name) in ["rocks", "stones", "four", "saints"].into_iter().enumerate() {
        let texel = |x: u32, y: u32| image::Luma([((x * 7 + y * 13 + k as u32 * 29) * (x ^ y) % 251) as u8]);
        image::GrayImage::from_fn(32, 32, texel).save(dir.path().join(format!("{name}.png"))).unwrap();
    }
    dir
}

/// What `synth` would have written about the watertight design on maps of 32 texels.
fn synth(dir: &Path, c: &Config) -> PathBuf {
    let file = dir.join("synth.json");
    let design =
        serde_json::json!({"exp": 7, "man": 16, "traverse": c.traverse, "mode": c.mode, "datapath": c.datapath});
    let unit = serde_json::json!([{"unit": "traverse", "target": "ecp5", "luts": 12345, "multipliers": 17, "clock": {"median": 84.5}, "design": design}, {"unit": "hf_add", "target": "ecp5", "luts": 437, "multipliers": 0, "clock": null}]);
    std::fs::write(&file, unit.to_string()).unwrap();
    file
}

fn run(plan: &Plan, dir: &Path) -> (Output, Work) {
    let (measurements, work) = measurements(plan, dir, &|_, _| {}).unwrap();
    let files = files(plan, &measurements, "reliefrtl report").unwrap();
    write(dir, &files).unwrap();
    (files, work)
}

fn text<'a>(files: &'a Output, name: &str) -> &'a str {
    let (_, bytes) = files.iter().find(|f| f.0 == name).unwrap_or_else(|| panic!("no {name}"));
    std::str::from_utf8(bytes).unwrap()
}

/// The text of a JSON value as the CSV has it.
fn plain(v: &Value) -> String {
    match v {
        Value::Null => String::new(),
        Value::String(s) => s.clone(),
        other => other.to_string(),
    }
}

/// Numbers of the HTML table with this id, in order, all digits.
fn page_numbers(html: &str, id: &str) -> Vec<String> {
    let table = html.split(&format!("<table id=\"{id}\">")).nth(1).unwrap_or_else(|| panic!("no table {id}"));
    let table = table.split("</table>").next().unwrap();
    table.split("data-v=\"").skip(1).map(|s| s.split('"').next().unwrap().to_owned()).collect()
}

#[test]
fn page_json_and_csv_hold_the_same_numbers_and_a_resumed_run_the_same_bytes() {
    let (maps, dir) = (scenes(), tempfile::tempdir().unwrap());
    let mut c = Config::default();
    c.traverse.levels = 5;
    let synth = vec![synth(maps.path(), &c)];
    let traversals = reliefrtl::catalogue::ray_units();
    let chosen = Selection { scenes: Some(maps.path().to_owned()), synth, traversals, ..tiny() };
    let plan = Plan::new(&c, &chosen).unwrap();
    let (first, work) = run(&plan, dir.path());
    assert_eq!((work.measured, work.taken), (plan.jobs.len(), 0));
    let json: Value = serde_json::from_str(text(&first, "report.json")).unwrap();
    for name in ["cells", "pareto", "steps", "published"] {
        let mut csv = csv::Reader::from_reader(text(&first, &format!("{name}.csv")).as_bytes());
        let keys: Vec<String> = csv.headers().unwrap().iter().map(str::to_owned).collect();
        let rows: Vec<csv::StringRecord> = csv.records().map(Result::unwrap).collect();
        let objects = json[name].as_array().unwrap();
        assert_eq!(rows.len(), objects.len(), "{name}");
        assert!(!rows.is_empty(), "{name} is empty");
        for (row, object) in rows.iter().zip(objects) {
            keys.iter().zip(row).for_each(|(k, v)| assert_eq!(plain(&object[k]), v, "{name}.{k}"));
        }
    }
    let html = text(&first, "report.html");
    let mut numbers = 0;
    for id in [
        "worst",
        "pareto",
        "series",
        "steps",
        "histogram",
        "matrix",
        "maps",
        "units",
        "bilinear",
        "published",
        "claims",
    ] {
        // The page leaves no column with a number out, so that all of a table's numbers stand there in the order of the JSON.
        let values = json[id].as_array().unwrap().iter().flat_map(|row| row.as_object().unwrap().values());
        let expected: Vec<String> = values.filter(|v| v.is_number()).map(plain).collect();
        assert!(!expected.is_empty(), "{id} has no number");
        assert_eq!(page_numbers(html, id), expected, "{id}");
        numbers += expected.len();
    }
    assert!(numbers > 200, "{numbers} numbers compared");
    for word in ["http://", "https://", "src=\"/"] {
        assert!(!html.contains(word), "the page needs nothing from outside: {word}");
    }

    // Stopped in the middle: some cells are there, one is half a file, one is of another model.
    let stored =
        || -> BTreeSet<_> { std::fs::read_dir(dir.path().join("cells")).unwrap().map(|f| f.unwrap().path()).collect() };
    let names = stored();
    let bytes: Vec<Vec<u8>> = names.iter().map(|p| std::fs::read(p).unwrap()).collect();
    let mut paths = names.iter();
    std::fs::remove_file(paths.next().unwrap()).unwrap();
    std::fs::write(paths.next().unwrap(), b"{\"spec\":").unwrap();
    let other = paths.next().unwrap();
    let probe = std::fs::read_to_string(other).unwrap().replace("\"probe\":\"", "\"probe\":\"0");
    std::fs::write(other, probe).unwrap();
    // One number of a measurement, and what measured it.
    for (key, other) in [("\"rays\":", "\"rays\":1"), ("\"program\":\"", "\"program\":\"0")] {
        let path = paths.next().unwrap();
        let text = std::fs::read_to_string(path).unwrap();
        assert!(text.contains(key), "{text}");
        std::fs::write(path, text.replacen(key, other, 1)).unwrap();
    }
    let (again, work) = run(&plan, dir.path());
    assert_eq!((work.measured, work.taken), (5, plan.jobs.len() - 5));
    let altered: Vec<String> =
        names.iter().skip(1).take(4).map(|p| format!("cells/{}", p.file_name().unwrap().to_string_lossy())).collect();
    assert_eq!(work.altered.iter().collect::<BTreeSet<_>>(), altered.iter().collect::<BTreeSet<_>>());
    assert!(first == again, "a resumed run writes other bytes");
    assert_eq!(stored(), names);
    assert_eq!(names.iter().map(|p| std::fs::read(p).unwrap()).collect::<Vec<_>>(), bytes);
}

#[test]
fn what_has_no_datapath_is_listed_with_its_reason() {
    let mut c = Config::default();
    // Sixteen-bit heights are exact in no format of ten fraction bits.
    c.traverse.height_bits = 16;
    let plan = Plan::new(&c, &tiny()).unwrap();
    let refused = plan.not_legal.iter().find(|r| r.design.starts_with("watertight 7/7")).expect("7/7 is refused");
    assert!(refused.reason.contains("height_bits"), "{}", refused.reason);
    let listed: BTreeSet<usize> = plan.jobs.iter().map(|job| job.design).collect();
    assert_eq!(listed.len() + plan.not_legal.len(), plan.designs.len(), "every design is measured or refused");
}

/// Maps, views and designs of a plan.
fn planned(c: &Config, s: &Selection) -> (Vec<(String, u32)>, BTreeSet<String>, Vec<String>) {
    let plan = Plan::new(c, s).unwrap();
    let rays = plan.jobs.iter().map(|j| &plan.rays[j.view]);
    let views = rays.filter(|r| r.elevation.is_none()).map(|r| r.set.name.clone()).collect();
    let designs = plan.designs.iter().map(|d| d.label()).collect();
    (plan.maps.iter().map(|s| (s.spec.name.clone(), s.spec.levels)).collect(), views, designs)
}

#[test]
fn what_is_chosen_is_what_is_measured() {
    let (maps, c) = (scenes(), Config::default());
    let mut chosen = Selection {
        maps: vec![MapKind::Stairs, MapKind::Pit],
        levels: vec![5, 6],
        views: vec![RaySet::view(View::Grazing)],
        datapaths: vec![DatapathKind::Fixed],
        fractions: vec![15, 20],
        modes: Some(ModeSet::One),
        ..Selection::default()
    };
    let (planned_maps, views, designs) = planned(&c, &chosen);
    let all = [("stairs", 5), ("pit", 5), ("stairs", 6), ("pit", 6)].map(|(name, n)| (name.to_owned(), n));
    assert_eq!(planned_maps, all);
    assert_eq!(views, BTreeSet::from(["grazing".to_owned()]));
    // The configured design, watertight here, is always among them.
    assert_eq!(designs, ["fixed Q.15", "fixed Q.20", "watertight 7/16"]);
    // A map of the user's stands in the place of own ones, at the size that it has.
    (chosen.maps, chosen.levels, chosen.map) = (Vec::new(), vec![5], Some(maps.path().join("four.png")));
    let (planned_maps, ..) = planned(&c, &chosen);
    assert_eq!(planned_maps, [("four".to_owned(), 5)]);
    chosen.levels = Vec::new();
    let refused = Plan::new(&c, &chosen).err().unwrap().to_string();
    assert!(refused.contains("32") && refused.contains("256"), "{refused}");
}

#[test]
fn the_configured_design_leads_the_page_unless_it_is_a_usual_one() {
    let mut c = Config::default();
    let names = |c: &Config| -> Vec<(String, String)> {
        // Which designs lead depends on no scene.
        let (maps, views) = (vec![MapKind::Spikes], vec![RaySet::view(View::Front)]);
        let small = Selection { levels: vec![5], maps, views, ..Selection::default() };
        let plan = Plan::new(c, &small).unwrap();
        plan.headlines.iter().map(|h| (h.name.clone(), h.design.label())).collect()
    };
    let usual = names(&c);
    assert!(usual.iter().all(|n| n.0 != "configured"));
    // The search by windows stands beside the modes of its datapath; where one mode is asked for, it does not.
    assert!(usual.contains(&("windows".to_owned(), "windows Q.24".to_owned())), "{usual:?}");
    let windows = |modes| {
        let designs = Selection { modes, ..Selection::default() }.designs(&c);
        designs.iter().filter(|d| d.label().starts_with("windows")).count()
    };
    assert_eq!([None, Some(ModeSet::One), Some(ModeSet::All)].map(windows), [1, 0, 6]);
    (c.datapath.kind, c.datapath.fraction_bits, c.datapath.reciprocal_bits) = (DatapathKind::Fixed, 15, 13);
    assert_eq!(names(&c)[0], ("configured".to_owned(), "fixed Q.15, reciprocal 13".to_owned()));
}

#[test]
fn a_file_that_synth_did_not_write_is_refused() {
    let (dir, c) = (tempfile::tempdir().unwrap(), Config::default());
    let file = dir.path().join("synth.json");
    for (text, told) in [("[]", "has no figures of a unit"), ("{}", "is no file of `synth`")] {
        std::fs::write(&file, text).unwrap();
        let refused = Plan::new(&c, &Selection { synth: vec![file.clone()], ..tiny() }).err().unwrap().to_string();
        assert!(refused.contains(told), "{refused}");
    }
}

/// One uv error: `accuracy`, `report` and `fit` say the same of the same rays, to the last digit, against the words and against the rays as
/// given; and it is Euclidean.
#[test]
fn accuracy_report_and_fit_measure_the_same_uv_error() {
    let dir = tempfile::tempdir().unwrap();
    let mut c = Config::default();
    (c.traverse.levels, c.map.kind) = (5, MapKind::Spikes);
    // So few bits that errors are seen.
    (c.datapath.kind, c.datapath.fraction_bits, c.datapath.reciprocal_bits) = (DatapathKind::Fixed, 10, 10);
    let turn = |k: u32, by: f64| (f64::from(k) * by).fract();
    let rays: Vec<[f64; 4]> =
        (0..500).map(|k| [turn(k, 0.618), turn(k, 0.327), turn(k, 0.171) * 2.0 - 1.0, turn(k, 0.9) - 0.5]).collect();
    let table = RayTable { rays: rays.clone(), lods: None };
    let set = RaySet { name: "r".into(), given: "r.csv".into(), source: RaySource::Table(table) };
    let chosen = Selection {
        maps: vec![MapKind::Spikes],
        levels: vec![5],
        views: vec![set],
        datapaths: vec![DatapathKind::Fixed],
        fractions: vec![10],
        modes: Some(ModeSet::One),
        ..Selection::default()
    };
    let plan = Plan::new(&c, &chosen).unwrap();
    let (measured, _) = measurements(&plan, dir.path(), &|_, _| {}).unwrap();
    let cell = measured.iter().find(|cell| cell.spec.design.fraction_bits == Some(10)).unwrap();
    let scene = Scene::new(&c, None, false).unwrap();
    let d = cell.spec.design.design(&c, 5).unwrap();
    let words: Vec<_> = rays.iter().map(|r| encode_ray(&d, *r)).collect();
    let hits = trace_golden(&d, &scene.pyramid, &words).unwrap();
    let own = Spread::of(accuracy(&d, &scene.texels, &words, &hits).unwrap().uv);
    let given = Spread::of(uv_given(&d, &scene.texels, &rays, &hits).unwrap());
    let truth = Truth::new(5, 8, scene.texels.clone(), rays).unwrap();
    let trial = Trial::run(&d, &truth).unwrap();
    assert_eq!(cell.uv_all, own);
    assert_eq!(cell.uv_unrounded, given);
    assert_eq!((trial.uv_p99, trial.uv_max), (given.p99, (given.max, given.max_ray)));
    assert!(given.p99 > own.p99 && own.p99 > 0.0, "{given:?} {own:?}");
}

/// What `fit` needs of positions is its own design's: the others keep theirs, and the page tells the two apart.
#[test]
fn fraction_bits_of_a_configuration_are_its_own_design_s() {
    let mut c = Config::default();
    (c.datapath.kind, c.datapath.fraction_bits, c.datapath.reciprocal_bits) = (DatapathKind::Fixed, 15, 13);
    (c.traverse.frac_bits, c.traverse.step_limit, c.traverse.tile_bits) = (4, 128, 2);
    let plan = Plan::new(&c, &Selection { maps: vec![MapKind::Spikes], ..Selection::default() }).unwrap();
    let (own, others): (Vec<_>, Vec<_>) = plan.designs.iter().partition(|d| d.frac_bits == 4);
    assert_eq!(own.len(), 1);
    assert_eq!(own[0].label(), "fixed Q.15, reciprocal 13, position to 2^-4");
    assert_eq!((own[0].step_limit, own[0].tile_bits), (128, 2));
    let usual = Config::default().traverse;
    assert!(others.len() > 30);
    for d in others {
        assert_eq!((d.frac_bits, d.tile_bits), (usual.frac_bits, usual.tile_bits), "{}", d.label());
        assert!(d.step_limit > 128, "{}", d.label());
    }
    // Rays that travel farther than usual do so in every design.
    c.traverse.tile_bits = 6;
    let plan = Plan::new(&c, &Selection { maps: vec![MapKind::Spikes], ..Selection::default() }).unwrap();
    assert!(plan.designs.iter().all(|d| d.tile_bits == 6));
}

/// Every card says its own mode in words, and a legend every short name that the page uses.
#[test]
fn the_page_explains_its_words() {
    let dir = tempfile::tempdir().unwrap();
    let mut c = Config::default();
    c.traverse.levels = 5;
    (c.mode.start_level, c.mode.levels_down, c.mode.level_up) = (false, 3, LevelUp::Coherent);
    c.mode.trim = Trim::Always;
    let chosen = Selection {
        maps: vec![MapKind::Spikes],
        levels: vec![5],
        views: vec![RaySet::view(View::Front)],
        datapaths: vec![DatapathKind::Watertight],
        formats: vec![FloatFormat::new(7, 16)],
        most: Some(50),
        ..Selection::default()
    };
    let plan = Plan::new(&c, &chosen).unwrap();
    let (files, _) = run(&plan, dir.path());
    let html = text(&files, "report.html");
    let cards = html.split("<div class=\"cards\">").nth(1).unwrap().split("</section>").next().unwrap();
    for words in [
        "starts at the root; three levels down a descent until the first crossing; up a level on the second crossing in a row; always chord trim",
        "starts at the lowest level whose node holds the whole ray; two levels down a descent until the first crossing; up a level when",
    ] {
        assert_eq!(cards.matches(words).count(), 1, "{words}: {cards}");
    }
    let legend = html.split("<section id=\"legend\">").nth(1).unwrap().split("</section>").next().unwrap();
    let json: Value = serde_json::from_str(text(&files, "report.json")).unwrap();
    let modes = json["pareto"].as_array().unwrap().iter().map(|row| row["mode"].as_str().unwrap());
    let explained = |mode: &&str| !["from root", "start level,"].iter().any(|spelled| mode.starts_with(spelled));
    for mode in modes.filter(explained) {
        assert!(legend.contains(&format!("<dt>{mode}</dt>")), "{mode} stands nowhere in the legend");
    }
    for word in ["[10], [12]", "a + b + c1", "Euclidean distance", "uv error", "wrong texel", "given up"] {
        assert!(legend.contains(word), "{word}");
    }
    assert!(html.contains("front: every 8th pixel each way, at most 50"), "which rays were traced");
}
