//! Everything that stands before a module's body: banner, parameters, ports, derived constants, conditions.
use super::align::{COMMENT, above, commented};
use super::expr::konst_name;
use super::layout::{COLUMNS, bare, filled, is_wide, range, wide, wrap};
use super::printer::{Printer, has_word};
use super::style::SPDX;
use reliefrtl_ir::{Dir, Local, Op, Port};

impl Printer<'_> {
    /// What the module is, how long it takes, what was chosen.
    pub(super) fn banner(&mut self) {
        let m = self.m;
        self.out += &format!("// {SPDX}\n");
        self.comment("", &format!("{}{}: ", self.style.prefix, m.name), &m.summary);
        self.comment("", "Emitted    ", &format!("by reliefrtl as its unit {}; do not edit", m.name));
        let chosen: Vec<String> =
            m.choices.iter().chain(&m.described).map(|(name, word)| format!("{name} {word}")).collect();
        if !chosen.is_empty() {
            self.comment("", "Chosen     ", &chosen.join(", "));
        }
        let latency = match m.latency() {
            Some(0) => "none, combinational".to_string(),
            Some(1) => "1 clock".to_string(),
            Some(k) if m.params.iter().any(|p| p.name == "CLOCKS") => format!("CLOCKS clocks, {k} by default"),
            Some(k) => format!("{k} clocks"),
            None => "varies; valid/ready on both sides".to_string(),
        };
        self.comment("", "Latency    ", &latency);
        if m.latency() != Some(0) {
            self.comment("", "Throughput ", &m.throughput);
        }
        for n in &m.notes {
            self.comment("", "Note       ", n);
        }
    }

    /// Parameters, ports and derived constants, a line each. Where a port's range leaves no room for its name, ports are declared after the
    /// constants, whose names make the ranges short.
    pub(super) fn header(&mut self, body: &str) {
        let m = self.m;
        self.out += &self.style.opening();
        self.out += &format!("module {}{}", self.style.prefix, m.name);
        let own = m.params.iter().map(|p| (p.name.clone(), p.default.to_string(), p.doc.clone()));
        let terms = self.style.terms(m).into_iter().map(|t| (t.name.to_string(), t.literal(), t.doc.to_string()));
        let params: Vec<(String, String, String)> = own.chain(terms).collect();
        if !params.is_empty() || !m.files.is_empty() {
            self.out += " #(\n";
            let names = params.iter().map(|p| p.0.len()).max().unwrap_or(0);
            // What it was generated for is longer than the values of the others, whose lines have no room for that.
            let values = m.params.iter().map(|p| p.default.to_string().len()).max().unwrap_or(0) + 1;
            for (i, (name, value, doc)) in params.iter().enumerate() {
                let comma = if i + 1 < params.len() || !m.files.is_empty() { "," } else { "" };
                let value = format!("{value}{comma}");
                self.out += &format!("  parameter integer {name:names$} = {value:values$}  // {doc}");
                self.out.push('\n');
            }
            for (i, f) in m.files.iter().enumerate() {
                let comma = if i + 1 < m.files.len() { "," } else { "" };
                self.comment("  ", "", &f.doc);
                self.out += &format!("  parameter {} = \"\"{comma}\n", f.name);
            }
            self.out += ")";
        }
        self.out += " (\n";
        let ranges: Vec<String> = m.ports.iter().map(|p| range(&p.width.expanded())).collect();
        let lines = self.ports(&ranges, ",");
        if lines.iter().all(|l| l.len() <= COLUMNS) {
            self.declare(&lines, "");
            self.out += ");\n";
            self.constants(body);
        } else {
            let names: Vec<String> = m.ports.iter().map(|p| p.name.clone()).collect();
            self.out += &filled("  ", &names, "");
            self.out += ");\n";
            let ranges: Vec<String> = m.ports.iter().map(|p| self.range(&p.width)).collect();
            self.constants(&format!("{body} {}", ranges.join(" ")));
            self.out.push('\n');
            let lines = self.ports(&ranges, ";");
            self.declare(&lines, ";");
        }
    }

    /// A declaration of each port, with room for what ends it.
    fn ports(&self, ranges: &[String], end: &str) -> Vec<String> {
        let rw = ranges.iter().map(String::len).max().unwrap_or(0);
        let nw = self.m.ports.iter().map(|p| p.name.len()).max().unwrap_or(0) + end.len();
        let line = |(p, range): (&Port, &String)| {
            let dir = if p.dir == Dir::In { "input " } else { "output" };
            format!("  {dir} wire {range:rw$} {:nw$}", format!("{}{end}", p.name))
        };
        self.m.ports.iter().zip(ranges).map(line).collect()
    }

    /// Writes the declarations of the ports with what they mean; the last one ends with `last`.
    fn declare(&mut self, lines: &[String], last: &str) {
        let m = self.m;
        for (i, (p, line)) in m.ports.iter().zip(lines).enumerate() {
            let mut decl = line.clone();
            if i + 1 == lines.len() {
                let width = decl.len();
                decl.truncate(decl.trim_end().len() - 1);
                decl = format!("{:width$}", decl + last);
            }
            let full = format!("{decl}  // {}", p.meaning());
            if full.len() > COLUMNS {
                self.comment("  ", "", &p.meaning());
                self.out += decl.trim_end();
            } else {
                self.out += &full;
            }
            self.out.push('\n');
        }
    }

    /// The derived constants that the body needs, directly or through another.
    fn constants(&mut self, body: &str) {
        let m = self.m;
        let mut text = body.to_string();
        let mut used = vec![false; m.locals.len()];
        for (i, Local { name, value: e, .. }) in m.locals.iter().enumerate().rev() {
            let konsts = m.nodes.iter().filter_map(|n| if let Op::Konst(k) = &n.op { Some(k) } else { None });
            used[i] = has_word(&text, name) || konsts.into_iter().any(|k| has_word(&k.to_string(), name));
            if used[i] {
                text += &format!(" {e} ");
            }
        }
        let local = |(_, l): (usize, &Local)| constant("integer", &l.name, &l.value.to_string(), Some(&l.doc));
        let mut lines: Vec<String> = m.locals.iter().enumerate().filter(|(i, _)| used[*i]).map(local).collect();
        let mut seen = Vec::new();
        for n in &m.nodes {
            let Op::Konst(e) = &n.op else { continue };
            let name = konst_name(n);
            if seen.contains(&name) {
                continue;
            }
            // An integer has 32 bits, and a part-select beyond them is undefined.
            let is_wide = is_wide(e) || n.width.as_const().is_some_and(|w| w > 32);
            let (kind, value) = if is_wide { ("[63:0]", wide(e)) } else { ("integer", e.to_string()) };
            lines.push(constant(kind, &name, &value, n.doc.as_deref()));
            seen.push(name);
        }
        self.out += &commented(&lines);
    }

    /// What parameters may be.
    pub(super) fn checks(&mut self) {
        let terms = self.style.terms(self.m);
        if self.m.checks.is_empty() && terms.is_empty() {
            return;
        }
        self.out += "\n  // Parameter checks: an illegal value ends elaboration at a missing module that names the rule.\n  generate\n";
        for (i, c) in self.m.checks.iter().enumerate() {
            let word = |s: String| {
                let t: String = s.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
                t.split('_').filter(|x| !x.is_empty()).collect::<Vec<_>>().join("_")
            };
            let sum = |e: &reliefrtl_ir::Expr| {
                let text = e
                    .to_string()
                    .replace("(1 << (EXP_W - 1)) - 1", "the exponent bias")
                    .replace("(1 << ", "(2 to the ");
                word(text.replace(" + ", " plus ").replace(" - ", " minus "))
            };
            let name = match c.lhs.as_const() {
                Some(_) => format!("{}_must_be_at_least_{}", sum(&c.rhs), sum(&c.lhs)),
                None => format!("{}_must_be_at_most_{}", sum(&c.lhs), sum(&c.rhs)),
            };
            // An identifier starts with a letter.
            let name = if name.starts_with(|d: char| d.is_ascii_digit()) { format!("sum_{name}") } else { name };
            let condition = match c.lhs.as_const() {
                Some(_) => format!("{} < {}", c.rhs, c.lhs),
                None => format!("{} > {}", c.lhs, c.rhs),
            };
            let head = format!("    if ({condition}) begin : gen_illegal_{i}");
            let whole = format!("{head} {name} u_illegal (); end");
            if whole.len() <= COLUMNS {
                self.out += &format!("{whole}\n");
            } else {
                self.out += &wrap(&head);
                self.out += &wrap(&format!("      {name} u_illegal ();"));
                self.out += "    end\n";
            }
        }
        // One after the other: some tools name only the last of several that are missing.
        for (i, t) in terms.iter().enumerate() {
            let branch = t.name.to_ascii_lowercase();
            let head = if i > 0 { "    end else if" } else { "    if" };
            self.out += &format!("{head} ({} != {}) begin : gen_other_{branch}\n", t.name, t.literal());
            let tail = " u_illegal ();";
            let most = COLUMNS.saturating_sub("      ".len() + self.style.prefix.len() + tail.len());
            self.out += &format!("      {}{}{tail}\n", self.style.prefix, self.m.misfit(t, most));
        }
        if !terms.is_empty() {
            self.out += "    end\n";
        }
        self.out += "  endgenerate\n";
    }
}

/// A derived constant, without the end of its last line; its meaning after it, or above one that takes lines.
fn constant(kind: &str, name: &str, value: &str, doc: Option<&str>) -> String {
    let code = wrap(&format!("  localparam {kind} {name} = {};", bare(value)));
    let code = code.trim_end();
    match doc {
        None => code.to_owned(),
        Some(doc) if code.contains('\n') => format!("{}{code}", above(doc)),
        Some(doc) => format!("{code}{COMMENT}{doc}"),
    }
}
