//! The whole text of a module: what stands before the body, then stages, loop, outputs.
use super::align::aligned;
use super::apart::Apart;
use super::bundle::Bundles;
use super::expr::Expressions;
use super::layout::wrap;
use super::prim;
use super::printer::{Printer, has_word};
use super::style::Style;
use reliefrtl_ir::{Body, Module, Names, NodeId, Op};

/// Prints a module. The same module gives the same bytes: no date, path, host or hash order reaches the text.
pub fn print_module(m: &Module, style: &Style) -> String {
    let names = Names::new(m);
    let (bundles, apart) = (Bundles::of(&names), Apart::of(m));
    let mut p = Printer { names, bundles, apart, m, style, out: String::new() };
    let body = match m.body {
        Body::Graph => {
            p.graph();
            aligned(&std::mem::take(&mut p.out)).lines().map(wrap).collect()
        }
        Body::Prim(prim) => prim::body(prim).into_owned(),
    };
    let body = body + "endmodule\n" + style.closing();
    p.banner();
    p.header(&body);
    p.checks();
    p.out + &body
}

impl Printer<'_> {
    fn graph(&mut self) {
        let m = self.m;
        let last = self.names.stage.iter().copied().max().unwrap_or(0);
        let mut inst_done = vec![false; m.insts.len()];
        self.loop_declarations();
        for stage in 0..=last {
            let mut section = usize::MAX;
            if stage > 0 && self.registers(stage) {
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
                if self.names.stage[i] != stage || !plain || self.apart.is_part(id) {
                    continue;
                }
                if let Some(net) = self.names.net(id) {
                    self.enter(&mut section, n.section, stage);
                    let (e, _) = self.names.expr(n);
                    self.declaration("wire", &n.width, &net, &format!(" = {e}"), n.doc.as_deref());
                }
            }
        }
        self.loop_registers();
        self.sinks();
        self.out += "\n";
        let mut wires = self.wires();
        wires.retain(|w| !self.names.drives_wire(w.1));
        for (id, driver) in wires {
            let (net, (e, _)) = (self.names.net(id).expect("wires have names"), self.names.operand(driver));
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

    /// Wires that are declared before what drives them, and what that is.
    pub(super) fn wires(&self) -> Vec<(NodeId, NodeId)> {
        let all = self.m.nodes.iter().enumerate().filter(|(_, n)| n.op == Op::Wire);
        let all = all.map(|(i, n)| (NodeId(i as u32), n.args[0]));
        all.filter(|(wire, _)| !self.names.is_driven_early(*wire)).collect()
    }

    /// Bits that nothing needs; in a unit without registers, clock, enable and reset are among them.
    fn sinks(&mut self) {
        let m = self.m;
        let idle = |p: &Option<usize>| p.map(|p| m.ports[p].name.clone()).filter(|name| !has_word(&self.out, name));
        let idle: Vec<String> = [m.clk, m.ce, m.rst].iter().filter_map(idle).collect();
        if m.unused.is_empty() && idle.is_empty() {
            return;
        }
        self.out += "\n  // Nets and bits that nothing reads, at some parameter values or at all, gathered so that the\n  // lint for unused bits stays on for all others.\n";
        self.out += "  // verilator lint_off UNUSED\n";
        for (k, id) in m.unused.iter().enumerate() {
            let (e, _) = self.names.operand(*id);
            // A concatenation needs no braces of its own in another one.
            let one = self.m.node(*id).op == Op::Concat && self.names.net(*id).is_none();
            let e = if one { &e[1..e.len() - 1] } else { &e };
            self.line(&format!("  wire unused_{k} = &{{1'b0, {e}}};"));
        }
        if !idle.is_empty() {
            self.line(&format!("  wire unused_control = &{{1'b0, {}}};", idle.join(", ")));
        }
        self.out += "  // verilator lint_on UNUSED\n";
    }
}

#[cfg(test)]
mod tests {
    use super::super::bundle::{delayed_bit, delayed_net};
    use super::*;
    use reliefrtl_ir::{BIT, BITS, Binding, Builder};

    /// A module whose three words of 8 bits come out `clocks` later, beside a valid bit.
    fn module(clocks: u32) -> std::sync::Arc<Module> {
        let b = Builder::new("m", file!(), "delays");
        b.clock();
        b.reset();
        let words = ["x", "y", "z"].map(|name| b.input(name, 8, BITS, "a word").named(&format!("word_{name}")));
        let valid = b.input("in_valid", 1, BIT, "the words count").named("valid").valid();
        let outs = ["a", "b", "c"].map(|name| b.output(name, 8, BITS, "the word"));
        outs.iter().zip(words).for_each(|(out, word)| b.drive(*out, word));
        let out = b.output("out_valid", 1, BIT, "the words count");
        b.drive(out, valid);
        b.at_least(clocks);
        b.finish(&[])
    }

    fn text(clocks: u32) -> String {
        print_module(&module(clocks), &Style::default())
    }

    #[test]
    fn values_that_wait_alike_share_one_shift_register() {
        let all = text(7);
        let data = "  reg [143:0] s0_to_s7;\n  always @(posedge clk) begin\n    {s7_word_x, s7_word_y, s7_word_z, \
                    s0_to_s7} <= {s0_to_s7, x, y, z};\n  end\n";
        let valid = "    if (rst) begin\n      {s7_valid, s0_to_s7_valid} <= 7'd0;\n    end else begin\n      \
                     {s7_valid, s0_to_s7_valid} <= {s0_to_s7_valid, in_valid};\n    end\n";
        assert!(all.contains(data) && all.contains(valid) && !all.contains("s1_"), "{all}");
        // Three registers are none that a bundle is for.
        let few = text(3);
        assert!(few.contains("s3_valid <= s2_valid;") && few.contains("{s3_word_x, "), "{few}");
        assert!(!text(1).contains("_to_"));
    }

    #[test]
    fn a_stage_without_registers_of_its_own_has_no_heading() {
        assert_eq!(text(7).matches(": registers").count(), 1);
    }

    #[test]
    fn bits_of_a_shift_register_have_names() {
        let m = module(7);
        let name = |bit| delayed_bit(&m, "s0_to_s7", bit);
        assert_eq!(name(0).as_deref(), Some("s1_word_z[0]"));
        assert_eq!(name(8 + 3).as_deref(), Some("s1_word_y[3]"));
        assert_eq!(name(2 * 24 + 23).as_deref(), Some("s3_word_x[7]"));
        assert_eq!((name(6 * 24), delayed_bit(&m, "s0_to_s3", 0)), (None, None));
        assert_eq!(delayed_bit(&m, "s0_to_s7_valid", 2).as_deref(), Some("s3_valid"));
    }

    #[test]
    fn a_value_is_found_in_every_stage() {
        let net = |m: &Module, value, stage, bits| delayed_net(m, &Binding::new(), value, stage, bits);
        let m = module(7);
        assert_eq!(net(&m, "word_z", 1, (0, 8)).as_deref(), Some("s0_to_s7[7:0]"));
        assert_eq!(net(&m, "word_x", 3, (7, 1)).as_deref(), Some("s0_to_s7[71]"));
        assert_eq!(net(&m, "word_x", 7, (0, 8)).as_deref(), Some("s7_word_x"));
        assert_eq!(net(&m, "valid", 3, (0, 1)).as_deref(), Some("s0_to_s7_valid[2]"));
        assert_eq!(net(&m, "valid", 7, (0, 1)).as_deref(), Some("s7_valid"));
        assert_eq!(net(&module(3), "valid", 2, (0, 1)).as_deref(), Some("s2_valid"));
        assert_eq!((net(&m, "valid", 8, (0, 1)), net(&m, "word_w", 1, (0, 8))), (None, None));
    }
}
