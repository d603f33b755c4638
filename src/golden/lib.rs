//! The golden model: what every unit must return, to the bit, computed without any thought of hardware.
//!
//! It implements `docs/datapath.md`, `docs/published.md`, `docs/fixed.md`, `docs/windows.md` and `docs/bilinear.md` on its own: exact integers times a power of two and one rounding, no guard bits,
//! no pipelines. It shares only the format's constants and the configuration with the units it judges.
mod cells;
mod datapath;
pub mod fixed;
pub mod float;
mod height_times;
mod image;
mod level;
mod planes;
mod published;
mod pyramid;
mod record;
mod registry;
mod state;
mod trim;
mod walk;
mod watertight;
mod window_maps;
mod windows;

pub use datapath::Datapath;
pub use image::Image;
pub use level::{Crossing, descend_levels, level_after, level_up, start_level, trim_return};
pub use planes::Setup;
pub use published::{Exit, Published, Route, Travel};
pub use pyramid::{Pyramid, address};
pub use record::{BilinearHit, Chord, Decision, Iteration, Patch, RayHit, RayInput};
pub use registry::{Model, datapath, decode_time, encode_ray, images, prepare};
pub use watertight::bilinear::{self, Refined};
pub use watertight::{Axis, Watertight};
pub use window_maps::{WindowMap, WindowMaps};
pub use windows::{WindowAxis, Windows};
