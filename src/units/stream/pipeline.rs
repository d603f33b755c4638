//! A pipeline between two streams, and what decouples its ready from the next one's (`latency.handshake`).
use super::credit_fifo::credit_fifo;
use super::spill_register::spill_register;
use super::stream_delay::stream_delay;
use reliefrtl_ir::{Builder, Record, Sig};

/// What decouples ready after setup and after the hit. The one definition of the values of `latency.handshake`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decoupling {
    /// 0: nothing; ready runs combinationally from `out_ready` to `in_ready`.
    Combinational,
    /// 1 and 2: a spill register.
    SpillRegister,
    /// 3: a credit FIFO, and no clock enable in the pipeline before it.
    CreditFifo,
}

impl Decoupling {
    /// That of a value of `latency.handshake`.
    pub const fn of(handshake: u32) -> Self {
        match handshake {
            0 => Self::Combinational,
            1 | 2 => Self::SpillRegister,
            _ => Self::CreditFifo,
        }
    }

    /// Whether the decision which ray retires is registered, from 2 on.
    pub const fn retire_is_registered(handshake: u32) -> bool {
        handshake > 1
    }
}

/// A pipeline whose words transfer by valid and ready on both sides. Its ready is known before its words are, which may depend on it.
pub struct Pipeline<'b> {
    name: &'static str,
    decoupling: Decoupling,
    out_ready: Sig<'b>,
    /// Input ready.
    pub ready: Sig<'b>,
    /// Output valid, a wire.
    pub valid: Sig<'b>,
}

impl<'b> Pipeline<'b> {
    /// Declares the pipeline `name`: the nets `<name>_valid`, and `<name>_ready` or, without anything that decouples, `<name>_ce`.
    pub fn declare(b: &'b Builder, name: &'static str, decoupling: Decoupling, out_ready: Sig<'b>) -> Self {
        let last = if decoupling == Decoupling::Combinational { "last stage of" } else { "buffer after" };
        let valid = b.wire(&format!("{name}_valid"), 1).doc(&format!("the {last} the {name} pipeline holds a word"));
        let ready = match decoupling {
            // All stages move while the last one is empty or its word transfers.
            Decoupling::Combinational => (!valid | out_ready).unstaged().named(&format!("{name}_ce")),
            Decoupling::SpillRegister | Decoupling::CreditFifo => {
                b.wire(&format!("{name}_ready"), 1).doc(&format!("the {name} pipeline can take a word"))
            }
        };
        Self { name, decoupling, out_ready, ready, valid }
    }

    /// Clock enable of its stages: always 1 before a credit FIFO.
    pub fn enable(&self, b: &'b Builder) -> Sig<'b> {
        if self.decoupling == Decoupling::CreditFifo { b.lit(1, 1) } else { self.ready }
    }

    /// Sends a word in wherever `valid` is 1, and in front of a credit FIFO only where the pipeline is ready. What comes out, in the nets
    /// `<outer>_<field>`: `computed` by units of `clocks` clocks, and `beside`, which waits as long. Before what decouples they are called
    /// `<inner>_<field>`.
    pub fn pass(
        &self,
        b: &'b Builder,
        clocks: u32,
        valid: Sig<'b>,
        (computed, beside): (Record<'b>, Record<'b>),
        [inner, outer]: [&str; 2],
    ) -> Record<'b> {
        let (name, beside_w) = (self.name, beside.width());
        let ins = [("in_valid", valid), ("in_data", beside.bundle(b)), ("ce", self.enable(b))];
        let o = b.inst(
            &stream_delay(&format!("{name}_delay"), clocks),
            &format!("u_{name}_delay"),
            &[("W", beside_w)],
            &ins,
        );
        let last_valid = o["out_valid"].rebase_stage(0);
        let delayed = beside.unbundle(o["out_data"].rebase_stage(0));
        let words = computed.and(delayed.map(|field, v| like(v, beside[field])));
        if self.decoupling == Decoupling::Combinational {
            b.connect(self.valid, last_valid);
            return words.named(outer);
        }
        let words = words.named(inner);
        let (last_valid, bundle) = (last_valid.named(&format!("{name}_last_valid")), words.bundle(b));
        let mut ins = vec![("in_valid", last_valid), ("in_data", bundle), ("out_ready", self.out_ready)];
        let (module, ready) = match self.decoupling {
            Decoupling::CreditFifo => (credit_fifo(), "credit"),
            Decoupling::SpillRegister | Decoupling::Combinational => (spill_register(), "in_ready"),
        };
        ins.extend((self.decoupling == Decoupling::CreditFifo).then_some(("issue", valid)));
        let o = b.inst(&module, &format!("u_{name}_buffer"), &[("W", bundle.width())], &ins);
        b.connect(self.ready, o[ready].unstaged());
        b.connect(self.valid, o["out_valid"].unstaged());
        let buffered = words.unbundle(o["out_data"]);
        buffered.map(|field, v| like(v.named(&format!("{outer}_{field}")), words[field]))
    }
}

/// `v`, which is what `origin` was some clocks before.
fn like<'b>(v: Sig<'b>, origin: Sig<'b>) -> Sig<'b> {
    origin.meaning().map_or(v, |text| v.doc(&text))
}
