//! Vector sets of `traverse`: rays, a height pyramid, expected hits, and every iteration on the way.
use super::design_at;
use crate::config::{Design, Trim};
use crate::error::Result;
use crate::golden::{Iteration, Pyramid, RayHit, RayInput, images, prepare};
use crate::ir::{Binding, Module};
use crate::trace::{hit_row, inputs, outputs, row};
use crate::units::traversal::traverse;
use crate::vectors::{Column, Counts, Iterations, VectorSet};
use std::collections::BTreeMap;
use std::fmt::Write;

/// A set of rays over a map.
pub struct RaySet {
    /// Rays and expected hits.
    pub set: VectorSet,
    /// The pyramid, `$readmemh` text: a word a line; empty where the map has several memories.
    pub memory: String,
    /// Where hits are refined, the words of the four memories of the map; of four cells at once those of each of the four siblings; of a map in several memories those of each; as `$readmemh` text.
    pub banks: Vec<String>,
    /// Every iteration of every ray, CSV.
    pub trace: String,
}

impl RaySet {
    /// The text files of the memories by their names in a directory of vectors: `memory.hex`, and of each bank that name with its number after it.
    pub fn memory_files(&self) -> impl Iterator<Item = (String, &String)> {
        let banks = self.banks.iter().enumerate().map(|(k, text)| (format!("memory.hex.{k}"), text));
        let whole = Some(("memory.hex".to_string(), &self.memory)).filter(|_| !self.memory.is_empty());
        whole.into_iter().chain(banks)
    }
}

/// Input and output columns of `traverse` at parameter values `b`.
pub fn ray_columns(m: &Module, b: &Binding) -> (Vec<Column>, Vec<Column>) {
    let column = |name: &&str| {
        let port = m.port(name).expect("traverse has its ports").1;
        Column { name: name.to_string(), width: port.width.eval(b) as u32 }
    };
    (inputs(m).iter().map(column).collect(), outputs(m).iter().map(column).collect())
}

/// The golden model's hits of `rays`, with the per-iteration trace.
///
/// # Errors
/// An illegal design.
pub fn ray_set(d: &Design, pyramid: &Pyramid, rays: &[RayInput], seed: u64) -> Result<RaySet> {
    ray_set_at(d, &Binding::new(), pyramid, [&[], rays], seed)
}

/// As [`ray_set`], with `over` put over the parameters; rays are planned ones, then those of cameras.
///
/// # Errors
/// As [`ray_set`].
pub fn ray_set_at(
    design: &Design,
    over: &Binding,
    pyramid: &Pyramid,
    [planned, seen]: [&[RayInput]; 2],
    seed: u64,
) -> Result<RaySet> {
    let m = &*traverse(design).module;
    let params = m.binding_with(over);
    let d = &design_at(design, &params);
    let rays = [planned, seen].concat();
    let g = prepare(d)?;
    // Where the design trims, the level of the node that was read stands at the end of the line.
    let trims = d.mode.trim != Trim::None;
    let mut trace = format!("ray,step,level,x,y,height,t,decision{}\n", if trims { ",read" } else { "" });
    let mut expected = Vec::with_capacity(rays.len());
    let (mut events, mut iterations) = (Reached::default(), Iterations::default());
    for (k, r) in rays.iter().enumerate() {
        let mut step = 0;
        let mut line = |i: &Iteration| {
            let (x, y) = (i.x, i.y);
            let read = if trims { format!(",{}", i.chord.map_or(i.level, |c| c.level)) } else { String::new() };
            writeln!(trace, "{k},{step},{},{x},{y},{},{:x},{:?}{read}", i.level, i.height, i.t, i.decision)
                .expect("writing to a string can't fail");
            step += 1;
        };
        let h = g.trace_with(pyramid, r, Some(&mut line));
        events.count(d, r, &h);
        iterations.most = iterations.most.max(h.steps);
        iterations.sum = iterations.sum.wrapping_add(h.steps);
        expected.push(hit_row(d, &h));
    }
    let names = inputs(m);
    let (inputs, outputs) = ray_columns(m, &params);
    let set = VectorSet {
        unit: m.name.clone(),
        params,
        seed,
        counts: Counts { corners: planned.len(), rays: seen.len(), ..Counts::default() },
        planned: !planned.is_empty(),
        events: events.0,
        iterations: (!d.gives_steps()).then_some(iterations),
        inputs,
        outputs,
        stimulus: rays.iter().map(|r| row(&names, r)).collect(),
        expected,
        ..VectorSet::default()
    };
    let digits = d.traverse.height_bits.div_ceil(4) as usize;
    let image = |head: &str, words: &mut dyn Iterator<Item = &u32>| {
        words.fold(format!("// {head}\n"), |mut text, w| {
            writeln!(text, "{w:0digits$x}").expect("writing to a string can't fail");
            text
        })
    };
    let mut images: Vec<String> =
        images(d, pyramid).iter().map(|one| image(&one.about, &mut one.words.iter())).collect();
    if images.len() > 1 {
        return Ok(RaySet { set, memory: String::new(), banks: images, trace });
    }
    let memory = images.pop().unwrap_or_default();
    let texels = 1usize << (2 * d.traverse.levels);
    // Of four cells all but the root, of a refined hit the map alone.
    let (words, of) = match d.fetch.blocks() {
        true => (pyramid.memory().len() - 1, "height pyramid: every fourth word"),
        false => (texels, "texels of the map: every fourth word of level 0"),
    };
    let bank = |k: usize| {
        let head = format!("{of}, from word {k} on");
        image(&head, &mut pyramid.memory()[..words].iter().skip(k).step_by(4))
    };
    let banks = if d.mode.bilinear || d.fetch.blocks() { (0..4).map(bank).collect() } else { Vec::new() };
    Ok(RaySet { set, memory, banks, trace })
}

/// How many rays reach what, by name.
#[derive(Default)]
struct Reached(BTreeMap<String, usize>);

impl Reached {
    fn count(&mut self, d: &Design, r: &RayInput, h: &RayHit) {
        let refused = h.limit && h.steps == 0;
        let still = |travel: u64| d.words().is_zero(travel);
        let found = [
            ("refused: not a ray", refused),
            ("given up at the step limit", h.limit && !refused),
            ("hit in the last step before the limit", !h.limit && h.steps == d.traverse.step_limit),
            ("hit in the first step", !h.limit && h.steps == 1),
            ("hit on a top", !h.limit && !h.wall),
            ("hit on a wall", h.wall),
            ("moves along no axis", !refused && still(r.du) && still(r.dv)),
            ("moves along one axis", !refused && still(r.du) != still(r.dv)),
            ("goes up levels", h.ups > 0),
            ("with a level of detail", r.lod > 0),
        ];
        found.into_iter().filter(|f| f.1).for_each(|(name, _)| *self.0.entry(name.to_string()).or_default() += 1);
    }
}
