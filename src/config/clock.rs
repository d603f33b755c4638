//! Latencies for a clock, from a table of measurements.
//!
//! The clocks are those of units alone on an ECP5 (85k, speed grade 8) at 1/7/16: medians of three seeds, `docs/clocks.md` has the commands. A
//! traversal around them is slower, by the share that the profiles came out at when they were placed and routed whole.
use super::{DatapathKind, LatencyConfig};

/// Clocks of one kind of unit: latency and MHz, the slowest first.
struct Curve {
    key: &'static str,
    points: &'static [(u32, u32)],
    set: fn(&mut LatencyConfig, u32),
}

/// Every kind of unit; of two that share a key, the slower one.
const CURVES: [Curve; 8] = [
    Curve {
        key: "add",
        points: &[(1, 74), (2, 125), (3, 162), (4, 195), (5, 236), (6, 256)],
        set: |l, n| l.add = n,
    },
    Curve { key: "mul", points: &[(1, 97), (2, 176), (3, 177)], set: |l, n| l.mul = n },
    Curve {
        key: "div",
        points: &[(2, 34), (4, 54), (6, 82), (8, 108), (10, 114), (14, 152), (20, 195)],
        set: |l, n| l.div = n,
    },
    Curve { key: "compare", points: &[(1, 204), (2, 256)], set: |l, n| l.compare = n },
    Curve { key: "from_int", points: &[(1, 134), (2, 137), (3, 195), (4, 197)], set: |l, n| l.from_int = n },
    Curve { key: "to_int", points: &[(1, 115), (2, 169), (3, 210), (4, 214)], set: |l, n| l.to_int = n },
    Curve {
        key: "sqrt",
        points: &[(2, 41), (4, 60), (6, 91), (8, 110), (12, 162), (20, 270)],
        set: |l, n| l.sqrt = n,
    },
    Curve {
        key: "add3",
        points: &[(2, 62), (3, 82), (4, 98), (6, 118), (8, 160), (12, 173)],
        set: |l, n| l.add3 = n,
    },
];

