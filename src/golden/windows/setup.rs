//! What is computed once per ray, and what is read of it in every iteration.
use super::Windows;
use crate::fixed::FixedAxis;
use crate::record::RayInput;
use reliefrtl_config::Window;

/// One axis of a ray after setup.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WindowAxis {
    /// Setup of the fixed-point datapath.
    pub fixed: FixedAxis,
    /// Q: parameter from plane to plane, in 2^-g' of t; all ones where it does not fit or the axis does not move.
    pub q: u64,
    /// C: parameter of the first plane, in the same unit.
    pub c: u64,
    /// s: travel a height code, in 2^-(n + e) tiles, less than it is by what the parameters of planes may be too large.
    pub s: u64,
    /// o: where the ray begins in its texel, seen along the ray, in 2^-e texels.
    pub o: u64,
}

impl Windows {
    /// Setup of one ray: along u and along v; `None` of a ray that is not valid.
    pub fn setup(&self, ray: &RayInput) -> Option<[WindowAxis; 2]> {
        let setup = self.fixed.setup(ray);
        setup.valid.then(|| [self.axis(setup.u), self.axis(setup.v)])
    }

    /// Setup of one axis, from that of the fixed-point datapath.
    pub fn axis(&self, fixed: FixedAxis) -> WindowAxis {
        let (d, w) = (&self.fixed.design, &self.widths);
        // Bits of a position below a texel.
        let below = d.datapath.fraction_bits - d.traverse.levels;
        let p0 = i128::from(fixed.p) % (1 << below);
        let (ahead, begun) = if fixed.neg { (p0, (1 << below) - 1 - p0) } else { ((1 << below) - p0, p0) };
        // A plane's parameter is its distance, times R 2^Z, over this.
        let unit = d.datapath.reciprocal_bits + d.traverse.tile_bits - 2;
        let word = |distance: i128| {
            let all = (1i128 << w.plane) - 1;
            let exact = (distance * i128::from(fixed.r)) << (fixed.z + w.guard);
            if fixed.a == 0 { all as u64 } else { (exact >> unit).min(all) as u64 }
        };
        let v = i128::from(fixed.s) >> (below - w.estimate_fraction);
        // R may be too large by one part in 2^W, and v is cut.
        let biased = v - 1 - (v >> d.datapath.reciprocal_bits);
        WindowAxis {
            fixed,
            q: word(1 << below),
            c: word(ahead),
            s: biased.clamp(0, (1 << w.travel) - 1) as u64,
            o: (begun >> (below - w.estimate_fraction)) as u64,
        }
    }

    /// t(k + i): where the ray meets the plane that is number `number` from its entry on, the first being 0.
    pub fn plane_time(&self, axis: &WindowAxis, number: i64) -> u64 {
        let exact = (i128::from(axis.c) + i128::from(number) * i128::from(axis.q)) >> self.widths.guard;
        exact.min(i128::from(self.fixed.never)) as u64
    }

    /// How many planes the ray has passed at `m`, or fewer.
    pub fn planes_passed(&self, axis: &WindowAxis, m: u64) -> i64 {
        let w = &self.widths;
        let m = i128::from(m >> (w.parameter - w.time));
        let texels = ((i128::from(axis.s) * m) >> w.time) + i128::from(axis.o);
        (texels >> w.estimate_fraction) as i64
    }
}

impl WindowAxis {
    /// X: the texel beyond `k` planes, unwrapped.
    pub fn texel(&self, k: i64) -> i64 {
        if self.fixed.neg { self.fixed.x - k } else { self.fixed.x + k }
    }

    /// r: texels of a window beyond the one that `k` planes lead to.
    pub fn beyond(&self, k: i64, window: Window) -> i64 {
        let x0 = if self.fixed.neg { !self.fixed.x } else { self.fixed.x };
        // Up to the border of the grid's cell, seen along the ray.
        let u = !(x0 + k) & i64::from(window.grid - 1);
        i64::from(window.ahead()) + u
    }

    /// I: the window that begins in that texel's cell and lies ahead; unwrapped.
    pub fn index(&self, k: i64, window: Window) -> i64 {
        let cell = self.texel(k) >> window.grid_bits();
        if self.fixed.neg { cell - i64::from(window.cells() - 1) } else { cell }
    }

    /// The plane that is number `number` from the entry on, in texels.
    pub(super) fn plane(&self, number: i64) -> i64 {
        if self.fixed.neg { self.fixed.x - number } else { self.fixed.x + number + 1 }
    }
}
