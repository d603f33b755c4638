//! The hardware datapaths, by their kind: the one place that knows all of them.
use super::datapath::Datapath;
use super::{fixed, published, watertight, windows};
use reliefrtl_config::{DatapathKind, Design};

impl Datapath {
    /// The datapath of a design.
    pub fn of(d: &Design) -> &'static Self {
        match d.datapath.kind {
            DatapathKind::Watertight if d.fetch.blocks() => &watertight::BLOCKS,
            DatapathKind::Fixed if d.fetch.blocks() => &fixed::BLOCKS,
            DatapathKind::Watertight => &watertight::DATAPATH,
            DatapathKind::Published => &published::DATAPATH,
            DatapathKind::Fixed => &fixed::DATAPATH,
            DatapathKind::Windows => &windows::DATAPATH,
        }
    }
}
