//! What a datapath puts into `traverse`: its numbers, a ray's constants, setup, iteration and hit position.
//!
//! The loop itself (accept, tags, back-pressure, retire) is the same for all of them: `traverse.rs`.
use super::height_source::{HeightPort, HeightSource, Load};
use super::loop_state::{Field, Numbers, Ray, Sizes, said_by, tag};
use super::search::Search;
use super::slot_memory::SlotMemory;
use crate::float::FormatParams;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Expr, Module, Sig};
use std::sync::Arc;

/// Builds an iteration: from the slot's ray to the ray that goes back; where constants stand in slot memories, from these, too.
pub type Iterate =
    for<'b> fn(&'b Builder, &Sizes, &Design, &Ray<'b>, &mut dyn HeightPort<'b>, Option<&SlotMemory<'b>>) -> Ray<'b>;

/// The parts of one datapath.
pub struct Datapath {
    /// What it searches.
    pub search: &'static Search,
    /// The arithmetic that the units below are made of, leaves first.
    pub arithmetic: fn(&Design) -> Vec<Arc<Module>>,
    /// The units of an iteration that are this datapath's own.
    pub steps: fn(&Design) -> Vec<Arc<Module>>,
    /// Declares the parameters of the number format.
    pub declare: fn(&Builder, &Design) -> Option<FormatParams>,
    /// The words at the ports, with what LEVELS, HEIGHT_W and TILE_W may be.
    pub numbers: fn(&Builder, &Design, Option<FormatParams>, &Expr, &Expr, &Expr) -> Numbers,
    /// Constants that a ray carries through the loop.
    pub constants: fn(&Sizes, &Design) -> Vec<Field>,
    /// Once per ray: inputs u, v, du, dv and, with a level of detail, lod; outputs ok, level, then finest, first_x, first_y and all that fields start from. Of at least one clock.
    pub setup: fn(&Design) -> Arc<Module>,
    /// One iteration.
    pub iteration: Iterate,
    /// Hit, descend or cross, where an iteration steps indices; where it moves positions, the datapath has units of its own for that.
    pub level_decision: Option<fn(&Design) -> Arc<Module>>,
    /// `level_up`, where there are levels and a rule that ascends.
    pub level_up: fn(&Design) -> Option<Arc<Module>>,
    /// Position of a hit inside its texel along one axis; with a level of detail, the texel (wrapped) after it. Of at least one clock.
    pub hit: fn(&Design) -> Arc<Module>,
    /// Inputs of `hit` along an axis (`x` or `y`) and the words that they take.
    pub hit_inputs: for<'b> fn(&Ray<'b>, &str) -> Vec<(&'static str, Sig<'b>)>,
    /// Why its loop differs from the published one in a row of `LoopResources::rows`; empty where nothing is to be said.
    pub difference: fn(&str) -> &'static str,
}

impl Datapath {
    /// Declares the parameters of `traverse`, with what they may be.
    pub fn sizes(&self, b: &Builder, d: &Design) -> Sizes {
        // The format's parameters come first.
        let declared = (self.declare)(b, d);
        Sizes::declare(b, d, |levels, height, tile| (self.numbers)(b, d, declared, levels, height, tile))
    }

    /// All that a ray carries: tag and constants, unless they stand in slot memories; what an iteration changes, and what the source adds.
    pub fn fields(
        &self,
        s: &Sizes,
        d: &Design,
        (source, loads): (&dyn HeightSource, &[Load<'_>]),
        setup: &Module,
    ) -> Vec<Field> {
        let mut list = Vec::new();
        list.extend(self.search.leaving.is_none().then(|| tag(s)));
        list.extend(said_by(setup, (self.constants)(s, d)));
        list.extend((self.search.state)(s, d));
        list.extend(source.fields(s, loads));
        list
    }
}
