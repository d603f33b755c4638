//! Which rays a design refuses, where its hits do not say it.
use super::trace_golden;
use crate::config::Design;
use crate::error::Result;
use crate::golden::{Pyramid, RayHit, RayInput};

/// Which of these rays were refused: they took no iteration. Where a hit has no steps, the golden model is asked about the rays that have no hit,
/// with a step limit of 1: whether words are a ray does not depend on how many iterations follow.
///
/// # Errors
/// If the design is not a legal one.
pub fn refused(design: &Design, pyramid: &Pyramid, rays: &[RayInput], hits: &[RayHit]) -> Result<Vec<bool>> {
    if design.gives_steps() {
        return Ok(hits.iter().map(|h| h.limit && h.steps == 0).collect());
    }
    let mut first = *design;
    first.traverse.step_limit = 1;
    let without: Vec<usize> = (0..hits.len()).filter(|k| hits[*k].limit).collect();
    let asked: Vec<RayInput> = without.iter().map(|k| rays[*k]).collect();
    let mut list = vec![false; hits.len()];
    for (k, h) in without.into_iter().zip(trace_golden(&first, pyramid, &asked)?) {
        list[k] = h.steps == 0;
    }
    Ok(list)
}
