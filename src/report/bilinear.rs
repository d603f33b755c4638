//! The bilinear refinement: its error against the exact root, and what it does to a magnified picture.
use super::pictures::{SIZE, cameras, data_uri};
use super::plan::{Map, Plan, Rays};
use super::table::{Table, real};
use crate::config::modes::BEST;
use crate::config::{Config, DatapathConfig, MapConfig, ModeConfig};
use crate::error::Result;
use crate::golden::{RayInput, encode_ray};
use crate::measure::bilinear;
use crate::scene::border::tiles;
use crate::scene::{Picture, Shader, ViewRay, evenly};
use crate::trace::{shade_point, trace_interp};
use rayon::prelude::*;
use serde_json::{Value, json};

/// Rays of a view, evenly over the picture: the exact root costs far more than the exact walk.
const RAYS: usize = 120;
/// EXP_W and MAN_W.
const FORMATS: [(u32, u32); 3] = [(7, 16), (8, 23), (5, 10)];
/// log2 of the side of the map in the pictures: texels must be large to be seen.
const PICTURE_LEVELS: u32 = 5;

/// The refined design of a format on a site's map; `None` if there is none.
fn config(plan: &Plan, map: &Map, (exp, man): (u32, u32)) -> Option<Config> {
    let (mut c, s) = (plan.config.clone(), &map.spec);
    (c.format.exp, c.format.man, c.traverse.levels) = (exp, man, s.levels);
    (c.datapath, c.mode) = (DatapathConfig::default(), ModeConfig { bilinear: true, ..BEST });
    (c.map.kind, c.map.scale, c.map.repeat, c.map.border) = (s.kind, s.scale, s.repeat, s.border);
    c.map.file = map.file.clone();
    c.validate().is_ok().then_some(c)
}

fn rays(c: &Config, map: &Map, of: &Rays) -> Result<Vec<ViewRay>> {
    Ok(evenly(&map.set(c, &of.set, of.stride)?, Some(RAYS)))
}

fn words(c: &Config, rays: &[ViewRay]) -> Vec<RayInput> {
    rays.iter().map(|r| encode_ray(&c.design(), [r.u, r.v, r.du, r.dv])).collect()
}

/// Refined hits against the exact root, a row a map, view and format.
///
/// # Errors
/// As [`bilinear`].
pub fn table(plan: &Plan) -> Result<Table> {
    let keys = [
        ("map", "map"),
        ("levels", "levels"),
        ("view", "view"),
        ("format", "float"),
        ("rays", "rays"),
        ("hit", "hit"),
        ("above", "above"),
        ("below", "below"),
        ("rootless", "hit without a root"),
        ("missed", "root not seen"),
        ("t_p50", "t p50, codes"),
        ("t_p99", "t p99"),
        ("t_max", "t max"),
        ("uv_p50", "uv p50, texel"),
        ("uv_p99", "uv p99"),
        ("uv_max", "uv max"),
        ("block_p50", "block hit, uv p50"),
        ("block_p99", "block hit, uv p99"),
        ("words", "u v du dv (hex) of the largest"),
        ("command", "see it again"),
    ];
    let mut t = Table::new("bilinear", &keys);
    let side = plan.config.traverse.levels;
    let views: Vec<&Rays> = plan.rays.iter().filter(|r| r.elevation.is_none()).collect();
    let views = &views;
    let jobs: Vec<_> = plan
        .maps
        .iter()
        .filter(|s| s.spec.levels == side)
        .flat_map(|map| FORMATS.into_iter().filter_map(move |f| config(plan, map, f).map(|c| (map, f, c))))
        .flat_map(|(map, format, c)| views.iter().map(move |view| (map, format, c.clone(), *view)))
        .collect();
    let one = |(map, format, c, view): &(&Map, (u32, u32), Config, &Rays)| -> Result<Vec<Value>> {
        let rays = rays(c, map, view)?;
        let words = words(c, &rays);
        let b = bilinear(&c.design(), &map.pyramid, &map.texels, &words)?;
        let w = words.get(b.uv.max_ray).filter(|_| b.uv.rays > 0);
        Ok(vec![
            json!(map.spec.name),
            json!(map.spec.levels),
            json!(view.set.name),
            json!(format!("{}/{}", format.0, format.1)),
            json!(b.rays),
            json!(b.patches[0]),
            json!(b.patches[1]),
            json!(b.patches[2]),
            json!(b.rootless),
            json!(b.missed),
            real(b.t.p50),
            real(b.t.p99),
            real(b.t.max),
            real(b.uv.p50),
            real(b.uv.p99),
            real(b.uv.max),
            real(b.uv_block.p50),
            real(b.uv_block.p99),
            json!(w.map(|w| format!("{:x} {:x} {:x} {:x}", w.u, w.v, w.du, w.dv))),
            json!(b.command(c, map.file.as_deref(), &rays)),
        ])
    };
    let rows: Vec<Vec<Value>> = jobs.par_iter().map(one).collect::<Result<_>>()?;
    rows.into_iter().for_each(|row| t.push(row));
    Ok(t)
}

/// A map of few texels by its block hits, and by its refined ones; null if there is no such design.
///
/// # Errors
/// A map or a design that is not legal.
pub fn pictures(plan: &Plan) -> Result<Value> {
    let first = &plan.maps[0].spec;
    let levels = PICTURE_LEVELS + first.border.levels();
    // A file is resampled for this: the picture shows texels, not the map.
    let file = plan.maps[0].file.clone();
    let map = plan.config.map.clone();
    let map = MapConfig { kind: first.kind, file, seed: first.seed, resample: true, crop: false, pad: false, ..map };
    let map = Map::new(&plan.config, &map, levels, false)?;
    let Some(c) = config(plan, &map, FORMATS[0]) else { return Ok(Value::Null) };
    let s = &map.spec;
    let shader = Shader::new(&map.texels, s.levels, s.height_bits, s.scale, tiles(s.border, s.repeat), s.kind);
    let mut out = Vec::new();
    for (view, camera) in cameras(plan) {
        let rays = map.rays(&c, &camera, 1)?;
        let words = words(&c, &rays);
        let picture = |bilinear: bool| -> Result<String> {
            let mut d = c.design();
            d.mode.bilinear = bilinear;
            let hits = trace_interp(&d, &map.pyramid, &words)?;
            let mut pixels = vec![None; (SIZE.0 * SIZE.1) as usize];
            for (r, h) in rays.iter().zip(hits.iter()).filter(|x| !x.1.limit) {
                pixels[(r.py * SIZE.0 + r.px) as usize] = Some(shade_point(&d, h));
            }
            data_uri(&Picture::shaded(&shader, SIZE.0 as usize, SIZE.1 as usize, &pixels))
        };
        out.push(json!({"view": view, "pair": [picture(false)?, picture(true)?]}));
    }
    Ok(json!({"map": s.name, "side": 1u64 << levels, "views": out}))
}
