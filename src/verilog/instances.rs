//! Instances in the text: parameters and ports filled into lines.
use super::expr::Expressions;
use super::layout::{COLUMNS, bare, filled};
use super::printer::Printer;
use super::widths::by_parts;
use reliefrtl_ir::{Dir, Expr, Instance, NodeId, Op};

impl Printer<'_> {
    /// Instance `index` of the module, after the nets that it drives.
    pub(super) fn instance(&mut self, index: usize) {
        let m = self.m;
        let inst = &m.insts[index];
        let mut pins: Vec<(usize, String)> =
            inst.inputs.iter().map(|(p, id)| (*p, self.names.operand(*id).0)).collect();
        for (i, n) in m.nodes.iter().enumerate() {
            let Op::InstOut(k, port) = n.op else { continue };
            if k.0 as usize == index {
                let id = NodeId(i as u32);
                if let Some(parts) = self.apart.parts(id).map(<[NodeId]>::to_vec) {
                    pins.push((port, self.driven_apart(&parts)));
                    continue;
                }
                let net = self.names.net(id);
                let net = net.unwrap_or_else(|| panic!("{}: output of {} needs a name", m.name, inst.name));
                if !self.names.drives_wire(id) && !self.is_early(id) {
                    self.declare_output(id);
                }
                pins.push((port, net));
            }
        }
        if let Some(c) = inst.module.clk {
            pins.push((c, "clk".into()));
        }
        pins.sort();
        let connected = |dir: Dir| -> Vec<String> {
            let ports = &inst.module.ports;
            let of = pins.iter().filter(|(p, _)| ports[*p].dir == dir);
            of.map(|(p, net)| format!(".{}({net})", ports[*p].name)).collect()
        };
        let (ins, outs) = (connected(Dir::In), connected(Dir::Out));
        let head = self.instance_head(inst);
        let all: Vec<&str> = ins.iter().chain(&outs).map(String::as_str).collect();
        let whole = format!("{head}{});\n", all.join(", "));
        if !head.contains('\n') && whole.len() <= COLUMNS + 1 {
            self.out += &whole;
            return;
        }
        // Inputs, then outputs, which begin a line of their own.
        self.out += &format!("{head}\n");
        self.out += &filled("    ", &ins, ",");
        self.out += &filled("    ", &outs, "");
        self.out += "  );\n";
    }

    /// Declares the parts of a bundle that an instance drives; their concatenation.
    fn driven_apart(&mut self, parts: &[NodeId]) -> String {
        let mut nets = Vec::new();
        for id in parts {
            let (net, node) = (self.names.net(*id).expect("parts of a bundle have names"), self.m.node(*id));
            self.declaration("wire", &node.width, &net, "", node.doc.as_deref());
            nets.push(net);
        }
        format!("{{{}}}", nets.join(", "))
    }

    /// Module, parameters and name of an instance, up to the parenthesis of its ports.
    fn instance_head(&self, inst: &Instance) -> String {
        let module = format!("{}{}", self.style.prefix, inst.module.name);
        let value = |(n, e): &(String, Expr)| format!(".{n}({})", bare(&by_parts(self.m, e).to_string()));
        let file = |(n, suffix): &(String, String)| match suffix.as_str() {
            "" => format!(".{n}({n})"),
            _ => format!(".{n}(({n} == \"\") ? \"\" : {{{n}, \"{suffix}\"}})"),
        };
        let terms = self.style.terms(&inst.module).into_iter().map(|t| format!(".{}({})", t.name, t.literal()));
        let params: Vec<String> =
            inst.params.iter().map(value).chain(terms).chain(inst.files.iter().map(file)).collect();
        if params.is_empty() {
            return format!("  {module} {} (", inst.name);
        }
        let head = format!("  {module} #({}) {} (", params.join(", "), inst.name);
        if head.len() <= COLUMNS {
            return head;
        }
        format!("  {module} #(\n{}  ) {} (", filled("    ", &params, ""), inst.name)
    }
}
