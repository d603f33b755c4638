//! Many modules in one run of Icarus: one bench with an instance of each, operands and results from one file.
use crate::simulators::skip;
use reliefrtl::ir::{Binding, Module};
use reliefrtl::verilog::{Style, print_module};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::process::Command;

/// Modules and rows that are still to be run.
pub struct Batch {
    modules: BTreeMap<String, String>,
    benches: String,
    data: String,
    words: usize,
    instances: usize,
    checks: usize,
}

impl Batch {
    /// Nothing.
    pub fn new() -> Self {
        let (benches, data) = (String::new(), String::new());
        Self { modules: BTreeMap::new(), benches, data, words: 0, instances: 0, checks: 0 }
    }

    /// An instance of `m`, with rows of inputs and the rows of outputs that are expected.
    pub fn add(
        &mut self,
        m: &Module,
        b: &Binding,
        ins: Vec<(String, u32)>,
        outs: Vec<(String, u32)>,
        rows: &[Vec<u64>],
        expected: &[Vec<u64>],
    ) {
        self.modules.entry(m.name.clone()).or_insert_with(|| print_module(m, &Style::default()));
        let n = self.instances;
        let columns = ins.len() + outs.len();
        let mut text = format!("module bench_{n};\n  integer k;\n");
        let mut pins = Vec::new();
        for (name, w) in &ins {
            writeln!(text, "  reg [{}:0] {name};", w - 1).unwrap();
            pins.push(format!(".{name}({name})"));
        }
        for (name, w) in &outs {
            writeln!(text, "  wire [{}:0] {name};", w - 1).unwrap();
            pins.push(format!(".{name}({name})"));
        }
        let params: Vec<String> = b.iter().map(|(k, v)| format!(".{k}({v})")).collect();
        let params = if params.is_empty() { String::new() } else { format!("#({}) ", params.join(", ")) };
        writeln!(text, "  {} {params}dut ({});", m.name, pins.join(", ")).unwrap();
        writeln!(text, "  initial begin\n    #1;\n    for (k = 0; k < {}; k = k + 1) begin", rows.len()).unwrap();
        for (c, (name, _)) in ins.iter().enumerate() {
            writeln!(text, "      {name} = top.data[{} + k * {columns} + {c}];", self.words).unwrap();
        }
        writeln!(text, "      #1;").unwrap();
        for (c, (name, w)) in outs.iter().enumerate() {
            let at = format!("top.data[{} + k * {columns} + {}]", self.words, ins.len() + c);
            writeln!(text, "      if ({{{{(64 - {w}){{1'b0}}}}, {name}}} !== {at})").unwrap();
            writeln!(
                text,
                "        $display(\"WRONG {} {b:?}: row %0d, {name} is %h, not %h\", k, {name}, {at});",
                m.name
            )
            .map(|()| ())
            .unwrap();
            writeln!(text, "      top.checks = top.checks + 1;").unwrap();
            self.checks += rows.len();
        }
        text += "    end\n  end\nendmodule\n";
        self.benches += &text.replace(&format!("{b:?}"), &format!("{b:?}").replace('"', ""));
        for (row, want) in rows.iter().zip(expected) {
            row.iter().chain(want).for_each(|v| writeln!(self.data, "{v:x}").unwrap());
        }
        self.words += rows.len() * columns;
        self.instances += 1;
    }

    /// Runs everything; `least` results must have been compared.
    ///
    /// # Panics
    /// If a result differs, is missing, or Icarus is.
    pub fn run(self, least: usize) {
        println!("{} results of {} instances", self.checks, self.instances);
        assert!(self.checks >= least, "only {} results would be compared", self.checks);
        if skip() {
            return;
        }
        let dir = tempfile::tempdir().unwrap();
        let path = |name: &str| dir.path().join(name);
        let mut text: String = self.modules.values().cloned().collect();
        text += &self.benches;
        writeln!(text, "module top;\n  reg [63:0] data [0:{}];\n  integer checks = 0;", self.words - 1).unwrap();
        writeln!(text, "  initial begin\n    $readmemh(\"{}\", data);", path("data.hex").display()).unwrap();
        writeln!(text, "    #1000 $display(\"CHECKS %0d\", checks);\n    $finish;\n  end").unwrap();
        (0..self.instances).for_each(|n| writeln!(text, "  bench_{n} b{n} ();").unwrap());
        text += "endmodule\n";
        std::fs::write(path("all.v"), &text).unwrap();
        std::fs::write(path("data.hex"), &self.data).unwrap();
        let run = |tool: &str, args: &[&str]| {
            let out = Command::new(tool).args(args).output().unwrap_or_else(|e| {
                panic!("{tool} can't be started ({e}): install Icarus, or set RELIEFRTL_NO_SIMULATORS=1 to go without")
            });
            let all = String::from_utf8_lossy(&out.stdout) + String::from_utf8_lossy(&out.stderr);
            assert!(out.status.success(), "{tool} failed:\n{}", with_source(&all, &text));
            all.into_owned()
        };
        let (source, program) = (path("all.v"), path("all.vvp"));
        let (source, program) = (source.to_str().unwrap(), program.to_str().unwrap());
        run("iverilog", &["-g2005", "-s", "top", "-o", program, source]);
        let out = run("vvp", &["-n", program]);
        let wrong: Vec<&str> = out.lines().filter(|l| l.starts_with("WRONG")).collect();
        assert!(
            wrong.is_empty(),
            "{} of {} results are wrong:\n{}",
            wrong.len(),
            self.checks,
            first_lines(&wrong.join("\n"))
        );
        assert!(
            out.lines().any(|l| l == format!("CHECKS {}", self.checks)),
            "not all was checked:\n{}",
            first_lines(&out)
        );
    }
}

fn first_lines(text: &str) -> String {
    text.lines().take(30).collect::<Vec<_>>().join("\n")
}

/// Messages of the compiler, each with the line that it is about.
fn with_source(messages: &str, source: &str) -> String {
    let line = |m: &str| source.lines().nth(m.split(':').nth(1)?.parse::<usize>().ok()? - 1);
    first_lines(&messages.lines().map(|m| format!("{m}: {}\n", line(m).unwrap_or("").trim())).collect::<String>())
}
