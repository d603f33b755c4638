//! Units at other parameter values than the configuration's, as the emitted text takes them: what a bench is given by `-P`.
use super::Scene;
use crate::catalogue::{count_events, design_at, find, has_vectors, ray_set, takes_rays, vector_set, without_vectors};
use crate::config::Config;
use crate::emit::Files;
use crate::error::{Error, Result};
use crate::interp::elaborate;
use crate::ir::{Binding, Module};
use crate::vectors::{Plan, set_files};
use std::path::Path;

/// No parameter is as large as this; larger numbers would only overflow what is computed of them.
const MOST: i64 = 65535;

/// Reads `NAME=VALUE`s.
///
/// # Errors
/// What is not one, or a name twice.
pub fn parameters(words: &[String]) -> Result<Binding> {
    let mut out = Binding::new();
    for word in words {
        let pair = word.split_once('=').and_then(|(name, v)| Some((name.trim(), v.trim().parse::<i64>().ok()?)));
        let Some((name, value)) = pair else {
            return Err(Error::input(format!("--param {word} is not NAME=VALUE with a whole number, as W=13")));
        };
        if !(0..=MOST).contains(&value) {
            return Err(Error::input(format!("--param {word}: no parameter is below 0 or above {MOST}")));
        }
        if out.insert(name.to_string(), value).is_some() {
            return Err(Error::input(format!("--param gives {name} twice")));
        }
    }
    Ok(out)
}

/// Whether `m`, and all that stands in it, takes these values.
///
/// # Errors
/// A name that it does not have, or the conditions that don't hold.
pub fn accepts(m: &Module, over: &Binding) -> Result<()> {
    if let Some(name) = over.keys().find(|k| !m.params.iter().any(|p| p.name == **k)) {
        let known: Vec<&str> = m.params.iter().map(|p| p.name.as_str()).collect();
        let known =
            if known.is_empty() { "no parameters".to_string() } else { format!("the parameters {}", known.join(", ")) };
        return Err(Error::input(format!("--param: {} has no parameter {name}; it has {known}", m.name)));
    }
    let b = m.binding_with(over);
    // A number outside of its own bounds first: what is computed of it may be too large for any number.
    let mut checks: Vec<_> = m.checks.iter().collect();
    checks.sort_by_key(|c| c.lhs.as_const().is_none() && c.rhs.as_const().is_none());
    for c in checks {
        if c.lhs.eval_wide(&b) > c.rhs.eval_wide(&b) {
            let values = over.iter().map(|(k, v)| format!("{k}={v}")).collect::<Vec<_>>().join(", ");
            return Err(Error::input(format!("--param {values}: {} needs {} <= {}", m.name, c.lhs, c.rhs)));
        }
    }
    elaborate(m, over).map(|_| ())
}

/// The configuration whose `traverse` has these parameter values by default.
fn with_parameters(c: &Config, over: &Binding) -> Config {
    let d = design_at(&c.design(), over);
    let mut c = c.clone();
    (c.format.exp, c.format.man) = (d.format.exp, d.format.man);
    (c.traverse, c.datapath) = (d.traverse, d.datapath);
    c
}

/// Vectors of one unit of the whole design at parameter values `over`, under `golden/`.
///
/// # Errors
/// An unknown unit, values that it does not take, a map that does not fit.
pub fn unit_vectors(c: &Config, name: &str, over: &Binding, map: Option<&Path>, resample: bool) -> Result<Files> {
    let d = c.design();
    let m = find(&d, name)?;
    accepts(&m, over)?;
    let under = |files: Vec<(String, String)>| {
        let mut files: Files = files.into_iter().map(|(n, t)| (format!("golden/{name}/{n}"), t)).collect();
        files.extend(super::digests::digests(&files));
        files
    };
    if !takes_rays(&m) {
        if !has_vectors(&d, &m) {
            return Err(Error::NothingRan(without_vectors(&d, std::slice::from_ref(&m.name))));
        }
        let plan = Plan { rows: c.vectors.arithmetic as usize, seed: c.vectors.seed };
        let mut set = vector_set(&d, &m, over, plan);
        set.events = count_events(&d, &m, &set);
        return Ok(under(set_files(&set).into_iter().collect()));
    }
    let c = with_parameters(c, over);
    let scene = Scene::new(&c, map, resample)?;
    let set = ray_set(&c.design(), &scene.pyramid, &scene.sample(&c)?, c.vectors.seed)?;
    let mut files: Vec<(String, String)> = set_files(&set.set).into_iter().collect();
    files.extend(set.memory_files().map(|(n, t)| (n, t.clone())));
    files.push(("trace.csv".into(), set.trace.clone()));
    Ok(under(files))
}
