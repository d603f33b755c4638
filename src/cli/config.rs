//! `reliefrtl config`: the configuration as it stands, with comments, or its schema.
use super::args::{Cli, ConfigArgs};
use crate::config::{Config, Design, for_clock};
use crate::error::{Error, Result};
use crate::ir::Module;
use std::sync::Arc;

/// The configuration of this call: defaults, then the file, then `--set`.
///
/// # Errors
/// Unknown keys, wrong types, illegal values: one sentence each.
pub fn load(cli: &Cli) -> Result<Config> {
    let c = load_ranges(cli)?;
    c.validate()?;
    Ok(c)
}

/// As [`load`] for `unit`: one of arithmetic stands alone, and what a traversal asks of its numbers does not bind it; it comes with the
/// configuration.
///
/// # Errors
/// As [`load`].
pub fn load_for(cli: &Cli, unit: Option<&str>) -> Result<(Config, Option<Arc<Module>>)> {
    let c = load_ranges(cli)?;
    c.design().check_divider()?;
    let alone = unit.and_then(|name| crate::project::alone(&c, name));
    if alone.is_none() {
        c.validate()?;
    }
    Ok((c, alone))
}

/// As [`load`], with each value checked by itself and not against the others.
///
/// # Errors
/// As [`load`].
pub(super) fn load_ranges(cli: &Cli) -> Result<Config> {
    let mut c = match &cli.config {
        Some(path) => Config::load(path)?,
        None => Config::default(),
    };
    if let Some(profile) = cli.profile {
        c.latency = profile.latency_for(&numbers(cli, &c)?);
    }
    if let Some(mhz) = cli.clock {
        let choice = for_clock(mhz, numbers(cli, &c)?.datapath.kind)?;
        (c.latency, c.emit.clock_mhz) = (choice.latency, mhz);
        eprintln!("reliefrtl: {}", choice.certainty(mhz));
    }
    cli.sets.iter().try_for_each(|s| c.apply_set(s))?;
    Ok(c)
}

/// The design with the datapath and the format that the configuration ends up with.
fn numbers(cli: &Cli, c: &Config) -> Result<Design> {
    let mut c = c.clone();
    let numbers = |s: &&String| ["datapath.kind", "format."].iter().any(|key| s.trim_start().starts_with(key));
    cli.sets.iter().filter(numbers).try_for_each(|s| c.apply_set(s))?;
    Ok(c.design())
}

/// Runs `config`.
pub fn run(cli: &Cli, a: &ConfigArgs) -> Result<()> {
    if a.schema {
        let text = serde_json::to_string_pretty(&Config::schema()).expect("a schema is plain data");
        println!("{text}");
        return Ok(());
    }
    let c = load(cli)?;
    if cli.json {
        println!("{}", serde_json::to_string_pretty(&c).expect("a configuration is plain data"));
        return Ok(());
    }
    if !a.print {
        return Err(Error::input("config needs --print (the configuration) or --schema (its JSON schema)"));
    }
    print!("{}", c.to_commented_toml());
    Ok(())
}
