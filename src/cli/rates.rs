//! `reliefrtl accuracy --scenes`: wrong texels and position errors on the published scenes, in floating and in fixed point.
use super::args::Cli;
use super::hard::words;
use super::output::{spinner, table};
use crate::config::{Config, DatapathKind, MapKind, View};
use crate::error::Result;
use crate::golden::RayInput;
use crate::measure::{Accuracy, PUBLISHED, Published, accuracy};
use crate::project::{Scene, encode};
use crate::trace::trace_golden;
use serde_json::{Value, json};
use std::path::Path;

/// The larger size: the same maps, resampled.
const WIDE: u32 = 11;

/// A ray and where it is: scene, view, index.
struct Found {
    at: String,
    words: String,
    value: f64,
}

/// What one datapath makes of all scenes at one size.
#[derive(Default)]
struct Rate {
    design: String,
    side: u32,
    rays: usize,
    limits: usize,
    wrong: usize,
    errors: Vec<f64>,
    /// The wrong texel whose exact decision had the largest margin.
    worst: Option<Found>,
    /// The largest position error.
    farthest: Option<Found>,
}

/// Prints the rates.
///
/// # Errors
/// A scene that can't be read; a configuration that is not legal at a size.
pub fn run(cli: &Cli, c: &Config, dir: &Path) -> Result<()> {
    c.map.published_border()?;
    // The published datapath stands apart: where it is asked for, alone.
    let kinds = match c.datapath.kind {
        DatapathKind::Published => &[DatapathKind::Published][..],
        _ => &[DatapathKind::Watertight, DatapathKind::Fixed],
    };
    let bar = spinner(cli, "measuring");
    let mut rates = Vec::new();
    let mut sizes = vec![c.traverse.levels, WIDE];
    sizes.dedup();
    for levels in sizes {
        for kind in kinds {
            let mut c = c.clone();
            (c.traverse.levels, c.datapath.kind, c.map.kind) = (levels, *kind, MapKind::File);
            c.map.file = Some(dir.join("-"));
            c.validate()?;
            let mut rate = Rate { design: label(&c), side: 1 << levels, ..Rate::default() };
            for p in &PUBLISHED {
                bar.set_message(format!("{} on {}, {} texels", rate.design, p.scene, rate.side));
                rate.scene(&mut c, p, dir)?;
            }
            rate.errors.sort_by(f64::total_cmp);
            rates.push(rate);
        }
    }
    bar.finish_and_clear();
    if cli.json {
        let value: Vec<Value> = rates.iter().map(Rate::value).collect();
        println!("{}", serde_json::to_string_pretty(&value).expect("plain data"));
        return Ok(());
    }
    let head = [
        "datapath",
        "texels",
        "wrong texels",
        "%",
        "given up",
        "uv error p99, texel",
        "largest",
        "of ray",
        "its u v du dv (hex)",
    ];
    print!("{}", table(&head, &rates.iter().map(Rate::line).collect::<Vec<_>>()));
    let worst: Vec<Vec<String>> = rates
        .iter()
        .filter_map(|r| {
            let w = r.worst.as_ref()?;
            let of = format!("{} of {}", r.wrong, r.rays);
            Some(vec![
                r.design.clone(),
                r.side.to_string(),
                of,
                format!("{:.1e}", w.value),
                w.at.clone(),
                w.words.clone(),
            ])
        })
        .collect();
    if !worst.is_empty() {
        println!("\nthe wrong texel farthest from another decision, of each:");
        print!("{}", table(&["datapath", "texels", "wrong", "margin", "ray", "u v du dv (hex)"], &worst));
    }
    println!(
        "\nrocks, stones, four, saints as published, three views each, every {} pixels each way; `trace` shows a ray again",
        c.view.stride
    );
    Ok(())
}

fn label(c: &Config) -> String {
    match c.datapath.kind {
        DatapathKind::Fixed => {
            format!("fixed Q.{}, reciprocal {}", c.datapath.fraction_bits, c.datapath.reciprocal_bits)
        }
        DatapathKind::Published if c.datapath.nudge_bits == 0 => {
            format!("published {}/{}, no nudge", c.format.exp, c.format.man)
        }
        kind => format!("{} {}/{}", kind.word(), c.format.exp, c.format.man),
    }
}

impl Rate {
    fn scene(&mut self, c: &mut Config, p: &Published, dir: &Path) -> Result<()> {
        (c.map.scale, c.map.repeat) = (p.scale, p.repeat);
        // The maps have 256 texels a side; another size is asked for here, so it need not be asked for again.
        let scene = Scene::new(c, Some(&dir.join(format!("{}.png", p.scene))), c.traverse.levels == WIDE)?;
        for view in View::ALL {
            let rays: Vec<RayInput> = scene.view(c, *view, c.view.stride)?.iter().map(|r| encode(c, r)).collect();
            let hits = trace_golden(&c.design(), &scene.pyramid, &rays)?;
            let a = accuracy(&c.design(), &scene.texels, &rays, &hits)?;
            self.add(&format!("{} {view}", p.scene), &rays, &a);
        }
        Ok(())
    }

    fn add(&mut self, place: &str, rays: &[RayInput], a: &Accuracy) {
        let found = |ray: usize, value| Found { at: format!("{place} @{ray}"), words: words(&rays[ray]), value };
        let larger = |old: &Option<Found>, value: f64| old.as_ref().is_none_or(|f| value > f.value);
        self.rays += a.rays;
        self.limits += a.limits;
        self.wrong += a.wrong.len();
        for w in &a.wrong {
            if larger(&self.worst, w.margin) {
                self.worst = Some(found(w.ray, w.margin));
            }
        }
        for &(error, ray) in &a.uv {
            self.errors.push(error);
            if larger(&self.farthest, error) {
                self.farthest = Some(found(ray, error));
            }
        }
    }

    /// The error that 99 of 100 hits do not exceed: one that some ray has.
    fn p99(&self) -> f64 {
        self.errors.get((self.errors.len() * 99).div_ceil(100).max(1) - 1).copied().unwrap_or(0.0)
    }

    fn share(&self) -> f64 {
        100.0 * self.wrong as f64 / self.rays.max(1) as f64
    }

    fn line(&self) -> Vec<String> {
        let far = self.farthest.as_ref();
        vec![
            self.design.clone(),
            self.side.to_string(),
            format!("{} of {}", self.wrong, self.rays),
            format!("{:.4}", self.share()),
            self.limits.to_string(),
            format!("{:.2e}", self.p99()),
            far.map_or(String::new(), |f| format!("{:.2e}", f.value)),
            far.map_or(String::new(), |f| f.at.clone()),
            far.map_or(String::new(), |f| f.words.clone()),
        ]
    }

    fn value(&self) -> Value {
        let found = |f: &Option<Found>| f.as_ref().map(|f| json!({"ray": f.at, "words": f.words, "value": f.value}));
        json!({"datapath": self.design, "texels": self.side, "rays": self.rays, "wrong": self.wrong, "wrong_percent": self.share(),
            "given_up": self.limits, "uv_p99": self.p99(), "uv_largest": found(&self.farthest), "worst_wrong": found(&self.worst)})
    }
}
