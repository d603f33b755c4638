//! `--map`, `--view` and `--rays` mean the same to every verb that traces or judges.
use super::{engines, run, said};
use std::path::Path;

/// A map of 32 x 32 texels, a camera of 40 x 30 pixels, and five rays.
fn scene() -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    let texel = |x: u32, y: u32| image::Luma([(x * 37 + y * 101 + x * y * 13) as u8]);
    image::GrayImage::from_fn(32, 32, texel).save(dir.path().join("h.png")).unwrap();
    std::fs::write(dir.path().join("eye.toml"), "elevation = 40.0\nazimuth = 10.0\nwidth = 40\nheight = 30\n").unwrap();
    let rays = "u,v,du,dv\n0.1,0.2,0.3,-0.4\n0.99,0.5,-1.5,0.25\n-0.5,0.5,0,0\n0.3,0.3,1,0\n0.7,0.2,1,0.5\n";
    std::fs::write(dir.path().join("five.csv"), rays).unwrap();
    dir
}

const MAP: [&str; 4] = ["--map", "h.png", "--set", "traverse.levels=5"];

/// The verbs, each with what else it needs to be quick; where the simulators are left out, `bench` says so.
fn verbs() -> Vec<Vec<&'static str>> {
    vec![
        vec!["steps"],
        vec!["accuracy"],
        vec!["hard"],
        vec!["fit", "--max-uv-error", "4"],
        vec!["report", "--out", "page", "--datapaths", "fixed", "--fractions", "12", "--modes", "one"],
        vec!["trace", "--engine", "golden", "--out", "h.csv"],
        vec!["render", "--engine", "golden", "--out", "p.png"],
    ]
}

fn json(dir: &Path, args: &[&str]) -> serde_json::Value {
    let out = run(dir, &[args, &["--json"]].concat());
    let text = String::from_utf8_lossy(&out.stdout).into_owned();
    assert_eq!(out.status.code(), Some(0), "{args:?}: {text} {}", String::from_utf8_lossy(&out.stderr));
    serde_json::from_str(&text).unwrap_or_else(|e| panic!("{args:?}: {e} in {text}"))
}

#[test]
fn every_verb_takes_a_map_a_camera_and_a_table() {
    let dir = scene();
    for verb in verbs() {
        for seen in [
            &["--view", "eye.toml"][..],
            &["--views", "eye.toml"],
            &["--view", "oblique,eye.toml", "--rays", "five.csv"],
        ] {
            // A page takes long: of it, all at once.
            if verb[0] == "report" && seen.len() == 2 {
                continue;
            }
            let all = [
                &verb[..],
                &MAP,
                seen,
                &["--set", "view.stride=2", "--set", "view.width=64", "--set", "view.height=48"],
            ];
            let (code, text) = said(dir.path(), &all.concat());
            assert_eq!(code, Some(0), "{all:?}: {text}");
            // A table of views names them.
            if ["steps", "accuracy", "hard", "fit"].contains(&verb[0]) {
                assert!(text.contains("eye"), "{all:?}: {text}");
                assert_eq!(text.contains("five"), seen.contains(&"--rays"), "{all:?}: {text}");
            }
        }
        // The same sentence from all: a word that is no view, a table without a column, a camera below the plane.
        std::fs::write(dir.path().join("low.toml"), "elevation = -5\n").unwrap();
        std::fs::write(dir.path().join("no.csv"), "u,v,du\n0,0,0\n").unwrap();
        for (seen, told) in [
            (["--view", "side"], "--view side is none of front, oblique, grazing, nor a camera file"),
            (["--view", "low.toml"], "puts the camera below the quad's plane, where no ray of this unit can begin"),
            (["--rays", "no.csv"], "no column dv"),
            (["--rays", "nowhere.csv"], "nowhere.csv"),
        ] {
            let (code, text) = said(dir.path(), &[&verb[..], &MAP, &seen].concat());
            assert_eq!(code, Some(2), "{verb:?} {seen:?}: {text}");
            assert!(text.contains(told), "{verb:?} {seen:?}: {text}");
        }
    }
}

/// The table's rays are what is traced: steps, accuracy, hard, report and trace count the same iterations and texels of the same five.
#[test]
fn the_rays_of_a_table_are_the_rays_that_count() {
    let dir = scene();
    let of = |verb: &[&str]| json(dir.path(), &[verb, &MAP, &["--rays", "five.csv"]].concat());
    let traced = of(&["trace", "--engine", "golden", "--out", "h.csv"]);
    assert_eq!(traced["rays"], 5);
    let table = std::fs::read_to_string(dir.path().join("h.csv")).unwrap();
    let steps: Vec<u32> = table.lines().skip(1).map(|l| l.split(',').nth(6).unwrap().parse().unwrap()).collect();
    assert_eq!(steps.len(), 5);
    let rows = of(&["steps"]);
    let best = rows.as_array().unwrap().iter().find(|r| r["row"] == "a + b + c1").unwrap();
    let mean = f64::from(steps.iter().sum::<u32>()) / 5.0;
    assert!((best["mean"].as_f64().unwrap() - mean).abs() < 1e-12 && best["view"] == "five", "{best} {steps:?}");
    assert_eq!(best["max"].as_u64().unwrap(), u64::from(*steps.iter().max().unwrap()));
    assert_eq!(of(&["accuracy"])["views"].as_array().unwrap().len(), 1);
    let hard = of(&["hard"]);
    assert_eq!((hard["rays"].as_u64(), hard["cases"][0]["case"].as_str()), (Some(5), Some("five")));
    of(&["report", "--out", "page", "--datapaths", "watertight", "--formats", "7/16", "--modes", "one"]);
    let report = std::fs::read_to_string(dir.path().join("page/report.json")).unwrap();
    let report: serde_json::Value = serde_json::from_str(&report).unwrap();
    let cell = &report["cells"][0];
    assert_eq!((cell["view"].as_str(), cell["rays"].as_u64()), (Some("five"), Some(5)), "{cell}");
    assert!((cell["steps_mean"].as_f64().unwrap() - mean).abs() < 1e-12, "{cell}");
    // Another table under the same name is another measurement.
    let other = "u,v,du,dv\n0.1,0.2,0.3,-0.4\n";
    std::fs::write(dir.path().join("five.csv"), other).unwrap();
    of(&["report", "--out", "page", "--datapaths", "watertight", "--formats", "7/16", "--modes", "one"]);
    let report = std::fs::read_to_string(dir.path().join("page/report.json")).unwrap();
    assert!(report.contains("\"rays\": 1,"), "{report}");
}

/// A number after `--rays` is a count, as it always was of `fit`, `hard` and `bench`.
#[test]
fn a_number_counts_rays() {
    let dir = scene();
    let hard = json(dir.path(), &["hard", "--case", "floor", "--rays", "7"]);
    assert_eq!(hard["rays"], 7);
    // A case's rays over the user's map; of views as many.
    let mine = json(
        dir.path(),
        &[&["hard", "--case", "floor,size-4", "--rays", "7", "--view", "eye.toml"][..], &MAP].concat(),
    );
    let cases = mine["cases"].as_array().unwrap();
    assert_eq!(cases.iter().map(|c| c["case"].as_str().unwrap()).collect::<Vec<_>>(), ["floor", "size-4", "eye"]);
    assert_eq!((cases[0]["rays"].as_u64(), cases[2]["rays"].as_u64()), (Some(7), Some(7)));
    assert_ne!(cases[0]["texels"], hard["cases"][0]["texels"]);
    assert!(cases[1]["left_out"].as_str().unwrap().contains("a size of its own"), "{mine}");
    let steps = json(dir.path(), &[&["steps", "--rays", "11", "--view", "front"][..], &MAP].concat());
    assert_eq!(steps[0]["rays"], 11);
    let endured = json(dir.path(), &[&["hard", "--endure", "240", "--rays", "five.csv"][..], &MAP].concat());
    assert_eq!((endured["rays"].as_u64(), endured["given_up"].as_u64()), (Some(240), Some(0)));
}

/// Every engine writes the same hits of a camera's pixels; so does the picture.
#[test]
fn a_camera_is_traced_by_every_engine() {
    let dir = scene();
    let mut all = Vec::new();
    for engine in engines() {
        let args = ["trace", "--engine", engine, "--view", "eye.toml", "--out", "e.csv"];
        let (code, text) = said(dir.path(), &[&args[..], &MAP].concat());
        assert_eq!(code, Some(0), "{engine}: {text}");
        all.push(std::fs::read(dir.path().join("e.csv")).unwrap());
    }
    assert!(all.iter().all(|bytes| *bytes == all[0]));
    assert!(all[0].iter().filter(|b| **b == b'\n').count() > 500);
}

/// Exit code 5 leaves no picture: of no ray, and of several views not even that of the other.
#[test]
fn a_picture_of_no_ray_is_not_written() {
    let dir = scene();
    let wide = "fov = 170.0\nwidth = 2\nheight = 2\ndistance = 100000.0\n";
    std::fs::write(dir.path().join("far.toml"), wide).unwrap();
    let before = std::fs::read_dir(dir.path()).unwrap().count();
    for view in ["far.toml", "eye.toml,far.toml"] {
        let args = ["render", "--engine", "golden", "--view", view, "--out", "p.png"];
        let (code, text) = said(dir.path(), &[&args[..], &MAP].concat());
        assert_eq!(code, Some(5), "{text}");
        assert!(text.contains("no ray of far.toml meets the map"), "{text}");
        assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), before);
    }
    // Nor is one whose rays have all been refused, nor a directory of hard cases of which none ran.
    let none =
        ["render", "--engine", "golden", "--out", "p.png", "--set", "traverse.step_limit=1", "--view", "eye.toml"];
    assert_eq!(said(dir.path(), &[&none[..], &MAP].concat()).0, Some(5));
    let small = ["hard", "--case", "size-4", "--pictures", "p", "--map", "h.png", "--set", "traverse.levels=5"];
    let (code, text) = said(dir.path(), &small);
    assert_eq!(code, Some(5), "{text}");
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), before);
}

/// Several views are several pictures; a table is drawn from above.
#[test]
fn several_views_are_several_pictures() {
    let dir = scene();
    let draw = |more: &[&str]| {
        json(dir.path(), &[&["render", "--engine", "golden", "--out", "p.png"][..], &MAP, more].concat())
    };
    let few = ["--set", "view.width=64", "--set", "view.height=48"];
    let both = draw(&[&["--view", "eye.toml,front"][..], &few].concat());
    assert_eq!(both.as_array().unwrap().len(), 2);
    let size = |name: &str| image::image_dimensions(dir.path().join(name)).unwrap();
    assert_eq!((size("p-eye.png"), size("p-front.png")), ((40, 30), (16, 12)));
    assert_eq!(draw(&["--rays", "five.csv"])["rays"], 5);
    assert!(size("p.png").0 > 640);
}

/// What `--json` prints are numbers under names that a program reads, not the cells of the table.
#[test]
fn accuracy_in_json_is_numbers() {
    let dir = tempfile::tempdir().unwrap();
    let args =
        ["accuracy", "--json", "--set", "map.kind=rocks", "--set", "view.stride=16", "--set", "mode.bilinear=true"];
    let out = run(dir.path(), &[&args[..], &["--set", "traverse.levels=6"]].concat());
    assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
    let said: serde_json::Value = serde_json::from_slice(&out.stdout).unwrap();
    let views = said["views"].as_array().unwrap();
    assert!(!views.is_empty());
    for v in views {
        assert!(v["map"].is_string() && v["view"].is_string(), "{v}");
        for key in ["rays", "wrong_texels", "wrong_walls", "given_up"] {
            assert!(v[key].is_u64(), "{key}: {v}");
        }
        let count = v["rays"].as_u64().unwrap();
        assert!(v["worst_t"]["error"].is_f64() && v["worst_t"]["ray"].as_u64() < Some(count), "{v}");
        for spread in ["uv", "uv_given"] {
            let of = |key: &str| v[spread][key].as_f64().unwrap();
            assert!(of("p50") <= of("p99") && of("p99") <= of("max") && of("rays") <= count as f64, "{v}");
        }
    }
    let refined = said["bilinear"].as_array().unwrap();
    assert_eq!(refined.len(), views.len());
    for r in refined {
        let of = |key: &str| r[key].as_u64().unwrap();
        assert_eq!(of("hit") + of("above") + of("below"), of("rays"), "{r}");
        assert!(r["uv"]["max"].is_f64() && r["command"].as_str().unwrap().contains("reliefrtl trace "), "{r}");
    }
    assert!(said["witnesses"].is_array() && said["definition"].is_string());
}
