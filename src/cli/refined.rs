//! `accuracy` of a design with `mode.bilinear`: refined hits against the exact root.
use super::output::table;
use crate::config::Config;
use crate::error::Result;
use crate::project::{Scene, encode};
use crate::report::{Spread, bilinear};
use crate::scene::ViewRay;
use std::path::Path;

/// Rays of a view, evenly over the picture: the exact root costs far more than the exact walk.
const RAYS: usize = 400;

/// Columns of [`Refined::rows`]; the last one is the command that shows the ray of the largest position error again.
pub const HEAD: [&str; 11] = [
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
    "see it again",
];

/// A row for each map and view.
#[derive(Default)]
pub struct Refined {
    /// Texts, as in [`HEAD`].
    pub rows: Vec<Vec<String>>,
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
        let three = |s: &Spread| format!("{:.1e} / {:.1e} / {:.1e}", s.p50, s.p99, s.max);
        let part = |n: u64| format!("{:.1} %", 100.0 * n as f64 / b.rays.max(1) as f64);
        let [hit, above, below] = b.patches.map(part);
        self.rows.push(vec![
            scene.name.clone(),
            view.into(),
            b.rays.to_string(),
            format!("{hit} / {above} / {below}"),
            format!("{} of {}", b.rootless, b.patches[0]),
            format!("{} of {}", b.missed, b.rays - b.patches[0]),
            three(&b.t),
            three(&b.uv),
            three(&b.uv_block),
            b.uv.max_ray.to_string(),
            b.command(c, file, &rays),
        ]);
        Ok(())
    }

    /// The table, then the commands.
    pub fn print(&self) {
        println!("\nrefined hits against the exact root in their window (at most {RAYS} rays a view):");
        let last = HEAD.len() - 1;
        let short: Vec<Vec<String>> = self.rows.iter().map(|r| r[..last].to_vec()).collect();
        print!("{}", table(&HEAD[..last], &short));
        println!("\nthe largest position error of each, again:");
        self.rows.iter().for_each(|r| println!("{}, {}: {}", r[0], r[1], r[last]));
    }
}
