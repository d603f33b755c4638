//! Rays without a hit, in words.
use crate::config::Config;
use crate::project::Lost;

/// A line for each reason that `of` rays have no hit.
pub fn print(lost: &Lost, c: &Config, of: usize) {
    if lost.beyond > 0 {
        println!(
            "{} of {of} go on more than half a side beyond the map's border, where map.border = \"clamp\" ends: they have no hit",
            lost.beyond
        );
    }
    if lost.refused > lost.beyond {
        println!(
            "{} of {of} can't be traced by this design: in its number format they travel 2^tile_bits = {} tiles of the design or more",
            lost.refused - lost.beyond,
            1u32 << c.traverse.tile_bits
        );
    }
    if lost.given_up > 0 {
        println!("{} of {of} were given up after {} iterations", lost.given_up, c.traverse.step_limit);
    }
}
