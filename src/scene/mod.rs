//! What the rays meet and where they come from: height maps, cameras, ray lists; and pictures of the result.
pub mod border;
mod camera;
mod codes;
mod degrees;
mod font;
pub mod hard;
mod height_map;
mod load;
mod maps;
mod noise;
mod palette;
mod pgm;
mod picture;
mod rays_csv;
mod rocks;
mod shade;

pub use crate::config::{MapKind, View};
pub use camera::{Camera, QUAD_SIDE, ViewRay};
pub use codes::{bordered_codes, to_codes};
pub use height_map::{Depth, HeightMap};
pub use load::{decode, load};
pub use maps::procedural;
pub use picture::Picture;
pub use rays_csv::{RayTable, parse_rays, parse_table, read_rays};
pub use shade::{ShadePoint, Shader};
