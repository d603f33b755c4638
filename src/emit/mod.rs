//! What a configuration emits: the modules, their Verilog files, the file list and the manifest.
//!
//! Everything is made in memory first; the same configuration gives the same bytes.
mod flow;
mod manifest;
mod tree;

pub use flow::flow;
pub use manifest::manifest;
pub use tree::{emitted_name, manifest_prefix};

use crate::config::{Config, DatapathKind, Divider, ExtraUnit, Trim};
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
pub fn modules(tops: &[Arc<Module>]) -> Result<Vec<Arc<Module>>> {
    let mut out: Vec<Arc<Module>> = Vec::new();
    for top in tops {
        for m in top.hierarchy() {
            let failed = m.failed_checks(&m.default_binding());
            if !failed.is_empty() {
                return Err(Error::input(format!("the configuration is illegal for {}", failed.join("; "))));
            }
            if !out.iter().any(|o| o.name == m.name) {
                out.push(m);
            }
        }
    }
    Ok(out)
}

/// The line of each banner that names the configuration.
pub fn config_line(c: &Config) -> String {
    let (t, m, l) = (&c.traverse, &c.mode, &c.latency);
    let mut clocks = String::new();
    for (unit, n) in [(ExtraUnit::Sqrt, l.sqrt), (ExtraUnit::Add3, l.add3)] {
        if c.emit.units.contains(&unit) {
            clocks += &format!(" {} {n}", ExtraUnit::WORDS[unit as usize].trim_start_matches("fp_"));
        }
    }
    let trim = match m.trim {
        Trim::None => "",
        Trim::Descent => ", trim after descents",
        Trim::Always => ", trim always",
    };
    let lod = if m.lod { ", level of detail" } else { "" };
    let more = format!("{trim}{lod}{}", if m.bilinear { ", bilinear" } else { "" });
    let numbers = match c.datapath.kind {
        DatapathKind::Fixed => {
            format!("fixed point {}, reciprocal {}", c.datapath.fraction_bits, c.datapath.reciprocal_bits)
        }
        DatapathKind::Watertight | DatapathKind::Published => format!("float {}", c.format.float()),
    };
    let divider = if l.divider == Divider::Table { " by table" } else { "" };
    let start = if m.start_level { "start level" } else { "from the root" };
    let path = match c.datapath.kind {
        DatapathKind::Watertight => "",
        DatapathKind::Published => "published datapath, ",
        DatapathKind::Fixed => "fixed datapath, ",
    };
    format!(
        "{path}{numbers}, levels {}, heights {} bits, {start}, {} down, up {}{more}; clocks add {} mul {} div {}{divider} compare {} from_int {} to_int {}{clocks}",
        t.levels,
        t.height_bits,
        m.levels_down,
        format!("{:?}", m.level_up).to_lowercase(),
        l.add,
        l.mul,
        l.div,
        l.compare,
        l.from_int,
        l.to_int
    )
}

/// `rtl/*.v` and `rtl/filelist.f` of `modules`.
pub fn rtl(c: &Config, modules: &[Arc<Module>]) -> Files {
    let style = Style { config: config_line(c), prefix: c.emit.prefix.clone() };
    let mut files = Files::new();
    let mut list = String::new();
    for m in modules {
        let path = format!("rtl/{}{}.v", style.prefix, m.name);
        list += &format!("{path}\n");
        files.insert(path, print_module(m, &style));
    }
    files.insert("rtl/filelist.f".into(), list);
    files
}
