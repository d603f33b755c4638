//! `arbiter`: some streams into one, round robin.
use crate::quantity::{BIT, BITS};
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Inputs of the arbiter where nothing else is asked for.
pub const INPUTS: u32 = 4;

/// Builds `arbiter` (parameter W) of `inputs` inputs, 2 to 32.
pub fn arbiter(inputs: u32) -> Arc<Module> {
    assert!((2..=32).contains(&inputs), "an arbiter has 2 to 32 inputs, not {inputs}");
    let b = Builder::new(
        "arbiter",
        file!(),
        "several streams into one: round robin, a grant is kept until its word transfers",
    );
    b.note("After a transfer the inputs above the granted one come first, then those from input 0 up: each waits for at most one word of every other.");
    b.note("Combinational from in_valid to out_valid and from out_ready to in_ready.");
    b.choice("inputs", inputs);
    let w = b.param("W", 8, "bits of a word");
    b.require(1, &w);
    b.clock();
    b.reset();
    let in_valid = b.input("in_valid", inputs, BITS, "input valid, a bit an input; stays 1 until the transfer");
    let o_ready = b.output("in_ready", inputs, BITS, "input ready (transfer when valid && ready), a bit an input");
    let in_data =
        b.input("in_data", w.clone() * i64::from(inputs), BITS, "input words, that of input 0 in the low bits");
    let o_valid = b.output("out_valid", 1, BIT, "output valid");
    let out_ready = b.input("out_ready", 1, BIT, "output ready (transfer when valid && ready)");
    let o_data = b.output("out_data", &w, BITS, "word of the granted input");
    let o_grant = b.output("out_grant", inputs, BITS, "the granted input, one-hot; 0 while no input is valid");

    let first = b
        .loop_reg("asked_first_q", inputs, true)
        .doc("the inputs above the last grant, which come first [mask; 0: from input 0 up]");
    let kept = b.loop_reg("kept_q", inputs, true).doc("the grant that waits for its transfer [one-hot; 0: none]");

    b.section(
        "grant",
        "The lowest valid input of those that come first, or of all; but a grant that waits for ready is kept.",
    );
    let one = b.lit(1, inputs);
    let preferred = (in_valid & first).named("preferred");
    let asking = preferred.any().mux(preferred, in_valid).named("asking");
    let lowest = (asking & !(asking - one)).named("lowest");
    let chosen = kept.any().mux(kept, lowest).named("chosen");
    let grant = (chosen & in_valid).named("grant");
    let valid = grant.any().named("any_grant");

    b.section("state", "Which inputs come first, and the grant that waits.");
    let transfer = (valid & out_ready).named("transfer");
    let above = (!(grant | (grant - one))).named("above_grant");
    b.close(&[
        (first, transfer.mux(above, first).named("asked_first_next")),
        (kept, (grant & !out_ready.rep(inputs)).named("kept_next")),
    ]);

    b.section("data", "The word of the granted input.");
    let word = |k: u32| in_data.slice(w.clone() * i64::from(k), &w);
    let data = (0..inputs - 1).rev().fold(word(inputs - 1), |other, k| grant.bit(k).mux(word(k), other));
    b.drive(o_ready, (grant & out_ready.rep(inputs)).named("ready"));
    b.drive(o_valid, valid);
    b.drive(o_data, data.named("selected"));
    b.drive(o_grant, grant);
    b.finish_streams(&[[("W".to_string(), 1)].into(), [("W".to_string(), 100)].into()])
}
