//! `interleave`: two words in Morton order, the first in the even bits.
use crate::quantity::BITS;
use reliefrtl_ir::{Builder, Module, Prim, Sig};
use std::sync::Arc;

/// Builds the interleaver (parameter W), wires only.
pub fn interleave_module(width: u32) -> Arc<Module> {
    let b = Builder::new("interleave", file!(), "two words in Morton order: a in the even bits, b in the odd ones");
    let w = b.param("W", width, "bits of each word");
    b.require(1, &w);
    b.require(&w, 32);
    b.input("a", &w, BITS, "word for the even bits");
    b.input("b", &w, BITS, "word for the odd bits");
    b.output("result", w.clone() * 2, BITS, "b[W-1] a[W-1] .. b[0] a[0]");
    b.finish_primitive(Prim::Interleave)
}

/// Instantiates an interleaver.
pub fn interleave<'b>(b: &'b Builder, instance: &str, even: Sig<'b>, odd: Sig<'b>, name: &str) -> Sig<'b> {
    b.inst(&interleave_module(8), instance, &[("W", even.width())], &[("a", even), ("b", odd)]).only().named(name)
}
