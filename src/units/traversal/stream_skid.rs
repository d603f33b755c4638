//! Registers between two pipelines with a valid/ready handshake, of which ready does not run through: two places, filled and emptied in turn.
//! The pipeline behind may stop at once, the one before stops a clock later, and the word that comes meanwhile has a place of its own.
//!
//! `stream_skid` knows which of the two places are filled; a `word_skid` for each word holds what is in them. What the wide words wait for are
//! registers alone, so that no decision has to reach all of them in the clock in which it is made.
use crate::ir::{Builder, Module, Sig};
use std::sync::Arc;

/// Builds `stream_skid`: the handshake.
pub fn stream_skid() -> Arc<Module> {
    let b = Builder::new("stream_skid", file!(), "handshake of a stream's two places: ready is a register");
    b.note("Words leave in the order in which they come; none is lost and none comes twice. Not ready in the first clock behind reset.");
    b.clock();
    b.reset();
    let in_valid = b.input("in_valid", 1, "bit", "a word is offered");
    let o_ready = b.output("in_ready", 1, "bit", "it is taken at the next edge");
    let o_valid = b.output("out_valid", 1, "bit", "a word is offered");
    let take = b.input("out_ready", 1, "bit", "it is taken at the next edge");
    let o_first = b.output("first_open", 1, "bit", "the first place takes what comes");
    let o_second = b.output("second_open", 1, "bit", "the second place takes what comes");
    let o_turn = b.output("turn", 1, "bit", "the second place is offered");

    let bit = |name: &str| b.loop_reg(name, 1, true);
    let valid = [bit("first_valid"), bit("second_valid")];
    let (some, writes, reads) = (bit("some_valid"), bit("writes_second"), bit("reads_second"));
    let (awake, ready) = (bit("awake"), bit("is_ready"));
    let open = [bit("first_takes"), bit("second_takes")];

    b.section("take", "A place that is not filled takes whatever comes; it counts once it was the place's turn.");
    let comes = (in_valid & awake & !(valid[0] & valid[1])).named("comes");
    let goes = (some & take).named("goes");
    let fills = [(comes & !writes).named("fills_first"), (comes & writes).named("fills_second")];
    let leaves = [(goes & !reads).named("leaves_first"), (goes & reads).named("leaves_second")];
    let filled = |k: usize, name: &str| (fills[k] | (valid[k] & !leaves[k])).named(name);
    let next = [filled(0, "first_filled"), filled(1, "second_filled")];

    b.section("registers", "What others wait for has registers of its own, beside the places' bits.");
    let one = b.lit(1, 1).named("from_now_on");
    b.close(&[
        (valid[0], next[0]),
        (valid[1], next[1]),
        (some, (next[0] | next[1]).named("some_filled")),
        (writes, (writes ^ comes).named("writes_next")),
        (reads, (reads ^ goes).named("reads_next")),
        (awake, one),
        (ready, (!(next[0] & next[1])).named("ready_next")),
        (open[0], (!next[0]).named("first_opens")),
        (open[1], (!next[1]).named("second_opens")),
    ]);
    b.drive(o_ready, ready, None);
    b.drive(o_valid, some, None);
    b.drive(o_first, open[0], None);
    b.drive(o_second, open[1], None);
    b.drive(o_turn, reads, None);
    b.finish(None, &[])
}

/// Builds `word_skid` (parameter W): the two places of a word.
pub fn word_skid() -> Arc<Module> {
    let b = Builder::new("word_skid", file!(), "the two places of a word beside a stream_skid");
    let w = b.param("W", 8, "bits of the word");
    b.require(1, &w);
    b.clock();
    let open = [("first_open", "the first place takes the word"), ("second_open", "the second place takes the word")]
        .map(|(name, what)| b.input(name, 1, "bit", what));
    let turn = b.input("turn", 1, "bit", "the second place is offered");
    let data = b.input("in_data", &w, "bits", "the word that comes");
    let o_data = b.output("out_data", &w, "bits", "the word that is offered");
    let place = |open: Sig<'_>, name: &str| {
        let held = b.loop_reg(name, &w, false);
        (held.id(), open.mux(data, held).named(&format!("{name}_next")).id())
    };
    let (first, second) = (place(open[0], "first"), place(open[1], "second"));
    let [first, second] = [first, second].map(|(held, next)| (b.sig(held), b.sig(next)));
    b.close(&[first, second]);
    b.drive(o_data, turn.mux(second.0, first.0).named("offered"), None);
    b.finish(None, &[])
}
