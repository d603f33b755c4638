//! `manifest.json`: for every module its file, parameters, ports, latency, throughput and content hash.
use super::Files;
use crate::config::Config;
use crate::ir::{Dir, Module};
use serde_json::{Value, json};
use std::sync::Arc;

/// The manifest of `modules` as emitted into `files`; no date, no path of this machine.
pub fn manifest(c: &Config, modules: &[Arc<Module>], files: &Files) -> Value {
    let list: Vec<Value> = modules.iter().map(|m| module(c, m, files)).collect();
    json!({
        "generator": "reliefrtl",
        "version": env!("CARGO_PKG_VERSION"),
        "config_hash": c.hash(),
        "config": c,
        "modules": list,
    })
}

/// What is no parameter of the module though it stands as one: the latency and the variant that an instance has to ask for, and what was
/// chosen.
fn generated_for(m: &Module) -> Value {
    let terms = m.contract().into_iter().map(|t| json!({"name": t.name, "value": t.value, "literal": t.literal()}));
    let choices = m.choices.iter().map(|(name, word)| json!({"choice": name, "word": word}));
    terms.chain(choices).collect()
}

fn module(c: &Config, m: &Module, files: &Files) -> Value {
    let file = format!("rtl/{}{}.v", c.emit.prefix, m.name);
    let text = files.get(&file).map(String::as_str).unwrap_or_default();
    let b = m.default_binding();
    let number = m.params.iter().map(|p| json!({"name": p.name, "default": p.default, "meaning": p.doc}));
    let text_params = m.files.iter().map(|p| json!({"name": p.name, "default": "", "meaning": p.doc}));
    let params: Vec<Value> = number.chain(text_params).collect();
    let port = |p: &crate::ir::Port| {
        let mut v = json!({
            "name": p.name,
            "direction": if p.dir == Dir::In { "input" } else { "output" },
            "width": p.width.eval(&b),
            "width_expression": p.width.expanded().to_string(),
            "meaning": p.doc,
            "unit": p.unit.to_string(),
        });
        if p.dir == Dir::Out {
            v["latency"] = match m.latency() {
                Some(_) => json!(p.stage.or(m.latency())),
                None => Value::Null,
            };
        }
        v
    };
    let instances: Vec<Value> = m
        .insts
        .iter()
        .map(|i| json!({"name": i.name, "module": format!("{}{}", c.emit.prefix, i.module.name)}))
        .collect();
    json!({
        "name": format!("{}{}", c.emit.prefix, m.name),
        "summary": m.summary,
        "file": file,
        "source": m.source,
        "parameters": params,
        "generated_for": generated_for(m),
        "conditions": m.checks.iter().map(|k| format!("{} <= {}", k.lhs, k.rhs)).collect::<Vec<_>>(),
        "ports": m.ports.iter().map(port).collect::<Vec<_>>(),
        "instances": instances,
        "latency": m.latency(),
        "throughput": m.throughput,
        "blake3": blake3::hash(text.as_bytes()).to_hex().to_string(),
    })
}
