//! What the committed vectors let live: every such mutant is judged, and `data/mutants.json` says how. It computes the same as its original for
//! every legal operand, or not, with operands that show it, or the comparison did not end in a minute (`RELIEFRTL_SECONDS` sets another limit).
//! Where it is inside of a part that is a unit, that unit's vectors may notice it: then the larger unit gives the part no operands that do, and it
//! is counted. What is proved of a part holds wherever it is.
//! `RELIEFRTL_REFRESH=1 cargo test --release --test proofs survivors -- --ignored` writes the file anew; of a netlist that it knows it takes the
//! proofs over.
use super::aig::Aig;
use super::blast::Bits;
use super::equal::{Verdict, compare_legal};
use super::legal::legal;
use super::parts::copies;
use super::{Survivor, mutate};
use rayon::prelude::*;
use reliefrtl::catalogue::{Context, Modelled, check_netlist, units, vector_set};
use reliefrtl::config::Design;
use reliefrtl::interp::{Netlist, elaborate};
use reliefrtl::ir::{Binding, Module};
use reliefrtl::vectors::{Plan, VectorSet, read_set};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Seconds of processor time for one comparison; 0: none is made.
fn seconds() -> u32 {
    std::env::var("RELIEFRTL_SECONDS").map_or(60, |v| v.parse().expect("a number of seconds"))
}

/// Rows that look for operands before a proof does.
const MORE: Plan = Plan { rows: 10_000, seed: 99 };
/// Survivors that are not the original, and those of which nothing is known, at most.
const MOST: [usize; 2] = [0, 0];

/// The mutants of a unit.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct Judged {
    unit: String,
    /// Digest of the netlist that was mutated.
    netlist: String,
    mutants: usize,
    /// Survivors inside of a part whose own vectors notice them.
    in_parts: usize,
    /// Survivors that are proved to compute the same.
    equal: Vec<String>,
    /// Survivors for which the comparison did not end.
    undecided: Vec<String>,
    /// Survivors that compute something else, and words of the inputs that show it.
    different: BTreeMap<String, String>,
}

impl Judged {
    fn survivors(&self) -> BTreeSet<&str> {
        let names = self.equal.iter().chain(&self.undecided).chain(self.different.keys());
        names.map(String::as_str).collect()
    }
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn file() -> PathBuf {
    root().join("data/mutants.json")
}

fn stored() -> Vec<Judged> {
    serde_json::from_str(&std::fs::read_to_string(file()).unwrap()).unwrap()
}

/// Digest of what a netlist computes, whatever its nets are called.
fn digest(net: &Netlist) -> String {
    let all = format!("{:?} {:?} {:?} {:?} {:?}", net.widths, net.consts, net.ops, net.regs, net.inputs);
    blake3::hash(all.as_bytes()).to_hex()[..32].to_owned()
}

/// A unit of the default design and what its committed vectors let live.
struct Unit {
    module: Arc<Module>,
    net: Netlist,
    mutants: usize,
    survivors: Vec<Survivor>,
}

/// Where a survivor is in a part: the mutant of the part by its name, where the part's own vectors let it live, too.
struct InPart<'a> {
    unit: &'a str,
    lives: Option<&'a str>,
}

/// What is known of each survivor of `u` from the units that are parts of it.
fn in_parts<'a>(u: &Unit, all: &'a [Unit]) -> BTreeMap<String, Vec<InPart<'a>>> {
    let mut found: BTreeMap<String, Vec<InPart<'a>>> = BTreeMap::new();
    for part in all.iter().filter(|p| p.module.name != u.module.name && p.mutants > 0) {
        for ops in copies(&u.net, &part.net) {
            for s in &u.survivors {
                let Some(op) = ops.get(&s.op) else { continue };
                let lives = part.survivors.iter().find(|other| other.op == *op && other.what == s.what);
                let place = InPart { unit: &part.module.name, lives: lives.map(|l| l.name.as_str()) };
                found.entry(s.name.clone()).or_default().push(place);
            }
        }
    }
    found
}

/// Whether the vectors of a part notice a survivor.
fn is_noticed(s: &Survivor, places: &BTreeMap<String, Vec<InPart<'_>>>) -> bool {
    places.get(&s.name).is_some_and(|at| at.iter().any(|p| p.lives.is_none()))
}

impl Unit {
    fn of(module: Arc<Module>) -> Self {
        let net = elaborate(&module, &Binding::new()).unwrap();
        let set = read_set(&root().join("golden").join(&module.name)).unwrap().0;
        let (mutants, survivors) = mutate(&net, module.latency().unwrap() as usize, &set);
        Self { module, net, mutants, survivors }
    }

    fn mismatched(&self, mutant: &Netlist, set: &VectorSet) -> Option<usize> {
        let report = check_netlist(mutant, self.module.latency().unwrap() as usize, set).unwrap();
        report.first.map(|m| m.vector)
    }

    /// The words of the data ports among those of all inputs.
    fn data(&self, words: &[u64]) -> Vec<u64> {
        let word = |name: &str| words[self.net.inputs.iter().position(|p| p.name == name).unwrap()];
        self.module.data_inputs().map(|(_, p)| word(&p.name)).collect()
    }

    /// What a mutant is, by more rows and then by proof.
    fn judge(&self, s: &Survivor, more: &VectorSet) -> Verdict {
        if let Some(row) = self.mismatched(&s.net, more) {
            return Verdict::Different(more.stimulus[row].clone());
        }
        let (d, unit) = (Design::default(), &self.module.name);
        let condition = |g: &mut Aig, ports: &BTreeMap<&str, Bits>| legal(unit, d.traverse.levels, g, ports);
        if seconds() == 0 {
            return Verdict::Open;
        }
        let words = match compare_legal(&self.net, &s.net, &condition, seconds()) {
            Verdict::Different(words) => words,
            same_or_open => return same_or_open,
        };
        // The condition lets nothing through that the catalogue would change, and the interpreter sees the difference, too.
        let row = self.data(&words);
        let binding = self.module.binding_with(&Binding::new());
        let (model, c) = (Modelled::of(&d, &self.module), Context::new(d, &binding));
        assert_eq!(model.legal(&c, row.clone()), row, "{unit} {}", s.name);
        let set = VectorSet { expected: vec![model.results(&c, &row)], stimulus: vec![row.clone()], ..more.clone() };
        assert!(self.mismatched(&s.net, &set).is_some(), "{unit} {}: {row:x?}", s.name);
        Verdict::Different(row)
    }

    /// All survivors besides those that a part's vectors notice; what `known` has a proof of is not proved again.
    fn judged(&self, known: &BTreeSet<&str>, places: &BTreeMap<String, Vec<InPart<'_>>>) -> Judged {
        let start = std::time::Instant::now();
        let more = vector_set(&Design::default(), &self.module, &Binding::new(), MORE);
        let judge = |s: &Survivor| match known.contains(s.name.as_str()) {
            true => Verdict::Same,
            false => self.judge(s, &more),
        };
        let own: Vec<&Survivor> = self.survivors.iter().filter(|s| !is_noticed(s, places)).collect();
        let verdicts: Vec<(&String, Verdict)> = own.par_iter().map(|s| (&s.name, judge(s))).collect();
        let those = |what: Verdict| verdicts.iter().filter(|v| v.1 == what).map(|v| v.0.clone()).collect();
        let example = |(name, verdict): &(&String, Verdict)| match verdict {
            Verdict::Different(row) => {
                Some(((*name).clone(), row.iter().map(|w| format!("{w:x}")).collect::<Vec<_>>().join(" ")))
            }
            _ => None,
        };
        let j = Judged {
            unit: self.module.name.clone(),
            netlist: digest(&self.net),
            mutants: self.mutants,
            in_parts: self.survivors.len() - own.len(),
            equal: those(Verdict::Same),
            undecided: those(Verdict::Open),
            different: verdicts.iter().filter_map(example).collect(),
        };
        let counts = [j.equal.len(), j.different.len(), j.undecided.len()];
        let [equal, different, undecided] = counts;
        let killed = j.mutants - self.survivors.len();
        println!(
            "{:<17} {killed} of {} killed, {} by vectors of parts, {equal} equal, {different} different, {undecided} undecided ({:.1?})",
            j.unit,
            j.mutants,
            j.in_parts,
            start.elapsed()
        );
        j
    }
}

fn all_units() -> Vec<Unit> {
    units(&Design::default()).into_iter().map(Unit::of).collect()
}

#[test]
fn committed_vectors_kill_the_mutants() {
    let (all, stored) = (all_units(), stored());
    let total: usize = all.iter().map(|u| u.mutants).sum();
    assert!(total > 1000, "only {total} mutants");
    let mut problems = Vec::new();
    for u in &all {
        let name = &u.module.name;
        let Some(j) = stored.iter().find(|j| j.unit == *name && j.netlist == digest(&u.net)) else {
            problems.push(format!("{name}: its mutants were judged of another netlist"));
            continue;
        };
        let places = in_parts(u, &all);
        let now: BTreeSet<&str> =
            u.survivors.iter().filter(|s| !is_noticed(s, &places)).map(|s| s.name.as_str()).collect();
        if u.survivors.len() - now.len() != j.in_parts {
            problems.push(format!("{name}: {} survivors are noticed in parts", u.survivors.len() - now.len()));
        }
        let then = j.survivors();
        problems.extend(now.difference(&then).map(|s| format!("{name}: {s} lives and was not judged")));
        problems.extend(then.difference(&now).map(|s| format!("{name}: {s} is killed, and is still in the file")));
    }
    assert!(problems.is_empty(), "{} (the first lines of this file say how they are judged)", problems.join("\n"));
    let count = |of: fn(&Judged) -> usize| stored.iter().map(of).sum::<usize>();
    assert_eq!((stored.len(), count(|j| j.mutants)), (all.len(), total));
    let left = [count(|j| j.different.len()), count(|j| j.undecided.len())];
    assert!(left[0] <= MOST[0] && left[1] <= MOST[1], "{left:?} are different, undecided; at most {MOST:?} were");
}

/// The condition under which mutants are compared keeps no operand out that the vectors have.
#[test]
fn committed_rows_meet_the_condition() {
    for m in units(&Design::default()) {
        let set = read_set(&root().join("golden").join(&m.name)).unwrap().0;
        let widths: Vec<u32> = set.inputs.iter().map(|c| c.width).collect();
        let mut g = Aig::new(widths.iter().sum());
        let (mut next, mut ports) = (0, BTreeMap::new());
        for column in &set.inputs {
            ports.insert(column.name.as_str(), (next..next + column.width).map(|k| g.input(k)).collect::<Bits>());
            next += column.width;
        }
        let condition = legal(&m.name, Design::default().traverse.levels, &mut g, &ports);
        for row in &set.stimulus {
            let bit = |(word, w): (&u64, &u32)| (0..*w).map(|k| word >> k & 1 == 1).collect::<Vec<_>>();
            let bits: Vec<bool> = row.iter().zip(&widths).flat_map(bit).collect();
            assert!(g.value(condition, &bits), "{}: {row:x?}", m.name);
        }
    }
}

/// Every survivor once more, by proof; `RELIEFRTL_UNITS` names the units that are judged, the others stay as they are.
#[test]
#[ignore = "minutes of proving; part of sh tools/test.sh --full"]
fn survivors_are_judged() {
    let old = std::fs::read_to_string(file()).map_or(Vec::new(), |text| serde_json::from_str(&text).unwrap());
    let refresh = std::env::var("RELIEFRTL_REFRESH").is_ok_and(|v| v == "1");
    let named = std::env::var("RELIEFRTL_UNITS").ok();
    let is_named = |unit: &str| named.as_ref().is_none_or(|n| n.split(',').any(|name| name == unit));
    let mut all: BTreeMap<String, Judged> = old.into_iter().map(|j: Judged| (j.unit.clone(), j)).collect();
    let units = all_units();
    all.retain(|name, _| units.iter().any(|u| u.module.name == *name));
    let mut problems = Vec::new();
    // Leaves first, so parts are judged before what they are in.
    for u in units.iter().filter(|u| is_named(&u.module.name)) {
        let then = all.get(&u.module.name).filter(|j| j.netlist == digest(&u.net));
        let places = in_parts(u, &units);
        let is_present = |j: &&Judged| units.iter().any(|u| u.module.name == j.unit && digest(&u.net) == j.netlist);
        let equal = |unit: &str| all.get(unit).filter(is_present).map_or(&[][..], |j| &j.equal);
        let proved = |p: &InPart<'_>| p.lives.is_some_and(|name| equal(p.unit).iter().any(|e| e == name));
        let of_parts = places.iter().filter(|(_, at)| at.iter().any(proved)).map(|(name, _)| name.as_str());
        let before = then.filter(|_| refresh).into_iter().flat_map(|j| &j.equal).map(String::as_str);
        let now = u.judged(&of_parts.chain(before).collect(), &places);
        problems.extend((then != Some(&now)).then(|| u.module.name.clone()));
        all.insert(u.module.name.clone(), now);
        if refresh {
            let all: Vec<&Judged> = all.values().collect();
            std::fs::write(file(), serde_json::to_string_pretty(&all).unwrap() + "\n").unwrap();
        }
    }
    assert!(refresh || problems.is_empty(), "{problems:?} are judged otherwise than in {:?}", file());
}
