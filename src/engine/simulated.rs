//! A simulator as an engine: it runs the emitted text under its bench.
use super::run::{Checked, Engine, Replay, SlotLoad, Traced};
use super::stored::{memory, memory_files, pyramid_of, ray_of};
use crate::bench::{Outcome, Paths, Simulator, bench_files, run_bench_on};
use crate::catalogue::{decoded, design_at, ray_set, takes_rays};
use crate::config::{Config, Design};
use crate::emit::{hardware, write_tree};
use crate::error::{Error, Result};
use crate::files::Scratch;
use crate::golden::{Pyramid, RayHit, RayInput};
use crate::ir::{Binding, Module};
use crate::trace::{hit, outputs, wrong_iteration};
use crate::vectors::set_files;

/// A simulator.
pub(super) struct Simulated(pub Simulator);

/// The plusargs with which a bench of `traverse` runs its set once more in rough traffic.
fn rough(m: &Module) -> &'static [&'static str] {
    if takes_rays(m) { &["again"] } else { &[] }
}

impl Engine for Simulated {
    fn name(&self) -> &'static str {
        self.0.name()
    }

    fn needs(&self) -> Vec<String> {
        self.0.programs()
    }

    fn reads_text(&self) -> bool {
        true
    }

    fn replay(&self, r: &Replay<'_>) -> Result<Checked> {
        let m = r.unit;
        let spoiled = Scratch::new()?;
        let mut from = r.place.canonicalize().map_err(|e| Error::file("find", r.place, e))?;
        if r.spoiled {
            for (name, text) in set_files(r.set) {
                crate::files::write_atomic(spoiled.path().join(name), text.as_bytes())?;
            }
            if takes_rays(m) {
                for name in memory_files(&from) {
                    let memory = from.join(&name);
                    std::fs::copy(&memory, spoiled.path().join(&name)).map_err(|e| Error::file("copy", memory, e))?;
                }
            }
            from = spoiled.path().to_path_buf();
        }
        let paths = Paths { vectors: Some(from), ..Paths::default() };
        let o =
            run_bench_on(self.0, r.tree, &m.name, r.over, &paths, rough(m)).map_err(|e| self.located(e, r, &paths))?;
        let note = o.output.lines().find(|l| l.starts_with("slots busy")).unwrap_or_default().to_string();
        Ok(Checked { unit: m.name.clone(), rows: o.checked, slots: SlotLoad::read(&note), note })
    }

    fn trace(&self, c: &Config, pyramid: &Pyramid, rays: &[RayInput]) -> Result<Traced> {
        let p = hardware(c)?;
        let t = &p.traverse;
        let set = ray_set(&c.design(), pyramid, rays, c.vectors.seed)?;
        let mut files = p.files;
        files.extend(bench_files(&[], Some((&c.design(), t)), &c.emit));
        files.extend(set_files(&set.set).into_iter().map(|(n, text)| (format!("golden/traverse/{n}"), text)));
        files.extend(set.memory_files().map(|(n, text)| (format!("golden/traverse/{n}"), text.clone())));
        let work = Scratch::new()?;
        let tree = work.path().join("tree");
        write_tree(&tree, &files)?;
        let results = work.path().join("results.txt");
        let paths = Paths { results: Some(results.clone()), ..Paths::default() };
        let Outcome { build, run, .. } = run_bench_on(self.0, &tree, &t.module.name, &Binding::new(), &paths, &[])?;
        let text = std::fs::read_to_string(&results).map_err(|e| Error::file("read", &results, e))?;
        let hits = self.hits(&c.design(), &text, rays.len(), outputs(&t.module).len())?;
        Ok(Traced { hits, build, run })
    }
}

impl Simulated {
    /// The hits of `rays` rays from what a bench wrote: a line a ray, its number and `words` words in hex.
    fn hits(&self, d: &Design, text: &str, rays: usize, words: usize) -> Result<Vec<RayHit>> {
        let mut hits = vec![RayHit::default(); rays];
        let broken = || Error::ToolFailed(format!("{} wrote results that can't be read", self.name()));
        for line in text.lines() {
            let mut fields = line.split_whitespace();
            let ray: usize = fields.next().and_then(|w| w.parse().ok()).ok_or_else(broken)?;
            let row = fields.map(|w| u64::from_str_radix(w, 16).map_err(|_| broken())).collect::<Result<Vec<u64>>>()?;
            let place = hits.get_mut(ray).filter(|_| row.len() == words).ok_or_else(broken)?;
            *place = hit(d, &row);
        }
        Ok(hits)
    }

    /// What a bench said, decoded; a mismatch of `traverse` with its first wrong iteration, for which the bench runs once more.
    fn located(&self, e: Error, r: &Replay<'_>, paths: &Paths) -> Error {
        let m = r.unit;
        let decoded = decoded(e, r.set, m);
        let Error::Mismatch(found) = decoded else { return decoded };
        let vector = found.place.as_ref().map(|p| p.vector);
        let again = |number: usize| -> Result<String> {
            let work = Scratch::new()?;
            let seen = work.path().join("iterations");
            // It fails as it did before.
            let paths = Paths { iterations: Some(seen.clone()), ..paths.clone() };
            let _ = run_bench_on(self.0, r.tree, &m.name, r.over, &paths, rough(m));
            let iterations = std::fs::read_to_string(&seen).map_err(|e| Error::file("read", &seen, e))?;
            let d = &design_at(r.design, &r.set.params);
            let pyramid = pyramid_of(d, &memory(r.place)?)?;
            wrong_iteration(d, &pyramid, &ray_of(&r.set.stimulus[number]), number, &iterations)
        };
        Error::Mismatch(match vector.filter(|_| takes_rays(m)).map(again) {
            Some(Ok(more)) => found.and(more),
            // A tree without these signals (a netlist, say) has nothing more to tell.
            Some(Err(_)) | None => found,
        })
    }
}
