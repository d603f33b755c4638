//! What a ray carries round the loop.
use crate::config::{Design, LevelUp};
use crate::ir::{Builder, Expr, Sig};
use crate::units::float::FormatParams;

/// Parameters of `traverse`.
pub struct Sizes {
    /// Number format.
    pub f: FormatParams,
    /// LEVELS.
    pub levels: Expr,
    /// Bits of a level number.
    pub level_w: Expr,
    /// HEIGHT_W.
    pub height: Expr,
    /// FRAC_W.
    pub frac: Expr,
    /// TAG_W.
    pub tag: Expr,
    /// STEP_LIMIT.
    pub step_limit: Expr,
    /// Bits of an unwrapped texel coordinate.
    pub idx: Expr,
}

impl Sizes {
    /// Declares them, with what they may be.
    pub fn declare(b: &Builder, d: &Design) -> Self {
        let t = &d.traverse;
        let f = FormatParams::declare(b, d.format);
        let levels = b.param("LEVELS", t.levels, "the map has 2^LEVELS x 2^LEVELS texels");
        let height = b.param("HEIGHT_W", t.height_bits, "bits of a height code");
        let tile = b.param("TILE_W", t.tile_bits, "a ray travels less than 2^TILE_W tiles along each axis");
        let frac = b.param("FRAC_W", t.frac_bits, "fraction bits of the hit position");
        let tag = b.param("TAG_W", t.tag_bits, "bits of a ray's tag");
        let step_limit = b.param("STEP_LIMIT", t.step_limit, "iterations after which a ray is given up");
        b.require(2, &levels);
        b.require(&levels, 12);
        super::params::ray_conditions(b, &f, &levels, &height, &tile);
        b.require(1, &frac);
        b.require(1, &tag);
        b.require(1, &step_limit);
        b.require(&step_limit, 65535);
        let level_w = b.local("LevelW", (&levels + 1).clog2());
        let idx = b.local("IdxW", &levels + &tile + 2);
        Self { f, levels, level_w, height, frac, tag, step_limit, idx }
    }
}

macro_rules! ray {
    ($($(#[$doc:meta])* $field:ident: $width:expr;)*) => {
        /// A ray in the loop: constants of the ray, then its state.
        #[derive(Clone, Copy)]
        pub struct Ray<'b> {
            /// The slot holds a ray.
            pub valid: Sig<'b>,
            $($(#[$doc])* pub $field: Sig<'b>,)*
            /// A node boundary was crossed already (only with several levels down).
            pub crossed: Option<Sig<'b>>,
            /// The iteration before was a crossing (only for coherent level-up).
            pub prev: Option<Sig<'b>>,
        }

        impl<'b> Ray<'b> {
            /// The loop's registers.
            pub fn registers(b: &'b Builder, s: &Sizes, d: &Design) -> Self {
                let flag = |on: bool, name: &str| on.then(|| b.loop_reg(name, 1, false).id());
                let (crossed, prev) = (flag(d.mode.levels_down > 1, "back_crossed"), flag(d.mode.level_up == LevelUp::Coherent, "back_prev"));
                Ray {
                    valid: b.loop_reg("back_valid", 1, true),
                    $($field: b.loop_reg(concat!("back_", stringify!($field)), ($width)(s), false),)*
                    crossed: crossed.map(|id| b.sig(id)),
                    prev: prev.map(|id| b.sig(id)),
                }
            }

            /// `new` where `admits`, else what came back; `valid` as given.
            pub fn or_new(&self, admits: Sig<'b>, new: &Self, valid: Sig<'b>) -> Self {
                let pick = |a: Sig<'b>, o: Sig<'b>, name: &str| admits.mux(a, o).named(name).id();
                let b = admits.builder();
                let flag = |n: Option<Sig<'b>>, o: Option<Sig<'b>>, name: &str| n.zip(o).map(|(n, o)| b.sig(pick(n, o, name)));
                Ray {
                    valid: valid.named("valid").valid(),
                    $($field: b.sig(pick(new.$field, self.$field, stringify!($field))),)*
                    crossed: flag(new.crossed, self.crossed, "has_crossed"),
                    prev: flag(new.prev, self.prev, "just_crossed"),
                }
            }

            /// Registers and what they take at the end of the loop.
            pub fn pairs(&self, next: &Self) -> Vec<(Sig<'b>, Sig<'b>)> {
                let mut v = vec![(self.valid, next.valid), $((self.$field, next.$field),)*];
                v.extend(self.crossed.zip(next.crossed));
                v.extend(self.prev.zip(next.prev));
                v
            }
        }
    };
}

fn float(s: &Sizes) -> Expr {
    s.f.width.clone()
}
fn index(s: &Sizes) -> Expr {
    s.idx.clone()
}
fn bit(_: &Sizes) -> Expr {
    Expr::from(1)
}
fn counter(_: &Sizes) -> Expr {
    Expr::from(16)
}

ray! {
    /// Tag.
    tag: |s: &Sizes| s.tag.clone();
    /// Entry point, texels.
    p_x: float;
    /// Entry point, biased backwards.
    pb_x: float;
    /// Direction, texels per height code.
    d_x: float;
    /// Reciprocal direction.
    r_x: float;
    /// Does not move along u.
    never_x: bit;
    /// Runs toward smaller u.
    neg_x: bit;
    /// Entry point, texels.
    p_y: float;
    /// Entry point, biased backwards.
    pb_y: float;
    /// Direction, texels per height code.
    d_y: float;
    /// Reciprocal direction.
    r_y: float;
    /// Does not move along v.
    never_y: bit;
    /// Runs toward smaller v.
    neg_y: bit;
    /// Level of the node.
    level: |s: &Sizes| s.level_w.clone();
    /// A texel of the node, unwrapped.
    x: index;
    /// A texel of the node, unwrapped.
    y: index;
    /// Parameter so far, height codes.
    t: float;
    /// The ray has ended and waits to leave.
    done: bit;
    /// It hit a wall.
    wall: bit;
    /// It was given up.
    limit: bit;
    /// Iterations so far.
    steps: counter;
    /// Crossings so far.
    crossings: counter;
    /// Levels gone up so far.
    ups: counter;
}

impl<'b> Ray<'b> {
    /// A ray as setup delivers it (outputs of `ray_setup` in port order).
    pub fn fresh(b: &'b Builder, s: &Sizes, d: &Design, setup: &[Sig<'b>], tag: Sig<'b>) -> Self {
        let [ok, level, p_x, pb_x, d_x, r_x, never_x, neg_x, x, p_y, pb_y, d_y, r_y, never_y, neg_y, y] = setup else {
            panic!("ray_setup has 16 outputs, not {}", setup.len())
        };
        let zero = b.zeros(1);
        let refused = (!*ok).named("new_refused");
        let (p_x, pb_x, d_x, r_x, never_x, neg_x) = (*p_x, *pb_x, *d_x, *r_x, *never_x, *neg_x);
        let (p_y, pb_y, d_y, r_y, never_y, neg_y) = (*p_y, *pb_y, *d_y, *r_y, *never_y, *neg_y);
        Ray {
            valid: zero,
            tag,
            p_x,
            pb_x,
            d_x,
            r_x,
            never_x,
            neg_x,
            p_y,
            pb_y,
            d_y,
            r_y,
            never_y,
            neg_y,
            level: *level,
            x: *x,
            y: *y,
            t: b.zeros(&s.f.width),
            done: refused,
            wall: zero,
            limit: refused,
            steps: b.zeros(16),
            crossings: b.zeros(16),
            ups: b.zeros(16),
            crossed: (d.mode.levels_down > 1).then_some(zero),
            prev: (d.mode.level_up == LevelUp::Coherent).then_some(zero),
        }
    }
}
