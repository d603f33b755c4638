//! Named sets of rays: those of a standard view, of a camera file, or of a table.
use super::border::enter_border;
use super::{Camera, RayTable, View, ViewRay};
use reliefrtl_base::error::{Error, Result};
use reliefrtl_config::Border;

/// Rays with a name.
#[derive(Clone, Debug, PartialEq)]
pub struct RaySet {
    /// What tables and pages call it: the view, or the file's name without its ending.
    pub name: String,
    /// As it was typed: the view, or the path of the file.
    pub given: String,
    /// Where the rays come from.
    pub source: RaySource,
}

/// Where rays come from.
#[derive(Clone, Debug, PartialEq)]
pub enum RaySource {
    /// A standard view, in pictures of the configured size.
    View(View),
    /// A camera file, in pictures of its own size.
    Camera(Camera),
    /// A table of rays, in tiles of the map.
    Table(RayTable),
}

impl RaySet {
    /// A standard view.
    pub fn view(view: View) -> Self {
        Self { name: view.word().to_owned(), given: view.word().to_owned(), source: RaySource::View(view) }
    }

    /// The camera, of a standard view for pictures of `width` x `height` pixels; `None` of a table.
    pub const fn camera(&self, width: u32, height: u32) -> Option<Camera> {
        match &self.source {
            RaySource::View(view) => Some(Camera::standard(*view, width, height)),
            RaySource::Camera(camera) => Some(*camera),
            RaySource::Table(_) => None,
        }
    }

    /// The rays, in tiles of a design that sees what `border` puts beyond the map's border: of a camera every `stride`-th pixel's (as
    /// [`Camera::bordered_rays`], `quad` being scale and repeat, `size` the pixels of a standard view), of a table all, with their entry
    /// points wrapped into \[0, 1), the k-th for pixel (k, 0).
    ///
    /// # Errors
    /// A table's ray that enters outside of what `border` prepares.
    pub fn rays(&self, border: Border, quad: (f64, u32), size: (u32, u32), stride: u32) -> Result<Vec<ViewRay>> {
        let table = match &self.source {
            RaySource::View(view) => {
                return Ok(Camera::standard(*view, size.0, size.1).bordered_rays(border, quad.0, quad.1, stride));
            }
            RaySource::Camera(camera) => return Ok(camera.bordered_rays(border, quad.0, quad.1, stride)),
            RaySource::Table(table) => table,
        };
        let inside = enter_border(border, &table.rays).map_err(|e| Error::input(format!("{}: {e}", self.given)))?;
        let wrap = |x: f64| match x.rem_euclid(1.0) {
            // Of a tiny negative number the remainder rounds to the whole tile.
            1.0 => 0.0,
            inside => inside,
        };
        let ray =
            |(k, [u, v, du, dv]): (usize, [f64; 4])| ViewRay { px: k as u32, py: 0, u: wrap(u), v: wrap(v), du, dv };
        Ok(inside.into_iter().enumerate().map(ray).collect())
    }

    /// The standard view, if it is one.
    pub const fn standard(&self) -> Option<View> {
        match self.source {
            RaySource::View(view) => Some(view),
            RaySource::Camera(_) | RaySource::Table(_) => None,
        }
    }
}

/// `most` of `rays`, evenly over the picture; all where there are no more.
pub fn evenly<T: Copy>(rays: &[T], most: Option<usize>) -> Vec<T> {
    let n = most.unwrap_or(usize::MAX).min(rays.len());
    (0..n).map(|k| rays[k * rays.len() / n]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_wrap_and_pick() {
        let table = RayTable { rays: vec![[-0.25, 1.5, 1.0, -2.0], [-1e-30, 0.5, 0.0, 0.0]], lods: None };
        let set = RaySet { name: "r".into(), given: "r.csv".into(), source: RaySource::Table(table) };
        let rays = |border| set.rays(border, (20.0, 1), (64, 48), 1).unwrap();
        let first = rays(Border::Wrap)[0];
        assert_eq!((first.u, first.v, first.du, first.dv), (0.75, 0.5, 1.0, -2.0));
        assert_eq!((rays(Border::Wrap)[1].u, rays(Border::Wrap)[1].px), (0.0, 1));
        assert_eq!(rays(Border::Mirror)[0].v, 0.75);
        assert!(
            set.rays(Border::Clamp, (20.0, 1), (64, 48), 1).unwrap_err().to_string().contains("r.csv: ray 0 enters")
        );
        assert_eq!(evenly(&[0, 1, 2, 3, 4, 5, 6, 7], Some(3)), [0, 2, 5]);
        assert_eq!(evenly(&[0, 1], None), [0, 1]);
    }
}
