//! The designs that the page always names.
use super::design::DesignSpec;
use super::select::configured;
use crate::config::modes::BEST;
use crate::config::{Config, DatapathConfig, DatapathKind, datapaths};

/// A design that the page always names.
#[derive(Clone, Debug)]
pub struct Headline {
    /// What it is called.
    pub name: String,
    /// The design.
    pub design: DesignSpec,
}

/// The designs that the page always names, whether they are legal or not: each datapath in its usual format, or in the first that was chosen,
/// and the configured one.
pub fn headlines(c: &Config, designs: &[DesignSpec]) -> Vec<Headline> {
    let usual = DatapathConfig::default();
    let find = |kind: DatapathKind, nudge: u32| {
        let reads = kind.facts().reads;
        let same =
            |d: &&DesignSpec| d.kind == kind && d.mode == BEST && (!reads.nudge_bits || d.nudge_bits == Some(nudge));
        let known = |d: &&DesignSpec| {
            (!reads.format || (d.exp, d.man) == (Some(7), Some(16)))
                && (!reads.fraction_bits || d.fraction_bits == Some(usual.fraction_bits))
        };
        designs.iter().filter(same).find(known).or_else(|| designs.iter().find(same))
    };
    let mut out = Vec::new();
    // Searches that are no datapath of their own stand after the datapaths.
    let mut kinds: Vec<DatapathKind> = datapaths().collect();
    let own = configured(c);
    for d in designs.iter().filter(|d| **d != own) {
        if !kinds.contains(&d.kind) {
            kinds.push(d.kind);
        }
    }
    for kind in kinds {
        let word = kind.word();
        let both = [(word.to_owned(), usual.nudge_bits), (format!("{word}, no nudge"), 0)];
        let named = both.into_iter().take(if kind.facts().reads.nudge_bits { 2 } else { 1 });
        out.extend(named.filter_map(|(name, nudge)| Some(Headline { name, design: find(kind, nudge)?.clone() })));
    }
    if designs.contains(&own) && out.iter().all(|h| h.design != own) {
        out.insert(0, Headline { name: "configured".to_owned(), design: own });
    }
    out
}
