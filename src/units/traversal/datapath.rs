//! What a datapath puts into `traverse`: its numbers, a ray's constants, setup, iteration and hit position.
//!
//! The loop itself (admission, tags, back-pressure, leaving) is the same for all of them: `traverse.rs`.
use super::loop_state::{Field, Numbers, Ray, Sizes};
use super::published;
use super::traverse::Load;
use super::{fixed, watertight};
use crate::config::{DatapathKind, Design};
use crate::ir::{Builder, Expr, Module, Sig};
use crate::units::float::FormatParams;
use std::sync::Arc;

/// The parts of one datapath.
pub struct Datapath {
    /// The arithmetic that the units below are made of, leaves first.
    pub arithmetic: fn(&Design) -> Vec<Arc<Module>>,
    /// The units of an iteration that are this datapath's own.
    pub steps: fn(&Design) -> Vec<Arc<Module>>,
    /// Declares the parameters of the number format.
    pub declare: fn(&Builder, &Design) -> Option<FormatParams>,
    /// The words at the ports, with what LEVELS, HEIGHT_W and TILE_W may be.
    pub numbers: fn(&Builder, &Design, Option<FormatParams>, &Expr, &Expr, &Expr) -> Numbers,
    /// What a ray carries besides the state that all datapaths have.
    pub constants: fn(&Sizes, &Design) -> Vec<Field>,
    /// Once per ray: inputs u, v, du, dv and, with a level of detail, lod; outputs ok, level, then finest, first_x, first_y and all that fields start from.
    pub setup: fn(&Design) -> Arc<Module>,
    /// Clocks through setup, at least 1.
    pub setup_clocks: fn(&Design) -> u32,
    /// One iteration.
    pub iteration: for<'b> fn(&'b Builder, &Sizes, &Design, &Ray<'b>, &Load<'b>) -> Ray<'b>,
    /// Position of a hit inside its texel along one axis; with a level of detail, the texel (wrapped) after it.
    pub hit: fn(&Design) -> Arc<Module>,
    /// Clocks through `hit`, at least 1.
    pub hit_clocks: fn(&Design) -> u32,
    /// Inputs of `hit` along an axis (`x` or `y`) and the words that they take.
    pub hit_inputs: for<'b> fn(&Ray<'b>, &str) -> Vec<(&'static str, Sig<'b>)>,
    /// Why its loop differs from the published one in a row of `LoopResources::rows`; empty where nothing is to be said.
    pub difference: fn(&str) -> &'static str,
}

impl Datapath {
    /// The datapath of a design.
    pub fn of(d: &Design) -> &'static Self {
        match d.datapath.kind {
            DatapathKind::Watertight => &watertight::DATAPATH,
            DatapathKind::Published => &published::DATAPATH,
            DatapathKind::Fixed => &fixed::DATAPATH,
        }
    }
}
