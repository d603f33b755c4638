//! The constants of a published design.
use crate::float;
use crate::height_times::height_times;
use reliefrtl_base::error::{Error, Result};
use reliefrtl_config::{Design, Trim};
use std::sync::Arc;

/// The published model of one design, with the design's constants at hand.
#[derive(Clone, Debug)]
pub struct Published {
    pub(super) design: Design,
    /// IDX_W.
    pub(super) idx_w: u32,
    /// 1, encoded: the ray parameter at the bottom plane.
    pub(super) one: u64,
    /// Encoded parameter at which a ray meets a node of maximum height code H, by H: (M - H) * (1 / M).
    pub(super) tops: Arc<[u64]>,
}

impl Published {
    /// The model of `design`.
    ///
    /// # Errors
    /// [`Error::Input`] if the sizes are outside of the ranges of `docs/published.md`.
    pub(super) fn new(design: &Design) -> Result<Self> {
        let mode = &design.mode;
        if mode.trim != Trim::None || mode.lod || mode.bilinear {
            return Err(Error::input(
                "mode.trim, mode.lod and mode.bilinear need a datapath that compares parameters of planes: the published one has none of them",
            ));
        }
        let (fmt, size, nudge) = (design.format, design.traverse, design.datapath.nudge_bits);
        let bias = u32::try_from(fmt.bias()).unwrap_or(0);
        let (n, h, tile) = (size.levels, size.height_bits, size.tile_bits);
        let legal = (2..=11).contains(&fmt.exp)
            && (7..=52).contains(&fmt.man)
            && (2..=12).contains(&n)
            && (2..=16).contains(&h)
            && h <= fmt.man + 1
            && (1..=8).contains(&tile)
            && size.idx_bits() <= 24
            && nudge <= 16
            // The nudged plane is converted in one word.
            && size.idx_bits() + nudge + fmt.man <= 60
            // The plane after the farthest texel is a finite number, and so is the parameter of a height code.
            && n + tile < bias
            && h + 2 <= bias
            && (1..=16).contains(&size.frac_bits)
            && (1..=4).contains(&design.mode.levels_down)
            && (1..=65535).contains(&size.step_limit);
        if !legal {
            return Err(Error::input(format!(
                "no published datapath of {n} levels, {h} height bits, {tile} tile bits, {nudge} nudge bits and format {fmt}: see docs/published.md, Parameters"
            )));
        }
        let m = (1u64 << h) - 1;
        let inv = float::recip_int(fmt, m);
        let top = |height: u64| float::mul(fmt, float::from_int(fmt, (m - height) as i64), inv);
        let one = float::from_int(fmt, 1);
        Ok(Self { design: *design, idx_w: size.idx_bits(), one, tops: height_times(("published", fmt, h), top) })
    }

    /// Ray parameter where a node of maximum height code `height` is met.
    pub fn height_time(&self, height: u32) -> u64 {
        self.tops[height as usize]
    }
}
