//! Text of the harnesses and scripts.
use super::flights::Flights;
use super::proof::{Extra, Proof, Reach};
use crate::config::{Design, LevelUp, Trim};
use crate::emit::Files;
use crate::ir::{Binding, Module};
use crate::units::traversal::Traverse;
use crate::verilog::{SPDX, Style};
use minijinja::{Environment, Value, context};
use std::fmt::Write;
use std::sync::Arc;

/// Harness and script of each of `proofs`, under `testbench/`: `units` are those of the design, `files` the emitted modules without folder, in
/// `rtl/`.
pub fn proof_files(
    d: &Design,
    proofs: &[&Proof],
    units: &[Arc<Module>],
    t: &Traverse,
    style: &Style,
    files: &[String],
) -> Files {
    let prefix = &style.prefix;
    let mut out = Files::new();
    for p in proofs {
        let over: Binding = p.over.iter().map(|(k, v)| ((*k).to_string(), *v)).collect();
        let flights = Flights::of(t, d.latency.handshake, d.traverse.tag_bits);
        let mut env = Environment::new();
        env.set_keep_trailing_newline(true);
        let (copies, values, name) = (units.to_vec(), over.clone(), prefix.to_string());
        env.add_function("instance", move |unit: String, mark: String, driven: Option<String>| {
            let m = copies.iter().find(|m| m.name == unit).expect("the design has the unit");
            instance(m, &values, &name, &mark, driven.as_deref().unwrap_or_default())
        });
        let (copies, values) = (units.to_vec(), over.clone());
        env.add_function("width", move |unit: String, port: String| {
            let m = copies.iter().find(|m| m.name == unit).expect("the design has the unit");
            m.port(&port).expect("the unit has the port").1.width.eval(&m.binding_with(&values))
        });
        let (copies, values) = (units.to_vec(), over.clone());
        env.add_function("value", move |unit: String, param: String| {
            let m = copies.iter().find(|m| m.name == unit).expect("the design has the unit");
            m.binding_with(&values)[&param]
        });
        let copies = units.to_vec();
        env.add_function("terms", move |unit: String, params: String| {
            let m = copies.iter().flat_map(|m| m.hierarchy()).find(|m| m.name == unit);
            passed(&m.expect("the design has the unit"), [params].into_iter().filter(|p| !p.is_empty()).collect())
        });
        let counted = match p.extra {
            Extra::RaysOfTheLoop { counted } if flights.counts() => Some(counted),
            _ => None,
        };
        let harness = counted.unwrap_or(p.text);
        let value = context! {
            flights => flights.value(),
            mode => Value::from_serialize(d.mode),
            claim => p.claim, latency => p.clocks(units), prefix,
            levels_down => d.mode.levels_down, parity => matches!(d.mode.level_up, LevelUp::Tevs | LevelUp::Selective),
            trims => d.mode.trim != Trim::None, lod => d.mode.lod, rule => d.mode.level_up.word(), slots => flights.len(), lengths => LENGTHS.collect::<Vec<u32>>(), tag_w => d.traverse.tag_bits,
        };
        let text = env.render_str(harness, value).expect("templates use only what they are given");
        out.insert(format!("testbench/{prefix}fv_{}.v", p.name), style.dress(&text));
        let extra = match p.extra {
            Extra::Nothing => String::new(),
            Extra::Registers(list) => {
                list.iter().map(|(to, from)| format!("connect -nounset -set {to} \\{from}\n")).collect()
            }
            Extra::DelayLines => rings(),
            Extra::Fifo => slots(),
            // The other harness counts valid bits, which have registers of their own.
            Extra::RaysOfTheLoop { .. } if counted.is_some() => flights.script(),
            Extra::RaysOfTheLoop { .. } => flights.script() + SPLIT,
        };
        let (mode, depth) = match (p.extra, p.reach) {
            // Each place says by itself how many rays follow, so the first clocks show what is wrong.
            _ if counted.is_some() => ("prove", 12),
            // Long enough for a ray that is lost or doubled to be missed at a door, should the induction fail.
            (Extra::RaysOfTheLoop { .. }, _) => ("prove", flights.len() as u32 + 3),
            // Combinational units and constant inputs are proved for good at one depth.
            (_, Reach::Latency) => ("bmc", p.clocks(units) + 1),
            (_, Reach::Induction(n)) => ("prove", n),
        };
        out.insert(format!("testbench/{prefix}fv_{}.sby", p.name), script(p, mode, depth, &extra, prefix, files));
    }
    out
}

/// Wires for every port of `m`, free constants where nothing drives them, and an instance. `driven` lists inputs that the harness drives.
fn instance(m: &Module, over: &Binding, prefix: &str, mark: &str, driven: &str) -> String {
    let b = m.binding_with(over);
    let driven: Vec<&str> = driven.split(' ').collect();
    let (mut nets, mut pins) = (String::new(), Vec::new());
    let data = m.data_inputs().map(|p| p.1).map(|p| (p, true)).chain(m.data_outputs().map(|p| (p.1, false)));
    for (p, input) in data {
        let free = if input && !driven.contains(&p.name.as_str()) { "(* anyconst *) " } else { "" };
        writeln!(nets, "  {free}wire [{}:0] {mark}{};", p.width.eval(&b) - 1, p.name).expect("writing to a string");
        pins.push(format!(".{0}({mark}{0})", p.name));
    }
    pins.extend(m.clk.is_some().then(|| ".clk(clk), .ce(1'b1)".to_string()));
    let params = passed(m, m.params.iter().map(|p| format!(".{}({})", p.name, b[&p.name])).collect());
    format!("{nets}  {prefix}{}{params} {mark}dut (\n    {}\n  );", m.name, pins.join(",\n    "))
}

/// The parameters of an instance of `m`, and what `m` has to be besides: ` #(...)`, or nothing.
fn passed(m: &Module, mut params: Vec<String>) -> String {
    params.extend(m.contract().iter().map(|t| format!(".{}({})", t.name, t.literal())));
    if params.is_empty() { String::new() } else { format!(" #({})", params.join(", ")) }
}

/// Clocks of the lines that are proved: all.
const LENGTHS: std::ops::RangeInclusive<u32> = 3..=17;

/// Cells by what is read of them (Yosys 0.26 on): of a bundle that holds a tag, the rest of the ray would stay, and all arithmetic before it.
const SPLIT: &str = "splitnets\nsplitcells\n";

/// Connects the wires of a FIFO's harness to its registers and to its words; the memory becomes registers before.
fn slots() -> String {
    let registers = ["write_ptr", "read_ptr", "occupancy_q", "valid_q"];
    let registers = registers.map(|r| format!("connect -nounset -set {r} \\dut.{r}\n"));
    let words = (0..16).map(|k| format!("connect -nounset -set slot_{k} \\dut.u_words.mem[{k}]\n"));
    std::iter::once("memory_map\n".to_string()).chain(registers).chain(words).collect()
}

/// Connects the wires of the line's harness to the words and the place of a ring of each length; the memory becomes registers before.
fn rings() -> String {
    let mut s = "memory_map\n".to_string();
    for n in LENGTHS {
        for k in 0..n - 1 {
            writeln!(s, "connect -nounset -set ring_{n}_{k} \\dut_{n}.ring[{k}]").expect("writing to a string");
        }
        writeln!(s, "connect -nounset -set index_{n} \\dut_{n}.index").expect("writing to a string");
    }
    s
}

fn script(p: &Proof, mode: &str, depth: u32, extra: &str, prefix: &str, files: &[String]) -> String {
    let (name, engine) = (format!("{prefix}fv_{}", p.name), p.engine);
    let extra = if extra.is_empty() { String::new() } else { format!("cd {name}\n{extra}cd ..\n") };
    let list: String = files.iter().map(|f| format!("../rtl/{f}\n")).collect();
    let read: String = files.iter().map(|f| format!("read_verilog {f}\n")).collect();
    format!(
        "[options]\n# {SPDX}\nmode {mode}\ndepth {depth}\n\n[engines]\n{engine}\n\n[script]\nread_verilog -formal {name}.v\n{read}hierarchy -check -top {name}\nproc\nflatten\n{extra}opt_clean\nprep -top {name}\n\n[files]\n{name}.v\n{list}"
    )
}
