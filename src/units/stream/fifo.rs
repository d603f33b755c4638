//! `fifo`: a synchronous FIFO with valid and ready on both sides.
use super::fifo_mem::fifo_mem;
use crate::quantity::{BIT, BITS, WORDS};
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `fifo` (parameters W, DEPTH).
pub fn fifo() -> Arc<Module> {
    let b = Builder::new("fifo", file!(), "synchronous FIFO of DEPTH words with valid and ready on both sides");
    b.note(
        "First in, first out, one word per clock. A word is at the output two clocks after its push, at the earliest.",
    );
    b.note(
        "No combinational path between the two sides: in_ready, out_valid and occupancy follow from registers alone.",
    );
    let w = b.param("W", 8, "bits of a word");
    let depth = b.param("DEPTH", 16, "words, a power of two");
    b.require(1, &w);
    b.require(4, &depth);
    b.require(&depth, 4096);
    b.require(depth.clog2().pow2(), &depth);
    let ptr_w = b.local("PtrW", depth.clog2(), "bits of a slot address");
    b.clock();
    b.reset();
    let in_valid = b.input("in_valid", 1, BIT, "input valid");
    let o_ready = b.output("in_ready", 1, BIT, "input ready (transfer when valid && ready): fewer than DEPTH words");
    let in_data = b.input("in_data", &w, BITS, "input word");
    let o_valid = b.output("out_valid", 1, BIT, "output valid");
    let out_ready = b.input("out_ready", 1, BIT, "output ready (transfer when valid && ready)");
    let o_data = b.output("out_data", &w, BITS, "output word; any while out_valid is 0");
    let o_occupancy = b.output("occupancy", &ptr_w + 1, WORDS, "words pushed and not yet popped, 0 to DEPTH");

    let occupancy = b.loop_reg("occupancy_q", &ptr_w + 1, true).doc("words held [words]");
    let write = b.loop_reg("write_ptr", &ptr_w, true).doc("slot that the next word is written to");
    let read = b.loop_reg("read_ptr", &ptr_w, true).doc("slot that is read");
    let valid = b.loop_reg("valid_q", 1, true).doc("the output is valid");

    b.section("handshake", "Full is the top bit of the occupancy.");
    let not_full = (!occupancy.msb()).named("not_full");
    let push = (in_valid & not_full).named("push");
    let pop = (valid & out_ready).named("pop");

    b.section("count", "The occupancy changes by +1, -1 or 0; each pointer follows its transfer.");
    let down = (pop & !push).named("down");
    let change = b.cat(&[down.rep(&ptr_w), push ^ pop]);
    let read_next = (read + pop.zext(&ptr_w)).named("read_next");
    // A word that is pushed now is in the memory from the next clock on, so only the older ones can be read now.
    let (two_or_more, one) = (occupancy.slice(1, &ptr_w).any(), occupancy.bit(0));
    b.close(&[
        (occupancy, (occupancy + change).named("occupancy_next")),
        (write, (write + push.zext(&ptr_w)).named("write_next")),
        (read, read_next),
        (valid, (two_or_more | (one & !pop)).named("valid_next")),
    ]);

    b.section("data", "The next word is read while this one transfers.");
    let params = [("ADDR_W", ptr_w), ("DATA_W", w), ("DEPTH", depth)];
    let ins = [("write_en", push), ("write_addr", write), ("write_data", in_data), ("read_addr", read_next)];
    let words = b.inst(&fifo_mem(), "u_words", &params, &ins);
    b.drive(o_ready, not_full);
    b.drive(o_valid, valid);
    b.drive(o_data, words["read_data"].rebase_stage(0).named("word"));
    b.drive(o_occupancy, occupancy);
    let at = |w: i64, depth: i64| [("W".to_string(), w), ("DEPTH".to_string(), depth)].into();
    b.finish_streams(&[at(1, 4), at(300, 1024)])
}
