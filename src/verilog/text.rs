//! The whole text of a module: banner, parameters, ports, stages, loop, outputs.
use super::expr::{Expressions, konst_name};
use super::layout::{COLUMNS, is_wide, range, wide, wrap};
use super::prim;
use crate::ir::{Body, Dir, Module, Names, NodeId, Op};

/// What the text has besides the module itself.
#[derive(Clone, Debug, Default)]
pub struct Style {
    /// The line of the banner that names the configuration.
    pub config: String,
    /// Stands before every module name.
    pub prefix: String,
}

/// Prints a module. The same module gives the same bytes: no date, path, host or hash order reaches the text.
pub fn print_module(m: &Module, style: &Style) -> String {
    let mut p = Printer { names: Names::new(m), m, style, out: String::new() };
    match m.body {
        Body::Graph => p.graph(),
        Body::Prim(prim) => p.out += prim::body(prim),
    }
    p.out += "endmodule\n`default_nettype wire\n";
    let body = std::mem::take(&mut p.out);
    p.banner();
    p.header();
    p.constants(&body);
    p.checks();
    p.out + &body
}

fn has_word(text: &str, word: &str) -> bool {
    text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).any(|w| w == word)
}

struct Printer<'m> {
    names: Names<'m>,
    m: &'m Module,
    style: &'m Style,
    out: String,
}

impl Printer<'_> {
    fn line(&mut self, s: &str) {
        self.out += &wrap(s);
    }
    fn comment(&mut self, indent: &str, head: &str, text: &str) {
        let mut line = format!("{indent}// {head}");
        for word in text.split_whitespace() {
            if line.len() + 1 + word.len() > COLUMNS {
                self.out += line.trim_end();
                self.out.push('\n');
                line = format!("{indent}// {}", " ".repeat(head.len().saturating_sub(1)));
            }
            if !line.ends_with(' ') {
                line.push(' ');
            }
            line += word;
        }
        self.out += line.trim_end();
        self.out.push('\n');
    }

    fn banner(&mut self) {
        let m = self.m;
        self.comment("", &format!("{}{}:", self.style.prefix, m.name), &m.summary);
        self.comment("", "Source     ", &format!("{} (emitted: do not edit)", m.source));
        self.comment("", "Config     ", &self.style.config);
        let latency = match m.latency {
            Some(0) => "none, combinational".to_string(),
            Some(1) => "1 clock".to_string(),
            Some(k) => format!("{k} clocks"),
            None => "varies; valid/ready on both sides".to_string(),
        };
        self.comment("", "Latency    ", &latency);
        if m.latency != Some(0) {
            self.comment("", "Throughput ", &m.throughput);
        }
        for n in &m.notes {
            self.comment("", "Note       ", n);
        }
    }

    fn header(&mut self) {
        let m = self.m;
        self.out += "`default_nettype none\n";
        self.out += &format!("module {}{}", self.style.prefix, m.name);
        if !m.params.is_empty() {
            self.out += " #(\n";
            let wide = m.params.iter().map(|p| p.name.len() + p.default.to_string().len()).max().unwrap_or(0);
            for (i, p) in m.params.iter().enumerate() {
                let comma = if i + 1 < m.params.len() { "," } else { "" };
                let decl = format!("{} = {}{comma}", p.name, p.default);
                self.out += format!("  parameter integer {decl:w$}  // {}", p.doc, w = wide + 4).trim_end();
                self.out.push('\n');
            }
            self.out += ")";
        }
        self.out += " (\n";
        let ranges: Vec<String> = m.ports.iter().map(|p| range(&p.width.expanded())).collect();
        let rw = ranges.iter().map(String::len).max().unwrap_or(0);
        let nw = m.ports.iter().map(|p| p.name.len()).max().unwrap_or(0) + 1;
        for (i, p) in m.ports.iter().enumerate() {
            let comma = if i + 1 < m.ports.len() { "," } else { "" };
            let dir = if p.dir == Dir::In { "input " } else { "output" };
            let name = format!("{}{comma}", p.name);
            let unit =
                if ["bit", "clock", ""].contains(&p.unit.as_str()) { String::new() } else { format!(" [{}]", p.unit) };
            let decl = format!("  {dir} wire {:rw$} {name:nw$}", ranges[i]);
            let full = format!("{decl}  // {}{unit}", p.doc);
            if full.len() > COLUMNS {
                self.comment("  ", "", &format!("{}{unit}", p.doc));
                self.out += decl.trim_end();
            } else {
                self.out += &full;
            }
            self.out.push('\n');
        }
        self.out += ");\n";
    }

    /// The derived constants that the body needs, directly or through another.
    fn constants(&mut self, body: &str) {
        let m = self.m;
        let mut text = body.to_string();
        let mut used = vec![false; m.locals.len()];
        for (i, (name, e)) in m.locals.iter().enumerate().rev() {
            let konsts = m.nodes.iter().filter_map(|n| if let Op::Konst(k) = &n.op { Some(k) } else { None });
            used[i] = has_word(&text, name) || konsts.into_iter().any(|k| has_word(&k.to_string(), name));
            if used[i] {
                text += &format!(" {e} ");
            }
        }
        for (_, (name, e)) in m.locals.iter().enumerate().filter(|(i, _)| used[*i]) {
            self.line(&format!("  localparam integer {name} = {e};"));
        }
        let mut seen = Vec::new();
        for n in &m.nodes {
            let Op::Konst(e) = &n.op else { continue };
            let name = konst_name(n);
            if seen.contains(&name) {
                continue;
            }
            // An integer has 32 bits, and a part-select beyond them is undefined.
            if is_wide(e) || n.width.as_const().is_some_and(|w| w > 32) {
                self.line(&format!("  localparam [63:0] {name} = {};", wide(e)));
            } else {
                self.line(&format!("  localparam integer {name} = {e};"));
            }
            seen.push(name);
        }
    }

    fn checks(&mut self) {
        if self.m.checks.is_empty() {
            return;
        }
        self.out += "\n  // Illegal parameters end elaboration here: the missing module's name says what must hold.\n  generate\n";
        for (i, c) in self.m.checks.iter().enumerate() {
            let word = |s: String| {
                let t: String = s.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
                t.split('_').filter(|x| !x.is_empty()).collect::<Vec<_>>().join("_")
            };
            let sum = |e: &crate::ir::Expr| word(e.to_string().replace(" + ", " plus ").replace(" - ", " minus "));
            let name = format!("must_hold_{}_at_most_{}", sum(&c.lhs), sum(&c.rhs));
            self.line(&format!("    if ({} > {}) begin : gen_illegal_{i}", c.lhs, c.rhs));
            self.line(&format!("      {name} u_illegal ();"));
            self.line("    end");
        }
        self.out += "  endgenerate\n";
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
                self.heading(stage, "", "");
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
                    let r = range(&n.width);
                    self.line(&format!("  wire {r}{}{net} = {e};", if r.is_empty() { "" } else { " " }));
                }
            }
        }
        self.loop_registers();
        self.sinks();
        self.out += "\n";
        for (net, _, driver) in self.wires() {
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
        let r = range(&self.m.node(id).width);
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
            self.line(&format!("  wire {}{}{net};", range(&width), if width.as_const() == Some(1) { "" } else { " " }));
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
        let ids = self.regs(|wrap, s| !wrap && s == stage);
        let nets: Vec<(String, NodeId)> = ids.into_iter().map(|id| (self.declare_reg(id), id)).collect();
        self.clocked(&nets);
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

    /// Data registers and reset registers stand in separate blocks: mixed, the reset would become an enable.
    fn clocked(&mut self, nets: &[(String, NodeId)]) {
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
                let r = range(&n.width);
                self.line(&format!("  wire {r}{}{net};", if r.is_empty() { "" } else { " " }));
                pins.push((port, net));
            }
        }
        if let Some(c) = inst.module.clk {
            pins.push((c, "clk".into()));
        }
        pins.sort();
        let module = format!("{}{}", self.style.prefix, inst.module.name);
        let params: Vec<String> = inst.params.iter().map(|(n, e)| format!(".{n}({e})")).collect();
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

    fn sinks(&mut self) {
        if self.m.unused.is_empty() {
            return;
        }
        self.out += "\n  // Bits that nothing needs, named so that no lint has to be switched off for the rest.\n";
        self.out += "  // verilator lint_off UNUSED\n";
        for (k, id) in self.m.unused.iter().enumerate() {
            let (e, _) = self.names.operand(*id);
            self.line(&format!("  wire unused_{k} = &{{1'b0, {e}}};"));
        }
        self.out += "  // verilator lint_on UNUSED\n";
    }
}
