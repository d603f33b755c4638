//! `height_memory`: the pyramid's heights on chip: one write port, one read port with a register after it.
use crate::quantity::{BIT, BITS, WORDS};
use reliefrtl_ir::{Builder, Expr, Module, Prim};
use std::sync::Arc;

/// The parameter that names the file of a memory's first words.
pub(super) const MEM_INIT: &str = "MEM_INIT";

/// Builds the memory (parameters ADDR_W, DATA_W, DEPTH).
pub fn height_memory(addr: u32, data: u32, depth: u32) -> Arc<Module> {
    let b = Builder::new("height_memory", file!(), "on-chip memory with a write port and a registered read");
    b.note("A read of the word that is being written gives any word, in a simulation the old one. Written for block RAM inference.");
    let addr_w = b.param("ADDR_W", addr, "address bits");
    let data_w = b.param("DATA_W", data, "bits of a word");
    let depth = b.param("DEPTH", depth, "words");
    for least in [&addr_w, &data_w, &depth] {
        b.require(1, least);
    }
    b.file_param(MEM_INIT, "file for $readmemh with all words, the first one's first; \"\": unknown at power-up");
    b.require(&depth, addr_w.pow2());
    b.clock();
    b.input_static("write_en", 1, BIT, "write at the next edge");
    b.input_static("write_addr", &addr_w, WORDS, "where");
    b.input_static("write_data", &data_w, BITS, "what");
    b.input("read_addr", &addr_w, WORDS, "where to read");
    b.output("read_data", &data_w, BITS, "the word, one clock later");
    b.finish_primitive(Prim::Memory)
}

/// Words of a pyramid of LEVELS levels below its root: (4^(LEVELS+1) - 1) / 3.
pub fn pyramid_words(levels: &Expr) -> Expr {
    ((levels.clone() * 2 + 2).pow2() - 1).div(3)
}
