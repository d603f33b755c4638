//! The search, and its check on rays that it has not seen: what breaks there is searched again with those rays.
use super::search::{Fit, Limits, fit};
use super::trial::{Budget, Trial, Truth};
use crate::config::Design;
use crate::error::{Error, Result};

/// Sets of rays that share none: one to search with, the others to check with, each until a design breaks its budget on it.
pub const SETS: usize = 4;

/// A design that keeps its budget on rays that the search has not seen.
pub struct Checked {
    /// What the search found; its reasons say which designs broke on fresh rays before.
    pub fit: Fit,
    /// The chosen design on the fresh rays.
    pub check: Trial,
    /// Which set of rays was the fresh one.
    pub set: usize,
}

/// Searches on set 0 and checks on set 1; a design that breaks the budget there is searched anew on both and checked on set 2, and so on.
/// `seen` is the truth on set 0, `truth` the one on any sets.
///
/// # Errors
/// No design keeps the budget, or the last fresh set broke that of the last design, too.
pub fn fit_checked(
    base: &Design,
    mut seen: Truth,
    truth: &dyn Fn(&[usize]) -> Result<Truth>,
    budget: Budget,
    limits: Limits,
    tell: &dyn Fn(&str),
) -> Result<Checked> {
    let mut broken: Option<(String, String)> = None;
    for set in 1..SETS {
        let mut found = fit(base, &seen, budget, limits, tell)?;
        let check = Trial::run(&found.chosen.design, &truth(&[set])?)?;
        if let Some((design, figure)) = &broken {
            found.reasons.push(format!("fresh rays broke the budget of {design} ({figure}): searched again with them"));
        }
        if check.keeps(budget) {
            return Ok(Checked { fit: found, check, set });
        }
        broken = Some((found.chosen.design.label(), check.figure(budget)));
        seen = truth(&(0..=set).collect::<Vec<_>>())?;
    }
    let figure = broken.map_or(String::new(), |b| b.1);
    Err(Error::mismatch(format!(
        "fresh rays break the budget of every design that the search found, {} times over: {figure}; ask for a tighter one, or for more --rays",
        SETS - 1
    )))
}
