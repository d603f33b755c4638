//! A queue behind a pipeline that never stops: a word sets out only if a place is free for it, so the pipeline needs no enable, and nobody
//! has to be told in the clock in which a decision is made.
//!
//! `stream_queue` counts; a `word_queue` for each word holds what is in its places.
use crate::ir::{Builder, Module, Prim, Sig};
use crate::units::lzc::finish_primitive;
use std::sync::Arc;

/// Address bits of the places: 16, as look-up tables have.
const PLACE_W: u32 = 4;
/// Words that a queue and the pipeline before it hold at most.
pub(super) const PLACES: u32 = 1 << PLACE_W;

/// Builds `stream_queue`: the counts.
pub fn stream_queue() -> Arc<Module> {
    let b =
        Builder::new("stream_queue", file!(), "the counts of 16 places for the words of a pipeline without an enable");
    b.note("Words leave in the order in which they come, one in three clocks at most; none is lost and none comes twice. Not ready in the first clock behind reset.");
    b.note("A word may set out while room is 1, in_valid is 1 when it arrives. From there on it stands in its place; its place is free again once it is taken.");
    b.throughput("one result in three clocks");
    b.clock();
    b.reset();
    let sets_out = b.input("sets_out", 1, "bit", "a word enters the pipeline at the next edge; only while room is 1");
    let arrives = b.input("in_valid", 1, "bit", "a word leaves the pipeline and is written at the next edge");
    let o_room = b.output("room", 1, "bit", "a place is free");
    let o_valid = b.output("out_valid", 1, "bit", "a word is offered");
    let take = b.input("out_ready", 1, "bit", "it is taken at the next edge");
    let o_write = b.output("write_place", PLACE_W, "places", "where the word that arrives is written");
    let o_read = b.output("read_place", PLACE_W, "places", "where the word stands that is offered next");

    let count = |name: &str| b.loop_reg(name, PLACE_W + 1, true);
    let place = |name: &str| b.loop_reg(name, PLACE_W, true);
    let bit = |name: &str| b.loop_reg(name, 1, true);
    let (taken, held) = (count("taken"), count("held"));
    let (write, read) = (place("writes_at"), place("reads_at"));
    let (room, offered) = (bit("has_room"), bit("is_offered"));
    let (set_out, went) = (bit("has_set_out"), bit("has_gone"));

    b.section("count", "Places that are taken, from a word's setting out on; and words that stand in theirs.");
    let goes = (offered & take).named("goes");
    // Both doors are counted a clock later, so that no sum waits for who stands before them. One sum: a word more, a word less, or as many.
    let moved = |count: Sig<'_>, more: Sig<'_>, name: &str| {
        let down = (went & !more).named(&format!("{name}_down"));
        let change = b.cat(&[down.rep(PLACE_W), more ^ went]);
        (b.sig(count.id()) + b.sig(change.id())).named(&format!("{name}_next")).id()
    };
    let (taken_next, held_next) = (moved(taken, set_out, "taken"), moved(held, arrives, "held"));
    let step =
        |place: Sig<'_>, by: Sig<'_>, name: &str| (b.sig(place.id()) + b.sig(by.zext(PLACE_W).id())).named(name).id();
    let (write_next, read_next) = (step(write, arrives, "write_next"), step(read, went, "read_next"));

    b.section(
        "offer",
        "Room is told two clocks late, so two places are kept back. Behind a word that goes the next one is offered three clocks later: it is counted, and read.",
    );
    let nearly = (taken.slice(PLACE_W, 1) | taken.slice(1, PLACE_W - 1).all()).named("nearly_full");
    b.close(&[
        (taken, b.sig(taken_next)),
        (held, b.sig(held_next)),
        (write, b.sig(write_next)),
        (read, b.sig(read_next)),
        (room, (!nearly).named("room_next")),
        (offered, (held.any() & !(goes | went)).named("offers_next")),
        (set_out, sets_out),
        (went, goes),
    ]);
    b.drive(o_room, room, None);
    b.drive(o_valid, offered, None);
    b.drive(o_write, write, None);
    b.drive(o_read, read, None);
    b.finish(None, &[])
}

/// Builds `word_queue` (parameter W): a word in each place.
pub fn word_queue() -> Arc<Module> {
    let b = Builder::new("word_queue", file!(), "a word in each place of a stream_queue, read with a register");
    let addr_w = b.param("ADDR_W", PLACE_W, "address bits");
    let data_w = b.param("DATA_W", 8, "bits of the word");
    let depth = b.param("DEPTH", 1 << PLACE_W, "places");
    for least in [&addr_w, &data_w, &depth] {
        b.require(1, least);
    }
    b.require(&depth, addr_w.pow2());
    b.clock();
    b.input_static("write_en", 1, "bit", "write at the next edge");
    b.input_static("write_addr", &addr_w, "places", "where");
    b.input_static("write_data", &data_w, "bits", "what");
    b.input("read_addr", &addr_w, "places", "where to read");
    b.output("read_data", &data_w, "bits", "the word, one clock later");
    finish_primitive(b, Prim::Queue, 1)
}
