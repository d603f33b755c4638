//! `accuracy` of a design with `mode.bilinear`: refined hits against the exact root.
use crate::cli::output::table;
use crate::project::{REFINED_RAYS, RefinedView, Three};

/// The table, then the commands.
pub fn print(rows: &[RefinedView]) {
    let three = |t: Three| format!("{:.1e} / {:.1e} / {:.1e}", t.p50, t.p99, t.max);
    println!("\nrefined hits against the exact root in their window (at most {REFINED_RAYS} rays a view):");
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
    let line = |r: &RefinedView| {
        let part = |n: u64| format!("{:.1} %", 100.0 * n as f64 / r.rays.max(1) as f64);
        vec![
            r.map.clone(),
            r.view.clone(),
            r.rays.to_string(),
            format!("{} / {} / {}", part(r.hit), part(r.above), part(r.below)),
            format!("{} of {}", r.hit_without_root, r.hit),
            format!("{} of {}", r.root_not_seen, r.rays - r.hit),
            three(r.t),
            three(r.uv),
            three(r.uv_of_block_hit),
            r.max_ray.to_string(),
        ]
    };
    print!("{}", table(&head, &rows.iter().map(line).collect::<Vec<_>>()));
    println!("\nthe largest position error of each, again:");
    rows.iter().for_each(|r| println!("{}, {}: {}", r.map, r.view, r.command));
}
