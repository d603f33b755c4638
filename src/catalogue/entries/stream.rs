//! Delay lines, handshakes, memories, and `traverse`: what has proofs, or rays for its vectors.
use super::super::unit::{UNIT, Unit};
use super::WIDTHS;
use crate::proofs::{BIT_LEVEL, Extra, PROOF, Proof, Reach};

/// The entries.
pub const UNITS: &[&Unit] =
    &[&DELAY_LINE, &SPILL_REGISTER, &SPILL_DATA, &CREDIT_FIFO, &FIFO_MEM, &HEIGHT_MEMORY, &HEIGHT_BANKS, &TRAVERSE];

static DELAY_LINE: Unit = Unit {
    name: "delay_line",
    model: Some(|_, row, out| out["out_data"] = row["in_data"]),
    bindings: WIDTHS,
    proofs: &[Proof {
        name: "delay_line",
        units: &["delay_line"],
        claim: "what as many registers in a row do, at every length, held and moving, for 40 clocks",
        text: harness!("delay_line"),
        engine: BIT_LEVEL,
        reach: Reach::Clocks(40),
        extra: Extra::DelayLines,
        ..PROOF
    }],
    ..UNIT
};

static SPILL_REGISTER: Unit = Unit {
    name: "spill_register",
    proofs: &[Proof {
        name: "spill_register",
        units: &["spill_register", SPILL_DATA.name],
        claim: "first in, first out, no word lost or duplicated, and a valid output is stable until it transfers, by induction",
        text: harness!("spill_register"),
        reach: Reach::Induction(10),
        extra: Extra::Registers(&[
            ("first_valid", "dut.first_valid"),
            ("second_valid", "dut.second_valid"),
            ("valid_q", "dut.valid_q"),
            ("wr_sel_q", "dut.wr_sel_q"),
            ("rd_sel_q", "dut.rd_sel_q"),
            ("out_of_reset", "dut.out_of_reset"),
            ("first_word", "word.first"),
            ("second_word", "word.second"),
        ]),
        ..PROOF
    }],
    ..UNIT
};

static SPILL_DATA: Unit = Unit { name: "spill_data", ..UNIT };

static CREDIT_FIFO: Unit = Unit {
    name: "credit_fifo",
    proofs: &[Proof {
        name: "credit_fifo",
        units: &["credit_fifo", FIFO_MEM.name],
        claim: "first in, first out, no occupied slot is overwritten, and a valid output is stable until it transfers, after a pipeline of any length, by induction",
        text: harness!("credit_fifo"),
        reach: Reach::Induction(24),
        extra: Extra::Registers(&[
            ("reserved", "dut.reserved"),
            ("occupancy", "dut.occupancy"),
            ("credit_q", "dut.credit_q"),
            ("issued", "dut.issued"),
            ("popped", "dut.popped"),
            ("valid_q", "dut.valid_q"),
        ]),
        ..PROOF
    }],
    ..UNIT
};

static FIFO_MEM: Unit = Unit { name: "fifo_mem", ..UNIT };

static HEIGHT_MEMORY: Unit = Unit { name: "height_memory", ..UNIT };

static HEIGHT_BANKS: Unit = Unit { name: "height_banks", ..UNIT };

static TRAVERSE: Unit = Unit {
    name: "traverse",
    proofs: &[Proof {
        name: "traverse",
        units: &["traverse"],
        claim: "no ray is lost or duplicated, and a valid result is stable until it transfers, by induction",
        text: harness!("traverse"),
        extra: Extra::RaysOfTheLoop { counted: harness!("traverse_counted") },
        ..PROOF
    }],
    ..UNIT
};
