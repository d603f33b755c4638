//! Registers in the text: a stage's, those of a loop, delay bundles.
use super::bundle::Bundle;
use super::expr::{Binds, Expressions};
use super::layout::{COLUMNS, fill, filled};
use super::printer::Printer;
use super::widths::named;
use reliefrtl_ir::{Expr, NodeId, Op};

impl Printer<'_> {
    fn declare_reg(&mut self, id: NodeId) -> String {
        let net = self.names.net(id).expect("registers have names");
        let node = self.m.node(id);
        self.declaration("reg", &node.width, &net, "", node.doc.as_deref());
        net
    }

    pub(super) fn loop_declarations(&mut self) {
        let ids: Vec<NodeId> = self.regs(|wrap, _| wrap);
        let early = self.early_outputs();
        if ids.is_empty() && self.wires().is_empty() && early.is_empty() {
            return;
        }
        if !ids.is_empty() {
            self.rule("state registers, written at the end of the module");
        }
        for id in ids {
            self.declare_reg(id);
        }
        if !self.wires().is_empty() || !early.is_empty() {
            self.rule("nets that are driven further below");
        }
        for (id, _) in self.wires() {
            let (net, node) = (self.names.net(id).expect("wires have names"), self.m.node(id));
            self.declaration("wire", &node.width, &net, "", node.doc.as_deref());
        }
        early.into_iter().for_each(|id| self.declare_output(id));
    }

    /// Outputs that are read at the beginning of the loop, of instances that stand at its end.
    fn early_outputs(&self) -> Vec<NodeId> {
        let all = (0..self.m.nodes.len()).map(|i| NodeId(i as u32));
        all.filter(|id| self.is_early(*id) && !self.names.drives_wire(*id) && self.apart.parts(*id).is_none()).collect()
    }

    /// Whether an output of an instance belongs to an earlier stage than the one that the instance stands in.
    pub(super) fn is_early(&self, id: NodeId) -> bool {
        let Op::InstOut(k, _) = self.m.node(id).op else { return false };
        self.m.insts[k.0 as usize].stage.is_some_and(|at| self.names.stage[id.0 as usize] < at)
    }

    /// Declares the net of an instance's output.
    pub(super) fn declare_output(&mut self, id: NodeId) {
        let (m, node) = (self.m, self.m.node(id));
        let Op::InstOut(k, port) = node.op else { return };
        let inst = &m.insts[k.0 as usize];
        let net = self.names.net(id).unwrap_or_else(|| panic!("{}: output of {} needs a name", m.name, inst.name));
        let doc = node.doc.clone().unwrap_or_else(|| inst.module.ports[port].meaning());
        self.declaration("wire", &node.width, &net, "", Some(&doc));
    }

    pub(super) fn regs(&self, keep: impl Fn(bool, u32) -> bool) -> Vec<NodeId> {
        let all = self.m.nodes.iter().enumerate();
        let regs = all.filter(|(i, n)| matches!(n.op, Op::Reg { wrap, .. } if keep(wrap, self.names.stage[*i])));
        regs.map(|(i, _)| NodeId(i as u32)).collect()
    }

    /// The registers at the end of the step to `stage`; whether there are any.
    pub(super) fn registers(&mut self, stage: u32) -> bool {
        let mut ids = self.regs(|wrap, s| !wrap && s == stage);
        ids.retain(|id| !self.bundles.holds(*id));
        let bundles = std::mem::take(&mut self.bundles.list);
        let ending = || bundles.iter().filter(|b| b.to == stage);
        let any = !ids.is_empty() || ending().next().is_some();
        if any {
            self.heading(stage, "registers", "");
            let nets: Vec<(String, NodeId)> = ids.into_iter().map(|id| (self.declare_reg(id), id)).collect();
            self.clocked(&nets);
            ending().for_each(|b| self.bundle(b));
        }
        self.bundles.list = bundles;
        any
    }

    /// Values that wait the same clocks: one shift register, whose oldest word stands in the nets of its last stage.
    fn bundle(&mut self, b: &Bundle) {
        let (clocks, inner) = (b.to - b.from, b.net());
        self.out += &format!("  // Delay of {clocks} clocks: stage {} to {}.\n", b.from, b.to);
        let last: Vec<String> = b.last().map(|last| self.declare_reg(last)).collect();
        let first: Vec<String> = b.values.iter().map(|(first, _)| self.names.operand(*first).0).collect();
        let by_name = |w: &Expr| named(self.m, w);
        let all = fill(&(b.width(self.m, by_name) * i64::from(clocks)), 0);
        self.out += &format!("  reg {} {inner};\n", b.range(self.m, by_name));
        let shift = |pad: &str| {
            let oldest = filled(&format!("{pad}{{"), last.iter().chain([&inner]), "} <=");
            let newest = filled(&format!("{pad}    {{"), [&inner].into_iter().chain(&first), "};");
            let line = format!("{} {}", oldest.trim_end(), newest.trim());
            if line.len() <= COLUMNS && !line.contains('\n') { line + "\n" } else { oldest + &newest }
        };
        let enable = self.m.ce.map(|p| self.m.ports[p].name.clone());
        let body = match (b.reset, enable) {
            (false, None) => shift("    "),
            (false, Some(ce)) => format!("    if ({ce}) begin\n{}    end\n", shift("      ")),
            (true, enable) => {
                let clear = filled("      {", last.iter().chain([&inner]), &format!("}} <= {all};"));
                let or = enable.map_or(String::new(), |ce| format!(" if ({ce})"));
                format!("    if (rst) begin\n{clear}    end else{or} begin\n{}    end\n", shift("      "))
            }
        };
        self.out += &format!("  always @(posedge clk) begin\n{body}  end\n");
    }

    pub(super) fn loop_registers(&mut self) {
        let ids = self.regs(|wrap, _| wrap);
        if ids.is_empty() {
            return;
        }
        self.rule("state registers");
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
        self.out +=
            &format!("  // In simulation an unknown bit (x) counts as {known}, so that no x reaches a handshake.\n");
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
                let zero = fill(&self.m.node(*id).width, 0);
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
}
