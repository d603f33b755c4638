//! What stands in the loop of `traverse`: floating-point units and stages, beside PIDM-HW table 1 and figure 7.
use super::bilinear;
use super::datapath::Datapath;
use super::traverse::Traverse;
use crate::float::names;
use reliefrtl_config::Design;
use reliefrtl_ir::Module;
use std::sync::Arc;

/// Floating-point units in the loop, and its stages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LoopResources {
    /// `fp_add`: adders of two inputs.
    pub adders: u32,
    /// `fp_lt`.
    pub comparators: u32,
    /// `fp_mul`.
    pub multipliers: u32,
    /// `fp_div`.
    pub dividers: u32,
    /// Slots of the loop.
    pub stages: u32,
}

/// The traverse unit of PIDM-HW: table 1, and the 15 stages of figure 7.
pub const PUBLISHED: LoopResources =
    LoopResources { adders: 6, comparators: 7, multipliers: 5, dividers: 2, stages: 15 };

impl LoopResources {
    /// Rows of a table: what, and how many.
    pub const fn rows(&self) -> [(&'static str, u32); 5] {
        [
            ("adders", self.adders),
            ("comparators", self.comparators),
            ("multipliers", self.multipliers),
            ("dividers", self.dividers),
            ("stages", self.stages),
        ]
    }
}

/// Counts what stands in the loop of `t`: all of it but setup, the position of the hit, and its refinement.
pub fn loop_resources(d: &Design, t: &Traverse) -> LoopResources {
    let path = Datapath::of(d);
    let outside = [(path.setup)(d).name.clone(), (path.hit)(d).name.clone(), bilinear::NAME.to_string()];
    let inside = t.module.insts.iter().map(|i| &i.module).filter(|m| !outside.contains(&m.name));
    let inside: Vec<&Arc<Module>> = inside.collect();
    let of = |name: &str| inside.iter().map(|m| count(m, name)).sum();
    LoopResources {
        adders: of(names::ADD),
        comparators: of(names::LT),
        multipliers: of(names::MUL),
        dividers: of(names::DIV),
        stages: t.slots,
    }
}

/// Instances of `name` in `m`, itself included.
fn count(m: &Module, name: &str) -> u32 {
    u32::from(m.name == name) + m.insts.iter().map(|i| count(&i.module, name)).sum::<u32>()
}
