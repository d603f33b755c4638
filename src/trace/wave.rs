//! One ray through the pipeline from power-up, undefined values tracked, as a waveform.
use super::diagnose::{Divergence, diagnose};
use super::interp::{Pipeline, hit, row};
use crate::bits::mask;
use crate::config::Design;
use crate::error::{Error, Result};
use crate::golden::{Pyramid, RayHit, RayInput};
use crate::interp::{Netlist, Tracked, Wave};
use crate::ir::Binding;

/// Traces `ray` from power-up and records every net of `traverse` until the hit is out.
///
/// # Errors
/// Illegal parameters, or a ray that never comes out, or comes out undefined.
pub fn record(design: &Design, pyramid: &Pyramid, ray: &RayInput) -> Result<(RayHit, Wave)> {
    let p = Pipeline::new(design, &Binding::new())?;
    let (hit, wave) = record_ray(&p, design, pyramid, ray, Wave::new(&p.net), None)?;
    Ok((hit.unwrap_or_default(), wave))
}

/// Clocks around something that was seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Window {
    /// The clock; reset is clock 0.
    pub at: u64,
    /// Clocks up to it, itself included.
    pub before: usize,
    /// Clocks after it.
    pub after: usize,
}

/// Traces `ray` from power-up into `wave` (which chooses the nets): all clocks until the hit is out, or a window, however
/// the ray ends.
///
/// # Errors
/// Without a window as [`record`].
pub fn record_ray(
    p: &Pipeline,
    design: &Design,
    pyramid: &Pyramid,
    ray: &RayInput,
    wave: Wave,
    window: Option<Window>,
) -> Result<(Option<RayHit>, Wave)> {
    let net = &p.net;
    let mut wave = if let Some(w) = window { wave.window(w.before) } else { wave };
    let mut sim = Tracked::new(net);
    p.images(pyramid).iter().enumerate().for_each(|(k, words)| sim.load(k, words));
    net.inputs.iter().for_each(|i| sim.set(i.slot, 0));
    sim.set(net.input("out_ready"), 1);
    let data: Vec<_> = p.inputs.iter().map(|n| net.input(n)).collect();
    let limit = u64::from(p.slots) * u64::from(design.traverse.step_limit + 2) + u64::from(p.depth) + 12;
    let (mut hit, mut accepted) = (None, false);
    for clock in 0..limit {
        sim.set(net.input("rst"), u64::from(clock == 0));
        let valid = clock > 0 && !accepted;
        sim.set(net.input("in_valid"), u64::from(valid));
        for (s, v) in data.iter().zip(row(&p.inputs, ray)) {
            // In the other clocks no ray is valid, and what is on the wires is unknown.
            sim.set_bits(*s, if valid { (v, 0) } else { (0, mask(net.widths[*s as usize])) });
        }
        sim.eval();
        // A handshake through registers is not ready in the first clock after reset: the ray is valid until it transfers.
        accepted |= valid && sim.get(net.output("in_ready")) == (1, 0);
        wave.sample(&sim);
        match window {
            None => {
                hit = result(p, &sim, clock)?;
                if hit.is_some() {
                    return Ok((hit, wave));
                }
            }
            Some(w) => {
                hit = hit.or(result(p, &sim, clock).unwrap_or_default());
                if clock == w.at {
                    wave.trigger(w.after);
                }
                if wave.is_complete() {
                    return Ok((hit, wave));
                }
            }
        }
        sim.clock();
    }
    Err(Error::Dropped(format!("{limit} clocks were not enough for the ray")))
}

/// Replays `rows` (words of the inputs named in `ports`) in a unit of fixed latency, a row a clock from power-up, and records the clocks
/// around the one in which row `at` comes out: as many as the unit has stages, and `margin` on both sides.
pub fn record_rows(
    net: &Netlist,
    latency: Option<u32>,
    ports: &[&str],
    rows: &[Vec<u64>],
    at: usize,
    margin: usize,
) -> Wave {
    let (latency, has_state) = (latency.unwrap_or(0) as usize, latency.is_none());
    let mut wave = Wave::new(net).window(latency + margin + 1);
    let mut sim = Tracked::new(net);
    if let Some(ce) = net.inputs.iter().find(|p| p.name == "ce") {
        sim.set(ce.slot, 1);
    }
    let slots: Vec<_> = ports.iter().map(|n| net.input(n)).collect();
    // Rows long before have left a pipeline; a state is that of all rows since reset.
    let first = if has_state { 0 } else { at.saturating_sub(latency + margin + 1) };
    if let Some(rst) = net.inputs.iter().find(|p| p.name == "rst") {
        slots.iter().for_each(|s| sim.set(*s, 0));
        for reset in [1, 0] {
            sim.set(rst.slot, reset);
            sim.eval();
            sim.clock();
        }
    }
    for clock in 0.. {
        let row = rows.get(first + clock);
        for (k, s) in slots.iter().enumerate() {
            sim.set_bits(*s, row.map_or((0, mask(net.widths[*s as usize])), |r| (r[k], 0)));
        }
        sim.eval();
        wave.sample(&sim);
        if clock == at - first + latency {
            wave.trigger(margin);
        }
        if wave.is_complete() {
            break;
        }
        sim.clock();
    }
    wave
}

/// The hit that stands at the output.
fn result(p: &Pipeline, sim: &Tracked<'_>, clock: u64) -> Result<Option<RayHit>> {
    if clock == 0 {
        return Ok(None);
    }
    let net = &p.net;
    let undefined = |name: &str| Error::mismatch(format!("{name} has undefined bits in clock {clock}"));
    let known = |name: &str| match sim.get(net.output(name)) {
        (v, 0) => Ok(v),
        _ => Err(undefined(name)),
    };
    let [valid, ..] = [known("out_valid")?, known("in_ready")?, known("slot_busy")?];
    if valid == 0 {
        return Ok(None);
    }
    let words = p.outputs.iter().map(|n| known(n)).collect::<Result<Vec<u64>>>()?;
    Ok(Some(hit(&p.design, &words)))
}

/// Compares `ray` with the golden model, net by net, and records `before` and `after` clocks around the first difference;
/// `None` if there is none.
///
/// # Errors
/// As [`record`].
pub fn record_mismatch(
    design: &Design,
    pyramid: &Pyramid,
    ray: &RayInput,
    before: usize,
    after: usize,
) -> Result<Option<(Divergence, Wave)>> {
    let Some(found) = diagnose(design, pyramid, ray)? else { return Ok(None) };
    let p = Pipeline::new(design, &Binding::new())?;
    let window = Window { at: found.clock, before, after };
    let (_, wave) = record_ray(&p, design, pyramid, ray, Wave::new(&p.net), Some(window))?;
    Ok(Some((found, wave)))
}
