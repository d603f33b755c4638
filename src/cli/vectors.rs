//! `reliefrtl vectors`: the golden vectors alone.
use super::args::{Cli, VectorsArgs};
use super::output::spinner;
use crate::emit::fill;
use crate::error::{Error, Result};
use crate::files::Part;
use crate::project::{self, Scene};
use serde_json::json;

/// Runs `vectors`.
pub fn run(cli: &Cli, a: &VectorsArgs) -> Result<()> {
    let (c, alone) = super::load::load_for(cli, &a.unit)?;
    let campaign = a.campaign.campaign(!alone.is_empty())?;
    let over = project::parameters(&a.param)?;
    alone.iter().try_for_each(|m| project::accepts(m, &over))?;
    let dir = super::output::directory(&a.out)?;
    let bar = spinner(cli, "computing vectors");
    let own: Vec<String> = a.unit.iter().map(|name| format!("golden/{name}/")).collect();
    let files = if alone.is_empty() && !over.is_empty() {
        let map = a.map.map.as_deref();
        let each = a.unit.iter().map(|name| project::unit_vectors(&c, name, &over, map, a.map.resample));
        each.collect::<Result<Vec<_>>>()?.into_iter().flatten().collect()
    } else if alone.is_empty() {
        let scene = Scene::new(&c, a.map.map.as_deref(), a.map.resample)?;
        let mut files = project::vectors(&c, &scene)?;
        files.retain(|f, _| own.is_empty() || own.iter().any(|dir| f.starts_with(dir)));
        files
    } else {
        alone.iter().flat_map(|m| project::alone_vectors(&c, m, &over, campaign)).collect()
    };
    if files.is_empty() {
        return Err(Error::NothingRan(crate::catalogue::without_vectors(&c.design(), &a.unit)));
    }
    let own: Vec<&str> = if own.is_empty() { vec!["golden/"] } else { own.iter().map(String::as_str).collect() };
    let part = Part { config: c.hash(), replaces: &own, alone_in: &[] };
    fill(dir.only(part), &files)?;
    bar.finish_and_clear();
    if cli.json {
        println!("{}", json!({"out": a.out, "files": files.keys().collect::<Vec<_>>()}));
    } else {
        println!("{} files in {}", files.len(), a.out.join("golden").display());
    }
    Ok(())
}
