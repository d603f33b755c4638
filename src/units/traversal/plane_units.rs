//! What a datapath that compares plane parameters puts into its iteration.
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Module, Sig};
use std::sync::Arc;

/// Two signals, of u or least first.
pub type Pair<'b> = [Sig<'b>; 2];

/// What such a datapath puts into an iteration. The constants of a ray that a unit reads per axis are named by its port and by the word
/// that the ray carries, without `_x` or `_y`.
pub struct PlaneUnits {
    /// The parameter of a plane; the plane comes beside these constants.
    pub plane_time: fn(&Design) -> Arc<Module>,
    /// Constants that `plane_time` reads.
    pub plane_inputs: &'static [(&'static str, &'static str)],
    /// The larger of the ray's parameter and that of a height.
    pub height_test: fn(&Design) -> Arc<Module>,
    /// The texel reached at a parameter, which comes beside these constants.
    pub predicted_hit: fn(&Design) -> Arc<Module>,
    /// Constants that `predicted_hit` reads.
    pub predicted_inputs: &'static [(&'static str, &'static str)],
    /// Where the design trims: the texel reached at the parameter of the other axis' exit plane, which comes beside these constants.
    pub chord_end: fn(&Design) -> Arc<Module>,
    /// Constants that `chord_end` reads.
    pub chord_inputs: &'static [(&'static str, &'static str)],
    /// Whether the ray leaves by the plane of v, given the parameters of both exit planes.
    pub leaves_y: for<'b> fn(&'b Builder, &Design, Pair<'b>) -> Sig<'b>,
    /// Hit or exit.
    pub node_crossing: fn(&Design) -> Arc<Module>,
    /// Where four cells are judged at once: the order of the parameters of a block's planes.
    pub plane_order: fn(&Design) -> Arc<Module>,
    /// Of four cells: a plane's parameter as a height code.
    pub depth_limit: fn(&Design) -> Arc<Module>,
    /// Of four cells: the one that is hit, or the last one.
    pub cell_choice: fn(&Design) -> Arc<Module>,
    /// Hit, descend or cross.
    pub level_decision: fn(&Design) -> Arc<Module>,
}
