//! `sqrt_rows`: rows of restoring square root, one digit each.
use crate::quantity::BITS;
use reliefrtl_ir::{Builder, Expr, Module, Prim, Sig};
use std::sync::Arc;

/// Builds the rows (parameters W, ROWS, FIRST), combinational.
pub fn sqrt_rows_module(width: u32, rows: u32) -> Arc<Module> {
    let b = Builder::new(
        "sqrt_rows",
        file!(),
        "rows of restoring square root: double, compare, subtract; one digit of the root each",
    );
    b.note("The root's top bit weighs 1, the remainder has one integer bit more; digit k weighs 2^-k.");
    b.note("rem_in must be less than twice the root and the place of its last digit.");
    let w = b.param("W", width, "bits of the root");
    let n = b.param("ROWS", rows, "digits");
    let first = b.param("FIRST", 1, "the first digit; those above it stand in root_in");
    b.require(2, &w);
    b.require(&w, 61);
    b.require(1, &n);
    b.require(1, &first);
    b.require(&first + &n, &w);
    b.input("rem_in", &w + 1, BITS, "remainder that the rows before left");
    b.input("root_in", &w, BITS, "digits so far");
    b.output("rem_out", &w + 1, BITS, "remainder, doubled once a row");
    b.output("root_out", &w, BITS, "digits so far and those of these rows");
    b.finish_primitive(Prim::SqrtRows)
}

/// Instantiates `rows` rows for the digits from `first` on; returns remainder and root.
pub fn sqrt_rows<'b>(
    b: &'b Builder,
    rem: Sig<'b>,
    root: Sig<'b>,
    first: &Expr,
    rows: &Expr,
    index: usize,
) -> (Sig<'b>, Sig<'b>) {
    let module = sqrt_rows_module(18, 17);
    let params = [("W", root.width()), ("ROWS", rows.clone()), ("FIRST", first.clone())];
    let o = b.inst(&module, &format!("u_rows_{index}"), &params, &[("rem_in", rem), ("root_in", root)]);
    (o["rem_out"].named(&format!("rem_{index}")), o["root_out"].named(&format!("root_{index}")))
}
