//! Units of the bilinear refinement.
use super::super::datapath::WATERTIGHT;
use super::super::ray_stimulus::{one_axis, refined_hit};
use super::super::unit::Unit;
use crate::golden::{address, bilinear as gb, float as gf};

/// The entries. Rays through `traverse` exercise those that hold memories.
pub const UNITS: &[&Unit] = &[
    &BILINEAR_WINDOW,
    &RAY_PLACE,
    &PATCH_CORNER,
    &BANK_ADDRESS,
    &PATCH_MEMORY,
    &SURFACE_GAP,
    &SECANT_STEP,
    &BILINEAR_HIT,
];

static BILINEAR_WINDOW: Unit = Unit {
    name: "bilinear_window",
    model: Some(|c, row, out| {
        let f = c.design.format;
        let bottom = gf::from_int(f, (1 << c.param("HEIGHT_W")) - 1);
        let [begin, end] = gb::window(f, bottom, [row["r_x"], row["r_y"]], row["t"]);
        out["t_begin"] = begin;
        out["t_end"] = end;
    }),
    stimulus: Some(refined_hit),
    ..WATERTIGHT
};

static RAY_PLACE: Unit = Unit {
    name: "ray_place",
    model: Some(|c, row, out| {
        let widths = [c.param("IDX_W"), c.param("FRAC_W")];
        let ray = [row["p"], row["d"], row["t"]];
        let (texel, fraction) = gb::place(c.design.format, c.design.traverse.levels, widths, ray);
        out["texel"] = u64::from(texel);
        out["fraction"] = u64::from(fraction);
    }),
    stimulus: Some(one_axis),
    ..WATERTIGHT
};

static PATCH_CORNER: Unit = Unit {
    name: "patch_corner",
    model: Some(|c, row, out| {
        let at = (row["texel"] as u32, row["fraction"] as u32);
        let (corner, weight) = gb::corner(c.design.traverse.levels, c.param("FRAC_W"), at);
        out["corner"] = u64::from(corner);
        out["weight"] = u64::from(weight);
    }),
    ..WATERTIGHT
};

static BANK_ADDRESS: Unit = Unit {
    name: "bank_address",
    model: Some(|c, row, out| {
        let n = c.design.traverse.levels;
        // The one of a texel and its neighbour that has the parity.
        let of = |port: &str, odd: u32| {
            let texel = row[port] as u32;
            if texel % 2 == odd { texel } else { (texel + 1) & ((1 << n) - 1) }
        };
        for (port, [odd_i, odd_j]) in
            [("address_00", [0, 0]), ("address_10", [1, 0]), ("address_01", [0, 1]), ("address_11", [1, 1])]
        {
            out[port] = address(n, 0, of("i", odd_i), of("j", odd_j)) as u64 / 4;
        }
    }),
    ..WATERTIGHT
};

static PATCH_MEMORY: Unit = Unit { name: "patch_memory", ..WATERTIGHT };

static SURFACE_GAP: Unit = Unit {
    name: "surface_gap",
    model: Some(|c, row, out| {
        let widths = [c.param("HEIGHT_W"), c.param("FRAC_W")];
        let codes = ["code_00", "code_10", "code_01", "code_11"].map(|p| row[p] as u32);
        let weights = ["weight_x", "weight_y"].map(|p| row[p] as u32);
        out["gap"] = gb::gap(c.design.format, widths, codes, weights, row["t"]);
    }),
    stimulus: Some(refined_hit),
    ..WATERTIGHT
};

static SECANT_STEP: Unit = Unit {
    name: "secant_step",
    model: Some(|c, row, out| {
        let (f, gaps) = (c.design.format, [row["gap_begin"], row["gap_end"]]);
        out["patch"] = gb::patch(f, gaps).code();
        out["t"] = gb::secant(f, [row["t_begin"], row["t_end"]], gaps);
    }),
    stimulus: Some(refined_hit),
    ..WATERTIGHT
};

static BILINEAR_HIT: Unit = Unit { name: "bilinear_hit", ..WATERTIGHT };
