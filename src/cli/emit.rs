//! `reliefrtl emit`: the Verilog, the file list and the manifest.
use super::args::{Cli, EmitArgs};
use crate::config::Config;
use crate::emit::{self, Files};
use crate::error::Result;
use crate::ir::Module;
use crate::project::alone_hardware;
use crate::units;
use std::sync::Arc;

/// Runs `emit`.
pub fn run(cli: &Cli, a: &EmitArgs) -> Result<()> {
    let (c, alone) = super::config::load_for(cli, a.unit.as_deref())?;
    let (count, files) = match (&alone, &a.unit) {
        (Some(m), _) => (emit::modules(std::slice::from_ref(m))?.len(), alone_hardware(&c, m)?),
        (None, None) => whole(&c, &units::all(&c.design()))?,
        (None, Some(name)) => whole(&c, &[crate::catalogue::find(&c.design(), name)?])?,
    };
    super::output::write_tree(&a.out, &files)?;
    if cli.json {
        let names: Vec<&String> = files.keys().collect();
        println!("{}", serde_json::json!({"out": a.out, "files": names}));
    } else {
        println!("{count} modules in {}", a.out.join("rtl").display());
    }
    Ok(())
}

/// Number of modules under `tops`, and their files.
fn whole(c: &Config, tops: &[Arc<Module>]) -> Result<(usize, Files)> {
    let modules = emit::modules(tops)?;
    let mut files = emit::rtl(c, &modules);
    let manifest = emit::manifest(c, &modules, &files);
    files.insert("manifest.json".into(), serde_json::to_string_pretty(&manifest).expect("plain data") + "\n");
    Ok((modules.len(), files))
}
