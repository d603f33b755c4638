//! `reliefrtl prove`: the proofs of the emitted units.
use super::args::{Cli, ProveArgs};
use super::output::{spinner, table};
use crate::catalogue::proofs;
use crate::emit::write_tree;
use crate::error::{Error, Result};
use crate::files::Scratch;
use crate::project::{Scene, project};
use crate::proofs::{Proved, Tools, prove};
use crate::units;

/// Runs `prove`.
pub fn run(cli: &Cli, a: &ProveArgs) -> Result<()> {
    let c = super::load::load(cli)?;
    let mut list = proofs(&units::all(&c.design()));
    if let Some(name) = &a.unit {
        let names: Vec<&str> = list.iter().map(|p| p.name).collect();
        if !names.contains(&name.as_str()) {
            return Err(Error::input(format!("no proof is named {name}; this design has {}", names.join(", "))));
        }
        list.retain(|p| p.name == name);
    }
    if list.is_empty() {
        return Err(Error::NothingRan("this design has no proofs".into()));
    }
    if a.list && cli.json {
        let rows: Vec<_> = list.iter().map(|p| serde_json::json!({"proof": p.name, "claim": p.claim})).collect();
        println!("{}", serde_json::to_string_pretty(&rows).expect("plain data"));
        return Ok(());
    }
    if a.list {
        let rows: Vec<Vec<String>> = list.iter().map(|p| vec![p.name.into(), p.claim.into()]).collect();
        print!("{}", table(&["proof", "for every input"], &rows));
        return Ok(());
    }
    a.dir.as_deref().map_or(Ok(()), |dir| super::output::tree(dir, "rtl"))?;
    let tools = Tools::find()?;
    let work = Scratch::new()?;
    let dir = match &a.dir {
        Some(dir) => dir.clone(),
        None => {
            let tree = work.path().join("tree");
            write_tree(&tree, &project(&c, &Scene::new(&c, None, false)?)?.files)?;
            tree
        }
    };
    let bar = spinner(cli, "proving");
    let mut done: Vec<(Proved, &str)> = Vec::new();
    for (k, p) in list.iter().enumerate() {
        bar.set_message(format!("{} ({} of {})", p.name, k + 1, list.len()));
        done.push((prove(&tools, &dir, p.name)?, p.claim));
    }
    bar.finish_and_clear();
    if cli.json {
        let rows: Vec<_> = done.iter().map(|(p, claim)| serde_json::json!({"proof": p.name, "claim": claim})).collect();
        println!("{}", serde_json::to_string_pretty(&rows).expect("plain data"));
        return Ok(());
    }
    let rows: Vec<Vec<String>> = done
        .iter()
        .map(|(p, claim)| vec![p.name.clone(), format!("{:.1} s", p.took.as_secs_f64()), (*claim).to_string()])
        .collect();
    print!("{}", table(&["proved", "time", "for every input"], &rows));
    Ok(())
}
