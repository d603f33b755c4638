//! FIFO at the end of a pipeline without a clock enable. A word is issued into the pipeline only against a credit, so the FIFO has a free slot
//! when the word arrives and the pipeline never has to stall.
//!
//! Pointers, occupancy and credits; a `fifo_mem` holds the data.
use super::fifo_mem::fifo_mem;
use crate::quantity::{BIT, BITS};
use reliefrtl_ir::{Builder, Module, Sig};
use std::sync::Arc;

/// Address bits of a slot: 16 slots, as a distributed memory of look-up tables has.
const SLOT_W: u32 = 4;
/// Slots: words in a FIFO and in the pipeline before it, at most.
pub const SLOTS: u32 = 1 << SLOT_W;

/// Builds `credit_fifo` (parameter W).
pub fn credit_fifo() -> Arc<Module> {
    let b = Builder::new("credit_fifo", file!(), "16-slot FIFO after a pipeline without a clock enable");
    b.note("First in, first out. in_valid has no ready: issue a word only while credit is 1. credit is 0 in the first clock after reset.");
    b.note("A slot is reserved from issue to pop. credit falls when 14 slots are reserved: the two words that may be issued before that shows take the others.");
    b.throughput("one result in three clocks");
    let w = b.param("W", 8, "bits of a word");
    b.require(1, &w);
    b.clock();
    b.reset();
    let issue = b.input("issue", 1, BIT, "a word enters the pipeline: reserve a slot; only while credit is 1");
    let push = b.input("in_valid", 1, BIT, "input valid: a word leaves the pipeline and is written");
    let data = b.input("in_data", &w, BITS, "input word");
    let o_credit = b.output("credit", 1, BIT, "a slot is free: a word may be issued");
    let o_valid = b.output("out_valid", 1, BIT, "output valid");
    let out_ready = b.input("out_ready", 1, BIT, "output ready (transfer when valid && ready)");
    let o_data = b.output("out_data", &w, BITS, "output word");

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
        "Credit is two clocks late, so two slots are held in reserve. After a pop the next word is valid three clocks later: count, then read.",
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
    b.drive(o_credit, credit);
    b.drive(o_valid, valid);

    b.section("data", "The word at the read pointer is read in every clock.");
    let params = [("ADDR_W", SLOT_W.into()), ("DATA_W", w), ("DEPTH", SLOTS.into())];
    let ins = [("write_en", push), ("write_addr", write), ("write_data", data), ("read_addr", read)];
    let o = b.inst(&fifo_mem(), "u_words", &params, &ins);
    b.drive(o_data, o["read_data"].rebase_stage(0).named("word"));
    b.finish_streams(&[])
}
