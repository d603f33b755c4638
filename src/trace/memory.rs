//! What loading a map leaves in the memories of `traverse`.
use crate::config::Design;
use crate::golden::{self, Pyramid};
use crate::interp::Netlist;
use std::sync::Arc;

/// All words that go through the load ports of a design, in their order.
pub fn image(d: &Design, pyramid: &Pyramid) -> Vec<u64> {
    golden::images(d, pyramid).into_iter().flat_map(|image| image.words).map(u64::from).collect()
}

/// Banks of a copy of the map.
const BANKS: usize = 4;

/// The words of each memory of `net` that all copies of it share, after the words of the image went through the load ports: one memory's after the
/// other's where that is the whole image; every fourth word where each of four siblings has a memory of its own; else the image itself, then the banks of each copy of the map, which hold every fourth word of its begin.
///
/// # Panics
/// If a memory is neither.
pub fn images(net: &Netlist, image: &[u64]) -> Vec<Arc<Vec<u64>>> {
    let shared = || net.mems.iter().filter(|m| !m.own);
    if shared().map(|m| m.depth).sum::<usize>() == image.len() {
        let mut rest = image;
        let next = |depth: usize| {
            let (words, after) = rest.split_at(depth);
            rest = after;
            Arc::new(words.to_vec())
        };
        return shared().map(|m| m.depth).map(next).collect();
    }
    let depth = image.len() / BANKS;
    if shared().count() == BANKS && shared().all(|m| m.depth == depth) {
        // Siblings in memories of their own; the root is in none.
        let sibling = |k: usize| Arc::new(image.iter().skip(k).step_by(BANKS).take(depth).copied().collect());
        return (0..BANKS).map(sibling).collect();
    }
    let mut banks: Vec<Option<Arc<Vec<u64>>>> = vec![None; BANKS];
    let mut of = |k: usize, depth: usize| {
        let bank = k % BANKS;
        let words = || Arc::new(image.iter().skip(bank).step_by(BANKS).take(depth).copied().collect());
        banks[bank].get_or_insert_with(words).clone()
    };
    let whole = Arc::new(image.to_vec());
    let one = |(k, depth): (usize, usize)| match k.checked_sub(1) {
        None => whole.clone(),
        Some(k) => of(k, depth),
    };
    let list: Vec<_> = shared().map(|m| m.depth).enumerate().map(one).collect();
    let fit = list.iter().zip(shared()).all(|(words, m)| words.len() == m.depth);
    assert!(fit, "an image of {} words fills no memories of this size", image.len());
    list
}
