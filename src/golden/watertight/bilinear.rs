//! The bilinear refinement of a block hit (`docs/bilinear.md`; PDM section 3.3): one secant step between half a texel before and half a
//! texel after the hit.
//!
//! Each part stands alone, at any format, so that the unit that computes it can be held to it.
use super::model::Watertight;
use super::setup::Axis;
use crate::float::{self, Value};
use crate::planes::Setup;
use crate::pyramid::Pyramid;
use crate::record::{BilinearHit, Patch, RayHit, RayInput};
use reliefrtl_base::format::FloatFormat;

/// A refined hit. Where the surface was not hit, texel, fractions and parameter are those of the block hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Refined {
    /// What was found.
    pub patch: Patch,
    /// Texel along u, wrapped.
    pub i: u32,
    /// Texel along v, wrapped.
    pub j: u32,
    /// Position in the texel along u, in 2^-FRAC_W texels.
    pub fu: u32,
    /// Position in the texel along v, in 2^-FRAC_W texels.
    pub fv: u32,
    /// Ray parameter, encoded.
    pub t: u64,
    /// The window's ends: encoded parameters half a texel before and after the block hit.
    pub window: [u64; 2],
    /// The ray's height over the surface at both ends, in height codes, encoded.
    pub gaps: [u64; 2],
}

impl Refined {
    /// What leaves the unit.
    pub fn hit(&self) -> BilinearHit {
        BilinearHit { patch: self.patch, i: self.i, j: self.j, fu: self.fu, fv: self.fv, t: self.t }
    }
}

impl Watertight {
    /// Refines the hit of `ray`; `None` of a ray that was given up, and of a design whose hits may be nodes of coarser levels.
    ///
    /// # Panics
    /// If the pyramid has other levels or height bits than the design.
    pub fn refine(&self, pyramid: &Pyramid, ray: &RayInput, hit: &RayHit) -> Option<Refined> {
        let size = &self.design.traverse;
        assert_eq!((pyramid.levels(), pyramid.height_bits()), (size.levels, size.height_bits), "wrong pyramid");
        let setup = self.setup(ray);
        if hit.limit || !setup.valid || self.design.mode.lod {
            return None;
        }
        let fmt = self.design.format;
        let window = window(fmt, self.bottom, [setup.u.r, setup.v.r], hit.t);
        let gaps = window.map(|t| self.gap(pyramid, &setup, t));
        let patch = patch(fmt, gaps);
        let block = Refined { patch, i: hit.i, j: hit.j, fu: hit.fu, fv: hit.fv, t: hit.t, window, gaps };
        if patch != Patch::Hit {
            return Some(block);
        }
        let t = secant(fmt, window, gaps);
        let [(i, fu), (j, fv)] = self.places(&setup, t);
        Some(Refined { i, j, fu, fv, t, ..block })
    }

    /// Texel, wrapped, and fraction along both axes at `t`.
    fn places(&self, setup: &Setup<Axis>, t: u64) -> [(u32, u32); 2] {
        let size = &self.design.traverse;
        [&setup.u, &setup.v]
            .map(|a| place(self.design.format, size.levels, [self.idx_w, size.frac_bits], [a.p, a.dt, t]))
    }

    /// The ray's height over the interpolated surface at `t`: positive above it.
    fn gap(&self, pyramid: &Pyramid, setup: &Setup<Axis>, t: u64) -> u64 {
        let size = &self.design.traverse;
        let [(i, fx), (j, fy)] = self.places(setup, t).map(|at| corner(size.levels, size.frac_bits, at));
        let code = |di: u32, dj: u32| {
            let last = (1 << size.levels) - 1;
            pyramid.node(0, (i + di) & last, (j + dj) & last)
        };
        let codes = [code(0, 0), code(1, 0), code(0, 1), code(1, 1)];
        gap(self.design.format, [size.height_bits, size.frac_bits], codes, [fx, fy], t)
    }
}

/// Half a texel of the faster axis before and after `t`, but not beyond the planes of full height and of none: `bottom` is the parameter of the
/// latter, `r` the axes' parameters per texel, of either sign. All encoded.
pub fn window(fmt: FloatFormat, bottom: u64, r: [u64; 2], t: u64) -> [u64; 2] {
    let [r_u, r_v] = r.map(|r| r & !fmt.sign_bit());
    let texel = if float::lt(fmt, r_v, r_u) { r_v } else { r_u };
    let half = float::mul(fmt, texel, float::from_f64(fmt, 0.5));
    let before = float::add(fmt, t, float::neg(fmt, half));
    let after = float::add(fmt, t, half);
    [if float::lt(fmt, 0, before) { before } else { 0 }, if float::lt(fmt, after, bottom) { after } else { bottom }]
}

/// Where p + dt * t lies on a map of 2^`levels` texels a side that repeats: texel, and fraction in 2^-`frac` texels. The coordinate has `idx` bits
/// before the point.
pub fn place(fmt: FloatFormat, levels: u32, [idx, frac]: [u32; 2], [p, dt, t]: [u64; 3]) -> (u32, u32) {
    let at = float::to_fixed(fmt, float::add(fmt, p, float::mul(fmt, dt, t)), idx + frac, frac);
    (((at >> frac) & ((1 << levels) - 1)) as u32, (at & ((1 << frac) - 1)) as u32)
}

/// The first texel of the patch in which a place lies, and its part of the way to the next texel: heights stand at the centres of texels.
pub fn corner(levels: u32, frac: u32, (texel, fraction): (u32, u32)) -> (u32, u32) {
    let at = (i64::from(texel) << frac) + i64::from(fraction) - (1i64 << (frac - 1));
    (((at >> frac) & ((1 << levels) - 1)) as u32, (at & ((1 << frac) - 1)) as u32)
}

/// Parameter `t` below the surface that `codes` (of texels (0, 0), (1, 0), (0, 1), (1, 1) of the patch, `height_bits` wide) span: the surface's depth at the
/// weights, in 2^-`frac`, exact, rounded once, less `t`.
pub fn gap(fmt: FloatFormat, [height_bits, frac]: [u32; 2], codes: [u32; 4], [fx, fy]: [u32; 2], t: u64) -> u64 {
    let one = 1i64 << frac;
    let [d00, d10, d01, d11] = codes.map(|c| (1i64 << height_bits) - 1 - i64::from(c));
    let row = |a: i64, b: i64| a * (one - i64::from(fx)) + b * i64::from(fx);
    // At most HEIGHT_W + 2 FRAC_W bits, exact.
    let depth = row(d00, d10) * (one - i64::from(fy)) + row(d01, d11) * i64::from(fy);
    float::add(fmt, float::from_fixed(fmt, depth, 2 * frac), float::neg(fmt, t))
}

/// What the signs of the gaps at a window's ends say.
pub fn patch(fmt: FloatFormat, gaps: [u64; 2]) -> Patch {
    match (float::lt(fmt, gaps[0], 0), float::lt(fmt, 0, gaps[1])) {
        (true, _) => Patch::Below,
        (false, true) => Patch::Above,
        (false, false) => Patch::Hit,
    }
}

/// Where the chord of the gaps meets zero.
pub fn secant(fmt: FloatFormat, [begin, end]: [u64; 2], [g_begin, g_end]: [u64; 2]) -> u64 {
    // 0 / 0 says nothing: the ray meets the surface where the window begins.
    if matches!(float::decode(fmt, g_begin), Value::Zero(_)) {
        return begin;
    }
    let fall = float::add(fmt, g_begin, float::neg(fmt, g_end));
    let part = float::div(fmt, g_begin, fall);
    let way = float::mul(fmt, part, float::add(fmt, end, float::neg(fmt, begin)));
    let t = float::add(fmt, begin, way);
    if float::lt(fmt, t, end) { t } else { end }
}
