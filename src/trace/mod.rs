//! Rays in, hits out, by the golden model or by the interpreter of the emitted datapath.
mod border;
mod csv;
mod diagnose;
mod interp;
mod iterations;
mod memory;
mod refused;
mod shown;
mod wave;

pub use border::{rays_inside, saw_border};
pub use csv::{HEADER, REFINED, hits_csv};
pub use diagnose::{Divergence, decode, diagnose, diagnose_in};
pub use interp::{INPUTS, OUTPUTS, Pipeline, hit, hit_row, inputs, outputs, row, said, trace_interp};
pub use iterations::wrong_iteration;
pub use memory::{image, images};
pub use refused::refused;
pub use shown::shade_point;
pub use wave::{Window, record, record_mismatch, record_ray, record_rows};

use crate::config::Design;
use crate::error::Result;
use crate::golden::{Pyramid, RayHit, RayInput, prepare};
use rayon::prelude::*;

/// Traces rays with the golden model, on all threads; hits come in the order of the rays.
///
/// # Errors
/// If the design is not a legal one.
pub fn trace_golden(design: &Design, pyramid: &Pyramid, rays: &[RayInput]) -> Result<Vec<RayHit>> {
    let golden = prepare(design)?;
    Ok(rays.par_iter().map(|r| golden.trace(pyramid, r)).collect())
}
