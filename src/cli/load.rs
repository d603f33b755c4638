//! The configuration of a call: defaults, file, options.
use super::args::Cli;
use crate::catalogue::timed;
use crate::config::{Choice, Config, Design, Scope, for_clock};
use crate::error::{Error, Result};
use crate::ir::Module;
use std::sync::Arc;

/// The configuration of this call: defaults, then the file, then `--set`.
///
/// # Errors
/// Unknown keys, wrong types, illegal values: one sentence each.
pub fn load(cli: &Cli) -> Result<Config> {
    let c = load_ranges(cli, &[])?;
    c.validate()?;
    Ok(c)
}

/// As [`load`] for `units`: those of arithmetic stand alone, and what a traversal asks of its numbers does not bind them; they come with the
/// configuration. Empty, if one is no arithmetic.
///
/// # Errors
/// As [`load`].
pub fn load_for(cli: &Cli, units: &[String]) -> Result<(Config, Vec<Arc<Module>>)> {
    let c = load_ranges(cli, units)?;
    c.design().check_divider()?;
    let alone: Option<Vec<_>> = units.iter().map(|name| crate::project::alone(&c, name)).collect();
    let alone = alone.unwrap_or_default();
    if alone.is_empty() {
        c.validate()?;
        let d = c.design();
        units.iter().filter(|name| *name != "all").try_for_each(|name| crate::catalogue::find(&d, name).map(|_| ()))?;
    }
    Ok((c, alone))
}

/// As [`load`], with each value checked by itself and not against the others; `--clock` is asked of `units`, or of a whole traversal.
///
/// # Errors
/// As [`load`].
pub(super) fn load_ranges(cli: &Cli, units: &[String]) -> Result<Config> {
    let mut c = match &cli.config {
        Some(path) => Config::load(path)?,
        None => Config::default(),
    };
    let asked = numbers(cli, &c)?;
    if let Some(profile) = cli.profile {
        c.latency = profile.latency_for(&asked);
    }
    let named = Config { convert: Default::default(), ..c.clone() };
    let alone = !units.is_empty() && units.iter().all(|name| crate::project::alone(&named, name).is_some());
    let scope = if alone { Scope::Alone(units) } else { Scope::Traversal };
    let clock =
        cli.clock.map(|mhz| Ok::<(u32, Choice), Error>((mhz, for_clock(mhz, &asked, scope, &timed())?))).transpose()?;
    if let Some((mhz, choice)) = &clock {
        (c.latency, c.emit.clock_mhz) = (choice.latency, *mhz);
    }
    cli.sets.iter().try_for_each(|s| c.apply_set(s))?;
    if let Some(map) = cli.verb.map() {
        map.apply(&mut c.map);
    }
    c.design().check_convert()?;
    if let Some((mhz, choice)) = clock {
        if c.emit.clock_mhz != mhz {
            return Err(Error::input(format!(
                "--clock {mhz} and --set emit.clock_mhz={} ask for two clocks: leave one of them out",
                c.emit.clock_mhz
            )));
        }
        super::output::note(choice.provenance(mhz, &c.design(), scope));
    }
    Ok(c)
}

/// The design with the datapath and its widths, the format and the kind of divider that the configuration ends up with.
fn numbers(cli: &Cli, c: &Config) -> Result<Design> {
    let mut c = c.clone();
    let keys = ["datapath.", "format.", "latency.divider"];
    let numbers = |s: &&String| keys.iter().any(|key| s.trim_start().starts_with(key));
    cli.sets.iter().filter(numbers).try_for_each(|s| c.apply_set(s))?;
    Ok(c.design())
}
