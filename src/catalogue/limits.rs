//! Vector sets of `traverse` at step limits that its rays reach: the configured one is there for rays that never end, so it is far from all others.
use super::design_at;
use super::ray_plan::planned_rays;
use super::rays::{RaySet, ray_set_at};
use crate::config::Design;
use crate::error::Result;
use crate::golden::{Pyramid, prepare};
use crate::ir::{Binding, Module};
use crate::units::traversal::traverse;

/// Rays of such a set, at most.
const RAYS: usize = 300;
/// Levels of its map: 16 x 16 texels.
const LEVELS: u32 = 4;

/// A set for a step limit of 1, and one for a limit that some rays hit exactly and others exceed, by the names of their directories below that of
/// `traverse`. They are made for parameter values of their own: STEP_LIMIT, and a small map where the number format allows it.
///
/// # Errors
/// An illegal design.
pub fn limit_sets(d: &Design, pyramid: &Pyramid, seed: u64) -> Result<Vec<(&'static str, RaySet)>> {
    let m = traverse(d).module;
    let small = small_map(d, &m, pyramid)?;
    let at = |limit: u32| {
        let levels = i64::from(small.levels());
        let over = Binding::from([("LEVELS".into(), levels), ("STEP_LIMIT".into(), i64::from(limit))]);
        (design_at(d, &m.binding_with(&over)), over)
    };
    let all = planned_rays(&at(d.traverse.step_limit).0, &small, seed)?;
    let rays: Vec<_> = all.iter().step_by(all.len().div_ceil(RAYS)).copied().collect();
    let tracer = prepare(&at(u32::from(u16::MAX)).0)?;
    let mut steps: Vec<u32> = rays.iter().map(|r| tracer.trace(&small, r).steps).filter(|s| *s > 1).collect();
    steps.sort_unstable();
    // Most rays stay below it.
    let limit = steps.get(steps.len() * 3 / 4).copied().unwrap_or(2);
    let set = |limit| ray_set_at(d, &at(limit).1, &small, [&rays, &[]], seed);
    Ok(vec![("limit", set(limit)?), ("limit_1", set(1)?)])
}

/// A map of [`LEVELS`], of the maxima of a larger one; the map itself if it is small already, or if the format has no datapath for less.
fn small_map(d: &Design, m: &Module, pyramid: &Pyramid) -> Result<Pyramid> {
    let n = pyramid.levels();
    let legal = m.failed_checks(&m.binding_with(&Binding::from([("LEVELS".into(), i64::from(LEVELS))]))).is_empty();
    if n <= LEVELS || !legal {
        return Ok(pyramid.clone());
    }
    let side = 1u32 << LEVELS;
    let node = |k: u32| pyramid.node(n - LEVELS, k % side, k / side);
    Pyramid::build(LEVELS, d.traverse.height_bits, &(0..side * side).map(node).collect::<Vec<u32>>())
}
