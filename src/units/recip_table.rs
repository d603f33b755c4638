//! `recip_table`: a line under the reciprocal for each value of a significand's top fraction bits.
use crate::quantity::BITS;
use reliefrtl_base::bits::{INDEX_W, SLOPE_W, START_W};
use reliefrtl_ir::{Builder, Module, Prim, Sig};
use std::sync::Arc;

/// Builds the table, one clock.
pub fn recip_table_module() -> Arc<Module> {
    let b = Builder::new("recip_table", file!(), "start and slope of the reciprocal in 256 intervals of a significand");
    b.note(format!(
        "Divisors from (256 + index) / 256 up, below 2. The upper {START_W} bits are the reciprocal less 1/2 there, in units of 2^-22; the lower \
         {SLOPE_W} how much it falls at each 2^-16, in units of 2^-28. A block memory: constants, and a register that holds while ce is 0."
    ));
    b.clock();
    b.clock_enable();
    b.input("index", INDEX_W, BITS, "the divisor's fraction bits below the leading one");
    b.output("word", START_W + SLOPE_W, BITS, "start, then slope, one clock later");
    b.finish_primitive(Prim::RecipTable)
}

/// The word for `index`, one clock later: start and slope.
pub fn recip_table<'b>(b: &'b Builder, index: Sig<'b>) -> Sig<'b> {
    b.inst(&recip_table_module(), "u_table", &[], &[("index", index)]).only().named("line")
}
