//! Floating-point arithmetic, on which more than one datapath stands.
use super::super::unit::{Counted, UNIT, Unit};
use crate::bits::{mask, signed};
use crate::config::Part;
use crate::golden::float as gf;
use crate::proofs::{BIT_LEVEL, PROOF, Proof};
use std::cmp::Ordering;

/// The entries.
pub const UNITS: &[&Unit] = &[
    &FP_LT,
    &FP_ADD,
    &FP_MUL,
    &FP_DIV,
    &FP_FROM_INT,
    &FP_TO_INT,
    &FP_FROM_FIXED,
    &FP_TO_FIXED,
    &FP_SQRT,
    &FP_RECIP,
    &FP_COMPARE,
    &FP_ADD3,
];

/// Parameter values at which a solver compares whole arithmetic units.
const SMALL: &[(&str, i64)] = &[("EXP_W", 4), ("MAN_W", 3)];

const ROUNDED: Counted = Counted::Rounding { sum: false };
const ROUNDED_SUM: Counted = Counted::Rounding { sum: true };

static FP_LT: Unit = Unit {
    name: "fp_lt",
    clock: Some(("compare", Part::Traversal)),
    model: Some(|c, row, out| out["result"] = u64::from(gf::lt(c.design.format, row["a"], row["b"]))),
    counted: Counted::Answers,
    proofs: &[Proof {
        name: "fp_lt",
        units: &["fp_lt"],
        claim: "the order of the numbers, at full width",
        text: harness!("fp_lt"),
        ..PROOF
    }],
    ..UNIT
};

static FP_ADD: Unit = Unit {
    name: "fp_add",
    clock: Some(("add", Part::Traversal)),
    model: Some(|c, row, out| out["result"] = gf::add(c.design.format, row["a"], row["b"])),
    counted: ROUNDED_SUM,
    proofs: &[Proof {
        name: "fp_add",
        units: &["fp_add"],
        claim: "the exact sum, rounded once (4/3)",
        text: harness!("fp_add"),
        engine: BIT_LEVEL,
        over: SMALL,
        ..PROOF
    }],
    ..UNIT
};

/// The product; other units' proofs are about what it gives them.
pub(super) static FP_MUL: Unit = Unit {
    name: "fp_mul",
    clock: Some(("mul", Part::Traversal)),
    model: Some(|c, row, out| out["result"] = gf::mul(c.design.format, row["a"], row["b"])),
    counted: ROUNDED,
    proofs: &[Proof {
        name: "fp_mul",
        units: &["fp_mul"],
        claim: "the exact product, rounded once (4/3)",
        text: harness!("fp_mul"),
        engine: BIT_LEVEL,
        over: SMALL,
        ..PROOF
    }],
    ..UNIT
};

static FP_DIV: Unit = Unit {
    name: "fp_div",
    clock: Some(("div", Part::Traversal)),
    model: Some(|c, row, out| out["result"] = gf::div(c.design.format, row["a"], row["b"])),
    counted: ROUNDED,
    ..UNIT
};

static FP_FROM_INT: Unit = Unit {
    name: "fp_from_int",
    clock: Some(("from_int", Part::Traversal)),
    model: Some(|c, row, out| out["result"] = gf::from_int(c.design.format, signed(row["a"], c.param("INT_W")))),
    counted: ROUNDED,
    ..UNIT
};

static FP_TO_INT: Unit = Unit {
    name: "fp_to_int",
    clock: Some(("to_int", Part::Traversal)),
    model: Some(|c, row, out| {
        let w = c.param("INT_W");
        out["result"] = gf::to_int(c.design.format, row["a"], w) as u64 & mask(w);
    }),
    counted: Counted::RangeEnds,
    ..UNIT
};

static FP_FROM_FIXED: Unit = Unit {
    name: "fp_from_fixed",
    clock: Some(("from_int", Part::Alone)),
    model: Some(|c, row, out| {
        let a = signed(row["a"], c.param("INT_W"));
        out["result"] = gf::from_fixed(c.design.format, a, c.param("FRAC_W"));
    }),
    counted: ROUNDED,
    ..UNIT
};

static FP_TO_FIXED: Unit = Unit {
    name: "fp_to_fixed",
    clock: Some(("to_int", Part::Traversal)),
    model: Some(|c, row, out| {
        let w = c.param("INT_W");
        out["result"] = gf::to_fixed(c.design.format, row["a"], w, c.param("FRAC_W")) as u64 & mask(w);
    }),
    counted: Counted::RangeEnds,
    ..UNIT
};

static FP_SQRT: Unit = Unit {
    name: "fp_sqrt",
    clock: Some(("sqrt", Part::Beside)),
    model: Some(|c, row, out| out["result"] = gf::sqrt(c.design.format, row["a"])),
    counted: ROUNDED,
    ..UNIT
};

static FP_RECIP: Unit = Unit {
    name: "fp_recip",
    clock: Some(("div", Part::Alone)),
    model: Some(|c, row, out| out["result"] = gf::recip(c.design.format, row["a"])),
    counted: ROUNDED,
    ..UNIT
};

static FP_COMPARE: Unit = Unit {
    name: "fp_compare",
    clock: Some(("compare", Part::Alone)),
    model: Some(|c, row, out| {
        let order = gf::compare(c.design.format, row["a"], row["b"]);
        let is = |o: Option<Ordering>| u64::from(order == o);
        out["lt"] = is(Some(Ordering::Less));
        out["eq"] = is(Some(Ordering::Equal));
        out["gt"] = is(Some(Ordering::Greater));
        // A format without NaN has no such port.
        out.set("unordered", is(None));
    }),
    counted: Counted::Answers,
    ..UNIT
};

static FP_ADD3: Unit = Unit {
    name: "fp_add3",
    clock: Some(("add3", Part::Beside)),
    model: Some(|c, row, out| out["result"] = gf::add3(c.design.format, [row["a"], row["b"], row["c"]])),
    counted: ROUNDED_SUM,
    ..UNIT
};
