//! Ports of a module under construction: clock, enable, reset, inputs by stage, outputs and what drives them.
use super::builder::{Builder, Driven, Sig};
use super::expr::Expr;
use super::module::*;
use super::quantity::{BIT, CLOCK, Quantity};

impl Builder {
    fn port(&self, name: &str, dir: Dir, width: Expr, unit: Quantity, doc: &str, stage: Stage) -> usize {
        let mut st = self.st.borrow_mut();
        st.m.ports.push(Port { name: name.into(), dir, width, doc: doc.into(), unit, stage });
        st.m.ports.len() - 1
    }
    /// The clock port.
    pub fn clock(&self) {
        let i = self.port("clk", Dir::In, Expr::from(1), CLOCK, "rising edge", None);
        self.st.borrow_mut().m.clk = Some(i);
    }
    /// The clock enable port: every register of the module holds while it is 0.
    pub fn clock_enable(&self) -> Sig<'_> {
        let i = self.port("ce", Dir::In, Expr::from(1), BIT, "clock enable: registers hold while 0", None);
        self.st.borrow_mut().m.ce = Some(i);
        self.push_at(Op::Input(i), vec![], Expr::from(1), None).named("ce")
    }
    /// The reset port: synchronous, active high; for valid bits and counts.
    pub fn reset(&self) -> Sig<'_> {
        let i = self.port(
            "rst",
            Dir::In,
            Expr::from(1),
            BIT,
            "synchronous, active high; clears valid bits and counts, no data",
            None,
        );
        self.st.borrow_mut().m.rst = Some(i);
        self.push_at(Op::Input(i), vec![], Expr::from(1), None).named("rst")
    }
    /// A data input, read in stage 0.
    pub fn input(&self, name: &str, width: impl Into<Expr>, unit: Quantity, doc: &str) -> Sig<'_> {
        self.input_at(name, width.into(), unit, doc, Some(0))
    }
    /// An input that belongs to no stage: handshakes, load ports, values that stand still.
    pub fn input_static(&self, name: &str, width: impl Into<Expr>, unit: Quantity, doc: &str) -> Sig<'_> {
        self.input_at(name, width.into(), unit, doc, None)
    }
    fn input_at(&self, name: &str, width: Expr, unit: Quantity, doc: &str, stage: Stage) -> Sig<'_> {
        let i = self.port(name, Dir::In, width.clone(), unit, doc, stage);
        self.push_at(Op::Input(i), vec![], width, stage).named(name)
    }
    /// Declares an output in port order; drive it with [`Builder::drive`].
    pub fn output(&self, name: &str, width: impl Into<Expr>, unit: Quantity, doc: &str) -> usize {
        self.port(name, Dir::Out, width.into(), unit, doc, None)
    }
    /// Drives an output. At the module's end it stands in the stage of the latest output: see [`Builder::finish`].
    #[track_caller]
    pub fn drive(&self, port: usize, v: Sig<'_>) {
        let mut st = self.st.borrow_mut();
        let (pw, vw) = (st.m.ports[port].width.eval(&st.defaults), st.m.node(v.id).width.eval(&st.defaults));
        assert!(pw == vw, "{}: output {} has {pw} bits, its driver {vw}", st.m.name, st.m.ports[port].name);
        let driven = Driven { port, by: v.id, nodes: st.m.nodes.len(), section: st.section };
        st.driven.push(driven);
    }
}
