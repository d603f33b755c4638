//! What a configuration emits: the modules, their Verilog files, the file list and the manifest.
//!
//! Everything is made in memory first; the same configuration gives the same bytes.
mod flow;
mod hardware;
mod manifest;
pub mod parts;
mod tree;

pub use flow::flow;
pub use hardware::{Hardware, hardware};
pub use manifest::manifest;
pub use tree::{emitted_name, fill, manifest_emit, write_tree};

use crate::config::Config;
use crate::error::{Error, Result};
use crate::ir::Module;
use crate::verilog::{Style, print_module};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Files by their path from the output directory.
pub type Files = BTreeMap<String, String>;

/// The modules of `tops` and all below them, leaves first, each name once: the first module of a name wins, so the
/// units' own defaults stand before those of their users.
///
/// # Errors
/// If the configuration does not fit its own modules' conditions on parameters.
///
/// # Panics
/// If units need one module in two forms: a bug of the units.
pub fn modules(tops: &[Arc<Module>]) -> Result<Vec<Arc<Module>>> {
    let mut out: Vec<Arc<Module>> = Vec::new();
    for top in tops {
        for m in top.hierarchy() {
            let failed = m.failed_checks(&m.default_binding());
            if !failed.is_empty() {
                return Err(Error::input(format!("the configuration is illegal for {}", failed.join("; "))));
            }
            match out.iter().find(|o| o.name == m.name) {
                None => out.push(m),
                Some(known) => {
                    let same = known.contract() == m.contract();
                    assert!(same, "{} is needed in two forms, of which only one can have the name", m.name);
                }
            }
        }
    }
    Ok(out)
}

/// `rtl/*.v` of `modules`, and lists of them: `rtl/filelist.f` from the output directory, the others from where they stand themselves (`-F`).
pub fn rtl(c: &Config, modules: &[Arc<Module>]) -> Files {
    let style = Style::from(&c.emit);
    let prefix = &style.prefix;
    let mut files = Files::new();
    for m in modules {
        files.insert(format!("rtl/{prefix}{}.v", m.name), print_module(m, &style));
        files.insert(format!("rtl/{prefix}{}.f", m.name), file_list("", prefix, &m.hierarchy()));
    }
    files.insert(format!("rtl/{prefix}all.f"), file_list("", prefix, modules));
    files.insert("rtl/filelist.f".into(), file_list("rtl/", prefix, modules));
    files
}

/// A line for the file of each module, after `folder`.
pub fn file_list(folder: &str, prefix: &str, modules: &[Arc<Module>]) -> String {
    modules.iter().map(|m| format!("{folder}{prefix}{}.v\n", m.name)).collect()
}
