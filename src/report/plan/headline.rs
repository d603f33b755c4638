//! The designs that the page always names.
use super::design::{BEST, DesignSpec};
use super::select::configured;
use crate::config::{Config, DatapathConfig, DatapathKind};

/// A design that the page always names.
#[derive(Clone, Debug)]
pub struct Headline {
    /// What it is called.
    pub name: &'static str,
    /// The design.
    pub design: DesignSpec,
}

/// The designs that the page always names, whether they are legal or not: each datapath in its usual format, or in the first that was chosen,
/// and the configured one.
pub fn headlines(c: &Config, designs: &[DesignSpec]) -> Vec<Headline> {
    let usual = DatapathConfig::default();
    let find = |kind: DatapathKind, nudge: u32| {
        let same = |d: &&DesignSpec| {
            let published = kind != DatapathKind::Published || d.nudge_bits == Some(nudge);
            d.kind == kind && d.mode == BEST && published
        };
        let known = |d: &&DesignSpec| {
            let float = kind == DatapathKind::Fixed || (d.exp, d.man) == (Some(7), Some(16));
            float && (kind != DatapathKind::Fixed || d.fraction_bits == Some(usual.fraction_bits))
        };
        designs.iter().filter(same).find(known).or_else(|| designs.iter().find(same))
    };
    let mut out: Vec<Headline> = [
        ("watertight", DatapathKind::Watertight, 0),
        ("fixed", DatapathKind::Fixed, 0),
        ("published", DatapathKind::Published, usual.nudge_bits),
        ("published, no nudge", DatapathKind::Published, 0),
    ]
    .into_iter()
    .filter_map(|(name, kind, nudge)| Some(Headline { name, design: find(kind, nudge)?.clone() }))
    .collect();
    let own = configured(c);
    if designs.contains(&own) && out.iter().all(|h| h.design != own) {
        out.insert(0, Headline { name: "configured", design: own });
    }
    out
}
