//! The table of hits: identical bytes whatever engine traced the rays.
use crate::config::{Border, Design};
use crate::golden::{RayHit, decode_time};
use crate::scene::border::{own_place, own_texel};
use std::fmt::Write;

/// Columns of the table.
pub const HEADER: &str = "ray,i,j,u,v,t,steps,crossings,ups,wall,limit";

/// One line a ray. `u`, `v` are in tiles, exact: (i + fraction) / 2^levels; `t` is 0 at the top plane, 1 at the bottom
/// (height codes over the largest code, as the nearest double). Decimals are the shortest that read back. With another border than
/// `wrap`, texels and places are those of the map itself.
pub fn hits_csv(design: &Design, border: Border, hits: &[RayHit]) -> String {
    let t = &design.traverse;
    let unit = |i: u32, f: u32| {
        ((u64::from(i) << t.frac_bits) + u64::from(f)) as f64 / 2f64.powi((t.levels + t.frac_bits) as i32)
    };
    let full = f64::from((1u32 << t.height_bits) - 1);
    let mut out = format!("{HEADER}\n");
    for (k, h) in hits.iter().enumerate() {
        let s = decode_time(design, h.t) / full;
        // A ray that was refused has no place.
        let border = if h.steps == 0 { Border::Wrap } else { border };
        let (u, v) = (own_place(border, unit(h.i, h.fu)), own_place(border, unit(h.j, h.fv)));
        let (i, j) = (own_texel(border, t.levels, h.i), own_texel(border, t.levels, h.j));
        let flags = (u8::from(h.wall), u8::from(h.limit));
        writeln!(out, "{k},{},{},{u},{v},{s},{},{},{},{},{}", i, j, h.steps, h.crossings, h.ups, flags.0, flags.1)
            .expect("writing to a string can't fail");
    }
    out
}
