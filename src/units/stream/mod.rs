//! Streams: words with valid and ready, what buffers, delays and merges them.
mod arbiter;
mod credit_fifo;
mod fifo;
mod fifo_mem;
mod pipeline;
mod ports;
mod spill_register;
mod stream_delay;

pub use arbiter::{INPUTS, arbiter};
pub use credit_fifo::{SLOTS, credit_fifo};
pub use fifo::fifo;
pub use fifo_mem::fifo_mem;
pub use pipeline::{Decoupling, Pipeline};
pub use ports::{InputStream, OutputStream};
pub use spill_register::spill_register;
pub use stream_delay::{stream_delay, word_delay};

use reliefrtl_config::ExtraUnit;
use reliefrtl_ir::{Builder, Module, Record, Sig};
use std::sync::Arc;

/// A unit of streams that no traversal needs, and what it alone brings with it, leaves first.
pub fn extra(unit: ExtraUnit) -> Vec<Arc<Module>> {
    match unit {
        ExtraUnit::Fifo => vec![fifo_mem(), fifo()],
        ExtraUnit::Arbiter => vec![arbiter(INPUTS)],
        // Of floating point.
        _ => Vec::new(),
    }
}

/// A record with valid and ready. It stands for no hardware of its own: plain nets, and ports where it enters or leaves a module.
pub struct Stream<'b> {
    /// The word.
    pub data: Record<'b>,
    /// The word is valid, and stays as it is until it transfers.
    pub valid: Sig<'b>,
    /// A wire: the word transfers where this and valid are 1. Whoever takes the stream drives it.
    pub ready: Sig<'b>,
}

impl<'b> Stream<'b> {
    /// Another record of the same words, by combinational logic.
    pub fn map(self, f: impl FnOnce(&Record<'b>) -> Record<'b>) -> Self {
        Self { data: f(&self.data), ..self }
    }

    /// A `spill_register` at the end of the stream: no combinational path from its ready to this one's. Its nets are called after `name`.
    pub fn spill(self, b: &'b Builder, name: &str) -> Self {
        self.buffered(b, name, &spill_register(), &[])
    }

    /// A `fifo` of `depth` words, a power of two, at the end of the stream.
    pub fn fifo(self, b: &'b Builder, name: &str, depth: u32) -> Self {
        self.buffered(b, name, &fifo(), &[("DEPTH", depth.into())])
    }

    fn buffered(self, b: &'b Builder, name: &str, module: &Arc<Module>, params: &[(&str, reliefrtl_ir::Expr)]) -> Self {
        let (word, ready) = (self.data.bundle(b), b.wire(&format!("{name}_ready"), 1));
        let params: Vec<_> = params.iter().cloned().chain([("W", word.width())]).collect();
        let ins = [("in_valid", self.valid), ("in_data", word), ("out_ready", ready)];
        let o = b.inst(module, &format!("u_{name}"), &params, &ins);
        b.connect(self.ready, o["in_ready"].unstaged());
        if let Some(occupancy) = o.get("occupancy") {
            b.unused(occupancy.named(&format!("{name}_occupancy")));
        }
        let valid = o["out_valid"].named(&format!("{name}_valid"));
        Self { data: self.data.unbundle(o["out_data"]).named(name), valid, ready }
    }

    /// An `arbiter` of streams of one record, the first of which is input 0.
    ///
    /// # Panics
    /// If the records differ in their fields.
    pub fn arbiter(b: &'b Builder, name: &str, streams: Vec<Self>) -> Self {
        let fields = |s: &Self| s.data.names().map(String::from).collect::<Vec<_>>();
        assert!(streams.iter().all(|s| fields(s) == fields(&streams[0])), "an arbiter takes streams of one record");
        let down: Vec<&Self> = streams.iter().rev().collect();
        let valid = b.cat(&down.iter().map(|s| s.valid).collect::<Vec<_>>());
        let words = b.cat(&down.iter().map(|s| s.data.bundle(b)).collect::<Vec<_>>());
        let ready = b.wire(&format!("{name}_ready"), 1);
        let ins = [("in_valid", valid), ("in_data", words), ("out_ready", ready)];
        let width = streams[0].data.width();
        let o = b.inst(&arbiter(streams.len() as u32), &format!("u_{name}"), &[("W", width)], &ins);
        b.unused(o["out_grant"].named(&format!("{name}_grant")));
        let readies = o["in_ready"].unstaged().named(&format!("{name}_in_ready"));
        streams.iter().zip(0i64..).for_each(|(s, k)| b.connect(s.ready, readies.bit(k)));
        let valid = o["out_valid"].named(&format!("{name}_valid"));
        Self { data: streams[0].data.unbundle(o["out_data"]).named(name), valid, ready }
    }
}
