//! One ray through the pipeline from power-up, undefined values tracked, as a waveform.
use super::interp::{INPUTS, OUTPUTS, Pipeline};
use crate::config::Design;
use crate::error::{Error, Result};
use crate::golden::{Pyramid, RayHit, RayInput};
use crate::interp::{Tracked, Wave};
use crate::ir::Binding;

/// Traces `ray` from power-up and records every net of `traverse` until the hit is out.
///
/// # Errors
/// Illegal parameters, or a ray that never comes out, or comes out undefined.
pub fn record(design: &Design, pyramid: &Pyramid, ray: &RayInput) -> Result<(RayHit, Wave)> {
    let p = Pipeline::new(design, &Binding::new())?;
    let net = &p.net;
    let (mut sim, mut wave) = (Tracked::new(net), Wave::new(net));
    let image: Vec<u64> = pyramid.memory().iter().map(|w| u64::from(*w)).collect();
    sim.load(0, &image);
    let row = [ray.u, ray.v, ray.du, ray.dv];
    net.inputs.iter().for_each(|i| sim.set(i.slot, 0));
    INPUTS.iter().zip(row).for_each(|(n, v)| sim.set(net.input(n), v));
    sim.set(net.input("out_ready"), 1);
    let limit = u64::from(p.slots) * u64::from(design.traverse.step_limit + 2) + u64::from(p.depth) + 4;
    for clock in 0..limit {
        sim.set(net.input("rst"), u64::from(clock == 0));
        sim.set(net.input("in_valid"), u64::from(clock == 1));
        sim.eval();
        wave.sample(&sim);
        let valid = sim.get(net.output("out_valid"));
        if clock > 0 && valid.1 != 0 {
            return Err(Error::Mismatch(format!("out_valid is undefined in clock {clock}")));
        }
        if clock > 0 && valid.0 == 1 {
            let outs: Vec<_> = OUTPUTS.iter().map(|n| sim.get(net.output(n))).collect();
            if let Some(k) = outs.iter().position(|o| o.1 != 0) {
                return Err(Error::Mismatch(format!("{} has undefined bits in clock {clock}", OUTPUTS[k])));
            }
            let words: Vec<u64> = outs.iter().map(|o| o.0).collect();
            return Ok((super::interp::hit(&words), wave));
        }
        sim.clock();
    }
    Err(Error::Dropped("the ray never came out".into()))
}
