//! Where rays are inside of `traverse`, for the proofs that count them.
use crate::ir::{Binding, Module};
use crate::units::stream::Decoupling;
use crate::units::traversal::Traverse;
use crate::verilog::delayed_net;
use std::fmt::Write;

/// The registers of `traverse` that hold a ray, and how the script ties the harness to them.
pub(super) struct Flights {
    decoupling: Decoupling,
    /// The decision which ray retires is registered.
    registered: bool,
    last: u32,
    /// Nets of valid bits and tags: setup, loop, hit.
    parts: [Vec<(String, String)>; 3],
}

/// The net, or the part of one, that carries the low `bits` of a value in a stage. Where a memory holds it instead (`latency.delay_line`), the
/// name that a register would have.
fn net(m: &Module, at: &Binding, value: &str, stage: u32, bits: u32) -> String {
    delayed_net(m, at, value, stage, (0, bits)).unwrap_or_else(|| format!("s{stage}_{value}"))
}

impl Flights {
    pub(super) fn of(t: &Traverse, handshake: u32, tag_w: u32) -> Self {
        let top = t.module.default_binding();
        let slot = |k: u32| match k {
            0 => ("s0_loop_valid_q".into(), "s0_loop_tag_q".into()),
            _ => (net(&t.module, &top, "valid", k, 1), net(&t.module, &top, "tag", k, tag_w)),
        };
        let below = |unit: &str, value: &str, k: u32, bits: u32| {
            let inst = t.module.insts.iter().find(|i| i.name == unit);
            let inst = inst.unwrap_or_else(|| panic!("{} has no instance {unit}", t.module.name));
            let at: Binding = inst.params.iter().map(|(name, e)| (name.clone(), e.eval(&top))).collect();
            format!("{unit}.{}", net(&inst.module, &at, value, k, bits))
        };
        // The tag is the last field of what is carried beside the units.
        let pair = |unit: &str, k| (below(unit, "valid", k, 1), below(unit, "data", k, tag_w));
        let mut setup: Vec<_> = (1..=t.setup).map(|k| pair("u_setup_delay", k)).collect();
        let mut hit: Vec<_> = (1..=t.finish).map(|k| pair("u_hit_delay", k)).collect();
        let decoupling = Decoupling::of(handshake);
        if decoupling == Decoupling::SpillRegister {
            for (list, unit) in [(&mut setup, "u_setup_buffer"), (&mut hit, "u_hit_buffer")] {
                // Their data are covered by the proof of spill_register.
                list.extend(["first", "second"].map(|k| (format!("{unit}.{k}_valid"), String::new())));
            }
        }
        Self {
            decoupling,
            registered: Decoupling::retire_is_registered(handshake),
            last: t.slots - 1,
            parts: [setup, (0..t.slots).map(slot).collect(), hit],
        }
    }

    /// Rays are counted whatever their tags: that words stay with their rays is the claim of the elastic boundary's own proof.
    pub(super) fn counts(&self) -> bool {
        self.decoupling != Decoupling::Combinational
    }

    /// Words of the template.
    pub(super) fn value(&self) -> minijinja::Value {
        let [setup, slots, hit] = [0, 1, 2].map(|k| self.parts[k].len());
        // In pipeline order; the loop's first register comes after its last. The slots of spill registers are no part of a row.
        let spill = if self.decoupling == Decoupling::SpillRegister { 2 } else { 0 };
        let rows: [Vec<usize>; 3] =
            [(0..setup - spill).collect(), (1..slots).chain([0]).collect(), (0..hit - spill).collect()];
        minijinja::context! {
            credits => self.decoupling == Decoupling::CreditFifo, registered => self.registered,
            rows => rows, parts => [("setup", setup), ("loop", slots), ("hit", hit)],
        }
    }

    pub(super) fn len(&self) -> usize {
        self.parts.iter().map(Vec::len).sum()
    }

    /// When a ray is done is left open, so what is proved holds whatever the datapath computes.
    pub(super) fn script(&self) -> String {
        let free = if self.registered { format!("s{}_is_done", self.last) } else { "s0_loop_done_q".into() };
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
            tie("retire".into(), "s0_retire");
            let registers: &[&str] = match self.decoupling {
                Decoupling::CreditFifo => &["reserved", "occupancy", "credit_q", "issued", "popped", "valid_q"],
                _ => &["ready_q", "valid_q", "out_of_reset", "wr_sel_q", "rd_sel_q"],
            };
            for at in ["setup", "hit"] {
                registers.iter().for_each(|r| tie(format!("{at}_{r}"), &format!("u_{at}_buffer.{r}")));
            }
        }
        s
    }
}
