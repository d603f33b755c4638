//! Spill register: two slots between two pipelines with a valid/ready handshake, so that no combinational path runs from ready out to ready in.
//! The consumer may stall at once; the producer stalls one cycle later, and the word of that cycle spills into the second slot.
//!
//! Only registers drive the wide multiplexer and the load enables, so no handshake fans out to every data bit in the cycle in which it is decided.
use crate::quantity::{BIT, BITS};
use reliefrtl_ir::{Builder, Module, Sig};
use std::sync::Arc;

/// Builds `spill_register` (parameter W).
pub fn spill_register() -> Arc<Module> {
    let b = Builder::new("spill_register", file!(), "two-slot buffer between two handshakes: in_ready is registered");
    b.note("First in, first out, one word per clock. Not ready in the first clock after reset.");
    let w = b.param("W", 8, "bits of a word");
    b.require(1, &w);
    b.clock();
    b.reset();
    let in_valid = b.input("in_valid", 1, BIT, "input valid");
    let o_ready = b.output("in_ready", 1, BIT, "input ready (transfer when valid && ready); registered");
    let in_data = b.input("in_data", &w, BITS, "input word");
    let o_valid = b.output("out_valid", 1, BIT, "output valid");
    let out_ready = b.input("out_ready", 1, BIT, "output ready (transfer when valid && ready)");
    let o_data = b.output("out_data", &w, BITS, "output word");

    let bit = |name: &str, doc: &str| b.loop_reg(name, 1, true).doc(doc);
    let holds = "the slot holds a word";
    let valid = [bit("first_valid", holds), bit("second_valid", holds)];
    let any_valid = bit("valid_q", "either slot holds a word");
    let wr_sel = bit("wr_sel_q", "write select: 0 the first slot, 1 the second");
    let rd_sel = bit("rd_sel_q", "read select: 0 the first slot, 1 the second");
    let out_of_reset = bit("out_of_reset", "reset has ended");
    let ready = bit("ready_q", "a slot is free");
    let empty = "the slot is free: it loads";
    let load = [bit("load_first_q", empty), bit("load_second_q", empty)];
    let word = ["first", "second"].map(|name| b.loop_reg(name, &w, false).doc("word of the slot [bits]"));

    b.section(
        "handshake",
        "An empty slot loads whatever is at the input; it becomes valid if the write select points to it.",
    );
    let push = (in_valid & out_of_reset & !(valid[0] & valid[1])).named("push");
    let pop = (any_valid & out_ready).named("pop");
    let pushes = [(push & !wr_sel).named("push_first"), (push & wr_sel).named("push_second")];
    let pops = [(pop & !rd_sel).named("pop_first"), (pop & rd_sel).named("pop_second")];
    let filled = |k: usize, name: &str| (pushes[k] | (valid[k] & !pops[k])).named(name);
    let next = [filled(0, "first_valid_next"), filled(1, "second_valid_next")];

    b.section("data", "The output word is selected by a register.");
    let loaded = |k: usize, name: &str| load[k].mux(in_data, word[k]).named(name);
    let word_next = [loaded(0, "first_next"), loaded(1, "second_next")];
    let selected = rd_sel.mux(word[1], word[0]).named("selected");

    b.section("registers", "Every control output has a register of its own beside the slots' valid bits.");
    let one = b.lit(1, 1).named("one");
    let bits: [(Sig<'_>, Sig<'_>); 9] = [
        (valid[0], next[0]),
        (valid[1], next[1]),
        (any_valid, (next[0] | next[1]).named("valid_next")),
        (wr_sel, (wr_sel ^ push).named("wr_sel_next")),
        (rd_sel, (rd_sel ^ pop).named("rd_sel_next")),
        (out_of_reset, one),
        (ready, (!(next[0] & next[1])).named("ready_next")),
        (load[0], (!next[0]).named("load_first_next")),
        (load[1], (!next[1]).named("load_second_next")),
    ];
    let words = word.into_iter().zip(word_next);
    b.close(&bits.into_iter().chain(words).collect::<Vec<_>>());
    b.drive(o_ready, ready);
    b.drive(o_valid, any_valid);
    b.drive(o_data, selected);
    b.finish_streams(&[])
}
