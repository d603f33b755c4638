//! Elastic boundary between two pipelines of `traverse`: what decouples ready (`latency.handshake`).
use super::credit_fifo::{credit_fifo, fifo_mem};
use super::spill_register::{spill_data, spill_register};
use crate::ir::{Builder, Sig};

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

/// An elastic boundary: a spill register, or a credit FIFO if words are issued against credits.
pub struct ElasticBoundary<'b> {
    /// What stands before it: `setup`, `hit`.
    pub name: &'static str,
    /// Output valid of the pipeline before it.
    pub valid: Sig<'b>,
    /// Wire: input ready of the spill register, the pipeline's clock enable; or the credit of the FIFO.
    pub ready: Sig<'b>,
    /// Output ready.
    pub out_ready: Sig<'b>,
    /// A word is issued into the pipeline, which has no clock enable and ends in a FIFO.
    pub issue: Option<Sig<'b>>,
}

impl<'b> ElasticBoundary<'b> {
    /// Passes `words` on; returns output valid, and the words under `names`.
    pub fn pass(&self, b: &'b Builder, words: &[Sig<'b>], names: &[String]) -> (Sig<'b>, Vec<Sig<'b>>) {
        match self.issue {
            Some(issue) => self.fifo(b, issue, words, names),
            None => self.spill(b, words, names),
        }
    }

    fn spill(&self, b: &'b Builder, words: &[Sig<'b>], names: &[String]) -> (Sig<'b>, Vec<Sig<'b>>) {
        let name = format!("{}_spill", self.name);
        let ins = [("in_valid", self.valid), ("out_ready", self.out_ready)];
        let o = b.inst(&spill_register(), &format!("u_{name}"), &[], &ins);
        b.connect(self.ready, o[0].unstaged());
        let [first, second, rd_sel] = [(2, "load_first"), (3, "load_second"), (4, "rd_sel")]
            .map(|(k, what)| o[k].named(&format!("{name}_{what}")));
        let slots = |(word, to): (&Sig<'b>, &String)| {
            let ins = [("load_first", first), ("load_second", second), ("rd_sel", rd_sel), ("in_data", *word)];
            b.inst(&spill_data(), &format!("u_{name}_{to}"), &[("W", word.width())], &ins)[0].named(to)
        };
        (o[1], words.iter().zip(names).map(slots).collect())
    }

    fn fifo(&self, b: &'b Builder, issue: Sig<'b>, words: &[Sig<'b>], names: &[String]) -> (Sig<'b>, Vec<Sig<'b>>) {
        let name = format!("{}_fifo", self.name);
        let ins = [("issue", issue), ("in_valid", self.valid), ("out_ready", self.out_ready)];
        let o = b.inst(&credit_fifo(), &format!("u_{name}"), &[], &ins);
        b.connect(self.ready, o[0].unstaged());
        let [write, read] = [(2, "write"), (3, "read")].map(|(k, what)| o[k].named(&format!("{name}_{what}")));
        let memory = fifo_mem();
        let slots = |(word, to): (&Sig<'b>, &String)| {
            let own = |p: &str| memory.params.iter().find(|q| q.name == p).expect("a FIFO has it").default;
            let params = [("ADDR_W", own("ADDR_W").into()), ("DATA_W", word.width()), ("DEPTH", own("DEPTH").into())];
            let ins = [("write_en", self.valid), ("write_addr", write), ("write_data", *word), ("read_addr", read)];
            b.inst(&memory, &format!("u_{name}_{to}"), &params, &ins)[0].rebase_stage(0).named(to)
        };
        (o[1], words.iter().zip(names).map(slots).collect())
    }
}
