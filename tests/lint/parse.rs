//! The emitted text as another parser reads it, beside what manifest.json says.
use super::configs::all;
use super::no_problems;
use reliefrtl::emit;
use serde_json::{Value, json};
use std::collections::HashMap;
use std::path::PathBuf;
use sv_parser::{Locate, NodeEvent, RefNode, SyntaxTree, parse_sv_str, unwrap_node};

/// A module's interface: parameters with defaults, ports with direction and whether they have a range.
#[derive(Debug, Default, PartialEq)]
struct Interface {
    name: String,
    params: Vec<(String, String)>,
    ports: Vec<(String, String, bool)>,
}

fn tree(text: &str, path: &str) -> Result<SyntaxTree, String> {
    let no_includes: [PathBuf; 0] = [];
    let parsed = parse_sv_str(text, path, &HashMap::new(), &no_includes, false, false);
    parsed.map(|(tree, _)| tree).map_err(|e| format!("{path}: {e}"))
}

/// The first identifier below a node.
fn identifier<'a>(tree: &'a SyntaxTree, node: RefNode<'a>) -> String {
    let found: Option<Locate> = match unwrap_node!(node, SimpleIdentifier) {
        Some(RefNode::SimpleIdentifier(x)) => Some(x.nodes.0),
        _ => None,
    };
    found.and_then(|l| tree.get_str(&l)).unwrap_or_default().to_owned()
}

/// What is written below a node.
fn text<'a>(tree: &'a SyntaxTree, node: RefNode<'a>) -> String {
    let mut out = String::new();
    for event in node.into_iter().event() {
        if let NodeEvent::Enter(RefNode::Locate(l)) = event {
            let piece = tree.get_str(l).unwrap_or_default();
            // Comments and blanks are places too.
            if !piece.trim().is_empty() && !piece.trim_start().starts_with("//") {
                out += piece.trim();
            }
        }
    }
    out
}

/// Reads the header; also counts the modules in the file.
fn read(tree: &SyntaxTree) -> (Interface, usize) {
    let mut i = Interface::default();
    let mut modules = 0;
    for node in tree {
        match node {
            RefNode::ModuleAnsiHeader(h) => {
                modules += 1;
                i.name = identifier(tree, RefNode::ModuleIdentifier(&h.nodes.3));
                if let Some(params) = &h.nodes.5 {
                    for n in params {
                        let RefNode::ParamAssignment(p) = n else { continue };
                        let name = identifier(tree, RefNode::ParameterIdentifier(&p.nodes.0));
                        let value = p.nodes.2.as_ref().map(|(_, v)| text(tree, RefNode::ConstantParamExpression(v)));
                        i.params.push((name, value.unwrap_or_default()));
                    }
                }
            }
            RefNode::AnsiPortDeclaration(p) => {
                let direction = match unwrap_node!(p, PortDirection) {
                    Some(d) => text(tree, d),
                    None => String::new(),
                };
                let Some(name) = unwrap_node!(p, PortIdentifier) else { continue };
                i.ports.push((identifier(tree, name), direction, unwrap_node!(p, PackedDimension).is_some()));
            }
            _ => {}
        }
    }
    (i, modules)
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
    let mut problems = Vec::new();
    let (mut files, mut ports, mut params) = (0, 0, 0);
    // Equal texts are parsed once: most files of the spread differ only in the banner.
    let mut seen: HashMap<String, (Interface, usize)> = HashMap::new();
    for e in all() {
        let manifest = emit::manifest(&e.config, &e.modules, &e.files);
        for module in manifest["modules"].as_array().expect("a list of modules") {
            let path = module["file"].as_str().expect("a path");
            let code: String = e.files[path].lines().skip_while(|l| l.starts_with("//")).collect::<Vec<_>>().join("\n");
            if !seen.contains_key(&code) {
                match tree(&code, path) {
                    Ok(t) => drop(seen.insert(code.clone(), read(&t))),
                    Err(p) => problems.push(format!("{}: {p}", e.label)),
                }
            }
            let Some((found, modules)) = seen.get(&code) else { continue };
            files += 1;
            ports += found.ports.len();
            params += found.params.len();
            if *found != expected(module) || *modules != 1 {
                problems.push(format!("{}: {path}: {found:?} but the manifest says {:?}", e.label, expected(module)));
            }
        }
    }
    no_problems(&problems);
    println!("{files} files, {ports} ports, {params} parameters");
    assert_eq!(files, super::configs::file_count());
    assert!(ports > 5 * files && params > files, "{ports} ports, {params} parameters");
}
