//! The colour of a hit: height, light, shadow and the darkness of hollows.
use super::camera::QUAD_SIDE;
use super::noise::fractal;
use super::palette::{Colour, by_height, mottle_of, of_map};
use glam::DVec3;
use reliefrtl_config::MapKind;

/// Where a ray met the height field; from any engine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShadePoint {
    /// Place along u in tiles, in [0, 1).
    pub u: f64,
    /// Place along v in tiles, in [0, 1).
    pub v: f64,
    /// Ray parameter: 0 at the top plane, 1 at height 0. (The datapath's t divided by 2^height_bits - 1.)
    pub t: f64,
    /// Whether it met the side of a texel and not its top.
    pub wall: bool,
}

/// Shades hits on one map. The surface is lit as the smooth one through the texels' centres, so that the steps between
/// texels are visible in outline, not as facets.
#[derive(Clone, Debug)]
pub struct Shader<'a> {
    codes: &'a [u32],
    side: i64,
    max: f64,
    /// World height of a full-height texel, in texels.
    steepness: f64,
    stops: &'static [Colour],
    /// How much lighter and darker the matter is from place to place.
    mottle: f64,
}

/// Towards the light, in (u, v, up).
const LIGHT: DVec3 = DVec3::new(-0.66, 0.34, 0.67);
/// Eight directions around a place, for the hollows; the diagonals have length 1 within a thousandth.
const AROUND: [(f64, f64); 8] = [
    (1.0, 0.0),
    (0.707, 0.707),
    (0.0, 1.0),
    (-0.707, 0.707),
    (-1.0, 0.0),
    (-0.707, -0.707),
    (0.0, -1.0),
    (0.707, -0.707),
];

impl<'a> Shader<'a> {
    /// For `4^levels` codes of `height_bits` bits, row by row; `scale` in world units;
    /// `tiles` of them lie along each side of the quad.
    /// `kind` chooses the colours only.
    ///
    /// # Panics
    /// If the number of codes is another.
    pub fn new(codes: &'a [u32], levels: u32, height_bits: u32, scale: f64, tiles: f64, kind: MapKind) -> Self {
        assert_eq!(codes.len(), 1 << (2 * levels), "one code a texel");
        let side = 1i64 << levels;
        let texel = QUAD_SIDE / (tiles * side as f64);
        let max = f64::from((1u32 << height_bits) - 1);
        Self { codes, side, max, steepness: scale / texel, stops: of_map(kind), mottle: mottle_of(kind) }
    }

    /// The colour of a hit, sRGB-like bytes.
    pub fn colour(&self, point: &ShadePoint) -> [u8; 3] {
        super::palette::bytes(self.linear(point))
    }

    pub(super) fn linear(&self, point: &ShadePoint) -> Colour {
        let (x, y) = (point.u * self.side as f64 - 0.5, point.v * self.side as f64 - 0.5);
        let height = 1.0 - point.t.clamp(0.0, 1.0);
        let light = LIGHT.normalize();
        // Fine maps would be lit texel by texel; a wider stencil keeps the picture calm.
        let reach = (self.side as f64 / 512.0).max(0.75);
        let slope_x = (self.smooth(x + reach, y) - self.smooth(x - reach, y)) * self.steepness / (2.0 * reach);
        let slope_y = (self.smooth(x, y + reach) - self.smooth(x, y - reach)) * self.steepness / (2.0 * reach);
        let normal = DVec3::new(-slope_x, -slope_y, 1.0).normalize();
        // A point of a side wall lies under the smooth surface, which would shadow it; seen from just outside it does not.
        let steep = (slope_x * slope_x + slope_y * slope_y).sqrt();
        let away = if point.wall && steep > 0.0 { 0.6 / steep } else { 0.0 };
        let (x, y) = (x - slope_x * away, y - slope_y * away);
        let above = height.max(self.smooth(x, y));
        let sun = normal.dot(light).max(0.0) * self.sunlit(x, y, above, light);
        let open = self.open(x, y, above);
        // Sky from above, and a little light back from the ground.
        let sky = (0.62 + 0.38 * normal.z) * open;
        let mottle = 1.0 + self.mottle * fractal(3, point.u, point.v, 9, 5);
        let base = by_height(self.stops, height).map(|channel| channel * mottle);
        // A side wall is the same matter, less exposed.
        let tone = if point.wall { [0.84, 0.81, 0.80] } else { [1.0; 3] };
        let (sun_colour, sky_colour) = ([2.05, 1.88, 1.62], [0.36, 0.43, 0.54]);
        std::array::from_fn(|c| {
            let lit = base[c] * tone[c] * (sun * sun_colour[c] + sky * sky_colour[c]);
            // Bright places bend towards white instead of being cut.
            lit * (1.0 + lit * 0.18) / (1.0 + lit) * 1.18
        })
    }

    /// 1 in the sun, 0 in full shadow, with a soft edge.
    fn sunlit(&self, x: f64, y: f64, height: f64, light: DVec3) -> f64 {
        let ground = (light.x * light.x + light.y * light.y).sqrt();
        let (dx, dy, rise) = (light.x / ground, light.y / ground, light.z / ground);
        let mut lit: f64 = 1.0;
        let mut far = 1.5;
        while lit > 0.0 {
            let ray = height * self.steepness + far * rise;
            if ray > self.steepness {
                break;
            }
            let above = self.smooth(x + dx * far, y + dy * far) * self.steepness - ray;
            lit = lit.min(1.0 - (above + 0.25) / (0.35 + 0.10 * far));
            // Far obstacles throw soft shadows; they may be looked for in longer steps.
            far += 0.75 + 0.04 * far;
        }
        lit.clamp(0.0, 1.0)
    }

    /// How much of the sky is free: 1 on a plain, less in a hollow.
    fn open(&self, x: f64, y: f64, height: f64) -> f64 {
        let unit = self.side as f64 / 256.0;
        let mut sum = 0.0;
        for (dx, dy) in AROUND {
            let mut horizon: f64 = 0.0;
            for far in [1.5, 3.0, 6.0, 11.0, 18.0] {
                let far = f64::max(far * unit, 1.0);
                let above = (self.smooth(x + dx * far, y + dy * far) - height) * self.steepness;
                let slope = above / far;
                // The sine of the angle under which the horizon stands.
                horizon = horizon.max(slope / (1.0 + slope * slope).sqrt());
            }
            sum += 1.0 - horizon;
        }
        let mean = sum / AROUND.len() as f64;
        mean * mean
    }

    /// Height at a place in texels (whole numbers at texel centres), bilinear, in [0, 1].
    fn smooth(&self, x: f64, y: f64) -> f64 {
        let (i, j) = (x.floor(), y.floor());
        let (fx, fy) = (x - i, y - j);
        let mask = self.side - 1;
        let texel = |di: i64, dj: i64| {
            let (i, j) = ((i as i64 + di) & mask, (j as i64 + dj) & mask);
            f64::from(self.codes[(j * self.side + i) as usize])
        };
        let top = texel(0, 0) * (1.0 - fx) + texel(1, 0) * fx;
        let bottom = texel(0, 1) * (1.0 - fx) + texel(1, 1) * fx;
        (top * (1.0 - fy) + bottom * fy) / self.max
    }
}
