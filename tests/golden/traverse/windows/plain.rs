//! The search by windows once more, read off `docs/windows.md` line by line: slow, every window looked up texel by texel, and with rules that can be left out.
use reliefrtl::config::{Design, Window};
use reliefrtl::golden::RayInput;
use reliefrtl::golden::fixed::{Fixed, FixedAxis};

/// What is left out of the rules, or turned round.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Fault {
    /// Nothing.
    #[default]
    None,
    /// The estimate's travel is not made smaller.
    NoBias,
    /// What a window adds to the parameter of a plane is rounded by itself.
    RoundedApart,
}

/// Texel, t, wall, iterations.
pub type Found = (i64, i64, i128, bool, u32);

/// Constants of one axis.
struct Axis {
    neg: bool,
    x: i64,
    c: i128,
    q: i128,
    s: i128,
    o: i128,
}

/// A search on one map.
pub struct Plain<'a> {
    pub design: &'a Design,
    pub sizes: &'a [Window],
    pub texels: &'a [u32],
    pub fault: Fault,
}

impl Plain<'_> {
    fn sizes_of(&self) -> (i128, i128, i128, i128, i128) {
        let (p, t) = (&self.design.datapath, &self.design.traverse);
        let of = |x: u32| i128::from(x);
        (of(p.fraction_bits), of(p.reciprocal_bits), of(t.tile_bits), of(t.levels), of(t.height_bits))
    }

    fn guard(&self) -> i128 {
        let (f, w, tile, n, _) = self.sizes_of();
        (w + tile + n - 2 - f).max(0)
    }

    fn axis(&self, a: &FixedAxis) -> Axis {
        let (f, w, tile, n, _) = self.sizes_of();
        let (p0, e) = (i128::from(a.p) & ((1 << (f - n)) - 1), (18 - n - tile).max(0).min(f - n));
        let all = (1i128 << (f + 2 + self.guard())) - 1;
        let (r, z) = (i128::from(a.r), i128::from(a.z));
        let d0 = if a.neg { p0 } else { (1 << (f - n)) - p0 };
        let (mut q, mut c) = if w + tile + n >= f + 2 {
            (r << z, ((d0 * r) << z) >> (f - n))
        } else {
            ((r << z) << (f + 2 - w - tile - n), ((d0 * r) << z) >> (w + tile - 2))
        };
        if a.a == 0 {
            (q, c) = (all, all);
        }
        let v = i128::from(a.s) >> (f - n - e);
        let less = if self.fault == Fault::NoBias { 0 } else { 1 + (v >> w) };
        let s = (v - less).max(0).min((1 << (n + tile + e)) - 1);
        let o = (if a.neg { (1 << (f - n)) - 1 - p0 } else { p0 }) >> (f - n - e);
        Axis { neg: a.neg, x: a.x, c: c.min(all), q: q.min(all), s, o }
    }

    fn time(&self, a: &Axis, k: i64, i: i64) -> i128 {
        let (f, g) = (self.sizes_of().0, self.guard());
        let (k, i) = (i128::from(k), i128::from(i));
        let t = match self.fault {
            Fault::RoundedApart => ((a.c + k * a.q) >> g) + (i * a.q >> g),
            _ => (a.c + (k + i) * a.q) >> g,
        };
        t.min((1 << (f + 2)) - 1)
    }

    /// The highest code of a window, texel by texel.
    fn word(&self, w: Window, i: i64, j: i64) -> i128 {
        let side = 1i64 << self.design.traverse.levels;
        let (s, g) = (i64::from(w.side), i64::from(w.grid));
        let code = |x: i64, y: i64| self.texels[(y.rem_euclid(side) * side + x.rem_euclid(side)) as usize];
        let all = (0..s).flat_map(|b| (0..s).map(move |a| (g * i + a, g * j + b)));
        i128::from(all.map(|(x, y)| code(x, y)).max().unwrap())
    }

    /// Traces a valid ray; `None` if it does not end in `most` iterations.
    pub fn trace(&self, fixed: &Fixed, ray: &RayInput, most: u32) -> Option<Found> {
        let (f, _, tile, n, h) = self.sizes_of();
        let setup = fixed.setup(ray);
        assert!(setup.valid);
        let axes = [self.axis(&setup.u), self.axis(&setup.v)];
        let (e, b) = ((18 - n - tile).max(0).min(f - n), (f + 2).min(18));
        let (mut k, mut t) = ([0i64; 2], 0i128);
        for steps in 1..=most {
            let texel = |c: usize| if axes[c].neg { axes[c].x - k[c] } else { axes[c].x + k[c] };
            let look = |w: &Window| {
                let (s, g) = (i64::from(w.side), i64::from(w.grid));
                let mut r = [0; 2];
                let mut at = [0; 2];
                for c in 0..2 {
                    let x0 = if axes[c].neg { !axes[c].x } else { axes[c].x };
                    r[c] = s - g + (!(x0 + k[c])).rem_euclid(g);
                    at[c] = texel(c).div_euclid(g) - if axes[c].neg { s / g - 1 } else { 0 };
                }
                let planes = [0, 1].map(|c| self.time(&axes[c], k[c], r[c]));
                let d = (((1 << h) - 1) - self.word(*w, at[0], at[1])) << (f + 2 - h);
                (r, planes, planes[0].min(planes[1]), d)
            };
            let seen: Vec<_> = self.sizes.iter().map(look).collect();
            let inside = |c: usize| seen[c].3 < seen[c].2;
            if inside(0) && t < seen[0].2 {
                let d = seen[0].3;
                let side = 1i64 << self.design.traverse.levels;
                return Some((texel(0).rem_euclid(side), texel(1).rem_euclid(side), t.max(d), d < t, steps));
            }
            let a = (0..seen.len()).rev().find(|c| !inside(*c)).unwrap_or(0);
            let deep = if a + 1 < seen.len() { seen[a + 1].3 } else { 0 };
            let m = if inside(0) { t } else { t.max(seen[a].2).max(deep) };
            let c = usize::from(seen[a].1[0] > seen[a].1[1]);
            k[c] += seen[a].0[c] + 1;
            for c in 0..2 {
                let estimate = ((axes[c].s * (m >> (f + 2 - b)) >> b) + axes[c].o) >> e;
                k[c] = k[c].max(estimate as i64);
            }
            t = m;
        }
        None
    }
}
