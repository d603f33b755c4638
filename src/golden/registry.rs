//! The table of the models, by datapath.
use super::datapath::Datapath;
use super::fixed::Fixed;
use super::image::Image;
use super::published::Published;
use super::pyramid::Pyramid;
use super::record::RayInput;
use super::watertight::Watertight;
use super::windows::Windows;
use reliefrtl_base::error::Result;
use reliefrtl_config::{DatapathKind, Design};

/// A row of the table: the model of a datapath, not yet of a design.
#[derive(Clone, Copy, Debug)]
pub struct Model {
    /// [`Datapath::prepare`].
    pub prepare: fn(&Design) -> Result<Box<dyn Datapath>>,
    /// [`Datapath::encode`].
    pub encode: fn(&Design, [f64; 4]) -> RayInput,
    /// [`Datapath::decode`].
    pub decode: fn(&Design, u64) -> f64,
    /// [`Datapath::images`].
    pub images: fn(&Design, &Pyramid) -> Vec<Image>,
    /// [`Datapath::image_words`].
    pub image_words: fn(&Design) -> usize,
    /// [`Datapath::texel_word`].
    pub texel_word: fn(&Design, u32, u32) -> usize,
}

impl Model {
    const fn of<D: Datapath + 'static>() -> Self {
        Self {
            prepare: boxed::<D>,
            encode: D::encode,
            decode: D::decode,
            images: D::images,
            image_words: D::image_words,
            texel_word: D::texel_word,
        }
    }
}

fn boxed<D: Datapath + 'static>(design: &Design) -> Result<Box<dyn Datapath>> {
    Ok(Box::new(D::prepare(design)?))
}

/// The model of a datapath.
pub fn datapath(kind: DatapathKind) -> Model {
    match kind {
        DatapathKind::Watertight => Model::of::<Watertight>(),
        DatapathKind::Published => Model::of::<Published>(),
        DatapathKind::Fixed => Model::of::<Fixed>(),
        DatapathKind::Windows => Model::of::<Windows>(),
    }
}

/// The model of a design.
///
/// # Errors
/// As [`Datapath::prepare`].
pub fn prepare(design: &Design) -> Result<Box<dyn Datapath>> {
    (datapath(design.datapath.kind).prepare)(design)
}

/// A ray in words of the design: [`Datapath::encode`].
pub fn encode_ray(design: &Design, ray: [f64; 4]) -> RayInput {
    (datapath(design.datapath.kind).encode)(design, ray)
}

/// A ray parameter of the design in height codes: [`Datapath::decode`].
pub fn decode_time(design: &Design, t: u64) -> f64 {
    (datapath(design.datapath.kind).decode)(design, t)
}

/// The memories of a map in the hardware of a design: [`Datapath::images`].
pub fn images(design: &Design, map: &Pyramid) -> Vec<Image> {
    (datapath(design.datapath.kind).images)(design, map)
}
