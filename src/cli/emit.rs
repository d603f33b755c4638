//! `reliefrtl emit`: the Verilog, the file list and the manifest.
use super::args::{Cli, EmitArgs};
use crate::emit;
use crate::error::{Error, Result};
use crate::units;

/// Runs `emit`.
pub fn run(cli: &Cli, a: &EmitArgs) -> Result<()> {
    let c = super::config::load_ranges(cli)?;
    // Arithmetic stands alone: what a traversal asks of its format does not bind it.
    let arithmetic = units::arithmetic(&c.design());
    let alone = a.unit.as_ref().is_some_and(|name| arithmetic.iter().any(|m| m.name == *name));
    if !alone {
        c.validate()?;
    }
    let all = if alone { arithmetic } else { units::all(&c.design()) };
    let tops = match &a.unit {
        None => all,
        Some(name) => {
            let names: Vec<&str> = all.iter().map(|m| m.name.as_str()).collect();
            let near = names.iter().max_by(|x, y| strsim::jaro(x, name).total_cmp(&strsim::jaro(y, name)));
            let miss = || {
                let near = near.copied().unwrap_or_default();
                Error::input(format!("no unit is named {name}; did you mean {near}? (`reliefrtl list` shows all)"))
            };
            vec![all.iter().find(|m| &m.name == name).cloned().ok_or_else(miss)?]
        }
    };
    let modules = emit::modules(&tops)?;
    let mut files = emit::rtl(&c, &modules);
    let manifest = emit::manifest(&c, &modules, &files);
    files.insert("manifest.json".into(), serde_json::to_string_pretty(&manifest).expect("plain data") + "\n");
    super::output::write_tree(&a.out, &files)?;
    if cli.json {
        let names: Vec<&String> = files.keys().collect();
        println!("{}", serde_json::json!({"out": a.out, "files": names}));
    } else {
        println!("{} modules in {}", modules.len(), a.out.join("rtl").display());
    }
    Ok(())
}
