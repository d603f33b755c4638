//! Exact numbers as f64, for figures: what is compared stays exact.
use super::exact::Dyadic;
use super::walk::{ExactHit, ExactRay};

impl Dyadic {
    /// The value as an f64: exact for up to 53 significant bits.
    pub fn to_f64(&self) -> f64 {
        let value = self.sig as f64 * 2f64.powi(self.exp);
        if self.negative { -value } else { value }
    }
}

impl ExactRay {
    /// Where the ray is when the exact hit happens, in tiles, unwrapped; `bottom` is M, the parameter of the bottom plane.
    pub fn place(&self, hit: &ExactHit, bottom: f64) -> [f64; 2] {
        let at = hit.t_f64 / bottom;
        [0, 1].map(|axis| self.p[axis].to_f64() + self.d[axis].to_f64() * at)
    }
}
