//! The bilinear refinement of a block hit (`docs/bilinear.md`; PDM section 3.3): one secant step between half a texel before and half a
//! texel behind the hit.
use super::float::{self, Value};
use super::pyramid::Pyramid;
use super::record::RayHit;
use super::setup::{Axis, RayInput, Setup};
use super::traverse::Golden;

/// What the refinement found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Patch {
    /// The ray goes from above the interpolated surface to below it within the window.
    Hit,
    /// It is still above at the window's end.
    Above,
    /// It is below at the window's begin already.
    Below,
}

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
    /// The window's ends: encoded parameters half a texel before and behind the block hit.
    pub window: [u64; 2],
    /// The ray's height over the surface at both ends, in height codes, encoded.
    pub gaps: [u64; 2],
}

impl Golden {
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
        let window = self.window(&setup, hit.t);
        let gaps = window.map(|t| self.gap(pyramid, &setup, t));
        let patch = match (float::lt(fmt, gaps[0], 0), float::lt(fmt, 0, gaps[1])) {
            (true, _) => Patch::Below,
            (false, true) => Patch::Above,
            (false, false) => Patch::Hit,
        };
        let block = Refined { patch, i: hit.i, j: hit.j, fu: hit.fu, fv: hit.fv, t: hit.t, window, gaps };
        if patch != Patch::Hit {
            return Some(block);
        }
        let t = self.secant(window, gaps);
        let [(i, fu), (j, fv)] = [&setup.u, &setup.v].map(|a| self.split(self.fixed(a, t)));
        Some(Refined { i: wrapped(i, size.levels), j: wrapped(j, size.levels), fu, fv, t, ..block })
    }

    /// Half a texel of the faster axis before and behind `t`, but not beyond the planes of full and of no height.
    fn window(&self, setup: &Setup, t: u64) -> [u64; 2] {
        let fmt = self.design.format;
        let [r_u, r_v] = [setup.u.r, setup.v.r].map(|r| r & !fmt.sign_bit());
        let texel = if float::lt(fmt, r_v, r_u) { r_v } else { r_u };
        let half = float::mul(fmt, texel, float::from_f64(fmt, 0.5));
        let before = float::add(fmt, t, float::neg(fmt, half));
        let behind = float::add(fmt, t, half);
        [
            if float::lt(fmt, 0, before) { before } else { 0 },
            if float::lt(fmt, behind, self.bottom) { behind } else { self.bottom },
        ]
    }

    /// The ray's height over the interpolated surface at `t`: positive above it.
    fn gap(&self, pyramid: &Pyramid, setup: &Setup, t: u64) -> u64 {
        let (fmt, size) = (self.design.format, &self.design.traverse);
        // Heights stand at the centres of texels.
        let centre = 1i64 << (size.frac_bits - 1);
        let [(i, fx), (j, fy)] = [&setup.u, &setup.v].map(|a| self.split(self.fixed(a, t) - centre));
        let depth = |di: i64, dj: i64| {
            let code = pyramid.node(0, wrapped(i + di, size.levels), wrapped(j + dj, size.levels));
            (1i64 << size.height_bits) - 1 - i64::from(code)
        };
        let one = 1i64 << size.frac_bits;
        let row = |dj: i64| depth(0, dj) * (one - i64::from(fx)) + depth(1, dj) * i64::from(fx);
        // At most HEIGHT_W + 2 FRAC_W bits, exact.
        let depth = row(0) * (one - i64::from(fy)) + row(1) * i64::from(fy);
        float::add(fmt, float::from_fixed(fmt, depth, 2 * size.frac_bits), float::neg(fmt, t))
    }

    /// Where the chord of the gaps meets zero.
    fn secant(&self, [begin, end]: [u64; 2], [g_begin, g_end]: [u64; 2]) -> u64 {
        let fmt = self.design.format;
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

    /// Where the ray is at `t`, in 2^-FRAC_W texels, unwrapped.
    fn fixed(&self, axis: &Axis, t: u64) -> i64 {
        let (fmt, frac) = (self.design.format, self.design.traverse.frac_bits);
        let at = float::add(fmt, axis.p, float::mul(fmt, axis.dt, t));
        float::to_fixed(fmt, at, self.idx_w + frac, frac)
    }

    /// Texel and fraction.
    fn split(&self, at: i64) -> (i64, u32) {
        let frac = self.design.traverse.frac_bits;
        (at >> frac, (at & ((1 << frac) - 1)) as u32)
    }
}

/// A texel of the map that repeats.
fn wrapped(x: i64, levels: u32) -> u32 {
    (x & ((1 << levels) - 1)) as u32
}
