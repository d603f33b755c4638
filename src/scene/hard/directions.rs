//! Cases about the ray's direction and length.
use super::case::Case;
use super::draw::Draw;

pub(super) const CASES: &[Case] = &[
    Case::new("axis", "along one axis only, either sign of zero for the other", |d| {
        (d.rough(), |d| {
            let zero = d.signed(0.0);
            let (u, v, travel) = (d.entry(), d.border(), d.travel(1.0));
            if d.coin() { [u, v, travel, zero] } else { [v, u, zero, travel] }
        })
    }),
    Case::new("straight-down", "no travel at all, from anywhere and from corners, either sign of both zeros", |d| {
        (d.noise(), |d| {
            let p = if d.coin() { [d.entry(), d.entry()] } else { [d.border(), d.border()] };
            [p[0], p[1], d.signed(0.0), d.signed(0.0)]
        })
    }),
    Case::new("corners", "through texel corners: both planes at once, again and again", |d| {
        (d.rough(), |d| {
            let travel = d.whole_travel();
            // Twice or half as fast along the other axis meets corners too, every second texel.
            let (other, (u, v)) = (d.signed(travel) * d.pick(&[1.0, 1.0, 0.5, 2.0]), (d.border(), d.border()));
            [u, v, travel, other]
        })
    }),
    Case::new("edges", "exactly along the borders of nodes of every level", |d| {
        (d.rough(), |d| {
            let (edge, u, travel, zero) = (d.node_border(), d.entry(), d.travel(1.0), d.signed(0.0));
            if d.coin() { [edge, u, zero, travel] } else { [u, edge, travel, zero] }
        })
    }),
    Case::new("node-corners", "through the corners of nodes of every level, to a corner", |d| {
        (d.noise(), |d| {
            let travel = d.whole_travel();
            [d.node_border(), d.node_border(), travel, d.signed(travel)]
        })
    }),
    Case::new("diagonal", "both components of the travel equal, from anywhere", |d| {
        (d.rough(), |d| {
            let travel = d.travel(1.0);
            [d.entry(), d.entry(), travel, d.signed(travel)]
        })
    }),
    Case::new("octants", "the same slope in all eight octants, from the same points", |d| {
        (d.rough(), |d| {
            let (slow, fast) = (d.numbers.tiles(3.0), d.numbers.tiles(11.0));
            let (slow, fast) = (d.signed(slow), d.signed(fast));
            let (u, v) = (d.border(), d.border());
            if d.coin() { [u, v, slow, fast] } else { [u, v, fast, slow] }
        })
    }),
    Case::new(
        "shortest",
        "travels of the smallest numbers of the format, one or both, from borders and from inside",
        |d| {
            (d.rough(), |d| {
                let tiny = |d: &mut Draw| {
                    let places = d.below(4) as i32;
                    let tiny = d.numbers.nudge(d.numbers.smallest(), places);
                    d.signed(tiny)
                };
                let other = if d.coin() { tiny(d) } else { d.travel(1.0) };
                let (u, v) = if d.coin() { (d.border(), d.entry()) } else { (d.entry(), d.entry()) };
                [u, v, tiny(d), other]
            })
        },
    ),
    Case::new("longest", "travels of the largest numbers of the format, one or both", |d| {
        let map = single_peak(d);
        (map, |d| {
            let places = -(d.below(4) as i32);
            let most = d.numbers.nudge(d.numbers.longest(), places);
            let (most, other) = (d.signed(most), d.pick(&[0.0, 1.0, 2.0]));
            let other = if other == 1.0 { d.travel(1.0) } else { other / 2.0 * most };
            let (u, v) = (d.entry(), d.entry());
            if d.coin() { [u, v, most, other] } else { [u, v, other, most] }
        })
    }),
    Case::new("steep", "travels of less than a texel, down to a thousandth of one", |d| {
        (d.noise(), |d| {
            let (a, b) = (d.real(-1.0, 1.0), d.real(-1.0, 1.0));
            let short = 2f64.powf(-d.real(0.0, 10.0));
            [d.entry(), d.entry(), d.numbers.tiles(a * short), d.numbers.tiles(b * short)]
        })
    }),
    Case::new("tiles", "half the longest travel and more, over many tiles of low hills", |d| {
        let map = low(d);
        (map, |d| {
            let most = d.numbers.longest();
            let (a, b) = (d.real(0.5, 1.0) * most, d.real(-1.0, 1.0) * most);
            let a = d.signed(a);
            if d.coin() { [d.entry(), d.entry(), a, b] } else { [d.entry(), d.entry(), b, a] }
        })
    }),
];

/// One texel at full height, a floor of 0: long rays miss it tile by tile.
fn single_peak(d: &Draw) -> Vec<u32> {
    let (middle, top) = (d.numbers.side() / 2, d.numbers.top);
    d.map(|i, j| if (i, j) == (middle, middle) { top } else { 0 })
}

/// Hills in the lowest eighth.
fn low(d: &Draw) -> Vec<u32> {
    d.rough().iter().map(|code| code / 8).collect()
}
