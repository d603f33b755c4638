//! Rays and hits for machines, as they stand in the results.
use crate::golden::{RayHit, RayInput};
use serde::Serialize;
use std::fmt;

/// The words u, v, du, dv of a ray in hex.
pub fn hex_words(r: &RayInput) -> [String; 4] {
    [r.u, r.v, r.du, r.dv].map(|word| format!("{word:x}"))
}

/// Where a ray ends.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct RayEnd {
    /// Texel, along u and v.
    pub texel: (u32, u32),
    /// The word of the parameter in hex.
    pub t: String,
    /// Whether a side wall was hit.
    pub wall: bool,
    /// Whether the ray was given up, or refused.
    pub given_up: bool,
}

impl From<&RayHit> for RayEnd {
    fn from(h: &RayHit) -> Self {
        Self { texel: (h.i, h.j), t: format!("{:x}", h.t), wall: h.wall && !h.limit, given_up: h.limit }
    }
}

impl fmt::Display for RayEnd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let end = match (self.given_up, self.wall) {
            (true, _) => ", given up",
            (false, true) => ", wall",
            (false, false) => "",
        };
        write!(f, "{}, {} at t {}{end}", self.texel.0, self.texel.1, self.t)
    }
}
