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
    /// Counts them; `refused` are those of [`crate::trace::refused`].
    pub fn of(hits: &[RayHit], refused: &[bool]) -> Self {
        let lost = hits.iter().filter(|h| h.limit).count();
        let refused = refused.iter().filter(|r| **r).count();
        Self { refused, given_up: lost - refused, beyond: 0 }
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

/// Takes their hits from `rays` (u, v, du, dv, in tiles of the design) that went on beyond what `map.border` prepares; returns how many these are, and marks them
/// among the `refused`.
pub fn without_border_hits(c: &Config, rays: &[[f64; 4]], hits: &mut [RayHit], refused: &mut [bool]) -> usize {
    let d = c.design();
    let mut beyond = 0;
    for ((hit, refused), ray) in hits.iter_mut().zip(refused).zip(rays) {
        if !hit.limit && !saw_border(&d, c.map.border, ray, hit) {
            *hit = RayHit { limit: true, ..RayHit::default() };
            *refused = true;
            beyond += 1;
        }
    }
    beyond
}
