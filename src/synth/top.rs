//! The module around a measured unit: ranks of registers, nothing else.
use crate::ir::{Dir, Module};
use std::fmt::Write;

/// Name of the measured top module.
pub(super) const TOP: &str = "synth_top";

/// `synth_top`: an instance of `module` (named with `prefix`) between two ranks of registers on every data port.
pub fn top_module(module: &Module, prefix: &str) -> String {
    let b = module.default_binding();
    let data = |i: usize| ![module.clk, module.ce].contains(&Some(i));
    let ports: Vec<(&str, i64, Dir)> = module
        .ports
        .iter()
        .enumerate()
        .filter(|(i, _)| data(*i))
        .map(|(_, p)| (p.name.as_str(), p.width.eval(&b), p.dir))
        .collect();
    let mut head = vec!["  input wire clk".to_string()];
    let (mut nets, mut steps, mut pins) = (String::new(), String::new(), Vec::new());
    for (name, width, dir) in &ports {
        let range = format!("[{}:0]", width - 1);
        head.push(format!("  {} wire {range} {name}", if *dir == Dir::In { "input" } else { "output" }));
        pins.push(format!("    .{name}({name}_{})", if *dir == Dir::In { "rank2" } else { "net" }));
        let _ = match dir {
            Dir::In => {
                let _ = writeln!(nets, "  reg {range} {name}_rank1, {name}_rank2;");
                writeln!(steps, "    {name}_rank1 <= {name};\n    {name}_rank2 <= {name}_rank1;")
            }
            Dir::Out => {
                let _ = writeln!(nets, "  wire {range} {name}_net;\n  reg {range} {name}_rank1, {name}_rank2;");
                let _ = writeln!(nets, "  assign {name} = {name}_rank2;");
                writeln!(steps, "    {name}_rank1 <= {name}_net;\n    {name}_rank2 <= {name}_rank1;")
            }
        };
    }
    if module.clk.is_some() {
        pins.push("    .clk(clk)".into());
    }
    if module.ce.is_some() {
        pins.push("    .ce(1'b1)".into());
    }
    format!(
        "module {TOP} (\n{}\n);\n{nets}  {prefix}{} u_unit (\n{}\n  );\n  always @(posedge clk) begin\n{steps}  end\nendmodule\n",
        head.join(",\n"),
        module.name,
        pins.join(",\n")
    )
}

#[cfg(test)]
mod tests {
    use super::top_module;
    use crate::ir::Builder;

    #[test]
    fn every_data_port_has_two_ranks() {
        let b = Builder::new("pass", file!(), "a, one clock later");
        b.clock();
        b.clock_enable();
        let a = b.input("a", 3, "bits", "operand");
        let out = b.output("result", 3, "bits", "a");
        b.drive(out, a, Some(1));
        let text = top_module(&b.finish(Some(1), &[]), "p_");
        for part in [
            "input wire [2:0] a",
            "p_pass u_unit",
            ".a(a_rank2)",
            ".ce(1'b1)",
            "result_rank1 <= result_net;",
            "assign result = result_rank2;",
        ] {
            assert!(text.contains(part), "{part} in {text}");
        }
    }
}
