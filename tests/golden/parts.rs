//! The integer parts of the golden model, each against a second way to say the same.
use proptest::prelude::*;
use reliefrtl::config::{Design, LevelUp, TraverseConfig};
use reliefrtl::format::FloatFormat;
use reliefrtl::golden::{Crossing, Datapath, Pyramid, Watertight, address, descend_levels, level_up, start_level};

#[test]
fn addresses_leave_no_gap_and_keep_children_together() {
    for n in 1..=7 {
        let mut seen = vec![false; ((4usize << (2 * n)) - 1) / 3];
        let mut base = 0;
        for k in 0..=n {
            let side = 1u32 << (n - k);
            for j in 0..side {
                for i in 0..side {
                    let at = address(n, k, i, j);
                    assert!(!std::mem::replace(&mut seen[at], true), "{n} {k} {i} {j}");
                    let mut morton = 0;
                    for b in 0..n {
                        morton += ((i as usize >> b) % 2) << (2 * b);
                        morton += ((j as usize >> b) % 2) << (2 * b + 1);
                    }
                    assert_eq!(at, base + morton);
                    assert_eq!(at, base | morton, "base and index overlap");
                }
            }
            base += (side * side) as usize;
        }
        assert!(seen.into_iter().all(|s| s));
        assert_eq!(address(n, n, 0, 0), base - 1, "the root is the last word");
    }
}

#[test]
fn every_node_is_the_maximum_of_its_texels() {
    let (n, side) = (5, 32usize);
    let texels: Vec<u32> = (0..side * side).map(|a| (a * a * 7919 + a * 31) as u32 % 1021).collect();
    let pyramid = Pyramid::build(n, 10, &texels).unwrap();
    assert_eq!(pyramid.memory().len(), (4usize.pow(n + 1) - 1) / 3);
    for k in 0..=n {
        for j in 0..side >> k {
            for i in 0..side >> k {
                let block = (0..1 << k).flat_map(|b| (0..1 << k).map(move |a| (a, b)));
                let most = block.map(|(a, b)| texels[((j << k) + b) * side + (i << k) + a]).max().unwrap();
                assert_eq!(pyramid.node(k, i as u32, j as u32), most);
                assert_eq!(pyramid.memory()[address(n, k, i as u32, j as u32)], most);
            }
        }
    }
}

#[test]
fn wrong_maps_are_refused() {
    let refused = |n, h, texels: &[u32]| Pyramid::build(n, h, texels).unwrap_err().to_string();
    assert_eq!(refused(1, 8, &[0; 5]), "the map has 5 texels, 2 x 2 are needed");
    assert_eq!(refused(1, 8, &[0, 0, 0, 256]), "texel (1, 1) has height code 256, more than 8 bits");
    assert!(refused(13, 8, &[]).contains("1 to 12 levels"));
}

#[test]
fn illegal_designs_are_refused() {
    let with = |format, levels, height_bits, tile_bits| {
        let traverse = TraverseConfig { levels, height_bits, tile_bits, ..TraverseConfig::default() };
        Watertight::prepare(&Design { format, traverse, ..Design::default() }).is_ok()
    };
    let fmt = FloatFormat::new;
    assert!(with(fmt(7, 16), 12, 16, 8) && with(fmt(5, 10), 4, 11, 3) && with(fmt(8, 23), 2, 2, 1));
    assert!(!with(fmt(7, 16), 1, 8, 4) && !with(fmt(7, 16), 13, 8, 4), "levels");
    assert!(!with(fmt(7, 16), 8, 17, 4) && !with(fmt(7, 7), 8, 9, 4), "heights");
    assert!(!with(fmt(5, 10), 7, 8, 8) && with(fmt(5, 10), 7, 8, 7), "exponents too short for the map");
    assert!(!with(fmt(5, 18), 2, 8, 1) && with(fmt(5, 17), 2, 8, 1), "exponents too short for the bias");
}

/// The start level as the contract writes it: from the leading one of the differing bits.
fn start_level_by_xor(n: u32, idx_w: u32, x: i64, y: i64, xa: i64, ya: i64) -> u32 {
    let m = (((x ^ xa) | (y ^ ya)) as u64) & ((1 << idx_w) - 1);
    n.min(u64::BITS - m.leading_zeros())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(5000) })]

    #[test]
    fn start_level_is_the_leading_difference(
        n in 2u32..=12, tile in 1u32..=8, x in 0i64..4096, y in 0i64..4096, dx in -(1i64 << 20)..1 << 20, dy in -(1i64 << 20)..1 << 20, s in 0u32..20
    ) {
        let idx_w = n + tile + 2;
        let (x, y) = (x % (1 << n), y % (1 << n));
        let end = |a: i64, d: i64| (a + (d >> s)).clamp(-(1 << (idx_w - 1)), (1 << (idx_w - 1)) - 1);
        let (xa, ya) = (end(x, dx), end(y, dy));
        let level = start_level(n, idx_w, x, y, xa, ya);
        prop_assert_eq!(level, start_level_by_xor(n, idx_w, x, y, xa, ya));
    }

    #[test]
    fn level_up_rules(level in 0u32..=12, x in -(1i64 << 20)..1 << 20, y in -(1i64 << 20)..1 << 20, ex in -3i64..=3, ey in -3i64..=3, previous: bool, neg: bool) {
        let mask = (1i64 << level) - 1;
        let plane = if neg { x & !mask } else { (x | mask) + 1 };
        let c = Crossing { level, plane, x, y, e_x: x + (ex << level), e_y: y + (ey << level), previous };
        let beyond = if neg { plane - 1 } else { plane };
        let exits_parent = beyond >> (level + 1) != x >> (level + 1);
        prop_assert!(!level_up(LevelUp::None, &c) && level_up(LevelUp::Always, &c));
        prop_assert_eq!(level_up(LevelUp::Tevs, &c), exits_parent);
        prop_assert_eq!(level_up(LevelUp::Coherent, &c), previous);
        let neighbour = ex.abs().max(ey.abs()) == 1;
        prop_assert_eq!(level_up(LevelUp::Selective, &c), exits_parent && !neighbour);
    }

    #[test]
    fn descents_stay_in_the_pyramid(down in 1u32..=4, k in 1u32..=12, crossed: bool) {
        let s = descend_levels(down, k, crossed);
        prop_assert!(s >= 1 && s <= k && (s == 1 || (!crossed && s == down)));
    }
}
