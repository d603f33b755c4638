//! Branch and toggle coverage of emitted files: Verilator counts while the benches replay what is shipped.
use super::run::{build_covered, link};
use super::simulator::Simulator;
use crate::emit::emitted_name;
use crate::error::{Error, Result};
use crate::files::{Scratch, read_text_of_tree};
use crate::ir::Binding;
use crate::process;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

/// What is counted.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum PointKind {
    /// A way through an `if` or `case`.
    Branch,
    /// A bit of a signal that changes.
    Toggle,
}

/// Something that can be reached, summed over all copies of the module.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Point {
    /// Module, without the prefix of the tree.
    pub unit: String,
    /// What is counted.
    pub kind: PointKind,
    /// Signal and bit, or the branch.
    pub name: String,
    /// Line in the module's file.
    pub line: u32,
}

/// A bench of a set at parameter values of its own.
pub struct Further {
    /// Its directory, from the tree's root.
    pub place: String,
    /// Parameter values that differ from the defaults.
    pub over: Binding,
}

/// Replays the vectors of `units`, those of `whole`, whose vectors are rays, and of `whole` once more for each of `further`, and returns how often each point
/// of the emitted files was reached. A file that has vectors of its own is counted under those, the others inside of `whole`.
///
/// # Errors
/// A missing tool, a failed build, benches that do not pass.
pub fn cover(dir: &Path, units: &[String], whole: &str, further: &[Further]) -> Result<BTreeMap<Point, u64>> {
    let dir = dir.canonicalize().map_err(|e| Error::file("find", dir, e))?;
    let bench = |unit: &str| emitted_name(&dir, "testbench", &format!("tb_{unit}"), ".v");
    let top = bench(whole)?;
    let prefix = top.strip_suffix(&format!("tb_{whole}")).unwrap_or_default();
    let mut alone = Program::default();
    for unit in units {
        alone.benches.push((bench(unit)?, Binding::new()));
    }
    let mut out = alone.count(&dir, prefix)?;
    let own: Vec<String> = units.iter().map(|u| format!("{prefix}{u}")).collect();
    let mut traversals = Program { benches: vec![(top.clone(), Binding::new())], sources: vec![], uncounted: own };
    let path = dir.join(format!("testbench/{top}.v"));
    let text = read_text_of_tree(&path)?;
    for (k, f) in further.iter().enumerate() {
        let name = format!("{top}_{k}");
        let text = text.replace(&format!("module {top} "), &format!("module {name} "));
        let text = text.replace(&format!("\"golden/{whole}\""), &format!("\"{}\"", f.place));
        traversals.sources.push((format!("{name}.v"), text));
        traversals.benches.push((name, f.over.clone()));
    }
    for (point, count) in traversals.count(&dir, prefix)? {
        *out.entry(point).or_insert(0) += count;
    }
    Ok(out)
}

/// Benches that are built into one program.
#[derive(Default)]
struct Program {
    /// Names of the benches, with parameter values.
    benches: Vec<(String, Binding)>,
    /// Texts that the tree does not have, by name.
    sources: Vec<(String, String)>,
    /// Modules in whose files nothing is counted.
    uncounted: Vec<String>,
}

impl Program {
    fn count(mut self, dir: &Path, prefix: &str) -> Result<BTreeMap<Point, u64>> {
        let work = Scratch::new()?;
        for part in ["rtl", "testbench", "golden"] {
            link(&dir.join(part), &work.path().join(part))?;
        }
        let written = |name: &str| self.sources.iter().any(|s| s.0 == format!("{name}.v"));
        let shipped = self.benches.iter().filter(|b| !written(&b.0)).map(|b| format!("testbench/{}.v", b.0));
        // Verilator takes orders for files that it reads later.
        let mut files: Vec<String> = std::iter::once("covered.vlt".to_string()).chain(shipped).collect();
        self.sources.push(("covered.v".into(), top(&self.benches)));
        self.sources.push(("covered.vlt".into(), self.quiet(prefix)));
        self.sources.push(("covered.cpp".into(), MAIN.into()));
        for (name, text) in &self.sources {
            crate::files::write_atomic(work.path().join(name), text.as_bytes())?;
        }
        files.extend(self.sources.iter().map(|s| s.0.clone()).filter(|name| !name.ends_with(".vlt")));
        let mut run = build_covered(work.path(), &files)?;
        let out = process::output(run.args(["+again", "coverage.dat"]));
        let out = out.map_err(|_| Error::ToolFailed("the benches that count coverage can't be run".into()))?;
        let text = String::from_utf8_lossy(&out.stdout);
        let passed = text.lines().filter(|l| l.starts_with("PASS ")).count();
        if !out.status.success() || passed != self.benches.len() {
            let failed = text.lines().find(|l| l.starts_with("FAIL ")).unwrap_or("without a verdict");
            let (name, all) = (Simulator::Verilator.name(), self.benches.len());
            return Err(Error::mismatch(format!("{passed} of {all} benches pass in {name}: {failed}")));
        }
        let counts = work.path().join("coverage.dat");
        let text = std::fs::read(&counts).map_err(|e| Error::file("read", &counts, e))?;
        points(&String::from_utf8_lossy(&text), prefix)
    }

    /// Verilator's orders: benches and what is counted elsewhere are not counted.
    fn quiet(&self, prefix: &str) -> String {
        let benches = [format!("*{prefix}tb_*.v"), "*covered.v".into()];
        let files = benches.into_iter().chain(self.uncounted.iter().map(|m| format!("*/{m}.v")));
        files.fold("`verilator_config\n".to_string(), |out, f| out + &format!("coverage_off -file \"{f}\"\n"))
    }
}

/// The top above all benches.
fn top(benches: &[(String, Binding)]) -> String {
    let n = benches.len();
    let mut out = format!(
        "module covered (\n  input wire clk,\n  output wire done,\n  output wire [7:0] exit_code\n);\n  wire [{}:0] all;\n",
        n - 1
    );
    for (k, (name, over)) in benches.iter().enumerate() {
        let over: Vec<String> = over.iter().map(|(p, v)| format!(".{p}({v})")).collect();
        let over = if over.is_empty() { String::new() } else { format!(" #({})", over.join(", ")) };
        writeln!(
            out,
            "  wire [7:0] code_{k};\n  {name}{over} bench_{k} (.clk(clk), .done(all[{k}]), .exit_code(code_{k}));"
        )
        .expect("writing to a string can't fail");
    }
    let codes: Vec<String> = (0..n).map(|k| format!("code_{k}")).collect();
    out + &format!("  assign done = &all;\n  assign exit_code = {};\nendmodule\n", codes.join(" | "))
}

/// Clocks all benches until they are done; the last argument says where the counts go.
const MAIN: &str = r#"#include <memory>
#include "Vtb.h"
#include "verilated.h"
#include "verilated_cov.h"
int main(int argc, char** argv) {
  const auto context = std::make_unique<VerilatedContext>();
  context->commandArgs(argc, argv);
  const auto top = std::make_unique<Vtb>(context.get());
  top->clk = 0;
  top->eval();
  while (!top->done && !context->gotFinish()) {
    top->clk = 1;
    top->eval();
    top->clk = 0;
    top->eval();
  }
  top->final();
  context->coveragep()->write(argv[argc - 1]);
  return top->done ? top->exit_code : 4;
}
"#;

/// Counts of a coverage file by point. A line is `C 'key' count`; fields of the key are `\x01name\x02value`.
fn points(text: &str, prefix: &str) -> Result<BTreeMap<Point, u64>> {
    let bad = |line: &str| Error::ToolFailed(format!("Verilator's coverage file holds the line {line:?}"));
    let mut out = BTreeMap::new();
    for line in text.lines().filter(|l| l.starts_with("C '")) {
        let (key, count) = line[3..].rsplit_once("' ").ok_or_else(|| bad(line))?;
        let count: u64 = count.trim().parse().map_err(|_| bad(line))?;
        let fields: BTreeMap<&str, &str> = key.split('\u{1}').filter_map(|f| f.split_once('\u{2}')).collect();
        let field = |name: &str| fields.get(name).copied().unwrap_or_default();
        let kind = match field("page").split('/').next() {
            Some("v_toggle") => PointKind::Toggle,
            Some("v_branch") => PointKind::Branch,
            _ => continue,
        };
        let path = Path::new(field("f"));
        if !path.starts_with("rtl") {
            continue;
        }
        let file = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        // Newer versions count both directions apart.
        let name = field("o").split(':').next().unwrap_or_default().to_string();
        let number = field("l").parse().map_err(|_| bad(line))?;
        let line = if kind == PointKind::Branch { number } else { 0 };
        *out.entry(Point { unit: file.strip_prefix(prefix).unwrap_or(&file).to_string(), kind, name, line })
            .or_insert(0) += count;
    }
    if out.is_empty() {
        return Err(Error::NothingRan("Verilator counted no point of any emitted file".into()));
    }
    Ok(out)
}
