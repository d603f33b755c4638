//! From `--view` and `--rays` to named sets of rays: one way for all verbs.
use super::args::SceneArgs;
use crate::config::{Config, View};
use crate::error::{Error, Result};
use crate::project::Scene;
use crate::scene::{Camera, RaySet, RaySource, ViewRay, evenly, read_rays};
use std::path::{Path, PathBuf};

/// A set of rays on a scene.
pub struct Viewed {
    /// The set.
    pub set: RaySet,
    /// Its rays, in tiles of the design.
    pub rays: Vec<ViewRay>,
}

/// Which pixels of a picture are traced.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Pixels {
    /// All.
    All,
    /// Every `view.stride`-th, of pictures of a camera file too: of verbs that measure.
    Some,
    /// Every `view.stride`-th of a standard view, all of a camera file: of verbs that draw.
    Drawn,
}

impl Pixels {
    /// The step from pixel to pixel.
    pub const fn stride(self, c: &Config, set: &RaySet) -> u32 {
        match (self, &set.source) {
            (Self::All, _) | (Self::Drawn, RaySource::Camera(_)) => 1,
            _ => c.view.stride,
        }
    }
}

/// The sets that `--view` and `--rays` name, in this order; `usual` where they name none. `lod`: a table has a level of detail a ray.
///
/// # Errors
/// A word that is no view and no camera file, a file that can't be read, or two sets of one name.
pub fn sets(a: &SceneArgs, usual: &[View], lod: bool) -> Result<Vec<RaySet>> {
    let mut sets: Vec<RaySet> = Vec::new();
    for text in &a.view {
        // A camera file may have a comma in its name.
        let whole = text.ends_with(".toml") && Path::new(text).exists();
        let words = if whole { vec![text.as_str()] } else { text.split(',').map(str::trim).collect() };
        for word in words {
            let set = named(word)?;
            if !sets.contains(&set) {
                sets.push(set);
            }
        }
    }
    if let Some(file) = a.table() {
        sets.push(RaySet {
            name: stem(file),
            given: file.display().to_string(),
            source: RaySource::Table(read_rays(file, lod)?),
        });
    }
    if sets.is_empty() {
        sets = usual.iter().map(|view| RaySet::view(*view)).collect();
    }
    for (k, set) in sets.iter().enumerate() {
        if sets[..k].iter().any(|before| before.name == set.name) {
            return Err(Error::input(format!(
                "two of the views and rays are named {}: give their files different names",
                set.name
            )));
        }
    }
    Ok(sets)
}

/// A view by its name, or a camera by its file.
fn named(word: &str) -> Result<RaySet> {
    if let Ok(view) = word.parse::<View>() {
        return Ok(RaySet::view(view));
    }
    if !word.ends_with(".toml") {
        let views = View::WORDS.join(", ");
        return Err(Error::input(format!(
            "--view {} is none of {views}, nor a camera file ending in .toml",
            if word.is_empty() { "(nothing)" } else { word }
        )));
    }
    let source = RaySource::Camera(Camera::load(word)?);
    Ok(RaySet { name: stem(Path::new(word)), given: word.to_owned(), source })
}

/// A file's name without its ending; with it, where the rest is the name of a standard view.
fn stem(file: &Path) -> String {
    let stem = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    match stem.parse::<View>() {
        Ok(_) => file.file_name().unwrap_or_default().to_string_lossy().into_owned(),
        Err(_) => stem,
    }
}

/// The files that the options name, which no output may replace.
pub fn inputs(a: &SceneArgs) -> Vec<PathBuf> {
    let words = a.view.iter().flat_map(|text| [text.as_str()].into_iter().chain(text.split(',').map(str::trim)));
    words.map(PathBuf::from).chain(a.table().cloned()).chain(a.map.map.clone()).collect()
}

/// The sets of [`sets`] on a scene, `most` rays of each view, evenly over its picture.
///
/// # Errors
/// As [`sets`]; rays with a level of detail; a set without any ray.
pub fn look(
    c: &Config,
    a: &SceneArgs,
    scene: &Scene,
    usual: &[View],
    pixels: Pixels,
    most: Option<usize>,
) -> Result<Vec<Viewed>> {
    sets(a, usual, false)?.into_iter().map(|set| viewed(c, scene, set, pixels, most)).collect()
}

fn viewed(c: &Config, scene: &Scene, set: RaySet, pixels: Pixels, most: Option<usize>) -> Result<Viewed> {
    block_rays(&set)?;
    if most == Some(0) {
        return Err(none_asked());
    }
    let rays = scene.set(c, &set, pixels.stride(c, &set))?;
    let rays = if set.camera(1, 1).is_some() { evenly(&rays, most) } else { rays };
    if rays.is_empty() {
        return Err(no_ray(&set.given));
    }
    Ok(Viewed { set, rays })
}

/// Refuses levels of detail: a judgement compares with the texels.
///
/// # Errors
/// One sentence.
pub fn block_rays(set: &RaySet) -> Result<()> {
    match &set.source {
        RaySource::Table(table) if table.lods.iter().flatten().any(|lod| *lod > 0) => Err(Error::input(format!(
            "{} has levels of detail (column lod): only `trace` takes them, for hits are judged by the texels of level 0",
            set.given
        ))),
        _ => Ok(()),
    }
}

/// A count of no rays.
pub fn none_asked() -> Error {
    Error::NothingRan("--rays 0 asks for no ray: at least one is needed".into())
}

/// A set without rays.
pub fn no_ray(name: &str) -> Error {
    Error::NothingRan(format!("no ray of {name} meets the map"))
}
