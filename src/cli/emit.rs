//! `reliefrtl emit`: the Verilog, its benches, the file list and the manifest.
use super::args::{Cli, EmitArgs};
use crate::config::Config;
use crate::emit::{self, Files};
use crate::error::Result;
use crate::files::Part;
use crate::ir::Module;
use crate::project::{self, alone_text};
use std::sync::Arc;

/// Runs `emit`.
pub fn run(cli: &Cli, a: &EmitArgs) -> Result<()> {
    let (c, alone) = super::load::load_for(cli, &a.unit)?;
    let dir = super::output::directory(&a.out)?;
    let (count, files) = match (&alone[..], &a.unit[..]) {
        ([], []) => {
            let p = project::text(&c)?;
            (p.modules.len(), p.files)
        }
        ([], names) => {
            let d = c.design();
            some(&c, &names.iter().map(|name| crate::catalogue::find(&d, name)).collect::<Result<Vec<_>>>()?)?
        }
        (units, _) => (emit::modules(units)?.len(), alone_text(&c, units)?),
    };
    // Units alone have a manifest and a list of files of its own: no other Verilog may stand beside it.
    let places = ["rtl/", "testbench/", "flow/", "manifest.json"];
    let part = match a.unit.is_empty() {
        true => Part { config: c.hash(), replaces: &places, alone_in: &[] },
        false => Part { config: c.hash(), replaces: &[], alone_in: &places },
    };
    emit::fill(dir.only(part), &files)?;
    if cli.json {
        let names: Vec<&String> = files.keys().collect();
        println!("{}", serde_json::json!({"out": a.out, "files": names}));
    } else {
        println!("{count} modules in {}", a.out.join("rtl").display());
    }
    Ok(())
}

/// Number of modules of units of the traversal, and their files.
fn some(c: &Config, tops: &[Arc<Module>]) -> Result<(usize, Files)> {
    let modules = emit::modules(tops)?;
    let mut files = emit::rtl(c, &modules);
    let manifest = emit::manifest(c, &modules, &files);
    files.insert("manifest.json".into(), serde_json::to_string_pretty(&manifest).expect("plain data") + "\n");
    files.extend(emit::flow(c, tops, &files));
    let mut whole = project::text(c)?.files;
    whole.retain(|path, _| {
        let bench = |top: &Arc<Module>| {
            ["_top.v", ".v", ".f"].map(|end| format!("testbench/{}tb_{}{end}", c.emit.prefix, top.name))
        };
        path == "testbench/verilator_main.cpp" || tops.iter().any(|top| bench(top).contains(path))
    });
    files.extend(whole);
    Ok((modules.len(), files))
}
