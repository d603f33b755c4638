//! The constants of a watertight design.
use crate::cells;
use crate::float::{self, power_of_two};
use crate::height_times::height_times;
use reliefrtl_base::error::{Error, Result};
use reliefrtl_config::{Design, Trim};
use std::sync::Arc;

/// The watertight model of one design, with the design's constants at hand.
#[derive(Clone, Debug)]
pub struct Watertight {
    pub(super) design: Design,
    /// IDX_W.
    pub(super) idx_w: u32,
    /// 1, encoded.
    pub(super) one: u64,
    /// 2^TILE_W, encoded: what a ray's travel stays below.
    pub(super) travel_end: u64,
    /// 2^n, encoded.
    pub(super) texels_per_tile: u64,
    /// M = 2^HEIGHT_W - 1, encoded: the ray parameter at the bottom plane.
    pub(super) bottom: u64,
    /// C = 1 / M, encoded.
    pub(super) inv_bottom: u64,
    /// Encoded parameter at which a ray meets a node of maximum height code H, by H.
    pub(super) tops: Arc<[u64]>,
}

impl Watertight {
    /// The model of `design`.
    ///
    /// # Errors
    /// [`Error::Input`] if the sizes are outside of the ranges of `docs/datapath.md`.
    pub(super) fn new(design: &Design) -> Result<Self> {
        let (fmt, size) = (design.format, design.traverse);
        let bias = u32::try_from(fmt.bias()).unwrap_or(0);
        let (n, h, tile) = (size.levels, size.height_bits, size.tile_bits);
        let legal = (2..=11).contains(&fmt.exp)
            && (7..=52).contains(&fmt.man)
            && (2..=12).contains(&n)
            && (2..=16).contains(&h)
            && h <= fmt.man + 1
            && (1..=8).contains(&tile)
            && size.idx_bits() <= 24
            // The plane after the farthest texel is a finite number.
            && n + tile < bias
            && h + 2 <= bias
            // The position estimate is biased by 2^(n + 1 - man) at least, which must stand clear of underflow.
            && fmt.man <= bias + n
            && (1..=16).contains(&size.frac_bits)
            && (1..=4).contains(&design.mode.levels_down)
            && cells::legal(design)
            && (1..=65535).contains(&size.step_limit)
            // A chord's end is estimated forward by more than all errors, what underflows included.
            && (design.mode.trim == Trim::None || fmt.man + 4 <= bias)
            // A refined hit stands on the finest level, and the surface's depth is exact before it is rounded.
            && (!design.mode.bilinear || !design.mode.lod && h + 2 * size.frac_bits + fmt.man <= 60);
        if !legal {
            return Err(Error::input(format!(
                "no datapath of {n} levels, {h} height bits, {tile} tile bits and format {fmt}: see docs/datapath.md, Parameters"
            )));
        }
        let m = (1u64 << h) - 1;
        Ok(Self {
            design: *design,
            idx_w: size.idx_bits(),
            one: power_of_two(fmt, 0),
            travel_end: power_of_two(fmt, tile as i32),
            texels_per_tile: power_of_two(fmt, n as i32),
            bottom: float::from_int(fmt, m as i64),
            inv_bottom: float::recip_int(fmt, m),
            tops: height_times(("watertight", fmt, h), |height| float::from_int(fmt, (m - height) as i64)),
        })
    }
}
