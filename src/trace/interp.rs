//! The traverse unit in the interpreter, as a tracer.
use super::memory::{image, images};
use crate::config::Design;
use crate::error::Result;
use crate::golden::{BilinearHit, Patch, Pyramid, RayHit, RayInput};
use crate::interp::{BLOCK, Netlist, Stream, StreamRun, Traffic, elaborate};
use crate::ir::{Binding, Module};
use crate::units::traversal::traverse;
use std::sync::Arc;

/// Data inputs of `traverse`, in the order of a ray's row.
pub const INPUTS: [&str; 4] = ["in_u", "in_v", "in_du", "in_dv"];
/// The same with the input that a design with a level of detail adds: those that `traverse` has, in the order of a ray's row.
pub fn inputs(traverse: &Module) -> Vec<&'static str> {
    INPUTS.into_iter().chain(["in_lod"]).filter(|n| traverse.port(n).is_some()).collect()
}
/// The row of a ray: a word for each of [`inputs`].
pub fn row(inputs: &[&str], r: &RayInput) -> Vec<u64> {
    let mut words = vec![r.u, r.v, r.du, r.dv, u64::from(r.lod)];
    words.truncate(inputs.len());
    words
}
/// Data outputs of a `traverse` over a pyramid that gives all counters, in the order of a hit's row; a search by windows has no crossings and goes up
/// no levels, and `emit.counters` leaves out counters.
pub const OUTPUTS: [&str; 10] =
    ["out_i", "out_j", "out_fu", "out_fv", "out_t", "out_wall", "out_limit", "out_steps", "out_crossings", "out_ups"];
/// Those that a design with the bilinear refinement has besides.
const REFINED: [&str; 6] = ["out_patch", "out_bi", "out_bj", "out_bfu", "out_bfv", "out_bt"];
/// The data outputs that `traverse` has, in the order of a hit's row.
pub fn outputs(traverse: &Module) -> Vec<&'static str> {
    OUTPUTS.into_iter().chain(REFINED).filter(|n| traverse.port(n).is_some()).collect()
}
/// The row of a hit: a word for each of [`outputs`].
pub fn hit_row(design: &Design, h: &RayHit) -> Vec<u64> {
    let mut row = [h.i, h.j, h.fu, h.fv].map(u64::from).to_vec();
    row.extend([h.t, u64::from(h.wall), u64::from(h.limit)]);
    row.extend(design.gives_steps().then(|| u64::from(h.steps)));
    if design.gives_crossings() {
        row.extend([h.crossings, h.ups].map(u64::from));
    }
    if design.mode.bilinear {
        // A ray that was given up keeps its words here too.
        let block = [0, u64::from(h.i), u64::from(h.j), u64::from(h.fu), u64::from(h.fv), h.t];
        row.extend(h.bilinear.map_or(block, |r| {
            [r.patch.code(), u64::from(r.i), u64::from(r.j), u64::from(r.fu), u64::from(r.fv), r.t]
        }));
    }
    row
}

/// The traverse unit of a design, elaborated.
pub struct Pipeline {
    /// The flat design.
    pub net: Netlist,
    /// Slots of the loop.
    pub slots: u32,
    /// The design.
    pub design: Design,
    /// Data inputs, in the order of a ray's row.
    pub inputs: Vec<&'static str>,
    /// Data outputs, in the order of a hit's row.
    pub outputs: Vec<&'static str>,
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
        Ok(Self {
            net,
            slots: t.slots,
            design: design.settled(),
            inputs: inputs(&t.module),
            outputs: outputs(&t.module),
            depth: t.setup + t.slots + t.finish,
        })
    }

    /// Runs `rays` through `lanes` copies; up to 16, and multiples of [`BLOCK`], are fastest.
    ///
    /// # Errors
    /// A ray that gets lost, or a result that is not waited for.
    pub fn run(&self, pyramid: &Pyramid, rays: &[RayInput], lanes: usize, traffic: Traffic) -> Result<StreamRun> {
        let (images, items) = self.words(pyramid, rays);
        self.stream().run(&items, &images, lanes, traffic)
    }

    /// As [`Pipeline::run`], on `threads` threads of `lanes` lanes each.
    ///
    /// # Errors
    /// As [`Pipeline::run`].
    pub fn run_parallel(
        &self,
        pyramid: &Pyramid,
        rays: &[RayInput],
        lanes: usize,
        threads: usize,
        traffic: Traffic,
    ) -> Result<StreamRun> {
        let (images, items) = self.words(pyramid, rays);
        self.stream().run_parallel(&items, &images, lanes, threads, traffic)
    }

    /// The memories' images and a row of inputs for each ray.
    pub fn words(&self, pyramid: &Pyramid, rays: &[RayInput]) -> (Vec<Arc<Vec<u64>>>, Vec<Vec<u64>>) {
        (self.images(pyramid), rays.iter().map(|r| row(&self.inputs, r)).collect())
    }

    /// The memories' images.
    pub fn images(&self, pyramid: &Pyramid) -> Vec<Arc<Vec<u64>>> {
        images(&self.net, &image(&self.design, pyramid))
    }

    /// The unit as a stream of rays.
    pub fn stream(&self) -> Stream {
        Stream::new(&self.net, &self.inputs, &self.outputs, u64::from(self.depth))
    }
}

/// Traces rays with the interpreter; hits come in the order of the rays.
///
/// # Errors
/// As [`Pipeline::run`].
pub fn trace_interp(design: &Design, pyramid: &Pyramid, rays: &[RayInput]) -> Result<Vec<RayHit>> {
    let p = Pipeline::new(design, &Binding::new())?;
    let run = p.run_parallel(pyramid, rays, BLOCK, rayon::current_num_threads(), Traffic::default())?;
    Ok(run.results.iter().map(|r| hit(design, r)).collect())
}

/// A hit from its row of outputs: what the design does not count is 0.
///
/// # Panics
/// If the row is not one of the design.
pub fn hit(design: &Design, r: &[u64]) -> RayHit {
    let mut words = r.iter().copied();
    let mut next = || words.next().expect("a row has a word for each output of its design");
    let [i, j, fu, fv] = [(); 4].map(|()| next() as u32);
    let (t, wall, limit) = (next(), next() != 0, next() != 0);
    let steps = if design.gives_steps() { next() as u32 } else { 0 };
    let [crossings, ups] = if design.gives_crossings() { [(); 2].map(|()| next() as u32) } else { [0; 2] };
    let mut refined = || {
        let code = next();
        let [i, j, fu, fv] = [(); 4].map(|()| next() as u32);
        let t = next();
        let patch = Patch::ALL.into_iter().find(|p| p.code() == code)?;
        Some(BilinearHit { patch, i, j, fu, fv, t })
    };
    let bilinear = if design.mode.bilinear { refined() } else { None };
    RayHit { i, j, fu, fv, t, wall, limit, steps, crossings, ups, bilinear }
}

/// A hit of the golden model as the design's `traverse` says it: what it does not count is 0.
pub fn said(design: &Design, h: &RayHit) -> RayHit {
    hit(design, &hit_row(design, h))
}
