//! Rays without a hit.
use crate::config::Config;
use crate::error::{Error, Result};
use crate::golden::RayHit;
use crate::trace::saw_border;
use serde::Serialize;

/// How many rays have no hit, and why.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Lost {
    /// Not rays of this design: they travel too far.
    pub refused: usize,
    /// Of those refused: went on after what was prepared beyond the map's border.
    pub beyond: usize,
    /// Ended by the step limit.
    pub given_up: usize,
}

impl Lost {
    /// Counts them.
    pub fn of(hits: &[RayHit]) -> Self {
        let count = |started: bool| hits.iter().filter(|h| h.limit && (h.steps > 0) == started).count();
        Self { refused: count(false), given_up: count(true), beyond: 0 }
    }

    /// An error if there was no hit at all.
    ///
    /// # Errors
    /// [`Error::NothingRan`].
    pub fn verdict(&self, of: usize) -> Result<()> {
        if self.refused + self.given_up < of {
            return Ok(());
        }
        Err(Error::NothingRan(format!("none of {of} rays has a hit")))
    }
}

/// Takes their hits from `rays` (u, v, du, dv, in tiles of the design) that went on beyond what `map.border` prepares; returns how many these are.
pub fn without_border_hits(c: &Config, rays: &[[f64; 4]], hits: &mut [RayHit]) -> usize {
    let d = c.design();
    let mut beyond = 0;
    for (hit, ray) in hits.iter_mut().zip(rays) {
        if !hit.limit && !saw_border(&d, c.map.border, ray, hit) {
            *hit = RayHit { limit: true, ..RayHit::default() };
            beyond += 1;
        }
    }
    beyond
}
