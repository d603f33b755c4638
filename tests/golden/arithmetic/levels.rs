//! Tables of corners crossed whole: what they reach, that parts make a whole, and the units in the interpreter on them.
//!
//! `RELIEFRTL_LEVEL=2` takes the large tables at five formats (default: the small ones, and the large ones at 7/16).
use crate::float_units::FLOAT_UNITS;
use rayon::prelude::*;
use reliefrtl::catalogue::{campaign_set, check_interp, count_events, find};
use reliefrtl::config::Design;
use reliefrtl::format::{FloatFormat, Rounding, Specials, Subnormals};
use reliefrtl::golden::float::{self, Events, events};
use reliefrtl::ir::Binding;
use reliefrtl::vectors::{Campaign, Level, Plan, Shard, VectorSet};
use std::collections::BTreeMap;

fn set(format: FloatFormat, unit: &str, level: Level, shard: Shard) -> VectorSet {
    let d = Design { format, ..Design::default() };
    let m = find(&d, unit).unwrap();
    let mut set = campaign_set(&d, &m, &Binding::new(), Plan { rows: 4000, seed: 1 }, Campaign { level, shard });
    set.events = count_events(&d, &m, &set);
    set
}

#[test]
fn parts_make_the_whole() {
    for unit in ["fp_add", "fp_add3", "fp_sqrt", "fp_from_fixed", "fp_from_int"] {
        let whole = set(FloatFormat::FP24, unit, Level::One, Shard::WHOLE);
        let parts: Vec<VectorSet> =
            (1..=7).map(|index| set(FloatFormat::FP24, unit, Level::One, Shard { index, of: 7 })).collect();
        let sizes: Vec<usize> = parts.iter().map(|p| p.stimulus.len()).collect();
        assert!(sizes.iter().all(|n| n.abs_diff(sizes[0]) <= 1), "{unit}: {sizes:?}");
        let mut events: BTreeMap<String, usize> = BTreeMap::new();
        parts.iter().flat_map(|p| &p.events).for_each(|(name, n)| *events.entry(name.clone()).or_default() += n);
        assert_eq!(events, whole.events, "{unit}");
        // Row by row in turn, as they were dealt.
        let joined: Vec<&Vec<u64>> = (0..whole.stimulus.len()).map(|k| &parts[k % 7].stimulus[k / 7]).collect();
        assert!(joined.into_iter().eq(&whole.stimulus), "{unit}");
    }
    assert!("3/16".parse::<Shard>().is_ok());
    for wrong in ["0/4", "5/4", "1", "1/0", "a/b"] {
        let e = wrong.parse::<Shard>().unwrap_err().to_string();
        assert!(e.contains("3/16 is the third of 16 parts"), "{e}");
    }
}

/// What the small tables and 4000 random rows must reach in each unit at 7/16; what is left out can't be: no quotient or root is a tie,
/// sums don't round when they are small, the reciprocal of no normal number is too large.
const REACHED: &[(&str, &[&str])] = &[
    (
        "fp_add",
        &[
            "exact",
            "tie",
            "sticky only",
            "above half",
            "carry out of rounding",
            "cancellation by one bit",
            "cancellation by many bits",
            "cancellation to zero",
            "overflow",
            "overflow by rounding",
            "underflow",
            "zero",
        ],
    ),
    (
        "fp_add3",
        &[
            "exact",
            "tie",
            "sticky only",
            "above half",
            "carry out of rounding",
            "cancellation by one bit",
            "cancellation by many bits",
            "cancellation to zero",
            "overflow",
            "zero",
        ],
    ),
    (
        "fp_mul",
        &[
            "exact",
            "tie",
            "sticky only",
            "above half",
            "carry out of rounding",
            "overflow",
            "overflow by rounding",
            "underflow",
            "up to the smallest normal number by rounding",
            "zero",
        ],
    ),
    ("fp_div", &["exact", "sticky only", "above half", "overflow", "underflow", "zero"]),
    ("fp_recip", &["exact", "sticky only", "above half", "underflow", "zero"]),
    ("fp_sqrt", &["exact", "sticky only", "above half", "infinity or NaN", "zero"]),
    ("fp_from_fixed", &["exact", "tie", "sticky only", "above half", "carry out of rounding", "zero"]),
    ("fp_compare", &["lt = 1", "eq = 1", "gt = 1", "unordered = 1"]),
    ("fp_lt", &["result = 0", "result = 1"]),
    ("fp_to_int", &["largest", "smallest", "zero", "minus one"]),
    ("fp_to_fixed", &["largest", "smallest", "zero", "minus one"]),
];

#[test]
fn small_tables_reach_every_event() {
    for (unit, wanted) in REACHED {
        let found = set(FloatFormat::FP24, unit, Level::One, Shard::WHOLE).events;
        println!("{unit}: {found:?}");
        for name in *wanted {
            assert!(found.get(*name).is_some_and(|n| *n > 0), "{unit} never reaches {name}: {found:?}");
        }
    }
}

/// Rows worked by hand at 7/16 (bias 63), and which events they are.
#[test]
fn events_of_known_rows() {
    let f = FloatFormat::FP24;
    let down = FloatFormat { rounding: Rounding::Up, ..f };
    let soft = FloatFormat { subnormals: Subnormals::Gradual, ..f };
    let full = FloatFormat { specials: Specials::Finite, ..f };
    let one = 63u64 << 16;
    let minus = f.sign_bit();
    let power = |e: i64| ((63 + e) as u64) << 16;
    let largest = f.infinity() - 1;
    type Row = (FloatFormat, u64, u64, Events, &'static [Events]);
    let sums: [Row; 11] = [
        (f, one, power(-17), Events::TIE, &[]),
        (f, one, power(-18), Events::STICKY, &[]),
        (f, one, power(-17) + 1, Events::ABOVE, &[]),
        (f, one + 0xffff, power(-17), Events::TIE, &[Events::CARRY]),
        (down, one + 0xffff, power(-30), Events::STICKY, &[Events::CARRY]),
        (f, one, minus | (one + 1), Events::EXACT, &[Events::CANCEL_MANY]),
        (f, power(1), minus | one, Events::EXACT, &[Events::CANCEL_ONE]),
        (f, largest, largest, Events::EXACT, &[Events::OVERFLOW]),
        (f, largest, power(63 - 17), Events::TIE, &[Events::OVERFLOW_ROUNDED, Events::CARRY]),
        // Without infinities, numbers go on for one more exponent.
        (full, largest, power(63 - 17), Events::TIE, &[Events::CARRY]),
        (
            soft,
            1 << 16,
            minus | (1 << 16 | 1),
            Events::EXACT,
            &[Events::CANCEL_MANY, Events::UNDERFLOW, Events::SUBNORMAL],
        ),
    ];
    for (k, (fmt, a, b, exactness, others)) in sums.into_iter().enumerate() {
        let e = events(fmt, true, &[a, b], &[true, true], &|w, x| float::add(w, x[0], x[1]));
        let mut named: Vec<Events> = Events::ALL.iter().map(|x| x.0).filter(|x| e.has(*x)).collect();
        let mut wanted = [&[exactness], others].concat();
        let order = |x: &Events| Events::ALL.iter().position(|y| y.0 == *x);
        named.sort_by_key(order);
        wanted.sort_by_key(order);
        assert_eq!(named, wanted, "sum {k}");
    }
    let all = |e: Events, wanted: &[Events]| wanted.iter().all(|w| e.has(*w));
    let mul = |fmt, a: u64, b: u64| events(fmt, false, &[a, b], &[true, true], &|w, x| float::mul(w, x[0], x[1]));
    // 1.5 times 4/3 cut to 17 bits is 2 - 2^-17: half-way between two numbers, and the even one is the smallest normal number.
    assert!(all(mul(f, 0x01_8000, 0x3e_5555), &[Events::TIE, Events::NOT_UNDERFLOW, Events::CARRY]));
    // Exact in 17 bits, so rounding does not save it.
    assert!(all(mul(f, 0x01_0000, 0x3e_ffff), &[Events::EXACT, Events::UNDERFLOW, Events::VANISHES]));
    assert!(all(mul(f, 1 << 16, power(-3)), &[Events::EXACT, Events::UNDERFLOW, Events::VANISHES]));
    // As a subnormal number it has its places, and ties stand at them.
    let e = mul(soft, 1 << 16, power(-3));
    assert!(all(e, &[Events::EXACT, Events::SUBNORMAL]) && !e.has(Events::VANISHES));
    assert!(all(mul(soft, 1 << 16 | 1, power(-1)), &[Events::TIE, Events::SUBNORMAL]));
    assert!(all(mul(soft, 1, power(-1)), &[Events::TIE, Events::VANISHES]));
    assert!(all(mul(soft, 1, power(-2)), &[Events::STICKY, Events::VANISHES]));
    assert!(all(mul(f, f.infinity(), one), &[Events::SPECIAL]) && all(mul(f, 0, one), &[Events::ZERO]));
}

#[test]
fn units_equal_their_models_on_crossed_corners() {
    let all = std::env::var("RELIEFRTL_LEVEL").is_ok_and(|v| v == "2");
    let mut cases = Vec::new();
    for (exp, man) in [(7, 16), (5, 10), (8, 23), (6, 9), (4, 12)] {
        for &unit in FLOAT_UNITS.iter() {
            let level = if all || (exp, man) == (7, 16) { Level::Two } else { Level::One };
            cases.push((FloatFormat::new(exp, man), unit, level));
        }
    }
    let check = |(format, unit, level): &(FloatFormat, &str, Level)| {
        let d = Design { format: *format, ..Design::default() };
        let m = find(&d, unit).unwrap();
        let s = campaign_set(
            &d,
            &m,
            &Binding::new(),
            Plan { rows: 4000, seed: 2 },
            Campaign { level: *level, shard: Shard::WHOLE },
        );
        let report = check_interp(&m, &s).unwrap();
        report.verdict(&s, &m).unwrap_or_else(|e| panic!("{format}: {e}"));
        report.checked
    };
    let total: usize = cases.par_iter().map(check).sum();
    println!("{} units and formats: 0 of {total} mismatched", cases.len());
    assert!(total > 2_000_000, "{total}");
}
