//! The smallest design that meets an error budget on one scene: which numbers, which modes, how much map.
//!
//! The truth is the exact walk of the rays as they were given, over the map as it was given; a design answers for all that it changes: it rounds
//! the ray to its input format, computes in that format, and may hold a coarser map.
mod figures;
mod fresh;
mod search;
mod trial;
mod trial_figures;

pub use figures::FitFigures;
pub use fresh::{Checked, SETS, fit_checked};
pub use search::{Fit, Limits, Rejected, fit};
pub use trial::{Budget, Trial, Truth};
pub use trial_figures::TrialFigures;

/// Keys of the configuration that a fit chooses; what they were before has no meaning to it.
pub const CHOSEN: &[&str] = &[
    "datapath.kind",
    "datapath.search",
    "datapath.fraction_bits",
    "datapath.reciprocal_bits",
    "windows.set",
    "format.exp",
    "format.man",
    "traverse.frac_bits",
    "traverse.step_limit",
    "mode.start_level",
    "mode.levels_down",
    "mode.level_up",
    "mode.trim",
];
