//! What loading a map leaves in the memories of `traverse`.
use super::pyramid::Pyramid;

/// The words of one memory, by address.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    /// What they are, in a few words.
    pub about: String,
    /// The words, of as many bits as a height code.
    pub words: Vec<u32>,
}

impl Image {
    /// The pyramid's one memory.
    pub(super) fn of_pyramid(map: &Pyramid) -> Vec<Self> {
        let about = "height pyramid: level 0 first, the root last".to_owned();
        vec![Self { about, words: map.memory().to_vec() }]
    }
}
