//! Four sibling cells judged in one iteration (`docs/cells.md`): the units that both watertight datapaths share, the memory's words, the iteration.
mod block_descent;
mod block_middle;
mod cell_choice;
mod iteration;
mod search;

pub use block_descent::{block_descent, reads_crossed};
pub use block_middle::block_middle;
pub use cell_choice::{CELLS, ORDER};

pub(super) use cell_choice::cell_choice;
pub(super) use iteration::block_iteration;
pub(super) use search::{BLOCKS, cells_level};

use reliefrtl_config::Design;
use reliefrtl_ir::Expr;

/// Words of a memory that holds one of four siblings of every block: (4^LEVELS - 1) / 3.
pub(super) fn block_words(levels: &Expr) -> Expr {
    ((levels.clone() * 2).pow2() - 1).div(3)
}

/// Bits of a block's address.
pub(super) fn block_address(levels: &Expr) -> Expr {
    levels.clone() * 2 - 1
}

/// Address bits and words of such a memory at the design's sizes.
pub(super) fn block_memory(d: &Design) -> (u32, u32) {
    let n = d.traverse.levels;
    (2 * n - 1, ((1 << (2 * n)) - 1) / 3)
}
