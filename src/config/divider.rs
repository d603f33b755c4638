//! What a divider by table asks of the rest of the design.
use super::{Design, Divider};
use reliefrtl_base::error::{Error, Result};

impl Design {
    /// The fewest clocks of a divider by table: its memory has a register, and so has the result.
    pub const TABLE_CLOCKS: u32 = 2;
    /// The most fraction bits that one 18 x 18 multiplier a product takes.
    pub const TABLE_MAN: u32 = 16;
    /// The most bits of a fixed-point reciprocal whose last one the table's estimate misses by less than a half.
    pub const TABLE_RECIP: u32 = 31;

    /// Whether `fp_div`, or the `reciprocal` in fixed point, can be built as it is asked for.
    ///
    /// # Errors
    /// One sentence with all keys that don't fit `latency.divider`.
    pub fn check_divider(&self) -> Result<()> {
        let problems = self.divider_problems();
        if problems.is_empty() { Ok(()) } else { Err(Error::input(problems.join("; "))) }
    }

    /// Whether conversions alone can be built as they are asked for.
    ///
    /// # Errors
    /// One sentence with all keys of `convert` that don't fit the format.
    pub fn check_convert(&self) -> Result<()> {
        let problems = self.convert_problems();
        if problems.is_empty() { Ok(()) } else { Err(Error::input(problems.join("; "))) }
    }

    /// As [`Design::check_divider`], a sentence a problem.
    pub(super) fn divider_problems(&self) -> Vec<String> {
        let mut problems = Vec::new();
        if self.latency.divider == Divider::Rows {
            return problems;
        }
        let mut say = |text: String| problems.push(format!("latency.divider = \"table\" {text}"));
        let reads = self.datapath.kind.facts().reads;
        if reads.fraction_bits && self.datapath.reciprocal_bits > Self::TABLE_RECIP {
            let most = Self::TABLE_RECIP;
            say(format!(
                "multiplies in 18 x 18 bits: datapath.reciprocal_bits = {} is too large, 8 to {most} are legal",
                self.datapath.reciprocal_bits
            ));
        }
        if reads.format && self.format.man > Self::TABLE_MAN {
            let most = Self::TABLE_MAN;
            say(format!(
                "multiplies in 18 x 18 bits: format.man = {} is too large, 2 to {most} are legal",
                self.format.man
            ));
        }
        if self.latency.div < Self::TABLE_CLOCKS {
            let least = Self::TABLE_CLOCKS;
            say(format!(
                "has a register in its memory: latency.div = {} is too small, {least} to 32 are legal",
                self.latency.div
            ));
        }
        if reads.format && !self.format.is_plain() {
            say(format!(
                "needs format.rounding = \"nearest-even\", format.subnormals = \"flush\" and format.specials = \"ieee\": the format is {}",
                self.format
            ));
        }
        problems
    }
}
