//! `fp_add3`: the sum of three numbers, rounded once.
//!
//! The terms are ordered by magnitude, x first, and aligned to x in a window of `2p + 3` bits, `p = MAN_W + 1`, the last one
//! sticky. That is enough, because
//! - if x and y cancel entirely, z alone is the result and takes x's place;
//! - if y keeps all its bits, x + y is a multiple of its last place, which is 2^-p of x or above; what z loses lies below
//!   a quarter of the last place of any sum that is left;
//! - if y loses bits, y + z is less than half the last place of x minus it, so only its sign counts, which is y's: z is
//!   left out, and so is y if z is -y.
use super::fields::FormatParams;
use super::general::{Classes, Exact, Operand, Range, any, exponent_width, round};
use crate::lzc::lzc;
use crate::quantity::FLOAT;
use reliefrtl_base::format::{FloatFormat, Rounding};
use reliefrtl_ir::{Builder, Expr, Module, Sig};
use std::sync::Arc;

/// Sections and how long each takes, in tenths of a nanosecond on ECP5.
const PLAN: &[(&str, u32)] = &[
    ("compare", 28),
    ("order", 25),
    ("cancel", 30),
    ("align", 35),
    ("save", 10),
    ("add", 35),
    ("magnitude", 35),
    ("count", 30),
    ("normalize", 30),
    ("round", 30),
    ("select", 20),
];

/// A term of the sum: sign, weight and significand.
#[derive(Clone, Copy)]
struct Term<'b> {
    sign: Sig<'b>,
    weight: Sig<'b>,
    sig: Sig<'b>,
}

impl<'b> Term<'b> {
    /// `s ? a : b`.
    fn pick(s: Sig<'b>, a: Self, b: Self) -> Self {
        Self { sign: s.mux(a.sign, b.sign), weight: s.mux(a.weight, b.weight), sig: s.mux(a.sig, b.sig) }
    }
    fn named(self, name: &str) -> Self {
        let called = |s: Sig<'b>, what: &str| s.named(&format!("{name}_{what}"));
        Self { sign: called(self.sign, "sign"), weight: called(self.weight, "weight"), sig: called(self.sig, "term") }
    }
    /// The terms cancel.
    fn cancels(self, o: Self) -> Sig<'b> {
        self.weight.eq(o.weight) & self.sig.eq(o.sig) & (self.sign ^ o.sign)
    }
}

/// Builds `fp_add3` with `latency` clocks from operand to result.
pub fn fp_add3(format: FloatFormat, latency: u32) -> Arc<Module> {
    let b = Builder::new("fp_add3", file!(), "sum of three floating-point numbers, rounded once");
    let f = FormatParams::declare(&b, format);
    // The sum and its carry-in take 2 * MAN_W + 9 bits.
    b.require(&f.man, 27);
    let e_w = exponent_width(&b, &f);
    let p = b.local("SigW", &f.man + 1, "bits of a significand, the hidden one included");
    let sum_w = b.local("SumW", p.clone() * 2 + 6, "bits of an aligned sum of three significands");
    b.clock();
    b.clock_enable();
    let ins = ["a", "b", "c"].map(|n| b.input(n, &f.width, FLOAT, "term"));
    let out = b.output("result", &f.width, FLOAT, "a + b + c");
    b.plan(latency, PLAN);

    b.section("compare", "");
    let [fa, fb, fc] = [0, 1, 2].map(|k| Operand::of(&b, &f, ins[k], ["a", "b", "c"][k]));
    let mag = |k: usize| ins[k].slice(0, &f.exp + &f.man);
    let ab = mag(0).lt(mag(1)).named("a_below_b");
    let bc = mag(1).lt(mag(2)).named("b_below_c");
    let ac = mag(0).lt(mag(2)).named("a_below_c");
    let [ta, tb, tc] = [&fa, &fb, &fc].map(|o| Term { sign: o.sign, weight: o.weight(), sig: o.sig() });
    let agree = (!(fa.sign ^ fb.sign) & !(fa.sign ^ fc.sign)).named("signs_agree");
    let infs = [&fa, &fb, &fc].map(|o| o.inf().map(|i| (i & o.sign, i & !o.sign)));
    let minus = any(&infs.map(|i| i.map(|i| i.0))).map(|s| s.named("minus_inf"));
    let plus = any(&infs.map(|i| i.map(|i| i.1))).map(|s| s.named("plus_inf"));
    let both = minus.zip(plus).map(|(m, p)| m & p);
    let nan = any(&[fa.nan(), fb.nan(), fc.nan(), both]).map(|s| s.named("is_nan"));
    let inf = any(&[minus, plus]).map(|s| s.named("is_inf"));

    b.section("order", "");
    let pick = Term::pick;
    let x = pick(ab, pick(bc, tc, tb), pick(ac, tc, ta)).named("x");
    let y = pick(ab, pick(bc, tb, pick(ac, tc, ta)), pick(ac, ta, pick(bc, tc, tb))).named("y");
    let z = pick(ab, pick(ac, ta, tc), pick(bc, tb, tc)).named("z");

    b.section("cancel", "");
    let gone = x.cancels(y).named("x_y_cancel");
    let first = pick(gone, z, x).named("first");
    let d_w = b.local("DistanceW", f.exp.larger((&p + 4).clog2()), "bits of a difference of exponents");
    let y_down = (x.weight - y.weight).named("y_down");
    let z_down = (x.weight - z.weight).named("z_down");
    let far = b
        .konst(&p + 2, &d_w)
        .named("max_shift")
        .doc("the largest shift of a term that is not lost")
        .lt(y_down.zext(&d_w))
        .named("y_loses");
    let y_is_lost = (gone | (far & y.cancels(z))).named("y_is_lost");
    let z_is_lost = (gone | far).named("z_is_lost");
    let y_minus = (y.sign ^ first.sign).named("y_minus");
    let z_minus = (z.sign ^ first.sign).named("z_minus");

    b.section("align", "");
    let y_at = aligned(&b, &p, y.sig, y_down, y_is_lost, "y");
    let z_at = aligned(&b, &p, z.sig, z_down, z_is_lost, "z");
    let x_at = b.cat(&[b.zeros(3), first.sig, b.zeros(&p + 3)]).named("x_at");

    b.section("save", "A term to subtract is complemented; the ones that this lacks come in as carries.");
    let (u, v) = (y_at ^ y_minus.rep(&sum_w), z_at ^ z_minus.rep(&sum_w));
    let save = (x_at ^ u ^ v).named("save");
    let carry = ((x_at & u) | (x_at & v) | (u & v)).named("carry");

    b.section("add", "");
    let one = b.lit(1, 1);
    b.unused(carry.msb());
    let total = (b.cat(&[save, one]) + b.cat(&[carry.slice(0, &sum_w - 1), y_minus, z_minus])).named("total");
    b.unused(total.bit(0));
    let sum = total.slice(1, &sum_w).named("sum");

    b.section("magnitude", "");
    let negative = sum.msb().named("negative");
    let magnitude = (sum.slice(0, &sum_w - 1) ^ negative.rep(&sum_w - 1)) + negative.zext(&sum_w - 1);
    let magnitude = magnitude.named("magnitude");

    b.section("count", "");
    let count = lzc(&b, "u_lzc", magnitude, "lz_count");
    let none = magnitude.none().named("sum_is_zero");

    b.section("normalize", "Up to a leading one; where subnormals are numbers, not beyond their exponent.");
    let (exp, norm) = normalized(&b, &f, &e_w, first.weight, magnitude, count);
    let down = if format.rounding == Rounding::Down { b.lit(1, 1) } else { b.zeros(1) };
    let sign = none.mux(agree.mux(fa.sign, down), first.sign ^ negative);
    let sign = inf.zip(minus).map_or(sign, |(i, m)| i.mux(m, sign)).named("sum_sign");
    let rest = &sum_w - 2 - &p;
    let (guard, sticky) = (norm.bit(&rest).named("guard"), norm.slice(0, &rest).any().named("sticky"));
    let x = Exact { sign, exp, sig: norm.slice(&rest + 1, &p).named("sig"), guard, sticky };
    let range = if format.is_gradual() { Range::Aligned } else { Range::Any };
    let value = round(&b, &f, x, range, &Classes { nan, inf, zero: Some(none) });
    b.drive(out, value);
    b.finish(&super::bindings())
}

/// A significand moved down in the window, with what it loses as its last bit; nothing if `is_lost`.
fn aligned<'b>(b: &'b Builder, p: &Expr, sig: Sig<'b>, down: Sig<'b>, is_lost: Sig<'b>, name: &str) -> Sig<'b> {
    let wide = b.cat(&[sig, b.zeros(p + 2)]).named(&format!("{name}_wide"));
    let lost = (wide & !b.ones(wide.width()).shift_left(down)).any();
    let word = b.cat(&[wide.shift_right(down), lost]);
    b.cat(&[b.zeros(3), word & (!is_lost).rep(word.width())]).named(&format!("{name}_at"))
}

/// Exponent and normalized magnitude, whose top bit weighs 4 times as much as x's.
fn normalized<'b>(
    b: &'b Builder,
    f: &FormatParams,
    e_w: &Expr,
    weight: Sig<'b>,
    magnitude: Sig<'b>,
    count: Sig<'b>,
) -> (Sig<'b>, Sig<'b>) {
    let weight = weight.zext(e_w);
    let wide = count.zext(e_w);
    let exp = (weight + b.lit(2, e_w) - wide).named("plain_exp");
    if !f.format.is_gradual() {
        return (exp, magnitude.shift_left(count).named("norm"));
    }
    let most = (weight + b.lit(1, e_w)).named("most");
    let short = most.lt(wide).named("short");
    let up = short.mux(most, wide).named("up");
    (short.mux(b.lit(1, e_w), exp).named("exp"), magnitude.shift_left(up).named("norm"))
}
