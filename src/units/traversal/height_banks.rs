//! `height_banks`: the pyramid's heights on chip, in banks with a second register each, for clocks that a block memory's read does not leave
//! time for anything else.
use super::height_memory::MEM_INIT;
use crate::quantity::{BIT, BITS, WORDS};
use reliefrtl_ir::{Builder, Module, Prim};
use std::sync::Arc;

/// Address bits of a bank: 8192 words of 8 bits fill four ECP5 block memories of 8192 x 2.
const BANK_BITS: u32 = 13;

/// Builds the memory (parameters ADDR_W, DATA_W, DEPTH, BANK_W).
pub fn height_banks(addr: u32, data: u32, depth: u32) -> Arc<Module> {
    let b =
        Builder::new("height_banks", file!(), "on-chip memory in banks, with a write port and two registers a read");
    b.note("Preloaded by MEM_INIT, it is one array with two registers: what it does is the same.");
    b.note("A read of the word that is being written gives any word, in a simulation the old one. Written for block RAM inference.");
    let addr_w = b.param("ADDR_W", addr, "address bits");
    let data_w = b.param("DATA_W", data, "bits of a word");
    let depth = b.param("DEPTH", depth, "words");
    let bank_w = b.param("BANK_W", BANK_BITS, "address bits of a bank");
    b.require(2, &addr_w);
    for least in [&data_w, &depth, &bank_w] {
        b.require(1, least);
    }
    b.file_param(MEM_INIT, "file for $readmemh with all words, the first one's first; \"\": unknown at power-up");
    b.require(&depth, addr_w.pow2());
    b.clock();
    b.input_static("write_en", 1, BIT, "write at the next edge");
    b.input_static("write_addr", &addr_w, WORDS, "where");
    b.input_static("write_data", &data_w, BITS, "what");
    b.input("read_addr", &addr_w, WORDS, "where to read");
    b.output("read_data", &data_w, BITS, "the word read, two clocks after its address");
    b.finish_primitive(Prim::Banks)
}

/// Passed at each instance, so that a parameter of the same name above would not be taken for it.
pub(super) fn bank_bits() -> reliefrtl_ir::Expr {
    reliefrtl_ir::Expr::from(i64::from(BANK_BITS))
}
