//! The traversal's units, one file each, and `traverse` on top. Units of one datapath stand in a folder of its name.
mod datapath;
pub mod fixed;
mod height_address;
mod height_memory;
mod level_decision;
mod level_up;
mod loop_state;
mod multi_level_down;
mod node_planes;
mod params;
mod plane_iteration;
mod start_level;
mod stream_delay;
mod traverse;
pub mod watertight;

pub use datapath::Datapath;
pub use height_address::height_address;
pub use height_memory::{height_memory, pyramid_words};
pub use level_decision::level_decision;
pub use level_up::level_up;
pub use multi_level_down::multi_level_down;
pub use node_planes::node_planes;
pub use start_level::start_level;
pub use stream_delay::stream_delay;
pub use traverse::{Traverse, traverse};
