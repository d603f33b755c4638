//! What a search found, as numbers under names: what `fit --json` prints.
use super::search::{Fit, Rejected};
use super::trial::Trial;
use super::trial_figures::TrialFigures;
use crate::config::{DatapathConfig, ModeConfig, TraverseConfig, WindowsConfig};
use crate::measure::Cost;
use serde::Serialize;
use std::collections::BTreeMap;

/// The design that was found, what it does, and what was not taken.
#[derive(Clone, Debug, Serialize)]
pub struct FitFigures<'a> {
    /// Map and ray widths.
    pub traverse: TraverseConfig,
    /// Traversal modes.
    pub mode: ModeConfig,
    /// Datapath and its widths.
    pub datapath: DatapathConfig,
    /// Windows, where the search is by windows.
    pub windows: WindowsConfig,
    /// Exponent bits.
    pub exp: u32,
    /// Fraction bits.
    pub man: u32,
    /// Size, in bits.
    pub bits: Cost,
    /// On the rays of the search.
    pub search: TrialFigures,
    /// On fresh rays.
    pub fresh: TrialFigures,
    /// On the fresh rays of each view.
    pub fresh_by_view: BTreeMap<&'a str, TrialFigures>,
    /// A sentence for each decision.
    pub reasons: &'a [String],
    /// Designs that were not taken, each with the reason.
    pub rejected: &'a [Rejected],
    /// Designs tried.
    pub tried: usize,
}

impl<'a> FitFigures<'a> {
    /// The figures of a search that was checked on fresh rays, all together and view by view.
    pub fn new(found: &'a Fit, fresh: &Trial, by_view: &'a [(String, Trial)]) -> Self {
        let d = &found.chosen.design;
        Self {
            traverse: d.traverse,
            mode: d.mode,
            datapath: d.datapath,
            windows: d.windows,
            exp: d.format.exp,
            man: d.format.man,
            bits: found.chosen.cost,
            search: (&found.chosen).into(),
            fresh: fresh.into(),
            fresh_by_view: by_view.iter().map(|(view, t)| (view.as_str(), t.into())).collect(),
            reasons: &found.reasons,
            rejected: &found.rejected,
            tried: found.tried,
        }
    }
}
