//! The golden model: what every unit must return, to the bit, computed without any thought of hardware.
//!
//! It implements `docs/datapath.md`, `docs/published.md`, `docs/fixed.md` and `docs/bilinear.md` on its own: exact integers times a power of two and one rounding, no guard bits,
//! no pipelines. It shares only the format's constants and the configuration with the units it judges.
pub mod bilinear;
pub mod fixed;
pub mod float;
mod level;
mod published;
mod pyramid;
mod record;
mod setup;
mod tracer;
mod traverse;
mod trim;
mod walk;

pub use bilinear::Refined;
pub use level::{Crossing, descend_levels, level_up, start_level, trim_return};
pub use published::{Exit, Published, Route, Travel};
pub use pyramid::{Pyramid, address};
pub use record::{BilinearHit, Chord, Decision, Iteration, Patch, RayHit};
pub use setup::{Axis, RayInput, Setup};
pub use tracer::{Tracer, decode_time, decode_travel, encode_ray};
pub use traverse::Watertight;
