//! Delay beside a pipeline with a clock enable: a word's valid bit, and what it carries along.
use crate::quantity::{BIT, BITS};
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds a delay of `clocks` under the name `name` (parameter W): a word, and its valid bit, which reset clears.
pub fn stream_delay(name: &str, clocks: u32) -> Arc<Module> {
    build(name, clocks, true)
}

/// Builds a delay of `clocks` for a word alone (parameter W).
pub fn word_delay(name: &str, clocks: u32) -> Arc<Module> {
    build(name, clocks, false)
}

fn build(name: &str, clocks: u32, with_valid: bool) -> Arc<Module> {
    let what = if with_valid { "a word and its valid bit" } else { "a word" };
    let b = Builder::new(name, file!(), &format!("{what}, delayed beside a pipeline"));
    let w = b.param("W", 8, "bits of the word");
    b.require(1, &w);
    b.clock();
    b.clock_enable();
    b.at_least(clocks);
    if with_valid {
        b.reset();
        let valid = b.input("in_valid", 1, BIT, "the word is valid").named("valid").valid();
        let port = b.output("out_valid", 1, BIT, "the delayed word is valid");
        b.drive(port, valid);
    }
    let data = b.input("in_data", &w, BITS, "the word").named("data");
    let port = b.output("out_data", &w, BITS, "the delayed word");
    b.drive(port, data);
    b.finish(&[])
}
