//! The golden model beside Berkeley SoftFloat at 8/23: corners crossed with each other, then random words, in each rounding that both have.
mod peer;

use peer::{OPERATIONS, ROUNDINGS, differing};
use reliefrtl::catalogue::campaign_set;
use reliefrtl::config::Config;
use reliefrtl::format::Subnormals;
use reliefrtl::ir::Binding;
use reliefrtl::project::alone;
use reliefrtl::vectors::{Campaign, Level, Plan, Shard};

/// Random operands of an operation; RELIEFRTL_PAIRS sets another number.
fn random() -> usize {
    std::env::var("RELIEFRTL_PAIRS").ok().map_or(200_000, |n| n.parse().expect("a number of operands"))
}

/// Level-1 corners crossed with each other, and random words.
fn operands(unit: &str) -> Vec<(u64, u64)> {
    let mut c = Config::default();
    (c.format.exp, c.format.man, c.format.subnormals) = (8, 23, Subnormals::Gradual);
    let module = alone(&c, unit).expect("a unit of arithmetic");
    let campaign = Campaign { level: Level::One, shard: Shard::WHOLE };
    let set = campaign_set(&c.design(), &module, &Binding::new(), Plan { rows: random(), seed: 1 }, campaign);
    set.stimulus.iter().map(|r| (r[0], r.get(1).copied().unwrap_or(0))).collect()
}

#[test]
fn golden_equals_softfloat() {
    for o in &OPERATIONS {
        let pairs = operands(o.unit);
        assert!(pairs.len() > random());
        for (number, rounding) in ROUNDINGS.iter().enumerate() {
            let (wrong, first) = differing(o, number, &pairs);
            assert_eq!(wrong, 0, "{}, {rounding:?}: {wrong} of {} differ, first at {first:x?}", o.unit, pairs.len());
        }
        println!("{}: 0 of {} operands differ in each of {} roundings", o.unit, pairs.len(), ROUNDINGS.len());
    }
}

#[test]
fn another_rounding_differs() {
    let pairs = operands("fp_add");
    let up = peer::Operation {
        golden: |f, a, b| {
            reliefrtl::golden::float::add(reliefrtl::format::FloatFormat { rounding: ROUNDINGS[3], ..f }, a, b)
        },
        ..OPERATIONS[0]
    };
    assert!(differing(&up, 0, &pairs).0 > 1000);
}
