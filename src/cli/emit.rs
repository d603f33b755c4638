//! `reliefrtl emit`: the Verilog, the file list and the manifest; of arithmetic alone, bench and vectors, too.
use super::args::{Cli, EmitArgs};
use crate::catalogue;
use crate::config::Config;
use crate::emit::{self, Files};
use crate::error::Result;
use crate::project;
use crate::units;

/// Runs `emit`.
pub fn run(cli: &Cli, a: &EmitArgs) -> Result<()> {
    let c = super::config::load_ranges(cli)?;
    // Arithmetic stands alone: what a traversal asks of its format does not bind it, and it brings bench and vectors along.
    let (count, files) = match a.unit.as_ref().and_then(|name| project::alone(&c, name)) {
        Some(m) => (emit::modules(std::slice::from_ref(&m))?.len(), project::alone_files(&c, &m)?),
        None => {
            c.validate()?;
            of_traversal(&c, a.unit.as_deref())?
        }
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

/// Modules and files of a traversal, or of one of its units.
fn of_traversal(c: &Config, unit: Option<&str>) -> Result<(usize, Files)> {
    let tops = match unit {
        None => units::all(&c.design()),
        Some(name) => vec![catalogue::find(&c.design(), name)?],
    };
    let modules = emit::modules(&tops)?;
    let mut files = emit::rtl(c, &modules);
    let manifest = emit::manifest(c, &modules, &files);
    files.insert("manifest.json".into(), serde_json::to_string_pretty(&manifest).expect("plain data") + "\n");
    Ok((modules.len(), files))
}
