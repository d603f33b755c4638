//! The Verilog of a whole design.
use super::{Files, flow, manifest, modules, rtl};
use crate::config::Config;
use crate::error::Result;
use crate::ir::Module;
use crate::units::all;
use crate::units::traversal::{Traverse, traverse};
use std::sync::Arc;

/// The emitted files of a design, and what they are printed from.
pub struct Hardware {
    /// Modules, leaves first.
    pub modules: Vec<Arc<Module>>,
    /// The traverse unit and its schedule.
    pub traverse: Traverse,
    /// Files by their path from the output directory.
    pub files: Files,
}

/// The Verilog and the manifest.
///
/// # Errors
/// A configuration that its own modules refuse.
pub fn hardware(c: &Config) -> Result<Hardware> {
    let d = c.design();
    let modules = modules(&all(&d))?;
    let mut files = rtl(c, &modules);
    let manifest = manifest(c, &modules, &files);
    files.insert("manifest.json".into(), serde_json::to_string_pretty(&manifest).expect("plain data") + "\n");
    let traverse = traverse(&d);
    files.extend(flow(c, std::slice::from_ref(&traverse.module), &files));
    Ok(Hardware { modules, traverse, files })
}
