//! The size of a design before synthesis, counted on its elaborated netlist: simple, the same everywhere, and good enough to rank.
use crate::config::Design;
use crate::error::Result;
use crate::interp::{Kind, elaborate};
use crate::ir::Binding;
use crate::units::traversal::traverse;
use serde::Serialize;

/// Bits of hardware. Wiring (slices, joins, extensions) is free.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Cost {
    /// Result bits of additions, comparisons, selections, shifts (times their depth) and gates.
    pub logic: u64,
    /// Products of the operand widths of multiplications, and of rows and width of divisions.
    pub products: u64,
    /// Register bits.
    pub registers: u64,
    /// Bits of the height pyramid and of tables.
    pub memory: u64,
    /// Block memories of 18 kbit that the heights take.
    pub blocks: u64,
}

impl Cost {
    /// Counts `traverse` of a design.
    ///
    /// # Errors
    /// A design that its own modules refuse.
    pub fn of(d: &Design) -> Result<Self> {
        let net = elaborate(&traverse(d).module, &Binding::new())?;
        let width = |s: u32| u64::from(net.widths[s as usize]);
        let mut c = Self::default();
        for op in &net.ops {
            let (w, a) = (u64::from(op.width), u64::from(op.arg_width));
            match op.kind {
                Kind::Copy | Kind::Join | Kind::Slice | Kind::Sext | Kind::Rep | Kind::Interleave => {}
                Kind::Mul => c.products += a * width(op.args[1]),
                // Quotient and remainder are one circuit.
                Kind::DivQuot => c.products += w * width(op.args[1]),
                Kind::DivRem => {}
                Kind::RecipTable => c.memory += w << a,
                Kind::Shl | Kind::Shr | Kind::Sar => c.logic += w * u64::from(w.next_power_of_two().ilog2()),
                Kind::RedOr | Kind::RedAnd | Kind::Eq | Kind::Ult | Kind::Slt | Kind::Lzc => c.logic += a,
                Kind::Not => {}
                Kind::And | Kind::Or | Kind::Xor | Kind::Add | Kind::Sub | Kind::Mux => c.logic += w,
            }
        }
        c.registers = net.regs.iter().map(|r| width(r.q)).sum();
        c.blocks = net.mems.iter().map(|m| blocks(m.depth as u64, width(m.read_data))).sum();
        c.memory += net.mems.iter().map(|m| m.depth as u64 * width(m.read_data)).sum::<u64>();
        Ok(c)
    }

    /// Logic, products and registers together: what competes for area besides the memory.
    pub const fn bits(&self) -> u64 {
        self.logic + self.products + self.registers
    }
}

/// Words up to which a memory is made of look-up tables.
const SMALL: u64 = 64;

/// Shapes of a block memory of 18 kbit: words, bits of a word (Lattice FPGA-TN-02204, table 1; other vendors' are alike).
const SHAPES: [(u64, u64); 6] = [(16384, 1), (8192, 2), (4096, 4), (2048, 9), (1024, 18), (512, 36)];

/// Block memories of 18 kbit of so many words, in the shape that takes the fewest.
fn blocks(words: u64, bits: u64) -> u64 {
    let all = SHAPES.iter().map(|(depth, width)| words.div_ceil(*depth) * bits.div_ceil(*width));
    if words > SMALL { all.min().unwrap_or(0) } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_are_those_that_a_part_has() {
        // 256 x 256 codes; with all their levels; a slot memory; 65 words of two codes.
        let all = [((65536, 8), 32), ((87381, 8), 43), ((12, 212), 0), ((65, 16), 1)];
        assert_eq!(all.map(|((words, bits), _)| blocks(words, bits)), all.map(|(_, n)| n));
    }
}
