//! The address of a ray's node.
use super::height_address::height_address;
use super::loop_state::{Ray, Sizes};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Sig};

/// Where the node of `level` that holds the ray's texel stands in the pyramid (2 * LEVELS + 1 bits, words), by an instance of that name.
pub fn node_address<'b>(
    b: &'b Builder,
    s: &Sizes,
    d: &Design,
    instance: &str,
    ray: &Ray<'b>,
    level: Sig<'b>,
) -> Sig<'b> {
    let texel = |axis: &str| level.stage().map_or(ray.get(axis), |k| ray.get(axis).at(k)).slice(0, &s.levels).id();
    let (i, j) = (b.sig(texel("x")), b.sig(texel("y")));
    b.inst(&height_address(&d.traverse), instance, &[], &[("level", level), ("i", i), ("j", j)]).only()
}
