//! The constants of a fixed-point design, and what its sizes may be.
use crate::cells;
use reliefrtl_base::error::{Error, Result};
use reliefrtl_config::Design;

/// Bits that the ray parameter has beyond FRACTION_W: it counts in 2^-(FRACTION_W + GUARD - HEIGHT_W) height codes.
pub(super) const GUARD: u32 = 2;

/// G: fraction bits of the ray parameter, which counts height codes.
///
/// Legal designs have height_bits <= fraction_bits, so it is at least [`GUARD`].
pub(super) fn time_fraction(d: &Design) -> u32 {
    d.datapath.fraction_bits + GUARD - d.traverse.height_bits
}

/// What is wrong with the sizes of a fixed-point design; `None` if nothing is.
fn illegal(d: &Design) -> Option<&'static str> {
    let (t, f, w) = (&d.traverse, d.datapath.fraction_bits, d.datapath.reciprocal_bits);
    let rules = [
        ((2..=12).contains(&t.levels), "levels are 2 to 12"),
        ((2..=16).contains(&t.height_bits), "height_bits are 2 to 16"),
        ((1..=8).contains(&t.tile_bits), "tile_bits are 1 to 8"),
        ((1..=16).contains(&t.frac_bits), "frac_bits are 1 to 16"),
        ((8..=28).contains(&f), "fraction_bits are 8 to 28"),
        ((8..=32).contains(&w), "reciprocal_bits are 8 to 32"),
        (t.idx_bits() <= 24, "levels + tile_bits + 2 is at most 24"),
        (t.levels <= f, "levels are at most fraction_bits"),
        (t.height_bits <= f, "height_bits are at most fraction_bits"),
        (f + t.tile_bits <= 32, "fraction_bits + tile_bits is at most 32"),
        (f + t.tile_bits + w <= 63, "fraction_bits + tile_bits + reciprocal_bits is at most 63"),
        ((1..=4).contains(&d.mode.levels_down), "levels_down are 1 to 4"),
        (cells::legal(d), "four cells have other modes (`docs/cells.md`)"),
        ((1..=65535).contains(&t.step_limit), "step_limit is 1 to 65535"),
        (!d.mode.bilinear, "mode.bilinear needs the watertight datapath"),
    ];
    rules.iter().find(|r| !r.0).map(|r| r.1)
}

/// The fixed-point model of one design, with the design's constants at hand.
#[derive(Clone, Debug)]
pub struct Fixed {
    pub(crate) design: Design,
    /// FRACTION_W: fraction bits of positions, in tiles.
    pub(super) fraction: u32,
    /// RECIP_W: significant bits of the reciprocal.
    pub(super) reciprocal: u32,
    /// FRACTION_W + TILE_W: bits of a travel's magnitude.
    pub(super) reach: u32,
    /// M = 2^HEIGHT_W - 1: the ray parameter at the bottom plane.
    pub(super) bottom: u64,
    /// G: fraction bits of the ray parameter.
    pub(super) time_fraction: u32,
    /// The largest ray parameter; no height is met there.
    pub(crate) never: u64,
}

impl Fixed {
    /// The model of `design`.
    ///
    /// # Errors
    /// [`Error::Input`] if the sizes are outside of the ranges of `docs/fixed.md`.
    pub(super) fn new(design: &Design) -> Result<Self> {
        if let Some(rule) = illegal(design) {
            return Err(Error::input(format!("no fixed-point datapath of these sizes: {rule} (`docs/fixed.md`)")));
        }
        let (t, path) = (&design.traverse, &design.datapath);
        Ok(Self {
            design: *design,
            fraction: path.fraction_bits,
            reciprocal: path.reciprocal_bits,
            reach: path.fraction_bits + t.tile_bits,
            bottom: (1 << t.height_bits) - 1,
            time_fraction: time_fraction(design),
            never: (1 << (path.fraction_bits + GUARD)) - 1,
        })
    }
}
