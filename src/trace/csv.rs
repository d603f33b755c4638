//! The table of hits: identical bytes whatever engine traced the rays.
use crate::config::{Border, Counters, Design};
use crate::golden::{Patch, RayHit, decode_time};
use crate::scene::border::{own_place, own_texel};
use std::fmt::Write;

/// Columns of the table where a hit has all counters.
pub const HEADER: &str = "ray,i,j,u,v,t,steps,crossings,ups,wall,limit";
/// Columns that a design with the bilinear refinement has besides.
pub const REFINED: &str = ",bi,bj,bu,bv,bt,patch";

/// One line a ray. `u`, `v` are in tiles, exact: (i + fraction) / 2^levels; `t` is 0 at the top plane, 1 at the bottom
/// (height codes over the largest code, as the nearest double). Decimals are the shortest that read back. With another border than
/// `wrap`, texels and places are those of the map itself, but of a ray that was `refused` the words. What `emit.counters` leaves out has no column.
/// With `mode.bilinear`, the same of the refined hit follows, and whether the patch was `hit` (or `above`, `below`; `none`: given up), which is the
/// block hit again where it was not.
pub fn hits_csv(design: &Design, border: Border, hits: &[RayHit], refused: &[bool]) -> String {
    let t = &design.traverse;
    let unit = |i: u32, f: u32| {
        ((u64::from(i) << t.frac_bits) + u64::from(f)) as f64 / 2f64.powi((t.levels + t.frac_bits) as i32)
    };
    let full = f64::from((1u32 << t.height_bits) - 1);
    let refined = design.mode.bilinear;
    let counters = counters(design);
    let names: String = counters.iter().map(|c| format!(",{}", c.0)).collect();
    let header = HEADER.replace(",steps,crossings,ups", &names);
    let mut out = format!("{header}{}\n", if refined { REFINED } else { "" });
    for (k, (h, refused)) in hits.iter().zip(refused).enumerate() {
        // A ray that was refused has no place.
        let border = if *refused { Border::Wrap } else { border };
        let place = |i: u32, j: u32, fu: u32, fv: u32, s: u64| {
            let (u, v) = (own_place(border, unit(i, fu)), own_place(border, unit(j, fv)));
            let (i, j) = (own_texel(border, t.levels, i), own_texel(border, t.levels, j));
            format!("{i},{j},{u},{v},{}", decode_time(design, s) / full)
        };
        let flags = (u8::from(h.wall), u8::from(h.limit));
        let block = place(h.i, h.j, h.fu, h.fv, h.t);
        let counts: String = counters.iter().map(|c| format!(",{}", (c.1)(h))).collect();
        write!(out, "{k},{block}{counts},{},{}", flags.0, flags.1).expect("writing to a string can't fail");
        if refined {
            let found = h.bilinear.map(|b| place(b.i, b.j, b.fu, b.fv, b.t));
            let word = h.bilinear.map_or("none", |b| Patch::word(b.patch));
            write!(out, ",{},{word}", found.unwrap_or(block)).expect("writing to a string can't fail");
        }
        out.push('\n');
    }
    out
}

/// A column of a counter: its name, and its value of a hit.
type Counter = (&'static str, fn(&RayHit) -> u32);

/// The columns of the counters that `emit.counters` keeps; of a search by windows, crossings and ups are 0.
fn counters(d: &Design) -> Vec<Counter> {
    let all: [Counter; 3] = [("steps", |h| h.steps), ("crossings", |h| h.crossings), ("ups", |h| h.ups)];
    let kept = match d.counters {
        Counters::All => 3,
        Counters::Steps => 1,
        Counters::None => 0,
    };
    all[..kept].to_vec()
}
