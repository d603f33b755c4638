//! A unit of arithmetic by itself, for a use that needs nothing else: at any format, whatever a traversal asks of its own.
use crate::bench::bench_files;
use crate::catalogue::{campaign_set, count_events, vector_set};
use crate::config::Config;
use crate::emit::{self, Files};
use crate::error::Result;
use crate::ir::{Binding, Module};
use crate::units::{arithmetic, available};
use crate::vectors::{Campaign, Plan, set_files};
use std::sync::Arc;

/// The unit of arithmetic of that name, those included that come only where they are named; `None` if there is none.
pub fn alone(c: &Config, name: &str) -> Option<Arc<Module>> {
    let d = c.design();
    arithmetic(&d).into_iter().chain(available(&d)).find(|m| m.name == name)
}

/// Its vectors at parameter values `over`, under `golden/`; of a campaign, or the usual choice.
pub fn alone_vectors(c: &Config, m: &Module, over: &Binding, campaign: Option<Campaign>) -> Files {
    let (d, b) = (c.design(), over);
    let plan = Plan { rows: c.vectors.arithmetic as usize, seed: c.vectors.seed };
    let mut set = match campaign {
        None => vector_set(&d, m, b, plan),
        Some(campaign) => campaign_set(&d, m, b, plan, campaign),
    };
    set.events = count_events(&d, m, &set);
    let mut files: Files = set_files(&set).into_iter().map(|(n, t)| (format!("golden/{}/{n}", m.name), t)).collect();
    files.extend(super::digests::digests(&files));
    files
}

/// The Verilog of units and of what they are made of, with benches and manifest.
///
/// # Errors
/// Parameter values that a unit refuses.
pub fn alone_text(c: &Config, units: &[Arc<Module>]) -> Result<Files> {
    let modules = emit::modules(units)?;
    let mut files = emit::rtl(c, &modules);
    let manifest = emit::manifest(c, &modules, &files);
    files.insert("manifest.json".into(), serde_json::to_string_pretty(&manifest).expect("plain data") + "\n");
    files.extend(emit::flow(c, units, &files));
    files.extend(bench_files(units, None, &c.emit));
    Ok(files)
}

/// Verilog, manifest, bench and vectors.
///
/// # Errors
/// As [`alone_text`].
pub fn alone_files(c: &Config, units: &[Arc<Module>], campaign: Option<Campaign>) -> Result<Files> {
    let mut files = alone_text(c, units)?;
    units.iter().for_each(|m| files.extend(alone_vectors(c, m, &Binding::new(), campaign)));
    Ok(files)
}
