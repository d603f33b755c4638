//! The table of hits: identical bytes whatever engine traced the rays.
use crate::config::Design;
use crate::golden::{RayHit, decode_time};
use std::fmt::Write;

/// Columns of the table.
pub const HEADER: &str = "ray,i,j,u,v,t,steps,crossings,ups,wall,limit";

/// One line a ray. `u`, `v` are in tiles, exact: (i + fraction) / 2^levels; `t` is 0 at the top plane, 1 at the bottom
/// (height codes over the largest code, as the nearest double). Decimals are the shortest that read back.
pub fn hits_csv(design: &Design, hits: &[RayHit]) -> String {
    let t = &design.traverse;
    let unit = |i: u32, f: u32| {
        ((u64::from(i) << t.frac_bits) + u64::from(f)) as f64 / 2f64.powi((t.levels + t.frac_bits) as i32)
    };
    let full = f64::from((1u32 << t.height_bits) - 1);
    let mut out = format!("{HEADER}\n");
    for (k, h) in hits.iter().enumerate() {
        let (u, v, s) = (unit(h.i, h.fu), unit(h.j, h.fv), decode_time(design, h.t) / full);
        let flags = (u8::from(h.wall), u8::from(h.limit));
        writeln!(out, "{k},{},{},{u},{v},{s},{},{},{},{},{}", h.i, h.j, h.steps, h.crossings, h.ups, flags.0, flags.1)
            .expect("writing to a string can't fail");
    }
    out
}
