//! `div_rows`: rows of restoring division, one quotient bit each.
use crate::quantity::BITS;
use reliefrtl_ir::{Builder, Expr, Module, Prim, Sig};
use std::sync::Arc;

/// Builds the rows (parameters W, ROWS), combinational.
pub fn div_rows_module(width: u32, rows: u32) -> Arc<Module> {
    let b = Builder::new(
        "div_rows",
        file!(),
        "rows of restoring division: compare, subtract, double; one quotient bit each",
    );
    b.note("rem_in must be less than twice div.");
    let w = b.param("W", width, "bits of the divisor");
    let n = b.param("ROWS", rows, "quotient bits");
    b.require(2, &w);
    b.require(&w, 62);
    b.require(1, &n);
    b.require(&n, 64);
    b.input("rem_in", &w + 1, BITS, "dividend, or the remainder that the rows before left");
    b.input("div", &w, BITS, "divisor");
    b.output("rem_out", &w + 1, BITS, "remainder, doubled once a row");
    b.output("quot", &n, BITS, "quotient bits, the first on top");
    b.finish_primitive(Prim::DivRows)
}

/// Instantiates `rows` rows; returns remainder and quotient bits.
pub fn div_rows<'b>(
    b: &'b Builder,
    instance: &str,
    rem: Sig<'b>,
    div: Sig<'b>,
    w: &Expr,
    rows: &Expr,
    index: usize,
) -> (Sig<'b>, Sig<'b>) {
    let module = div_rows_module(17, 19);
    let params = [("W", w.clone()), ("ROWS", rows.clone())];
    let o = b.inst(&module, instance, &params, &[("rem_in", rem), ("div", div)]);
    (o["rem_out"].named(&format!("rem_{index}")), o["quot"].named(&format!("digits_{index}")))
}
