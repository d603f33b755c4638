//! `node_crossing`: does the ray meet the node's height before it leaves, and if not, by which plane does it leave?
//! (PIDM-HW section 3.2; here on ray parameters: no position is ever moved.)
use crate::float::{FormatParams, bindings, fp_lt};
use crate::quantity::{BIT, float};
use reliefrtl_config::{Design, Register};
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `node_crossing`.
pub fn node_crossing(d: &Design) -> Arc<Module> {
    let b =
        Builder::new("node_crossing", file!(), "node crossing test: hit inside the node, or exit plane and parameter");
    let f = FormatParams::declare(&b, d.format);
    b.clock();
    b.clock_enable();
    let t = b.input("t", &f.width, float("height codes"), "parameter so far");
    let m = b.input("m", &f.width, float("height codes"), "parameter at which the node's height is met");
    let t_x = b.input("t_x", &f.width, float("height codes"), "parameter of the x exit plane");
    let t_y = b.input("t_y", &f.width, float("height codes"), "parameter of the y exit plane");
    let inside = b.output("is_inside", 1, BIT, "the height is met before the ray leaves");
    let x_first = b.output("x_first", 1, BIT, "the x plane comes first, or both at once");
    let t_next = b.output(
        "t_next",
        &f.width,
        float("height codes"),
        "parameter after a crossing: that of the exit plane, at least t",
    );
    let lt = fp_lt(d.format, d.latency.compare);

    b.section("compare", "All five comparisons at once; the selects follow.");
    let in_x = b.inst(&lt, "u_m_tx", &[], &[("a", m), ("b", t_x)]).only().named("m_lt_x");
    let in_y = b.inst(&lt, "u_m_ty", &[], &[("a", m), ("b", t_y)]).only().named("m_lt_y");
    let y_less = b.inst(&lt, "u_ty_tx", &[], &[("a", t_y), ("b", t_x)]).only().named("y_lt_x");
    let grow_x = b.inst(&lt, "u_t_tx", &[], &[("a", t), ("b", t_x)]).only().named("t_lt_x");
    let grow_y = b.inst(&lt, "u_t_ty", &[], &[("a", t), ("b", t_y)]).only().named("t_lt_y");

    b.section("select", "");
    let exit = y_less.mux(t_y, t_x).named("t_exit");
    let grow = y_less.mux(grow_y, grow_x).named("t_advances");
    let next = grow.mux(exit, t).named("t_after");
    b.drive(inside, (in_x & in_y).named("in_both"));
    b.drive(x_first, (!y_less).named("x_exits_first"));
    b.drive(t_next, next.reg_if(d.latency.has(Register::Parameter)));
    b.finish(&bindings())
}
