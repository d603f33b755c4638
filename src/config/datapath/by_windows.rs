//! Other searches of the same numbers, which find the same hits.
use crate::{DatapathConfig, DatapathKind, Design, ModeConfig, WindowSet, WindowsConfig};

/// A search by each set that has a name and fits the map, with the numbers of a pyramid.
pub(super) fn searches(d: &Design) -> Vec<Design> {
    let sets = WindowSet::named().into_iter().filter(|set| set.misfit(d.traverse.levels).is_none());
    let by = |set| Design {
        datapath: DatapathConfig { kind: DatapathKind::Windows, ..d.datapath },
        windows: WindowsConfig { set: Some(set) },
        mode: ModeConfig { bilinear: d.mode.bilinear, ..ModeConfig::default() },
        ..*d
    };
    sets.map(by).collect()
}
