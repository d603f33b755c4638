//! Text of the emitted benches, one pair of files a unit, from templates.
use crate::config::Design;
use crate::emit::{Files, file_list};
use crate::ir::{Body, Expr, Module, Prim};
use crate::units::traversal::{TRAVERSE, Traverse};
use crate::verilog::{Style, delayed_net};
use minijinja::{Environment, context};
use serde::Serialize;
use std::sync::Arc;

#[derive(Serialize)]
struct Port {
    name: String,
    /// `[EXP_W+MAN_W:0]`, or blank for one bit.
    range: String,
    /// Its number of bits.
    width: String,
    /// How a 64-bit word is cut to the port.
    select: String,
    /// The valid port that says whether its word counts, if there is one.
    valid: Option<String>,
}

/// A memory of a search by windows.
#[derive(Serialize)]
struct Size {
    /// Its address bits.
    addr: String,
    /// Its words.
    words: String,
}

#[derive(Serialize)]
struct Param {
    name: String,
    /// The line that declares it, as in the module under test.
    declared: String,
}

#[derive(Serialize)]
struct Term {
    name: &'static str,
    value: String,
}

/// The benches of `units` and of the `traverse` of a design; all names, those of the benches too, start with the prefix of `style`.
pub fn bench_files(units: &[Arc<Module>], traverse: Option<(&Design, &Traverse)>, style: impl Into<Style>) -> Files {
    let style = style.into();
    let prefix = &style.prefix;
    let mut env = Environment::new();
    env.set_keep_trailing_newline(true);
    let templates = [
        ("unit", include_str!("templates/unit.v")),
        ("top", include_str!("templates/top.v")),
        ("rays", include_str!("templates/traverse.v")),
    ];
    for (name, text) in templates {
        env.add_template(name, text).expect("templates are well formed");
    }
    let render = |name: &str, value: minijinja::Value| {
        let t = env.get_template(name).expect("template is there");
        style.dress(&t.render(value).expect("templates use only what they are given"))
    };
    let mut files = Files::from([(
        "testbench/verilator_main.cpp".to_string(),
        include_str!("templates/verilator_main.cpp").to_string(),
    )]);
    for m in units {
        let latency = m.latency().unwrap_or(0);
        let value = context! {
            has_state => m.latency().is_none(), prefix, unit => m.name, dut => format!("{prefix}{}", m.name), params => params(m), terms => terms(m), latency, clocked => m.clk.is_some(),
            travel_in => if latency == 0 { "1'b1" } else { "2" },
            inputs => ports(m.data_inputs().map(|p| p.1)), outputs => compared(m),
        };
        files.insert(format!("testbench/{prefix}tb_{}.v", m.name), render("unit", value.clone()));
        files.insert(format!("testbench/{prefix}tb_{}_top.v", m.name), render("top", value));
        files.insert(format!("testbench/{prefix}tb_{}.f", m.name), list(m, prefix));
    }
    let Some((d, whole)) = traverse else { return files };
    // Clocks until the pipeline can be full.
    let (traverse, warm_up) = (&whole.module, whole.setup + whole.slots + whole.finish);
    let named = |names: &[&str]| ports(names.iter().map(|n| traverse.port(n).expect("traverse has its ports").1));
    // The stage at which a slot's ray is chosen: the first that has it whole.
    let chosen = traverse.nodes.iter().filter(|n| n.name.as_deref() == Some("done")).filter_map(|n| n.stage).min();
    let enters = chosen.unwrap_or(0);
    // Its valid bit may wait in a bundle from there on; the words have nets of their own, since the iteration reads them.
    let valid = delayed_net(traverse, &traverse.default_binding(), "valid", enters, (0, 1));
    let value = context! {
        enters, valid => valid.unwrap_or_else(|| format!("s{enters}_valid")),
        prefix, unit => traverse.name, dut => format!("{prefix}{TRAVERSE}"), params => params(traverse), terms => terms(traverse),
        files => files_of(traverse), warm_up, sizes => sizes(d, traverse),
        counted => d.gives_steps(), lingers => !d.datapath.kind.facts().rays_end,
        inputs => named(&crate::trace::inputs(traverse)), outputs => named(&crate::trace::outputs(traverse)),
    };
    files.insert(format!("testbench/{prefix}tb_{TRAVERSE}.v"), render("rays", value.clone()));
    files.insert(format!("testbench/{prefix}tb_{TRAVERSE}_top.v"), render("top", value));
    files.insert(format!("testbench/{prefix}tb_{TRAVERSE}.f"), list(traverse, prefix));
    files
}

/// The memories of a search by windows, in the order of their load ports: as many as the instances that they are.
fn sizes(d: &Design, traverse: &Module) -> Vec<Size> {
    let size = |(c, words): (usize, Expr)| {
        let (_, port) = traverse.port(&format!("load_addr_{c}")).expect("each memory has its load port");
        Size { addr: format!("({})", port.width.expanded()), words: words.to_string() }
    };
    window_words(d, traverse).into_iter().enumerate().map(size).collect()
}

/// Words of each memory of a search by windows; of no other search any.
pub(super) fn window_words(d: &Design, traverse: &Module) -> Vec<Expr> {
    if !d.datapath.kind.facts().reads.window_set {
        return Vec::new();
    }
    let is_memory = |m: &Module| matches!(m.body, Body::Prim(Prim::Memory | Prim::Banks));
    let memories = traverse.insts.iter().filter(|i| is_memory(&i.module));
    memories.filter_map(|i| i.params.iter().find(|p| p.0 == "DEPTH").map(|p| p.1.expanded())).collect()
}

/// The outputs of a unit: what stands beside a valid that is 0 is not compared.
fn compared(m: &Module) -> Vec<Port> {
    let valid = |p: Port| Port { valid: m.valid_of(&p.name).map(|v| v.name.clone()), ..p };
    ports(m.data_outputs().map(|p| p.1)).into_iter().map(valid).collect()
}

/// The files of a bench and of what it tests, from where the list stands (`-F`).
fn list(m: &Arc<Module>, prefix: &str) -> String {
    let bench = format!("{prefix}tb_{}", m.name);
    file_list("../rtl/", prefix, &m.hierarchy()) + &format!("{bench}.v\n{bench}_top.v\n")
}

/// What the module under test has to be, besides its parameters.
fn terms(m: &Module) -> Vec<Term> {
    m.contract().iter().map(|t| Term { name: t.name, value: t.literal() }).collect()
}

fn params(m: &Module) -> Vec<Param> {
    let name_w = m.params.iter().map(|p| p.name.len()).max().unwrap_or(0);
    let value = |k: usize| {
        let is_last = k + 1 == m.params.len() && m.files.is_empty();
        format!("{}{}", m.params[k].default, if is_last { "" } else { "," })
    };
    let value_w = (0..m.params.len()).map(|k| value(k).len()).max().unwrap_or(0);
    let declared = |(k, p): (usize, &crate::ir::Param)| Param {
        name: p.name.clone(),
        declared: format!("parameter integer {:name_w$} = {:value_w$}  // {}", p.name, value(k), p.doc),
    };
    m.params.iter().enumerate().map(declared).collect()
}

fn files_of(m: &Module) -> Vec<&str> {
    m.files.iter().map(|f| f.name.as_str()).collect()
}

fn ports<'a>(ports: impl Iterator<Item = &'a crate::ir::Port>) -> Vec<Port> {
    let text = |e: Expr| e.to_string().replace(' ', "");
    let port = |p: &crate::ir::Port| {
        let w = p.width.expanded();
        let one = w.as_const() == Some(1);
        Port {
            name: p.name.clone(),
            width: w.to_string(),
            range: if one { String::new() } else { format!("[{}:0]", text(w.clone() - 1)) },
            valid: None,
            select: if one { "[0]".into() } else { format!("[{}:0]", text(w - 1)) },
        }
    };
    ports.map(port).collect()
}
