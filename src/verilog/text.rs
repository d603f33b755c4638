//! The whole text of a module: what stands before the body, then stages, loop, outputs.
use super::align::aligned;
use super::bundle::{Bundle, Bundles};
use super::expr::{Binds, Expressions};
use super::header::has_word;
use super::layout::{COLUMNS, bare, filled, range, wrap};
use super::prim;
use super::style::Style;
use crate::ir::{Atom, Body, Expr, Module, Names, NodeId, Op};

/// Prints a module. The same module gives the same bytes: no date, path, host or hash order reaches the text.
pub fn print_module(m: &Module, style: &Style) -> String {
    let names = Names::new(m);
    let bundles = Bundles::of(&names);
    let mut p = Printer { names, bundles, m, style, out: String::new() };
    let body = match m.body {
        Body::Graph => {
            p.graph();
            aligned(&std::mem::take(&mut p.out)).lines().map(wrap).collect()
        }
        Body::Prim(prim) => prim::body(prim).into_owned(),
    };
    let body = body + "endmodule\n" + style.closing();
    p.banner();
    p.header();
    p.constants(&body);
    p.checks();
    p.out + &body
}

pub(super) struct Printer<'m> {
    pub(super) names: Names<'m>,
    bundles: Bundles,
    pub(super) m: &'m Module,
    pub(super) style: &'m Style,
    pub(super) out: String,
}

impl Printer<'_> {
    /// A line of the body; it is broken when the whole body stands.
    fn line(&mut self, s: &str) {
        self.out += s;
        self.out.push('\n');
    }

    /// The range of a width in the body: by the `localparam` that has the same value everywhere, where there is one.
    fn range(&self, w: &Expr) -> String {
        range(&self.named(w))
    }

    fn named(&self, w: &Expr) -> Expr {
        let named = |e: &Expr| e.parts().0.iter().any(|(a, _)| matches!(a, Atom::Local(..)));
        let flat = w.expanded();
        // A number and a parameter alone say more than a name for them.
        let plain = matches!(flat.parts(), ([], _) | ([(Atom::Param(_), 1)], 0));
        let same = self.m.locals.iter().find(|(_, e)| !plain && !named(w) && e.expanded() == flat);
        same.map_or_else(|| w.clone(), |(name, e)| Expr::local(name, e.clone()))
    }

    fn heading(&mut self, stage: u32, title: &str, reason: &str) {
        self.out.push('\n');
        let text = match (self.names.staged, title) {
            (true, "") => format!("stage {stage}"),
            (true, t) => format!("stage {stage}: {t}"),
            (false, t) => t.to_string(),
        };
        let file = self.m.source.rsplit('/').next().unwrap_or_default();
        let head = format!("  // ---- {text} ");
        self.out += &format!("{head}{} {file}\n", "-".repeat(90usize.saturating_sub(head.len() + file.len() + 1)));
        if !reason.is_empty() {
            self.comment("  ", "", reason);
        }
    }

    fn graph(&mut self) {
        let m = self.m;
        let last = self.names.stage.iter().copied().max().unwrap_or(0);
        let mut inst_done = vec![false; m.insts.len()];
        self.loop_declarations();
        for stage in 0..=last {
            let mut section = usize::MAX;
            if stage > 0 {
                self.heading(stage, "registers", "");
                self.registers(stage);
                section = usize::MAX - 1;
            }
            for (i, n) in m.nodes.iter().enumerate() {
                let id = NodeId(i as u32);
                if let Op::InstOut(inst, _) = n.op {
                    let at = m.insts[inst.0 as usize].stage.unwrap_or(self.names.stage[i]);
                    if at == stage && !inst_done[inst.0 as usize] {
                        self.enter(&mut section, m.insts[inst.0 as usize].section, stage);
                        self.instance(inst.0 as usize);
                        inst_done[inst.0 as usize] = true;
                    }
                    continue;
                }
                let plain = !matches!(n.op, Op::Reg { .. } | Op::Wire | Op::Input(_)) && !n.op.is_const();
                if self.names.stage[i] != stage || !plain {
                    continue;
                }
                if let Some(net) = self.names.net(id) {
                    self.enter(&mut section, n.section, stage);
                    let (e, _) = self.names.expr(n);
                    let r = self.range(&n.width);
                    self.line(&format!("  wire {r}{}{net} = {e};", if r.is_empty() { "" } else { " " }));
                }
            }
        }
        self.loop_registers();
        self.sinks();
        self.out += "\n";
        let mut wires = self.wires();
        wires.retain(|w| !self.names.drives_wire(w.2));
        for (net, _, driver) in wires {
            let (e, _) = self.names.operand(driver);
            self.line(&format!("  assign {net} = {e};"));
        }
        for (p, id) in &m.outputs {
            let (e, _) = self.names.operand(*id);
            self.line(&format!("  assign {} = {e};", m.ports[*p].name));
        }
    }

    fn enter(&mut self, current: &mut usize, section: usize, stage: u32) {
        if *current == section {
            return;
        }
        let s = &self.m.sections[section];
        if !s.title.is_empty() {
            let (t, r) = (s.title.clone(), s.reason.clone());
            self.heading(stage, &t, &r);
        } else if *current == usize::MAX {
            self.out.push('\n');
        }
        *current = section;
    }

    fn declare_reg(&mut self, id: NodeId) -> String {
        let net = self.names.net(id).expect("registers have names");
        let r = self.range(&self.m.node(id).width);
        self.out += &format!("  reg {r}{}{net};\n", if r.is_empty() { "" } else { " " });
        net
    }

    fn loop_declarations(&mut self) {
        let ids: Vec<NodeId> = self.regs(|wrap, _| wrap);
        if ids.is_empty() {
            return;
        }
        self.out += "\n  // ---- state that comes back from the last stage, and handshakes\n";
        for id in ids {
            self.declare_reg(id);
        }
        for (net, width, _) in self.wires() {
            let r = self.range(&width);
            self.line(&format!("  wire {r}{}{net};", if r.is_empty() { "" } else { " " }));
        }
    }

    /// Wires that are declared before what drives them: net, width, driver.
    fn wires(&self) -> Vec<(String, crate::ir::Expr, NodeId)> {
        let all = self.m.nodes.iter().enumerate().filter(|(_, n)| n.op == Op::Wire);
        all.map(|(i, n)| (self.names.net(NodeId(i as u32)).unwrap_or_default(), n.width.clone(), n.args[0])).collect()
    }

    fn regs(&self, keep: impl Fn(bool, u32) -> bool) -> Vec<NodeId> {
        let all = self.m.nodes.iter().enumerate();
        let regs = all.filter(|(i, n)| matches!(n.op, Op::Reg { wrap, .. } if keep(wrap, self.names.stage[*i])));
        regs.map(|(i, _)| NodeId(i as u32)).collect()
    }

    fn registers(&mut self, stage: u32) {
        let mut ids = self.regs(|wrap, s| !wrap && s == stage);
        ids.retain(|id| !self.bundles.holds(*id));
        let nets: Vec<(String, NodeId)> = ids.into_iter().map(|id| (self.declare_reg(id), id)).collect();
        self.clocked(&nets);
        let bundles = std::mem::take(&mut self.bundles.list);
        bundles.iter().filter(|b| b.to == stage).for_each(|b| self.bundle(b));
        self.bundles.list = bundles;
    }

    /// Values that wait the same clocks: one shift register, whose oldest word stands in the nets of its last stage.
    fn bundle(&mut self, b: &Bundle) {
        let (clocks, inner) = (b.to - b.from, b.net());
        self.out += &format!("  // Delay of {clocks} clocks: stage {} to {}.\n", b.from, b.to);
        let last: Vec<String> = b.values.iter().map(|(_, last)| self.declare_reg(*last)).collect();
        let first: Vec<String> = b.values.iter().map(|(first, _)| self.names.operand(*first).0).collect();
        self.out += &format!("  reg {} {inner};\n", b.range(self.m, |w| self.named(w)));
        let enable = self.m.ce.map(|p| self.m.ports[p].name.clone());
        let (open, pad, close) = match enable {
            Some(ce) => (format!("    if ({ce}) begin\n"), "      ", "    end\n"),
            None => (String::new(), "    ", ""),
        };
        let oldest = filled(&format!("{pad}{{"), last.iter().chain([&inner]), "} <=");
        let newest = filled(&format!("{pad}    {{"), [&inner].into_iter().chain(&first), "};");
        self.out += &format!("  always @(posedge clk) begin\n{open}{oldest}{newest}{close}  end\n");
    }

    fn loop_registers(&mut self) {
        let ids = self.regs(|wrap, _| wrap);
        if ids.is_empty() {
            return;
        }
        self.out += "\n  // ---- back to stage 0\n";
        let nets: Vec<(String, NodeId)> =
            ids.into_iter().map(|id| (self.names.net(id).unwrap_or_default(), id)).collect();
        self.clocked(&nets);
    }

    /// Data registers, reset registers and decisions stand in separate blocks: mixed, the reset would become an enable.
    fn clocked(&mut self, nets: &[(String, NodeId)]) {
        let decides = |id: &NodeId| matches!(self.m.node(*id).op, Op::Reg { unknown: Some(_), .. });
        let (decisions, plain): (Vec<_>, Vec<_>) = nets.iter().cloned().partition(|(_, id)| decides(id));
        self.words(&plain);
        decisions.iter().for_each(|(net, id)| self.decision(net, *id));
    }

    /// A bit that is known in every simulation: the choice of `if` takes an unknown condition for a false one.
    fn decision(&mut self, net: &str, id: NodeId) {
        let node = self.m.node(id);
        let Op::Reg { reset, unknown: Some(as_known), .. } = node.op else { unreachable!("only decisions come here") };
        let (text, binds) = self.names.operand(node.args[0]);
        let condition = match (as_known, binds) {
            (false, _) => text,
            (true, Binds::Primary) => format!("!{text}"),
            (true, _) => format!("!({text})"),
        };
        let known = u8::from(as_known);
        self.out += &format!("  // An unknown bit of a simulation counts as {known}: none reaches a handshake.\n");
        self.out += "  always @(posedge clk) begin\n";
        let clear = format!("      {net} <= 1'b0;\n    end else ");
        let enable = self.m.ce.map(|p| self.m.ports[p].name.clone());
        let (open, pad) = match (reset, &enable) {
            (true, None) => (format!("    if (rst) begin\n{clear}"), "    "),
            (true, Some(ce)) => (format!("    if (rst) begin\n{clear}if ({ce}) begin\n      "), "      "),
            (false, None) => ("    ".to_string(), "    "),
            (false, Some(ce)) => (format!("    if ({ce}) begin\n      "), "      "),
        };
        self.out += &open;
        self.line(&format!("if ({condition}) begin"));
        for (value, end) in [(1 - known, "end else begin"), (known, "end")] {
            self.out += &format!("{pad}  {net} <= 1'b{value};\n{pad}{end}\n");
        }
        self.out += if enable.is_some() { "    end\n  end\n" } else { "  end\n" };
    }

    fn words(&mut self, nets: &[(String, NodeId)]) {
        let enable = self.m.ce.map(|p| self.m.ports[p].name.clone());
        let resets = |id: &NodeId| matches!(self.m.node(*id).op, Op::Reg { reset: true, .. });
        let (valid, data): (Vec<_>, Vec<_>) = nets.iter().cloned().partition(|(_, id)| resets(id));
        if !data.is_empty() {
            self.out += "  always @(posedge clk) begin\n";
            let pad = match &enable {
                Some(ce) => {
                    self.out += &format!("    if ({ce}) begin\n");
                    "      "
                }
                None => "    ",
            };
            for (net, id) in &data {
                let d = self.names.operand(self.m.node(*id).args[0]).0;
                self.line(&format!("{pad}{net} <= {d};"));
            }
            self.out += if enable.is_some() { "    end\n  end\n" } else { "  end\n" };
        }
        if !valid.is_empty() {
            self.out += "  always @(posedge clk) begin\n    if (rst) begin\n";
            for (net, id) in &valid {
                let zero = super::layout::fill(&self.m.node(*id).width, 0);
                self.out += &format!("      {net} <= {zero};\n");
            }
            self.out += &match &enable {
                Some(ce) => format!("    end else if ({ce}) begin\n"),
                None => "    end else begin\n".to_string(),
            };
            for (net, id) in &valid {
                let d = self.names.operand(self.m.node(*id).args[0]).0;
                self.line(&format!("      {net} <= {d};"));
            }
            self.out += "    end\n  end\n";
        }
    }

    fn instance(&mut self, index: usize) {
        let m = self.m;
        let inst = &m.insts[index];
        let mut pins: Vec<(usize, String)> =
            inst.inputs.iter().map(|(p, id)| (*p, self.names.operand(*id).0)).collect();
        for (i, n) in m.nodes.iter().enumerate() {
            let Op::InstOut(k, port) = n.op else { continue };
            if k.0 as usize == index {
                let net = self
                    .names
                    .net(NodeId(i as u32))
                    .unwrap_or_else(|| panic!("{}: output of {} needs a name", m.name, inst.name));
                let r = self.range(&n.width);
                if !self.names.drives_wire(NodeId(i as u32)) {
                    self.line(&format!("  wire {r}{}{net};", if r.is_empty() { "" } else { " " }));
                }
                pins.push((port, net));
            }
        }
        if let Some(c) = inst.module.clk {
            pins.push((c, "clk".into()));
        }
        pins.sort();
        let module = format!("{}{}", self.style.prefix, inst.module.name);
        let value = |(n, e): &(String, Expr)| format!(".{n}({})", bare(&e.to_string()));
        let file = |(n, suffix): &(String, String)| match suffix.as_str() {
            "" => format!(".{n}({n})"),
            _ => format!(".{n}(({n} == \"\") ? \"\" : {{{n}, \"{suffix}\"}})"),
        };
        let terms = self.style.terms(&inst.module).into_iter().map(|t| format!(".{}({})", t.name, t.literal()));
        let params: Vec<String> =
            inst.params.iter().map(value).chain(terms).chain(inst.files.iter().map(file)).collect();
        let head = if params.is_empty() {
            format!("  {} {} (", module, inst.name)
        } else {
            format!("  {} #({}) {} (", module, params.join(", "), inst.name)
        };
        if head.len() <= COLUMNS {
            self.out += &format!("{head}\n");
        } else {
            self.out += &format!("  {module} #(\n");
            let n = params.len();
            for (i, p) in params.iter().enumerate() {
                self.out += &format!("    {p}{}\n", if i + 1 < n { "," } else { "" });
            }
            self.out += &format!("  ) {} (\n", inst.name);
        }
        let n = pins.len();
        for (i, (port, net)) in pins.iter().enumerate() {
            let comma = if i + 1 < n { "," } else { "" };
            self.line(&format!("    .{}({net}){comma}", inst.module.ports[*port].name));
        }
        self.out += "  );\n";
    }

    /// Bits that nothing needs; in a unit without registers, clock, enable and reset are among them.
    fn sinks(&mut self) {
        let m = self.m;
        let idle = |p: &Option<usize>| p.map(|p| m.ports[p].name.clone()).filter(|name| !has_word(&self.out, name));
        let idle: Vec<String> = [m.clk, m.ce, m.rst].iter().filter_map(idle).collect();
        if m.unused.is_empty() && idle.is_empty() {
            return;
        }
        self.out += "\n  // Bits that nothing needs, named so that no lint has to be switched off for the rest.\n";
        self.out += "  // verilator lint_off UNUSED\n";
        for (k, id) in m.unused.iter().enumerate() {
            let (e, _) = self.names.operand(*id);
            self.line(&format!("  wire unused_{k} = &{{1'b0, {e}}};"));
        }
        if !idle.is_empty() {
            self.line(&format!("  wire unused_control = &{{1'b0, {}}};", idle.join(", ")));
        }
        self.out += "  // verilator lint_on UNUSED\n";
    }
}
