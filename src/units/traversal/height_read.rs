//! The read of a node's height: one to four clocks, as `latency.memory` says.
use super::loop_state::Sizes;
use super::traverse::Load;
use super::{height_banks, height_memory, pyramid_words};
use crate::config::Design;
use crate::ir::{Builder, Module, Sig};
use std::sync::Arc;

/// The memory of a design: from two clocks on, banks with a register behind each.
pub fn memory(d: &Design) -> Arc<Module> {
    let n = d.traverse.levels;
    let (addr, depth) = (2 * n + 1, ((1 << (2 * n + 2)) - 1) / 3);
    if d.latency.memory > 1 {
        height_banks(addr, d.traverse.height_bits, depth)
    } else {
        height_memory(addr, d.traverse.height_bits, depth)
    }
}

/// Reads the height at `address`. A third clock stands behind the selection of the bank, a fourth before the memory.
pub(super) fn read<'b>(b: &'b Builder, s: &Sizes, d: &Design, load: &Load<'b>, address: Sig<'b>) -> Sig<'b> {
    let clocks = d.latency.memory;
    let mut params =
        vec![("ADDR_W", s.levels.clone() * 2 + 1), ("DATA_W", s.height.clone()), ("DEPTH", pyramid_words(&s.levels))];
    params.extend((clocks > 1).then(|| ("BANK_W", height_banks::bank_bits())));
    let address = if clocks > 3 { address.reg() } else { address };
    let ins = [("write_en", load.en), ("write_addr", load.addr), ("write_data", load.data), ("read_addr", address)];
    let height = b.inst(&memory(d), "u_heights", &params, &ins)[0].named("height");
    if clocks > 2 { height.reg() } else { height }
}
