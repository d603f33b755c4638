//! Which operands a unit can get, as a condition over bits: a second time, beside the catalogue's, which makes a row legal.
use super::aig::{Aig, Lit, TRUE};
use super::blast::{Bits, difference};
use reliefrtl::config::Design;
use std::collections::BTreeMap;

/// 1 where the operands of `unit` are legal. Ports of a level hold at most `levels`.
pub fn legal(unit: &str, levels: u32, g: &mut Aig, ports: &BTreeMap<&str, Bits>) -> Lit {
    let mut all = TRUE;
    for port in ["level", "start"].into_iter().filter_map(|p| ports.get(p)) {
        let exists = at_most(g, port, u64::from(levels));
        all = g.and(all, exists);
    }
    // A finest level above the pyramid is legal at `finest_level` alone, which has a start.
    if let (Some(lod), false) = (ports.get("lod"), ports.contains_key("start")) {
        let exists = at_most(g, lod, u64::from(levels));
        all = g.and(all, exists);
    }
    match unit {
        "multi_level_down" => {
            let root = at_most(g, &ports["level"], 0);
            all = g.and(all, root ^ 1);
            for (low, high) in [("x_low", "x_high"), ("y_low", "y_high")] {
                let swapped = above(g, &ports[low], &ports[high]);
                all = g.and(all, swapped ^ 1);
            }
        }
        // The travel is a number: its exponent is not all ones.
        "axis_slope" => {
            let dn = &ports["dn"];
            let man = Design::default().format.man as usize;
            let ones = dn[man..dn.len() - 1].iter().fold(TRUE, |all, bit| g.and(all, *bit));
            all = g.and(all, ones ^ 1);
        }
        // A bit of headroom: the sign stands twice.
        "level_up" => {
            for port in ["x_at", "x_hit", "y_at", "y_hit"].into_iter().filter_map(|p| ports.get(p)) {
                let [.., next, top] = port[..] else { panic!("a coordinate of a bit") };
                let apart = g.xor(next, top);
                all = g.and(all, apart ^ 1);
            }
        }
        _ => {}
    }
    all
}

/// Unsigned, against a constant.
fn at_most(g: &mut Aig, word: &Bits, most: u64) -> Lit {
    let most: Bits = (0..word.len()).map(|k| Lit::from(most >> k & 1 == 1)).collect();
    difference(g, &most, word, word.len()).1 ^ 1
}

/// Whether `a` is more than `b`, both signed and of equal widths.
fn above(g: &mut Aig, a: &Bits, b: &Bits) -> Lit {
    let flip = |x: &Bits| -> Bits { x.iter().enumerate().map(|(k, l)| l ^ Lit::from(k + 1 == x.len())).collect() };
    let (a, b) = (flip(a), flip(b));
    difference(g, &b, &a, a.len()).1
}
