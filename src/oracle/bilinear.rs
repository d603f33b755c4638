//! The exact answer of the bilinear refinement: the first point at which a ray meets the surface interpolated between the centres of texels.
//!
//! Between two planes through texel centres the ray's height over that surface is a quadratic in the ray parameter with rational
//! coefficients. Its first root is isolated by the signs of the quadratic at rational points, none of them rounded, and halved down to
//! the width that is asked for.
use super::exact::Dyadic;
use super::walk::{ExactMap, ExactRay};
use dashu::integer::IBig;
use dashu::rational::RBig;
use reliefrtl_base::error::{Error, Result};

/// A root, enclosed: `low <= root <= high`, parameters in height codes. Equal ends are the root itself, but for the rounding to f64.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Root {
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

/// The ray's height over one patch: `c[0] + c[1] t + c[2] t^2`.
struct Quadratic([RBig; 3]);

impl Quadratic {
    fn at(&self, t: &RBig) -> RBig {
        let [c0, c1, c2] = &self.0;
        (c2 * t + c1) * t + c0
    }

    /// The parameter of the extremum.
    fn turn(&self) -> Option<RBig> {
        let [_, c1, c2] = &self.0;
        (*c2 != RBig::ZERO).then(|| -c1.clone() / (c2 * RBig::from(2)))
    }
}

/// A ray in texels, and the map under it.
struct Scene<'a> {
    map: ExactMap<'a>,
    /// Entry point and travel per height code.
    p: [RBig; 2],
    d: [RBig; 2],
}

fn rational(x: &Dyadic) -> RBig {
    let power = RBig::from(IBig::ONE << x.exp.unsigned_abs() as usize);
    let sig = RBig::from(x.sig);
    let value = if x.exp < 0 { sig / power } else { sig * power };
    if x.negative { -value } else { value }
}

fn half() -> RBig {
    RBig::ONE / RBig::from(2)
}

impl Scene<'_> {
    fn new<'a>(map: ExactMap<'a>, ray: &ExactRay) -> Result<Scene<'a>> {
        if map.texels.len() != 1 << (2 * map.levels) {
            return Err(Error::input(format!("the map has {} texels, not 4^{}", map.texels.len(), map.levels)));
        }
        let side = RBig::from(1u64 << map.levels);
        let bottom = RBig::from((1u64 << map.height_bits) - 1);
        let p = [0, 1].map(|a: usize| rational(&ray.p[a]) * &side);
        let d = [0, 1].map(|a: usize| rational(&ray.d[a]) * &side / &bottom);
        Ok(Scene { map, p, d })
    }

    fn place(&self, axis: usize, t: &RBig) -> RBig {
        &self.p[axis] + &self.d[axis] * t
    }

    fn depth(&self, i: &IBig, j: &IBig) -> RBig {
        let side = IBig::from(1u64 << self.map.levels);
        let wrap = |x: &IBig| usize::try_from(((x % &side) + &side) % &side).expect("below the side");
        let code = self.map.texels[(wrap(j) << self.map.levels) + wrap(i)];
        RBig::from((1u64 << self.map.height_bits) - 1 - u64::from(code))
    }

    /// The quadratic over the patch that holds the ray at `t`.
    fn patch(&self, t: &RBig) -> Quadratic {
        let [i, j] = [0, 1].map(|a| (self.place(a, t) - half()).floor());
        let next = |x: &IBig| x + IBig::ONE;
        let [h00, h10] = [self.depth(&i, &j), self.depth(&next(&i), &j)];
        let [h01, h11] = [self.depth(&i, &next(&j)), self.depth(&next(&i), &next(&j))];
        // depth = h00 + a fx + b fy + c fx fy with fx = x0 + x1 t, fy = y0 + y1 t.
        let (a, b) = (&h10 - &h00, &h01 - &h00);
        let c = h11 - h10 - h01 + &h00;
        let x0 = &self.p[0] - half() - RBig::from(i);
        let y0 = &self.p[1] - half() - RBig::from(j);
        let [x1, y1] = &self.d;
        let c0 = h00 + &a * &x0 + &b * &y0 + &c * &x0 * &y0;
        let c1 = &a * x1 + &b * y1 + &c * (&x0 * y1 + &y0 * x1) - RBig::ONE;
        Quadratic([c0, c1, c * x1 * y1])
    }

    /// The window's ends and all parameters between them at which the ray goes from patch to patch, ascending.
    fn borders(&self, from: &RBig, to: &RBig) -> Vec<RBig> {
        let mut all = vec![from.clone(), to.clone()];
        for axis in 0..2 {
            if self.d[axis] == RBig::ZERO {
                continue;
            }
            let [a, b] = [from, to].map(|t| (self.place(axis, t) - half()).floor());
            let (mut at, last) = if a < b { (a, b) } else { (b, a) };
            while at <= last {
                let t = (RBig::from(at.clone()) + half() - &self.p[axis]) / &self.d[axis];
                if *from < t && t < *to {
                    all.push(t);
                }
                at += IBig::ONE;
            }
        }
        all.sort();
        all.dedup();
        all
    }
}

/// The first root in `[low, high]`, where `q` is monotone and not negative at `low`; enclosed to `width`.
fn bisect(q: &Quadratic, mut low: RBig, mut high: RBig, width: &RBig) -> Option<[RBig; 2]> {
    if q.at(&low) == RBig::ZERO {
        return Some([low.clone(), low]);
    }
    if q.at(&high) > RBig::ZERO {
        return None;
    }
    while &high - &low > *width {
        let middle = (&low + &high) * half();
        if q.at(&middle) > RBig::ZERO { low = middle } else { high = middle }
    }
    Some([low, high])
}

impl ExactMap<'_> {
    /// The ray's height over the interpolated surface at parameter `t`, in height codes: the nearest f64 of the exact value.
    ///
    /// # Errors
    /// A map of the wrong size.
    pub fn bilinear_gap(&self, ray: &ExactRay, t: &Dyadic) -> Result<f64> {
        let (scene, t) = (Scene::new(*self, ray)?, rational(t));
        Ok(scene.patch(&t).at(&t).to_f64().value())
    }

    /// The first parameter in `[from, to]` at which the ray meets the interpolated surface, to within 2^-`bits` height codes. `None`: it
    /// does not, or it is below the surface at `from`.
    ///
    /// # Errors
    /// A map of the wrong size.
    pub fn bilinear_root(&self, ray: &ExactRay, [from, to]: [&Dyadic; 2], bits: u32) -> Result<Option<Root>> {
        let scene = Scene::new(*self, ray)?;
        let (from, to) = (rational(from), rational(to));
        let width = RBig::ONE / RBig::from(IBig::ONE << bits as usize);
        if scene.patch(&from).at(&from) < RBig::ZERO {
            return Ok(None);
        }
        let f64 = |x: &RBig| x.to_f64().value();
        for ends in scene.borders(&from, &to).windows(2) {
            let q = scene.patch(&((&ends[0] + &ends[1]) * half()));
            let turn = q.turn().filter(|t| ends[0] < *t && *t < ends[1]);
            let stops: Vec<&RBig> = [Some(&ends[0]), turn.as_ref(), Some(&ends[1])].into_iter().flatten().collect();
            for part in stops.windows(2) {
                if let Some([low, high]) = bisect(&q, part[0].clone(), part[1].clone(), &width) {
                    return Ok(Some(Root { low: f64(&low), high: f64(&high) }));
                }
            }
        }
        Ok(None)
    }
}
