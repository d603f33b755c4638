//! Where rays are inside of `traverse`, for the proofs that count them.
use crate::units::traversal::Traverse;
use std::fmt::Write;

/// What stands in the way of ready (`latency.handshake`).
#[derive(Clone, Copy, PartialEq, Eq)]
enum Between {
    Nothing,
    Skids,
    Queues,
}

/// The places of `traverse` that hold a ray, and how the script ties the harness to them.
pub(super) struct Flights {
    between: Between,
    /// The choice of the ray that leaves has a register.
    decided: bool,
    last: u32,
    /// Nets of valid bits and tags: setup, loop, hit.
    parts: [Vec<(String, String)>; 3],
}

impl Flights {
    pub(super) fn of(t: &Traverse, handshake: u32) -> Self {
        let slot = |k: u32| match k {
            0 => ("s0_back_valid".into(), "s0_back_tag".into()),
            _ => (format!("s{k}_valid"), format!("s{k}_tag")),
        };
        let mut setup: Vec<_> =
            (1..=t.setup).map(|k| (format!("u_setup_delay.s{k}_valid"), format!("u_setup_delay.s{k}_data"))).collect();
        let mut hit: Vec<_> =
            (1..=t.finish).map(|k| (format!("u_hit_valid.s{k}_valid"), format!("u_hit_tag.s{k}_data"))).collect();
        let between = match handshake {
            0 => Between::Nothing,
            1 | 2 => Between::Skids,
            _ => Between::Queues,
        };
        if between == Between::Skids {
            for (list, unit) in [(&mut setup, "u_setup_skid"), (&mut hit, "u_hit_skid")] {
                // Their words are looked after by the proof of stream_skid.
                list.extend(["first", "second"].map(|k| (format!("{unit}.{k}_valid"), String::new())));
            }
        }
        Self {
            between,
            decided: handshake > 1,
            last: t.slots - 1,
            parts: [setup, (0..t.slots).map(slot).collect(), hit],
        }
    }

    /// Rays are counted whatever their tags: where something stands in the way of ready, that thing's own proof says that words stay with
    /// their rays.
    pub(super) fn counts(&self) -> bool {
        self.between != Between::Nothing
    }

    /// Words of the template.
    pub(super) fn value(&self) -> minijinja::Value {
        let [setup, slots, hit] = [0, 1, 2].map(|k| self.parts[k].len());
        // In the order in which rays pass; the loop's first register comes after its last. The places of skids are no part of a row.
        let skid = if self.between == Between::Skids { 2 } else { 0 };
        let rows: [Vec<usize>; 3] =
            [(0..setup - skid).collect(), (1..slots).chain([0]).collect(), (0..hit - skid).collect()];
        minijinja::context! {
            queues => self.between == Between::Queues, decided => self.decided,
            rows => rows, parts => [("setup", setup), ("loop", slots), ("hit", hit)],
        }
    }

    pub(super) fn len(&self) -> usize {
        self.parts.iter().map(Vec::len).sum()
    }

    /// When a ray is done is left open, so what is proved holds whatever the datapath computes.
    pub(super) fn script(&self) -> String {
        let free = if self.decided { format!("s{}_ends", self.last) } else { "s0_back_done".into() };
        let mut s = format!("cutpoint w:dut.{free}\n");
        let mut tie = |to: String, from: &str| {
            writeln!(s, "connect -nounset -set {to} \\dut.{from}").expect("writing to a string");
        };
        if !self.counts() {
            // In the order of the loop, the setup and the hit.
            let [setup, slots, hit] = &self.parts;
            for (k, (valid, tag)) in slots.iter().chain(setup).chain(hit).enumerate() {
                tie(format!("holds_{k}"), valid);
                tie(format!("tag_{k}"), tag);
            }
        } else {
            for (part, name) in self.parts.iter().zip(["setup", "loop", "hit"]) {
                part.iter().enumerate().for_each(|(k, (valid, _))| tie(format!("{name}_{k}"), valid));
            }
            tie("leaves".into(), "s0_leaves");
            let (unit, registers): (_, &[&str]) = match self.between {
                Between::Queues => ("queue", &["taken", "held", "has_room", "has_set_out", "has_gone", "is_offered"]),
                _ => ("skid", &["is_ready", "some_valid", "awake", "writes_second", "reads_second"]),
            };
            for door in ["setup", "hit"] {
                registers.iter().for_each(|r| tie(format!("{door}_{r}"), &format!("u_{door}_{unit}.{r}")));
            }
        }
        s
    }
}
