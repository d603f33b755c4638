//! The module around a measured unit: ranks of registers, nothing else.
use crate::ir::{Dir, Module};

/// Name of the measured top module.
pub(super) const TOP: &str = "synth_top";

/// `synth_top`: `copies` instances of `module` (named with `prefix`) between two ranks of registers on every data port. Copies share the outermost
/// rank of inputs, so that pins are enough for any number: each has an inner rank of its own, which takes what the one before it had, turned by
/// a bit, so that no two ever hold the same and nothing of two units is one. The outputs are what all give, by exclusive or.
pub fn top_module(module: &Module, prefix: &str, copies: u32) -> String {
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
    let (mut nets, mut steps, mut units) = (String::new(), String::new(), String::new());
    // The first copy's names are those of one alone.
    let mark = |k: u32| if k == 0 { String::new() } else { format!("_{k}") };
    for (name, width, dir) in &ports {
        let range = format!("[{}:0]", width - 1);
        head.push(format!("  {} wire {range} {name}", if *dir == Dir::In { "input" } else { "output" }));
        let all = |what: &str| (0..copies).map(|k| format!("{name}_{what}{}", mark(k))).collect::<Vec<_>>();
        match dir {
            Dir::In => {
                nets += &format!("  reg {range} {name}_rank1, {};\n", all("rank2").join(", "));
                steps += &format!("    {name}_rank1 <= {name};\n");
                for (k, rank2) in all("rank2").iter().enumerate() {
                    let turned = match k {
                        0 => format!("{name}_rank1"),
                        k => {
                            let from = format!("{name}_rank2{}", mark(k as u32 - 1));
                            if *width == 1 { from } else { format!("{{{from}[0], {from}[{}:1]}}", width - 1) }
                        }
                    };
                    steps += &format!("    {rank2} <= {turned};\n");
                }
            }
            Dir::Out => {
                nets += &format!("  wire {range} {};\n", all("net").join(", "));
                nets += &format!("  reg {range} {}, {name}_rank2;\n", all("rank1").join(", "));
                nets += &format!("  assign {name} = {name}_rank2;\n");
                for (net, rank1) in all("net").iter().zip(all("rank1")) {
                    steps += &format!("    {rank1} <= {net};\n");
                }
                steps += &format!("    {name}_rank2 <= {};\n", all("rank1").join(" ^ "));
            }
        }
    }
    for k in 0..copies {
        let pin = |(name, _, dir): &(&str, i64, Dir)| {
            format!("    .{name}({name}_{}{})", if *dir == Dir::In { "rank2" } else { "net" }, mark(k))
        };
        let mut pins: Vec<String> = ports.iter().map(pin).collect();
        pins.extend(module.clk.map(|_| "    .clk(clk)".to_string()));
        pins.extend(module.ce.map(|_| "    .ce(1'b1)".to_string()));
        units += &format!("  {prefix}{} u_unit{} (\n{}\n  );\n", module.name, mark(k), pins.join(",\n"));
    }
    format!(
        "module {TOP} (\n{}\n);\n{nets}{units}  always @(posedge clk) begin\n{steps}  end\nendmodule\n",
        head.join(",\n")
    )
}

#[cfg(test)]
mod tests {
    use super::top_module;
    use crate::ir::{BITS, Builder};

    #[test]
    fn every_data_port_has_two_ranks() {
        let b = Builder::new("pass", file!(), "a, one clock later");
        b.clock();
        b.clock_enable();
        let a = b.input("a", 3, BITS, "operand");
        let out = b.output("result", 3, BITS, "a");
        b.drive(out, a.reg());
        let text = top_module(&b.finish(&[]), "p_", 2);
        for part in [
            "input wire [2:0] a",
            "p_pass u_unit",
            ".a(a_rank2)",
            ".ce(1'b1)",
            "result_rank1 <= result_net;",
            "assign result = result_rank2;",
            "a_rank2_1 <= {a_rank2[0], a_rank2[2:1]};",
            "p_pass u_unit_1",
            "result_rank2 <= result_rank1 ^ result_rank1_1;",
        ] {
            assert!(text.contains(part), "{part} in {text}");
        }
    }
}
