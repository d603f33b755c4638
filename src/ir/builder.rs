//! Describing a module: values that know their stage, registers that appear by themselves.
use super::expr::{Binding, Expr};
use super::module::*;
use super::schedule::plan_stages;
use std::cell::RefCell;
use std::collections::BTreeMap;

/// A module under construction. Values are [`Sig`]s; using values of different stages together delays the earlier
/// ones, so that changing a latency anywhere rebalances everything after it.
pub struct Builder {
    pub(super) st: RefCell<State>,
}

pub(super) struct State {
    pub m: Module,
    pub defaults: Binding,
    pub section: usize,
    pub min_stage: u32,
    /// Stage of the outputs, at least.
    pub least: u32,
    /// What drives each output.
    pub driven: Vec<Driven>,
    plan: BTreeMap<String, u32>,
    delays: BTreeMap<(NodeId, u32), NodeId>,
}

/// An output that is driven.
#[derive(Clone, Copy)]
pub(super) struct Driven {
    pub port: usize,
    pub by: NodeId,
    /// Where the text was then: nodes before it, and the section.
    pub nodes: usize,
    pub section: usize,
}

/// A value in a module under construction.
#[derive(Clone, Copy)]
pub struct Sig<'b> {
    pub(super) b: &'b Builder,
    pub(super) id: NodeId,
}

impl Builder {
    /// Starts a module; `source` is the Rust file that describes it.
    pub fn new(name: &str, source: &str, summary: &str) -> Self {
        let m = Module {
            name: name.into(),
            summary: summary.into(),
            choices: vec![],
            described: vec![],
            variant_memo: Default::default(),
            notes: vec![],
            source: source.into(),
            params: vec![],
            files: vec![],
            checks: vec![],
            locals: vec![],
            ports: vec![],
            nodes: vec![],
            insts: vec![],
            outputs: vec![],
            unused: vec![],
            sections: vec![Section::default()],
            latency: None,
            throughput: "one result per clock".into(),
            body: Body::Graph,
            clk: None,
            ce: None,
            rst: None,
        };
        let (defaults, plan, delays) = (Binding::new(), BTreeMap::new(), BTreeMap::new());
        Self {
            st: RefCell::new(State { m, defaults, section: 0, min_stage: 0, least: 0, driven: vec![], plan, delays }),
        }
    }

    /// A line for the banner.
    pub fn note(&self, line: impl Into<String>) {
        self.st.borrow_mut().m.notes.push(line.into());
    }
    /// What was chosen at generation and no parameter can change; names the module where an instance asks for another.
    pub fn choice(&self, name: &str, word: impl ToString) {
        self.st.borrow_mut().m.choices.push((name.into(), word.to_string()));
    }
    /// What was chosen, too, and shows in ports, stages and operations: for the banner alone.
    pub fn describe(&self, name: &str, word: impl ToString) {
        self.st.borrow_mut().m.described.push((name.into(), word.to_string()));
    }
    /// Declares a Verilog parameter.
    pub fn param(&self, name: &str, default: u32, doc: &str) -> Expr {
        let mut st = self.st.borrow_mut();
        st.defaults.insert(name.into(), i64::from(default));
        st.m.params.push(Param { name: name.into(), default: i64::from(default), doc: doc.into() });
        Expr::param(name)
    }
    /// Declares a parameter that names a file for `$readmemh`, "" by default: no file.
    pub fn file_param(&self, name: &str, doc: &str) {
        self.st.borrow_mut().m.files.push(FileParam { name: name.into(), doc: doc.into() });
    }
    /// Names a derived constant; printed as a `localparam`.
    pub fn local(&self, name: &str, value: Expr, doc: &str) -> Expr {
        self.st.borrow_mut().m.locals.push(Local { name: name.into(), value: value.clone(), doc: doc.into() });
        Expr::local(name, value)
    }
    /// Requires `lhs <= rhs` of the parameters, each condition once; elaboration fails otherwise. Of two lower bounds the greater one stays.
    pub fn require(&self, lhs: impl Into<Expr>, rhs: impl Into<Expr>) {
        let (lhs, rhs) = (lhs.into(), rhs.into());
        let mut st = self.st.borrow_mut();
        let checks = &mut st.m.checks;
        if checks.iter().any(|c| c.lhs == lhs && c.rhs == rhs) {
            return;
        }
        let same = |c: &&mut Check| c.rhs == rhs && c.lhs.as_const().is_some() && lhs.as_const().is_some();
        match checks.iter_mut().find(same) {
            Some(c) if c.lhs.as_const() < lhs.as_const() => c.lhs = lhs,
            Some(_) => {}
            None => checks.push(Check { lhs, rhs }),
        }
    }
    /// Declares what a throughput of other than one result per clock is.
    pub fn throughput(&self, text: &str) {
        self.st.borrow_mut().m.throughput = text.into();
    }

    /// Registers that were asked for: the outputs stand in stage `stage`, or in a later one if what drives them does.
    pub fn at_least(&self, stage: u32) {
        let mut st = self.st.borrow_mut();
        st.least = st.least.max(stage);
    }
    /// Places the named sections over `latency` stages, balancing their weights (in LUT hops). The outputs stand in the last of them
    /// ([`Builder::at_least`]).
    pub fn plan(&self, latency: u32, sections: &[(&str, u32)]) {
        self.plan_from(0, latency, sections);
    }
    /// As [`Builder::plan`], from stage `first` on: before it stands what has registers of its own.
    pub fn plan_from(&self, first: u32, latency: u32, sections: &[(&str, u32)]) {
        self.at_least(first + latency);
        let stages = plan_stages(latency, &sections.iter().map(|s| s.1).collect::<Vec<_>>());
        let mut st = self.st.borrow_mut();
        st.plan = sections.iter().zip(stages).map(|(s, k)| (s.0.to_string(), first + k)).collect();
    }
    /// Opens a section: a heading in the emitted text, and the stage that the plan gave it.
    pub fn section(&self, title: &str, reason: &str) {
        let mut st = self.st.borrow_mut();
        st.m.sections.push(Section { title: title.into(), reason: reason.into() });
        st.section = st.m.sections.len() - 1;
        if let Some(s) = st.plan.get(title).copied() {
            st.min_stage = s;
        }
    }

    /// All zeros.
    pub fn zeros(&self, w: impl Into<Expr>) -> Sig<'_> {
        self.push_at(Op::Zeros, vec![], w.into(), None)
    }
    /// All ones.
    pub fn ones(&self, w: impl Into<Expr>) -> Sig<'_> {
        self.push_at(Op::Ones, vec![], w.into(), None)
    }
    /// A literal.
    pub fn lit(&self, v: u64, w: impl Into<Expr>) -> Sig<'_> {
        self.push_at(Op::Lit(v), vec![], w.into(), None)
    }
    /// A constant expression over the parameters, modulo 2^w.
    pub fn konst(&self, v: impl Into<Expr>, w: impl Into<Expr>) -> Sig<'_> {
        self.push_at(Op::Konst(v.into()), vec![], w.into(), None)
    }
    /// Concatenation, first on top.
    #[track_caller]
    pub fn cat(&self, parts: &[Sig<'_>]) -> Sig<'_> {
        let w = parts.iter().fold(Expr::from(0), |s, p| s + p.width());
        self.push(Op::Concat, parts.iter().map(|p| p.id).collect(), w)
    }
    /// A net that is driven later by [`Builder::connect`]: for handshakes that run against the flow of the data.
    pub fn wire(&self, name: &str, width: impl Into<Expr>) -> Sig<'_> {
        self.push_at(Op::Wire, vec![], width.into(), None).named(name)
    }
    /// Drives a wire.
    pub fn connect(&self, wire: Sig<'_>, v: Sig<'_>) {
        self.st.borrow_mut().m.nodes[wire.id.0 as usize].args = vec![v.id];
    }
    /// A register of a loop: read in stage 0, written by [`Builder::close`].
    pub fn loop_reg(&self, name: &str, width: impl Into<Expr>, valid: bool) -> Sig<'_> {
        let s = self.push_at(Op::Reg { reset: valid, wrap: true, unknown: None }, vec![], width.into(), Some(0));
        self.st.borrow_mut().m.nodes[s.id.0 as usize].valid = valid;
        s.named(name)
    }
    /// A loop register of one bit that is never unknown in a simulation once it was clocked: an unknown value counts as `unknown`. For
    /// decisions about data that a handshake follows from.
    pub fn loop_decision(&self, name: &str, valid: bool, unknown: bool) -> Sig<'_> {
        let s = self.loop_reg(name, 1, valid);
        self.st.borrow_mut().m.nodes[s.id.0 as usize].op = Op::Reg { reset: valid, wrap: true, unknown: Some(unknown) };
        s
    }
    /// Closes loop registers: all values are delayed to the latest of their stages; returns the loop's length in slots.
    #[track_caller]
    pub fn close(&self, loops: &[(Sig<'_>, Sig<'_>)]) -> u32 {
        let last = loops.iter().filter_map(|(_, v)| v.stage()).max().unwrap_or(0);
        for (r, v) in loops {
            let v = v.at(last);
            let mut st = self.st.borrow_mut();
            st.m.nodes[r.id.0 as usize].args = vec![v.id];
        }
        last + 1
    }
    /// A value that is deliberately not used (or not whole): printed as a named sink.
    pub fn unused(&self, v: Sig<'_>) {
        self.st.borrow_mut().m.unused.push(v.id);
    }

    /// Adds a node at the latest stage of its operands.
    #[track_caller]
    pub(super) fn push(&self, op: Op, args: Vec<NodeId>, width: Expr) -> Sig<'_> {
        let stage = args.iter().filter_map(|a| self.st.borrow().m.node(*a).stage).max();
        let stage = stage.map(|s| s.max(self.st.borrow().min_stage));
        let args = match stage {
            Some(s) => args.iter().map(|a| Sig { b: self, id: *a }.at(s).id).collect(),
            None => args,
        };
        self.push_at(op, args, width, stage)
    }
    pub(super) fn push_at(&self, op: Op, args: Vec<NodeId>, width: Expr, stage: Stage) -> Sig<'_> {
        let mut st = self.st.borrow_mut();
        let section = st.section;
        st.m.nodes.push(Node {
            op,
            args,
            width,
            name: None,
            stage,
            section,
            valid: false,
            doc: None,
            handshaked: false,
        });
        Sig { b: self, id: NodeId(st.m.nodes.len() as u32 - 1) }
    }
    /// `v` one register later; shared by all that ask.
    #[track_caller]
    pub(super) fn delay_once(&self, v: NodeId) -> NodeId {
        self.delay_as(v, None)
    }
    /// The same; an unknown bit counts as `unknown` from there on.
    #[track_caller]
    pub(super) fn delay_as(&self, v: NodeId, unknown: Option<bool>) -> NodeId {
        let (node, stage) = {
            let st = self.st.borrow();
            let n = st.m.node(v).clone();
            let s = n.stage.expect("only staged values are delayed");
            if let Some(d) = st.delays.get(&(v, s + 1)) {
                assert!(unknown.is_none(), "the register after a decision is its first");
                return *d;
            }
            (n, s)
        };
        let name = node.name.unwrap_or_else(|| panic!("a {} without a name crosses a stage: name it", node.op.name()));
        let op = Op::Reg { reset: node.valid, wrap: false, unknown };
        let d = self.push_at(op, vec![v], node.width, Some(stage + 1));
        let mut st = self.st.borrow_mut();
        let n = &mut st.m.nodes[d.id.0 as usize];
        (n.name, n.valid) = (Some(name), node.valid);
        st.delays.insert((v, stage + 1), d.id);
        d.id
    }

    /// The latest stage of some values; 0 if none has one.
    pub fn latest<'b>(&self, values: impl Iterator<Item = Sig<'b>>) -> u32 {
        values.filter_map(Sig::stage).max().unwrap_or(0)
    }
    /// A value by its id (closures can't name a value's lifetime).
    pub fn sig(&self, id: NodeId) -> Sig<'_> {
        Sig { b: self, id }
    }
}
