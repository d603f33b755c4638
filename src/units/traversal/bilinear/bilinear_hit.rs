//! `bilinear_hit`: a hit on a texel moved to the surface interpolated between the centres of texels, one ray a clock.
use super::{bilinear_window, patch_corner, patch_memory, ray_place, secant_step, surface_gap};
use crate::float::FormatParams;
use crate::quantity::{BIT, CODES, TEXELS, WORDS, float, integer};
use crate::traversal::params::{LevelParams, index_width};
use reliefrtl_config::Design;
use reliefrtl_ir::{Binding, Builder, Module, Sig};
use std::sync::Arc;

/// Name of the module.
pub const NAME: &str = "bilinear_hit";

/// Builds `bilinear_hit`.
pub fn bilinear_hit(d: &Design) -> Arc<Module> {
    let t = &d.traverse;
    let b = Builder::new(NAME, file!(), "refines a hit to the bilinear surface, by a secant over a texel's way");
    let f = FormatParams::declare(&b, d.format);
    let levels = LevelParams::declare(&b, t).levels;
    let h = b.param("HEIGHT_W", t.height_bits, "bits of a height code");
    let idx = index_width(&b, t, Some(&levels));
    let frac = b.param("FRAC_W", t.frac_bits, "fraction bits of the position");
    super::common::preloaded(&b);
    b.require(2, &h);
    b.require(&h, 16);
    b.require(&h, &f.man + 1);
    b.require(&h + 2, f.bias());
    b.require(1, &frac);
    b.require(&frac, 16);
    b.require(&idx + &frac + &f.man, 60);
    b.require(&h + frac.clone() * 2 + &f.man, 60);
    b.clock();
    b.clock_enable();
    let load = [
        b.input_static("load_en", 1, BIT, "write a word of the pyramid"),
        b.input_static("load_addr", levels.clone() * 2 + 1, WORDS, "address: level 0 first, the root last"),
        b.input_static("load_data", &h, CODES, "largest height in that node"),
    ];
    let axes = ["x", "y"].map(|a| Axis {
        p: b.input(&format!("p_{a}"), &f.width, float("texels"), "entry point"),
        d: b.input(&format!("d_{a}"), &f.width, float("texels per height code"), "direction"),
        r: b.input(&format!("r_{a}"), &f.width, float("height codes per texel"), "reciprocal direction"),
    });
    let time = b.input("t", &f.width, float("height codes"), "parameter of the hit");
    let o_patch =
        b.output("patch", 2, integer("code"), "1 hit, 2 above the surface at the end, 3 below it at the begin");
    let o_t = b.output("t_refined", &f.width, float("height codes"), "parameter of the refined hit");
    let places = ["i", "j"].map(|n| b.output(n, &levels, TEXELS, "texel of the refined hit, wrapped"));
    let fractions = ["fu", "fv"]
        .map(|n| b.output(n, &frac, integer("1/2^FRAC_W texel"), "position of the refined hit in its texel"));
    let place = |name: &str, a: &Axis<'_>, t: Sig<'_>| {
        let o = b.inst(&ray_place(d), name, &[], &[("p", a.p), ("d", a.d), ("t", t)]);
        ["texel", "fraction"].map(|n| o[n].named(&format!("{}_{n}", &name[2..])).id())
    };

    b.section("window", "");
    let ins = [("r_x", axes[0].r), ("r_y", axes[1].r), ("t", time)];
    let window = b.inst(&bilinear_window(d), "u_window", &[], &ins);
    let window = ["t_begin", "t_end"].map(|n| window[n].named(n));

    let mut gaps = Vec::new();
    for (end, t_end) in ["begin", "end"].iter().zip(window) {
        b.section(end, "Position, the four texels around it, and the height over the surface between them.");
        let mut corners = Vec::new();
        for (a, axis) in ["x", "y"].iter().zip(&axes) {
            let at = place(&format!("u_{end}_{a}"), axis, t_end);
            let ins = [("texel", b.sig(at[0])), ("fraction", b.sig(at[1]))];
            let o = b.inst(&patch_corner(t), &format!("u_{end}_corner_{a}"), &[], &ins);
            corners.push(["corner", "weight"].map(|n| o[n].named(&format!("{end}_{n}_{a}"))));
        }
        let ins = [
            ("load_en", load[0]),
            ("load_addr", load[1]),
            ("load_data", load[2]),
            ("i", corners[0][0]),
            ("j", corners[1][0]),
        ];
        let codes = b.inst(&patch_memory(t), &format!("u_{end}_patch"), &[], &ins);
        let names = ["code_00", "code_10", "code_01", "code_11"];
        let mut ins: Vec<_> = names.map(|n| (n, codes[n].named(&format!("{end}_{n}")))).to_vec();
        ins.extend([("weight_x", corners[0][1]), ("weight_y", corners[1][1]), ("t", t_end)]);
        gaps.push(b.inst(&surface_gap(d), &format!("u_{end}_gap"), &[], &ins).only().named(&format!("gap_{end}")));
    }

    b.section("step", "");
    let ins = [("t_begin", window[0]), ("t_end", window[1]), ("gap_begin", gaps[0]), ("gap_end", gaps[1])];
    let step = b.inst(&secant_step(d), "u_step", &[], &ins);
    let (patch, refined) = (step["patch"].named("found"), step["t"].named("t_step"));

    b.section("position", "");
    for (k, axis) in axes.iter().enumerate() {
        let at = place(["u_position_x", "u_position_y"][k], axis, refined);
        b.drive(places[k], b.sig(at[0]));
        b.drive(fractions[k], b.sig(at[1]));
    }
    b.drive(o_patch, patch);
    b.drive(o_t, refined);
    let at = |n: i64, e: i64, m: i64| {
        let of = [("LEVELS", n), ("IDX_W", n + 6), ("EXP_W", e), ("MAN_W", m)];
        of.into_iter().map(|(k, v)| (k.to_string(), v)).collect::<Binding>()
    };
    b.finish(&[at(2, 5, 10), at(12, 8, 23)])
}

/// A ray's constants along an axis.
struct Axis<'b> {
    p: Sig<'b>,
    d: Sig<'b>,
    r: Sig<'b>,
}
