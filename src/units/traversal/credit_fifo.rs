//! FIFO at the end of a pipeline without a clock enable. A word is issued into the pipeline only against a credit, so the FIFO has a free slot
//! when the word arrives and the pipeline never has to stall.
//!
//! `credit_fifo` is the control: pointers, occupancy, credits. A `fifo_mem` for each word holds the data.
use crate::ir::{Builder, Module, Prim, Sig};
use crate::units::lzc::finish_primitive;
use std::sync::Arc;

/// Address bits of a slot: 16 slots, as a distributed memory of look-up tables has.
const SLOT_W: u32 = 4;
/// Slots: words in a FIFO and in the pipeline before it, at most.
pub(super) const SLOTS: u32 = 1 << SLOT_W;

/// Builds `credit_fifo`: the control.
pub fn credit_fifo() -> Arc<Module> {
    let b = Builder::new("credit_fifo", file!(), "control of a 16-slot FIFO after a pipeline without a clock enable");
    b.note("First in, first out. in_valid has no ready: issue a word only while credit is 1. Not ready in the first clock after reset.");
    b.note("A slot is reserved from issue to pop. One credit is two words early, because credit is registered.");
    b.throughput("one result in three clocks");
    b.clock();
    b.reset();
    let issue = b.input("issue", 1, "bit", "a word enters the pipeline: reserve a slot; only while credit is 1");
    let push = b.input("in_valid", 1, "bit", "input valid: a word leaves the pipeline and is written");
    let o_credit = b.output("credit", 1, "bit", "a slot is free: a word may be issued");
    let o_valid = b.output("out_valid", 1, "bit", "output valid");
    let out_ready = b.input("out_ready", 1, "bit", "output ready (transfer when valid && ready)");
    let o_write = b.output("write_slot", SLOT_W, "slots", "write pointer");
    let o_read = b.output("read_slot", SLOT_W, "slots", "read pointer");

    let count = |name: &str, doc: &str| b.loop_reg(name, SLOT_W + 1, true).doc(doc);
    let pointer = |name: &str, doc: &str| b.loop_reg(name, SLOT_W, true).doc(doc);
    let bit = |name: &str, doc: &str| b.loop_reg(name, 1, true).doc(doc);
    let reserved = count("reserved", "slots from issue to pop [slots]");
    let occupancy = count("occupancy", "slots from write to pop [slots]");
    let write = pointer("write_ptr", "slot that the next word is written to");
    let read = pointer("read_ptr", "slot that is read");
    let credit = bit("credit_q", "a word may be issued");
    let valid = bit("valid_q", "the output is valid");
    let issued = bit("issued", "a word was issued in the clock before");
    let popped = bit("popped", "a word was popped in the clock before");

    b.section("count", "Reserved slots, from issue to pop; and occupied slots, from write to pop.");
    let pop = (valid & out_ready).named("pop");
    // Issue and pop update the counters one cycle late, which keeps the adder off the handshake path. The change is +1, -1 or 0.
    let counted = |count: Sig<'_>, up: Sig<'_>, name: &str| {
        let down = (popped & !up).named(&format!("{name}_down"));
        let change = b.cat(&[down.rep(SLOT_W), up ^ popped]);
        (b.sig(count.id()) + b.sig(change.id())).named(&format!("{name}_next")).id()
    };
    let (reserved_next, occupancy_next) =
        (counted(reserved, issued, "reserved"), counted(occupancy, push, "occupancy"));
    let step = |pointer: Sig<'_>, by: Sig<'_>, name: &str| {
        (b.sig(pointer.id()) + b.sig(by.zext(SLOT_W).id())).named(name).id()
    };
    let (write_next, read_next) = (step(write, push, "write_next"), step(read, popped, "read_next"));

    b.section(
        "valid and credit",
        "Credit is two cycles late, so two slots are held in reserve. After a pop the next word is valid three cycles later: count, then read.",
    );
    let full = (reserved.slice(SLOT_W, 1) | reserved.slice(1, SLOT_W - 1).all()).named("almost_full");
    b.close(&[
        (reserved, b.sig(reserved_next)),
        (occupancy, b.sig(occupancy_next)),
        (write, b.sig(write_next)),
        (read, b.sig(read_next)),
        (credit, (!full).named("credit_next")),
        (valid, (occupancy.any() & !(pop | popped)).named("valid_next")),
        (issued, issue),
        (popped, pop),
    ]);
    b.drive(o_credit, credit, None);
    b.drive(o_valid, valid, None);
    b.drive(o_write, write, None);
    b.drive(o_read, read, None);
    b.finish(None, &[])
}

/// Builds `fifo_mem` (parameters ADDR_W, DATA_W, DEPTH): the data of a `credit_fifo`, simple dual-port.
pub fn fifo_mem() -> Arc<Module> {
    let b = Builder::new("fifo_mem", file!(), "data memory of a credit_fifo: one write port, one registered read port");
    let addr_w = b.param("ADDR_W", SLOT_W, "address bits");
    let data_w = b.param("DATA_W", 8, "bits of a word");
    let depth = b.param("DEPTH", 1 << SLOT_W, "slots");
    for least in [&addr_w, &data_w, &depth] {
        b.require(1, least);
    }
    b.require(&depth, addr_w.pow2());
    b.clock();
    b.input_static("write_en", 1, "bit", "write enable");
    b.input_static("write_addr", &addr_w, "slots", "write address");
    b.input_static("write_data", &data_w, "bits", "write data");
    b.input("read_addr", &addr_w, "slots", "read address");
    b.output("read_data", &data_w, "bits", "read data, one clock later");
    finish_primitive(b, Prim::FifoMem, 1)
}
