//! `fifo_mem`: the words of a FIFO, one write port and one read port with a register after it.
use crate::quantity::{BIT, BITS, integer};
use reliefrtl_ir::{Builder, Module, Prim};
use std::sync::Arc;

/// Builds `fifo_mem` (parameters ADDR_W, DATA_W, DEPTH), simple dual-port.
pub fn fifo_mem() -> Arc<Module> {
    let b = Builder::new(
        "fifo_mem",
        file!(),
        "memory of a FIFO's words or a loop's rays: one write port, one registered read port",
    );
    let addr_w = b.param("ADDR_W", 4, "address bits");
    let data_w = b.param("DATA_W", 8, "bits of a word");
    let depth = b.param("DEPTH", 16, "slots");
    for least in [&addr_w, &data_w, &depth] {
        b.require(1, least);
    }
    b.require(&depth, addr_w.pow2());
    b.clock();
    b.input_static("write_en", 1, BIT, "write enable");
    b.input_static("write_addr", &addr_w, integer("slots"), "write address");
    b.input_static("write_data", &data_w, BITS, "write data");
    b.input("read_addr", &addr_w, integer("slots"), "read address");
    b.output("read_data", &data_w, BITS, "read data, one clock later");
    b.finish_primitive(Prim::FifoMem)
}
