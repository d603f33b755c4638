//! `accuracy` of a design with `mode.bilinear`: refined hits against the exact root.
use super::output::table;
use crate::config::Config;
use crate::error::Result;
use crate::measure::{Spread, bilinear};
use crate::project::{Scene, encode};
use crate::scene::ViewRay;
use serde::Serialize;
use std::path::Path;

/// Rays of a view, evenly over the picture: the exact root costs far more than the exact walk.
const RAYS: usize = 400;

/// What was measured of one view of one map.
#[derive(Serialize)]
pub struct Row {
    map: String,
    view: String,
    /// Rays that were refined.
    rays: u64,
    hit: u64,
    above: u64,
    below: u64,
    /// Hits whose window has no root.
    hit_without_root: u64,
    /// Of the others, those whose window has one.
    root_not_seen: u64,
    /// Error of the parameter, in height codes.
    t: Three,
    /// Error of the position, in texels.
    uv: Three,
    /// The block hit's own, in texels.
    uv_of_block_hit: Three,
    /// The ray of the largest position error, and the command that shows it again.
    max_ray: usize,
    command: String,
}

#[derive(Serialize)]
struct Three {
    p50: f64,
    p99: f64,
    max: f64,
}

impl Three {
    fn of(s: &Spread) -> Self {
        Self { p50: s.p50, p99: s.p99, max: s.max }
    }
    fn text(&self) -> String {
        format!("{:.1e} / {:.1e} / {:.1e}", self.p50, self.p99, self.max)
    }
}

/// A row for each map and view.
#[derive(Default)]
pub struct Refined {
    /// In the order in which they were measured.
    pub rows: Vec<Row>,
}

impl Refined {
    /// Measures some of a view's rays.
    ///
    /// # Errors
    /// As [`bilinear`].
    pub fn add(&mut self, c: &Config, scene: &Scene, file: Option<&Path>, view: &str, seen: &[ViewRay]) -> Result<()> {
        let n = seen.len().min(RAYS);
        let rays: Vec<ViewRay> = (0..n).map(|k| seen[k * seen.len() / n]).collect();
        let words: Vec<_> = rays.iter().map(|r| encode(c, r)).collect();
        let b = bilinear(&c.design(), &scene.pyramid, &scene.texels, &words)?;
        let [hit, above, below] = b.patches;
        self.rows.push(Row {
            map: scene.name.clone(),
            view: view.into(),
            rays: b.rays,
            hit,
            above,
            below,
            hit_without_root: b.rootless,
            root_not_seen: b.missed,
            t: Three::of(&b.t),
            uv: Three::of(&b.uv),
            uv_of_block_hit: Three::of(&b.uv_block),
            max_ray: b.uv.max_ray,
            command: b.command(c, file, &rays),
        });
        Ok(())
    }

    /// The table, then the commands.
    pub fn print(&self) {
        println!("\nrefined hits against the exact root in their window (at most {RAYS} rays a view):");
        let head = [
            "map",
            "view",
            "rays",
            "hit / above / below",
            "hit without root",
            "root not seen",
            "t error, codes: p50 / p99 / max",
            "uv error, texels: p50 / p99 / max",
            "of the block hit",
            "@ray",
        ];
        let line = |r: &Row| {
            let part = |n: u64| format!("{:.1} %", 100.0 * n as f64 / r.rays.max(1) as f64);
            vec![
                r.map.clone(),
                r.view.clone(),
                r.rays.to_string(),
                format!("{} / {} / {}", part(r.hit), part(r.above), part(r.below)),
                format!("{} of {}", r.hit_without_root, r.hit),
                format!("{} of {}", r.root_not_seen, r.rays - r.hit),
                r.t.text(),
                r.uv.text(),
                r.uv_of_block_hit.text(),
                r.max_ray.to_string(),
            ]
        };
        print!("{}", table(&head, &self.rows.iter().map(line).collect::<Vec<_>>()));
        println!("\nthe largest position error of each, again:");
        self.rows.iter().for_each(|r| println!("{}, {}: {}", r.map, r.view, r.command));
    }
}
