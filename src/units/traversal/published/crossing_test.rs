//! `crossing_test`: is the predicted hit in another node, so that the ray crosses into its neighbour? (PIDM-HW section 4.2,
//! NC test and test for the end.)
use crate::float::{FormatParams, bindings, fp_lt};
use crate::quantity::{BIT, float};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module, Sig};
use std::sync::Arc;

/// Builds `crossing_test`.
pub fn crossing_test(d: &Design) -> Arc<Module> {
    let b = Builder::new("crossing_test", file!(), "node crossing test: does the predicted hit lie in another node?");
    let f = FormatParams::declare(&b, d.format);
    b.clock();
    b.clock_enable();
    let mut sides = Vec::new();
    for axis in ["x", "y"] {
        let hit = b.input(&format!("{axis}_hit"), &f.width, float("texels"), "predicted hit");
        let edge = b.input(&format!("{axis}_edge"), &f.width, float("texels"), "exit plane");
        let neg = b.input(&format!("{axis}_neg"), 1, BIT, "the ray runs toward smaller coordinates");
        sides.push((axis, hit, edge, neg));
    }
    let t = b.input("t", &f.width, float("height range"), "parameter so far");
    let t_exit = b.input("t_exit", &f.width, float("height range"), "parameter of the nearer exit plane");
    let crosses = b.output("crosses", 1, BIT, "the ray goes to the neighbour");
    let t_next = b.output("t_next", &f.width, float("height range"), "parameter of a crossing, never before t");
    let lt = fp_lt(d.format, d.latency.compare);

    b.section("compare", "All four comparisons at once; the selects follow.");
    let beyond: Vec<Sig<'_>> = sides
        .iter()
        .map(|(axis, hit, edge, neg)| {
            let less = b.inst(&lt, &format!("u_{axis}_edge"), &[], &[("a", *hit), ("b", *edge)]).only();
            // A node holds its lower planes and not its upper ones.
            let less = less.named(&format!("{axis}_below_edge"));
            (!(less ^ *neg)).named(&format!("{axis}_beyond")).id()
        })
        .map(|id| b.sig(id))
        .collect();
    let one_exp = b.konst(f.bias(), &f.exp).named("one_exp").doc("biased exponent of 1");
    let one = b.cat(&[b.zeros(1), one_exp, b.zeros(&f.man)]);
    let past = b.inst(&lt, "u_end", &[], &[("a", one), ("b", t_exit)]).only().named("past_end");
    let grows = b.inst(&lt, "u_t_exit", &[], &[("a", t), ("b", t_exit)]).only().named("t_advances");

    b.section("select", "A plane beyond the end of the ray is never crossed.");
    b.drive(crosses, ((beyond[0] | beyond[1]) & !past).named("exits_node"));
    b.drive(t_next, grows.mux(t_exit, t).named("t_after"));
    b.finish(&bindings())
}
