//! `delay_line`: a word some clocks later, in a small memory instead of registers (`latency.delay_line`).
use crate::quantity::BITS;
use reliefrtl_ir::{Builder, Lines, Module, Prim, with_lines};
use std::sync::Arc;

/// Clocks of the longest line: a memory of 16 words, as look-up tables have, and a register after it.
const MOST: u32 = 17;

/// Builds the line (parameters W, CLOCKS).
pub fn delay_line_module() -> Arc<Module> {
    let b = Builder::new("delay_line", file!(), "a word, delayed by CLOCKS clocks in a ring of words");
    b.note("CLOCKS - 1 words in a memory of look-up tables, read and written at one place, and a register: what CLOCKS registers in a row do.");
    b.note(
        "The place may start anywhere, so it has no reset; its initial value is for simulators and for devices that load one. \
         A simulation of a netlist that has lost it stays undefined: there, latency.delay_line = 0 keeps registers instead.",
    );
    let w = b.param("W", 8, "bits of the word");
    let clocks = b.param("CLOCKS", 4, "clocks from in_data to out_data");
    b.require(1, &w);
    b.require(3, &clocks);
    b.require(&clocks, i64::from(MOST));
    b.clock();
    b.clock_enable();
    b.input("in_data", &w, BITS, "the word");
    b.output("out_data", &w, BITS, "the word of CLOCKS clocks ago");
    b.finish_primitive(Prim::DelayLine)
}

/// `list` with what waits `least` clocks or longer in delay lines, and the line before them; as it is if `least` is 0.
pub fn in_lines(list: Vec<Arc<Module>>, least: u32) -> Vec<Arc<Module>> {
    if least == 0 {
        return list;
    }
    let lines = Lines { least, most: MOST, line: delay_line_module() };
    std::iter::once(lines.line.clone()).chain(list.iter().map(|m| with_lines(m, &lines))).collect()
}
