//! What the catalogue has of each datapath: the entries that are its own, and how its rays are sampled.
use super::ray_stimulus::sample::RaySample;
use super::ray_stimulus::{fixed, published, watertight, windows};
use super::unit::{UNIT, Unit};
use crate::config::{DatapathKind, Design};
use crate::golden::Datapath;
use rand_chacha::ChaCha8Rng;

/// An entry of the watertight datapath.
pub const WATERTIGHT: Unit = Unit { datapath: Some(DatapathKind::Watertight), ..UNIT };
/// An entry of the published datapath.
pub const PUBLISHED: Unit = Unit { datapath: Some(DatapathKind::Published), ..UNIT };
/// An entry of the fixed-point datapath.
pub const FIXED: Unit = Unit { datapath: Some(DatapathKind::Fixed), ..UNIT };
/// An entry of the search by windows.
pub const WINDOWS: Unit = Unit { datapath: Some(DatapathKind::Windows), ..UNIT };

/// Samples a ray at some iteration; texel indices are words of so many bits.
pub type Sampler = Box<dyn Fn(u32, &mut ChaCha8Rng) -> RaySample>;

/// Samples rays for a design; `None` if it has no datapath.
pub fn sampler(d: &Design) -> Option<Sampler> {
    match d.datapath.kind {
        DatapathKind::Watertight => of(d, watertight::sample),
        DatapathKind::Published => of(d, published::sample),
        DatapathKind::Fixed => of(d, fixed::sample),
        // What a set says comes to no unit from a sampled ray: any that every map has will do.
        DatapathKind::Windows => of(&windows::with_least_set(d), windows::sample),
    }
}

fn of<D: Datapath + 'static>(d: &Design, sample: fn(&D, u32, &mut ChaCha8Rng) -> RaySample) -> Option<Sampler> {
    let model = D::prepare(d).ok()?;
    Some(Box::new(move |idx_w, rng| sample(&model, idx_w, rng)))
}
