//! The emitted text as another parser reads it, beside what manifest.json says.
use super::configs::{all, file_count};
use super::no_problems;
use super::tools::{Tool, run};
use reliefrtl::emit;
use serde::Deserialize;
use serde_json::{Value, json};
use std::collections::HashMap;

/// A module's interface: parameters with defaults, ports with direction and whether they have a range.
#[derive(Debug, Default, PartialEq, Deserialize)]
struct Interface {
    name: String,
    params: Vec<(String, String)>,
    ports: Vec<(String, String, bool)>,
}

/// What `tools/slang_interfaces.py` says of a file.
#[derive(Deserialize)]
struct Read {
    dir: String,
    file: String,
    modules: usize,
    errors: usize,
    #[serde(flatten)]
    interface: Interface,
}

/// The same from the manifest.
fn expected(module: &Value) -> Interface {
    let list = |key: &str| module[key].as_array().cloned().unwrap_or_default();
    let text = |v: &Value| v.as_str().unwrap_or_default().to_owned();
    let (own, files): (Vec<Value>, Vec<Value>) = list("parameters").into_iter().partition(|p| p["default"].is_number());
    let with_default = |p: Value| (text(&p["name"]), p["default"].to_string());
    // What it was generated for stands between its numbers and its files, but for what was merely chosen.
    let terms = list("generated_for").into_iter().filter(|t| t["name"].is_string());
    let terms = terms.map(|t| (text(&t["name"]), text(&t["literal"])));
    Interface {
        name: text(&module["name"]),
        params: own.into_iter().map(with_default).chain(terms).chain(files.into_iter().map(with_default)).collect(),
        ports: list("ports")
            .iter()
            .map(|p| (text(&p["name"]), text(&p["direction"]), p["width_expression"] != json!("1")))
            .collect(),
    }
}

#[test]
fn every_file_parses_and_says_what_the_manifest_says() {
    let Some(mut c) = Tool::SlangInterfaces.command() else { return };
    let said = run(c.args(all().iter().map(|e| &e.dir)), &all()[0].dir);
    assert!(said.ok, "{}", said.problem("every file"));
    let lines = said.text.lines().map(|l| serde_json::from_str(l).unwrap_or_else(|e| panic!("{l}: {e}")));
    let read: HashMap<(String, String), Read> = lines.map(|r: Read| ((r.dir.clone(), r.file.clone()), r)).collect();
    let mut problems = Vec::new();
    let (mut files, mut ports, mut params) = (0, 0, 0);
    for e in all() {
        let manifest = emit::manifest(&e.config, &e.modules, &e.files);
        for module in manifest["modules"].as_array().expect("a list of modules") {
            let path = module["file"].as_str().expect("a path");
            let found = &read[&(e.dir.display().to_string(), path.to_string())];
            files += 1;
            ports += found.interface.ports.len();
            params += found.interface.params.len();
            let expected = expected(module);
            if found.errors > 0 || found.modules != 1 || found.interface != expected {
                let (errors, modules, interface) = (found.errors, found.modules, &found.interface);
                problems.push(format!(
                    "{}: {path}: {errors} errors, {modules} modules, {interface:?} but the manifest says {expected:?}",
                    e.label
                ));
            }
        }
    }
    no_problems(&problems);
    println!("{files} files, {ports} ports, {params} parameters");
    assert_eq!(files, file_count());
    assert!(ports > 5 * files && params > files, "{ports} ports, {params} parameters");
}
