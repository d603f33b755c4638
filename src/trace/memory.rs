//! What loading a pyramid leaves in the memories of `traverse`.
use crate::interp::Netlist;
use std::sync::Arc;

/// Banks of a copy of the map.
const BANKS: usize = 4;

/// The words of each memory of `net` that all copies of it share, after the words of the pyramid's image went through the load port: the pyramid itself, then the banks of each copy of
/// the map, which hold every fourth word of level 0.
///
/// # Panics
/// If a memory is neither.
pub fn images(net: &Netlist, image: &[u64]) -> Vec<Arc<Vec<u64>>> {
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
    let shared = || net.mems.iter().filter(|m| !m.own);
    let list: Vec<_> = shared().map(|m| m.depth).enumerate().map(one).collect();
    let fit = list.iter().zip(shared()).all(|(words, m)| words.len() == m.depth);
    assert!(fit, "an image of {} words fills no memories of this size", image.len());
    list
}
