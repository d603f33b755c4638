//! Delay lines beside a pipeline with a clock enable: a ray's tag and valid bit, and what a result carries along.
use crate::ir::{Builder, Module};
use std::sync::Arc;

/// Builds a delay of `clocks` under the name `name`: a word of W bits and a valid bit that reset clears.
pub fn stream_delay(name: &str, clocks: u32, width: u32) -> Arc<Module> {
    build(name, clocks, Some(width), true)
}

/// Builds a delay of `clocks` for a word of W bits alone.
pub fn word_delay(name: &str, clocks: u32, width: u32) -> Arc<Module> {
    build(name, clocks, Some(width), false)
}

/// Builds a delay of `clocks` for a valid bit alone.
pub fn valid_delay(name: &str, clocks: u32) -> Arc<Module> {
    build(name, clocks, None, true)
}

fn build(name: &str, clocks: u32, width: Option<u32>, with_valid: bool) -> Arc<Module> {
    let what = match (width, with_valid) {
        (Some(_), true) => "a word and its valid bit",
        (Some(_), false) => "a word",
        _ => "a valid bit",
    };
    let b = Builder::new(name, file!(), &format!("{what}, delayed beside a pipeline"));
    let word = width.map(|w| {
        let w = b.param("W", w, "bits of the word");
        b.require(1, &w);
        w
    });
    b.clock();
    b.clock_enable();
    if with_valid {
        b.reset();
        let valid = b.input("in_valid", 1, "bit", "the word counts").named("valid").valid();
        let port = b.output("out_valid", 1, "bit", "the delayed word counts");
        b.drive(port, valid, Some(clocks));
    }
    if let Some(w) = word {
        let data = b.input("in_data", &w, "bits", "the word").named("data");
        let port = b.output("out_data", &w, "bits", "the delayed word");
        b.drive(port, data, Some(clocks));
    }
    b.finish(Some(clocks), &[])
}
