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
    let (c, alone) = super::config::load_for(cli, a.unit.as_deref())?;
    let (count, files) = match (&alone, &a.unit) {
        (Some(m), _) => (emit::modules(std::slice::from_ref(m))?.len(), alone_text(&c, m)?),
        (None, None) => {
            let p = project::text(&c)?;
            (p.modules.len(), p.files)
        }
        (None, Some(name)) => one(&c, &crate::catalogue::find(&c.design(), name)?)?,
    };
    // A unit alone has a manifest and a list of files of its own: no other Verilog may stand beside it.
    let places = ["rtl/", "testbench/", "flow/", "manifest.json"];
    let part = match a.unit {
        None => Part { config: c.hash(), replaces: &places, alone_in: &[] },
        Some(_) => Part { config: c.hash(), replaces: &[], alone_in: &places },
    };
    super::output::write_part(&a.out, &files, part)?;
    if cli.json {
        let names: Vec<&String> = files.keys().collect();
        println!("{}", serde_json::json!({"out": a.out, "files": names}));
    } else {
        println!("{count} modules in {}", a.out.join("rtl").display());
    }
    Ok(())
}

/// Number of modules of a unit of the traversal, and their files.
fn one(c: &Config, top: &Arc<Module>) -> Result<(usize, Files)> {
    let modules = emit::modules(std::slice::from_ref(top))?;
    let mut files = emit::rtl(c, &modules);
    let manifest = emit::manifest(c, &modules, &files);
    files.insert("manifest.json".into(), serde_json::to_string_pretty(&manifest).expect("plain data") + "\n");
    files.extend(emit::flow(c, top, &files));
    let mut whole = project::text(c)?.files;
    whole.retain(|path, _| {
        let name = &top.name;
        [format!("testbench/tb_{name}.v"), format!("testbench/tb_{name}_top.v"), "testbench/verilator_main.cpp".into()]
            .contains(path)
    });
    files.extend(whole);
    Ok((modules.len(), files))
}
