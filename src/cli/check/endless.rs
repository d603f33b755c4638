//! `reliefrtl check --level 3`: random rows of one seed after the other, until it is stopped or something differs.
use crate::cli::args::{CheckArgs, Cli};
use crate::cli::output::spinner;
use crate::config::Config;
use crate::emit::write_tree;
use crate::error::{Error, Result};
use crate::files::Scratch;
use crate::ir::Module;
use crate::project::{alone_files, check_tree};
use crate::vectors::{Campaign, Shard, exhaustive};
use std::sync::Arc;

/// Checks batches of `vectors.arithmetic` rows: the seed of the configuration, the next one, and so on; of these the part that `campaign` says. A
/// line a batch, so that whoever stops it knows how far it came.
pub fn run(cli: &Cli, a: &CheckArgs, c: &Config, m: &Arc<Module>, campaign: Campaign) -> Result<()> {
    if a.wave.is_some() || a.canary.is_some() {
        return Err(Error::input("--level 3 takes no --wave and no --canary: levels 1 and 2 do"));
    }
    let (first, part) = (c.vectors.seed, campaign.shard);
    // Parts are whole batches here: a batch itself is not divided.
    let whole = Campaign { shard: Shard::WHOLE, ..campaign };
    let seeds = (0..).map(|k| first + k * u64::from(part.of) + u64::from(part.index) - 1);
    let mut rows = 0;
    for seed in seeds.take(a.batches.map_or(usize::MAX, |n| n as usize)) {
        let mut c = c.clone();
        c.vectors.seed = seed;
        let bar = spinner(cli, format!("seed {seed}"));
        let files = alone_files(&c, std::slice::from_ref(m), Some(whole))?;
        let work = Scratch::new()?;
        let dir = work.path().join("tree");
        write_tree(&dir, &files)?;
        let done = check_tree(&c, &dir, a.engine, std::slice::from_ref(&m.name), None, None, &|_| ());
        bar.finish_and_clear();
        let told = |e| match e {
            Error::Mismatch(f) => Error::Mismatch(f.and(format!("; of vectors.seed = {seed}"))),
            e => e,
        };
        let batch: usize = done.map_err(told)?.iter().map(|x| x.rows).sum();
        rows += batch;
        if cli.json {
            println!(
                "{}",
                serde_json::json!({"unit": m.name, "seed": seed, "checked": batch, "mismatched": 0, "total": rows})
            );
        } else {
            println!("{:<16} seed {seed}: 0 of {batch} mismatched; 0 of {rows} so far", m.name);
        }
        crate::cli::print::flush();
        if crate::cli::print::unheard() {
            break;
        }
        let bits = m.data_inputs().map(|(_, p)| p.width.eval(&m.default_binding()) as u32).sum();
        if exhaustive(bits) {
            println!("{}: these are all inputs that there are; another seed has no others", m.name);
            break;
        }
    }
    Ok(())
}
