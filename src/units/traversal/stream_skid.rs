//! A register between two pipelines with a valid/ready handshake, of which ready does not run through: the pipeline behind it may stop at once,
//! the one before it stops a clock later, and the word that comes meanwhile has a place of its own.
//!
//! `stream_skid` knows which of the two places are filled; a `word_skid` for each word holds what is in them.
use crate::ir::{Builder, Module};
use std::sync::Arc;

/// Builds `stream_skid`: the handshake.
pub fn stream_skid() -> Arc<Module> {
    let b = Builder::new("stream_skid", file!(), "handshake of a stream's two places: ready is a register");
    b.note("Words leave in the order in which they come; none is lost and none comes twice.");
    b.clock();
    b.reset();
    let in_valid = b.input("in_valid", 1, "bit", "a word is offered");
    let o_ready = b.output("in_ready", 1, "bit", "it is taken at the next edge");
    let o_valid = b.output("out_valid", 1, "bit", "a word is offered");
    let take = b.input("out_ready", 1, "bit", "it is taken at the next edge");
    let o_hold = b.output("hold", 1, "bit", "the first word stays");
    let o_spare = b.output("spare", 1, "bit", "the second place is filled");

    let head_valid = b.loop_reg("head_valid", 1, true);
    let tail_valid = b.loop_reg("tail_valid", 1, true);

    b.section("take", "The second place is filled only while the first one waits.");
    let ready = (!tail_valid).named("ready");
    let comes = (in_valid & ready).named("comes");
    let stays = (head_valid & !take).named("stays");
    let head_filled = (stays | tail_valid | comes).named("head_filled");
    let tail_filled = (stays & (tail_valid | comes)).named("tail_filled");
    b.close(&[(head_valid, head_filled), (tail_valid, tail_filled)]);
    b.drive(o_ready, ready, None);
    b.drive(o_valid, head_valid, None);
    b.drive(o_hold, stays, None);
    b.drive(o_spare, tail_valid, None);
    b.finish(None, &[])
}

/// Builds `word_skid` (parameter W): the two places of a word.
pub fn word_skid() -> Arc<Module> {
    let b = Builder::new("word_skid", file!(), "the two places of a word beside a stream_skid");
    let w = b.param("W", 8, "bits of the word");
    b.require(1, &w);
    b.clock();
    let hold = b.input("hold", 1, "bit", "the first word stays");
    let spare = b.input("spare", 1, "bit", "the second place is filled");
    let data = b.input("in_data", &w, "bits", "the word that comes");
    let o_data = b.output("out_data", &w, "bits", "the first word");
    let head = b.loop_reg("head", &w, false);
    let tail = b.loop_reg("tail", &w, false);
    let next = spare.mux(tail, data).named("next_word");
    let head_next = hold.mux(head, next).named("head_next");
    b.close(&[(head, head_next), (tail, next)]);
    b.drive(o_data, head, None);
    b.finish(None, &[])
}
