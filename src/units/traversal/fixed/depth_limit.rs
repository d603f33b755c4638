//! `depth_limit`: a plane's parameter rounded up to a height code: depths below it, as integers, are met before the plane (`docs/cells.md`).
use super::params::{GUARD, Params, TIME, bindings, time_width};
use crate::quantity::CODES;
use reliefrtl_config::{Design, Register};
use reliefrtl_ir::{Builder, Module};
use std::sync::Arc;

/// Builds `depth_limit`.
pub fn depth_limit(d: &Design) -> Arc<Module> {
    let b = Builder::new("depth_limit", file!(), "least depth that is not met before a plane, in height codes");
    let of = Params { b: &b, d };
    let f = of.fraction();
    let h = of.height(&f);
    let time = b.local("TimeW", time_width(&f), "bits of a ray parameter");
    let registered = d.latency.has(Register::Parameter);
    if registered {
        b.clock();
        b.clock_enable();
    }
    let t = b.input("t", &time, TIME, "parameter of the plane");
    let out = b.output("limit", &h + 1, CODES, "t rounded up, 0 to 2^HEIGHT_W");

    b.section("round up", "The largest parameter, of a plane that is never met, becomes 2^HEIGHT_W.");
    let rest = t.slice(0, &f - &h + GUARD).any().named("has_fraction");
    let whole = (t.slice(&f - &h + GUARD, &h).zext(&h + 1) + rest.zext(&h + 1)).named("whole");
    b.drive(out, whole.reg_if(registered));
    b.finish(&bindings())
}
