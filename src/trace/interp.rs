//! The traverse unit in the interpreter, as a tracer.
use crate::config::Design;
use crate::error::Result;
use crate::golden::{Pyramid, RayHit, RayInput};
use crate::interp::{Netlist, Stream, StreamRun, Traffic, elaborate};
use crate::ir::Binding;
use crate::units::traversal::traverse;
use rayon::prelude::*;
use std::sync::Arc;

/// Data inputs of `traverse`, in the order of a ray's row.
pub const INPUTS: [&str; 4] = ["in_u", "in_v", "in_du", "in_dv"];
/// Data outputs of `traverse`, in the order of a hit's row.
pub const OUTPUTS: [&str; 10] =
    ["out_i", "out_j", "out_fu", "out_fv", "out_t", "out_wall", "out_limit", "out_steps", "out_crossings", "out_ups"];

/// The traverse unit of a design, elaborated.
pub struct Pipeline {
    /// The flat design.
    pub net: Netlist,
    /// Slots of the loop.
    pub slots: u32,
    /// Clocks of setup, loop and hit position together: until the pipeline can be full.
    pub depth: u32,
}

impl Pipeline {
    /// Elaborates the traverse unit with `over` put over its parameters.
    ///
    /// # Errors
    /// Illegal parameters.
    pub fn new(design: &Design, over: &Binding) -> Result<Self> {
        let t = traverse(design);
        let net = elaborate(&t.module, over)?;
        Ok(Self { net, slots: t.slots, depth: t.setup + t.slots + t.finish })
    }

    /// Runs `rays` through `lanes` copies on `threads` threads.
    ///
    /// # Errors
    /// A ray that gets lost, or a result that nobody waits for.
    pub fn run(&self, pyramid: &Pyramid, rays: &[RayInput], lanes: usize, traffic: Traffic) -> Result<StreamRun> {
        let image: Vec<u64> = pyramid.memory().iter().map(|w| u64::from(*w)).collect();
        let items: Vec<Vec<u64>> = rays.iter().map(|r| vec![r.u, r.v, r.du, r.dv]).collect();
        let stream = Stream::new(&self.net, &INPUTS, &OUTPUTS, u64::from(self.depth));
        stream.run(&items, &Arc::new(image), lanes, traffic)
    }
}

/// Traces rays with the interpreter; hits come in the order of the rays.
///
/// # Errors
/// As [`Pipeline::run`].
pub fn trace_interp(design: &Design, pyramid: &Pyramid, rays: &[RayInput]) -> Result<Vec<RayHit>> {
    let p = Pipeline::new(design, &Binding::new())?;
    let share = rays.len().div_ceil(rayon::current_num_threads()).max(1);
    let runs: Vec<StreamRun> =
        rays.par_chunks(share).map(|part| p.run(pyramid, part, 64, Traffic::default())).collect::<Result<_>>()?;
    Ok(runs.iter().flat_map(|r| r.results.iter().map(|h| hit(h))).collect())
}

/// A hit from its row of outputs.
pub fn hit(r: &[u64]) -> RayHit {
    RayHit {
        i: r[0] as u32,
        j: r[1] as u32,
        fu: r[2] as u32,
        fv: r[3] as u32,
        t: r[4],
        wall: r[5] != 0,
        limit: r[6] != 0,
        steps: r[7] as u32,
        crossings: r[8] as u32,
        ups: r[9] as u32,
    }
}
