//! Pinhole cameras above the quad, and the rays through their pixels.
use super::degrees::sin_cos;
use glam::{DVec2, DVec3};
use reliefrtl_base::alike::nearest;
use reliefrtl_base::error::{Error, Result};
use reliefrtl_config::keys::{Key, Legal};
use reliefrtl_config::lines::{self, Lines};
use reliefrtl_config::{Border, View, check, validate};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// Side of the quad in world units: it lies in the plane y = 0, centred at the origin.
pub const QUAD_SIDE: f64 = 200.0;

/// A pinhole camera that looks at the origin from `-distance * f`, with
/// `f = (-sin a cos e, -sin e, cos a cos e)` and `(cos a, 0, sin a)` to its right (e elevation, a azimuth).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Camera {
    /// Angle above the quad's plane in degrees; 0.1 to 90. Below the plane no ray can begin: each enters through the top plane.
    pub elevation: f64,
    /// Direction around the y axis in degrees; -360 to 360.
    pub azimuth: f64,
    /// From the origin, in world units; 1 to 100000.
    pub distance: f64,
    /// Vertical field of view in degrees; 1 to 170.
    pub fov: f64,
    /// Width in pixels; 1 to 8192.
    pub width: u32,
    /// Height in pixels; 1 to 8192.
    pub height: u32,
}

const KEYS: [Key; 6] = [
    Key { path: "elevation", about: "angle above the plane, in degrees", legal: Legal::Real(0.1, 90.0) },
    Key { path: "azimuth", about: "direction around the vertical, in degrees", legal: Legal::Real(-360.0, 360.0) },
    Key { path: "distance", about: "from the quad's centre, in world units", legal: Legal::Real(1.0, 100_000.0) },
    Key { path: "fov", about: "vertical field of view, in degrees", legal: Legal::Real(1.0, 170.0) },
    Key { path: "width", about: "in pixels", legal: Legal::Whole(1, 8192) },
    Key { path: "height", about: "in pixels", legal: Legal::Whole(1, 8192) },
];

impl Default for Camera {
    fn default() -> Self {
        Self::standard(View::Oblique, 1024, 768)
    }
}

/// The ray of one pixel, as the traverse unit takes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewRay {
    /// Column of the pixel, from the left.
    pub px: u32,
    /// Row of the pixel, from the top.
    pub py: u32,
    /// Entry point in tiles, in [0, 1).
    pub u: f64,
    /// Entry point in tiles, in [0, 1).
    pub v: f64,
    /// Tiles travelled along u while the height falls from 1 to 0.
    pub du: f64,
    /// Tiles travelled along v while the height falls from 1 to 0.
    pub dv: f64,
}

impl Camera {
    /// A standard view for pictures of this many pixels.
    pub const fn standard(view: View, width: u32, height: u32) -> Self {
        let (elevation, azimuth, distance) = match view {
            View::Front => (90.0, 36.4, 200.0),
            View::Oblique => (22.0, 36.4, 200.0),
            View::Grazing => (3.0, 100.0, 240.0),
        };
        Self { elevation, azimuth, distance, fov: 45.0, width, height }
    }

    /// Reads a TOML file with the keys `elevation`, `azimuth`, `distance`, `fov`, `width`, `height`; a key that is
    /// missing has the value of the oblique view of 1024 x 768 pixels.
    ///
    /// # Errors
    /// [`Error::File`] if it can't be read, [`Error::Input`] naming every unknown key and every value out of range.
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        Self::from_toml(&lines::read(path)?, &path.display().to_string())
    }

    /// As [`Camera::load`], from text; `name` stands for the file in the sentences.
    ///
    /// # Errors
    /// [`Error::Input`] with all problems.
    pub fn from_toml(text: &str, name: &str) -> Result<Self> {
        let places = Lines::of(text, name)?;
        let table: toml::Table = toml::from_str(text).map_err(|error| lines::syntax(text, name, &error))?;
        let mut problems = Vec::new();
        for (name, value) in &table {
            let place = places.at(name);
            match KEYS.iter().find(|key| key.path == name) {
                Some(key) => problems.extend(problem(key, value).map(|text| format!("{text} ({place})"))),
                None => problems.push(format!("unknown key {name} ({place}): {}", guess(name))),
            }
        }
        validate::report(problems)?;
        toml::from_str(text).map_err(|error| lines::syntax(text, name, &error))
    }

    /// Checks every value.
    ///
    /// # Errors
    /// [`Error::Input`] with all problems.
    pub fn validate(&self) -> Result<()> {
        let table = toml::Table::try_from(self).map_err(|error| Error::input(error.to_string()))?;
        validate::report(KEYS.iter().filter_map(|key| problem(key, table.get(key.path)?)).collect())
    }

    /// Pixels of the picture that `stride` leaves: columns and rows.
    pub const fn picture_size(&self, stride: u32) -> (u32, u32) {
        (self.width.div_ceil(stride), self.height.div_ceil(stride))
    }

    /// The rays through the centres of every `stride`-th pixel that meet the quad, row by row.
    ///
    /// `scale` is the height of a full-height texel in world units; the height field lies below the quad. `repeat` tiles
    /// lie along each side.
    pub fn rays(&self, scale: f64, repeat: u32, stride: u32) -> Vec<ViewRay> {
        let (columns, rows) = self.picture_size(stride);
        let pixels = (0..rows).flat_map(|row| (0..columns).map(move |column| (column * stride, row * stride)));
        pixels.filter_map(|(px, py)| self.ray(px, py, scale, repeat)).collect()
    }

    /// As [`Camera::rays`], in tiles of a design that sees what `border` puts beyond the map's border.
    pub fn bordered_rays(&self, border: Border, scale: f64, repeat: u32, stride: u32) -> Vec<ViewRay> {
        let (columns, rows) = self.picture_size(stride);
        let pixels = (0..rows).flat_map(|row| (0..columns).map(move |column| (column * stride, row * stride)));
        // The map lies in the middle of what continues it.
        let shift = if border == Border::Clamp { 0.25 } else { 0.0 };
        let tiles = super::border::tiles(border, repeat);
        pixels.filter_map(|(px, py)| self.ray_in(px, py, scale, tiles, shift)).collect()
    }

    /// The ray through the centre of one pixel; `None` if it misses the quad.
    pub fn ray(&self, px: u32, py: u32, scale: f64, repeat: u32) -> Option<ViewRay> {
        self.ray_in(px, py, scale, f64::from(repeat), 0.0)
    }

    /// As [`Camera::ray`] where `tiles` tiles lie along each side of the quad, the first of them from `-shift` on.
    fn ray_in(&self, px: u32, py: u32, scale: f64, tiles: f64, shift: f64) -> Option<ViewRay> {
        let (sin_e, cos_e) = sin_cos(self.elevation);
        let (sin_a, cos_a) = sin_cos(self.azimuth);
        let forward = DVec3::new(-sin_a * cos_e, -sin_e, cos_a * cos_e);
        let right = DVec3::new(cos_a, 0.0, sin_a);
        let up = forward.cross(right);
        let (sin_f, cos_f) = sin_cos(self.fov / 2.0);
        let (width, height) = (f64::from(self.width), f64::from(self.height));
        // Half a picture's height spans tan(fov / 2); pixels are square.
        let unit = sin_f / cos_f / height;
        let x = (2.0 * f64::from(px) + 1.0 - width) * unit;
        let y = (height - 2.0 * f64::from(py) - 1.0) * unit;
        let direction = forward + right * x + up * y;
        let eye = -forward * self.distance;
        if direction.y >= 0.0 {
            return None;
        }
        let meet = eye + direction * (eye.y / -direction.y);
        let place = DVec2::new(meet.x / QUAD_SIDE + 0.5, 0.5 - meet.z / QUAD_SIDE);
        if !(0.0..1.0).contains(&place.x) || !(0.0..1.0).contains(&place.y) {
            return None;
        }
        let entry = place * tiles + shift;
        let travel = DVec2::new(direction.x, -direction.z) * (scale * tiles / QUAD_SIDE / -direction.y);
        Some(ViewRay { px, py, u: wrap(entry.x), v: wrap(entry.y), du: travel.x, dv: travel.y })
    }
}

/// What is wrong with a key's value. A camera at or below the plane can be said, and has no rays: they enter through the top plane, at ray
/// parameter 0, and fall.
fn problem(key: &Key, value: &toml::Value) -> Option<String> {
    let number = value.as_float().or_else(|| value.as_integer().map(|n| n as f64));
    match number {
        Some(e) if key.path == "elevation" && (-90.0..=0.0).contains(&e) => Some(format!(
            "elevation = {e} puts the camera {} the quad's plane, where no ray of this unit can begin: a ray enters the height range through its top plane and falls to its bottom, so the camera stands above the plane, at an elevation of 0.1 to 90",
            if e < 0.0 { "below" } else { "into" }
        )),
        _ => check::problem(key, value),
    }
}

/// Into [0, 1); the argument is not negative, so the subtraction is exact and never gives 1.
fn wrap(position: f64) -> f64 {
    position - position.floor()
}

fn guess(name: &str) -> String {
    let known = || KEYS.iter().map(|key| key.path);
    match nearest(name, known()) {
        Some(near) => format!("did you mean {near}?"),
        None => format!("there are {}", known().collect::<Vec<_>>().join(", ")),
    }
}
