//! Delay lines, handshakes, memories, and `traverse`: what has proofs, or rays for its vectors.
use super::super::clocked::Step;
use super::super::row::{Context, Row};
use super::super::unit::{UNIT, Unit};
use super::WIDTHS;
use crate::bits::mask;
use crate::proofs::{Extra, INVARIANT, PROOF, Proof, Reach};
use std::collections::VecDeque;

/// The entries.
pub const UNITS: &[&Unit] =
    &[&DELAY_LINE, &SPILL_REGISTER, &CREDIT_FIFO, &FIFO_MEM, &FIFO, &ARBITER, &HEIGHT_MEMORY, &HEIGHT_BANKS, &TRAVERSE];

static DELAY_LINE: Unit = Unit {
    name: "delay_line",
    model: Some(|_, row, out| out["out_data"] = row["in_data"]),
    bindings: WIDTHS,
    proofs: &[Proof {
        name: "delay_line",
        units: &["delay_line"],
        claim: "what as many registers in a row do, at every length, held and moving, by induction",
        text: harness!("delay_line"),
        engine: INVARIANT,
        reach: Reach::Induction(1),
        extra: Extra::DelayLines,
        ..PROOF
    }],
    ..UNIT
};

static SPILL_REGISTER: Unit = Unit {
    name: "spill_register",
    proofs: &[Proof {
        name: "spill_register",
        units: &["spill_register"],
        claim: "first in, first out, no word lost or duplicated, and a valid output is stable until it transfers, by induction",
        text: harness!("spill_register"),
        reach: Reach::Induction(10),
        extra: Extra::Registers(&[
            ("first_valid", "dut.first_valid"),
            ("second_valid", "dut.second_valid"),
            ("valid_q", "dut.valid_q"),
            ("wr_sel_q", "dut.wr_sel_q"),
            ("rd_sel_q", "dut.rd_sel_q"),
            ("load_first_q", "dut.load_first_q"),
            ("load_second_q", "dut.load_second_q"),
            ("out_of_reset", "dut.out_of_reset"),
            ("first_word", "dut.first"),
            ("second_word", "dut.second"),
        ]),
        ..PROOF
    }],
    ..UNIT
};

static CREDIT_FIFO: Unit = Unit {
    name: "credit_fifo",
    proofs: &[Proof {
        name: "credit_fifo",
        units: &["credit_fifo"],
        claim: "first in, first out, no occupied slot is overwritten, and a valid output is stable until it transfers, after a pipeline of any length, by induction",
        text: harness!("credit_fifo"),
        reach: Reach::Induction(24),
        extra: Extra::Registers(&[
            ("write_slot", "dut.write_ptr"),
            ("read_slot", "dut.read_ptr"),
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

static FIFO: Unit = Unit {
    name: "fifo",
    clocked: Some(queue),
    bindings: &[&[("W", 1), ("DEPTH", 4)], &[("W", 64), ("DEPTH", 32)]],
    proofs: &[Proof {
        name: "fifo",
        units: &["fifo"],
        claim: "first in, first out, no word lost, duplicated or overwritten, the occupancy is pushes less pops, and a valid output is stable until it transfers, by induction",
        text: harness!("fifo"),
        over: &[("W", 5), ("DEPTH", 16)],
        engine: INVARIANT,
        reach: Reach::Induction(1),
        extra: Extra::Fifo,
        ..PROOF
    }],
    ..UNIT
};

static ARBITER: Unit = Unit {
    name: "arbiter",
    clocked: Some(turns),
    bindings: &[&[("W", 1)], &[("W", 16)]],
    proofs: &[Proof {
        name: "arbiter",
        units: &["arbiter"],
        claim: "one grant at a time, to an input that is valid; the word is that input's and stable until it transfers; while an input waits, every other one transfers once at most, by induction",
        text: harness!("arbiter"),
        engine: INVARIANT,
        reach: Reach::Induction(1),
        extra: Extra::Registers(&[("first", "dut.asked_first_q"), ("kept", "dut.kept_q")]),
        ..PROOF
    }],
    ..UNIT
};

/// Words in a queue, each with the clock in which it was pushed: at the output two clocks later, at the earliest.
fn queue(c: &Context<'_>) -> Step {
    let depth = c.param("DEPTH") as usize;
    let (mut words, mut now) = (VecDeque::<(u64, u64)>::new(), 0);
    Box::new(move |row, out| {
        let oldest = words.front().copied().filter(|(_, pushed)| pushed + 2 <= now);
        let ready = words.len() < depth;
        out["in_ready"] = ready.into();
        out["out_valid"] = oldest.is_some().into();
        out["out_data"] = oldest.map_or(0, |w| w.0);
        out["occupancy"] = words.len() as u64;
        if oldest.is_some() && row.is_set("out_ready") {
            words.pop_front();
        }
        if ready && row.is_set("in_valid") {
            words.push_back((row["in_data"], now));
        }
        now += 1;
    })
}

/// The input that comes first is the one after the input that was served last; a grant stays until its word transfers.
fn turns(c: &Context<'_>) -> Step {
    const INPUTS: u32 = 4;
    let w = c.param("W");
    let (mut head, mut kept) = (0, None);
    Box::new(move |row: &Row<'_>, out: &mut Row<'_>| {
        let valid = |k: &u32| row["in_valid"] >> k & 1 == 1;
        let granted = kept.or_else(|| (0..INPUTS).map(|k| (head + k) % INPUTS).find(valid));
        let ready = row.is_set("out_ready");
        let one_hot = granted.map_or(0, |k| 1 << k);
        out["in_ready"] = if ready { one_hot } else { 0 };
        out["out_grant"] = one_hot;
        out["out_valid"] = granted.is_some().into();
        out["out_data"] = granted.map_or(0, |k| row["in_data"] >> (k * w) & mask(w));
        kept = granted.filter(|_| !ready);
        if let Some(k) = granted.filter(|_| ready) {
            head = (k + 1) % INPUTS;
        }
    })
}

static HEIGHT_MEMORY: Unit = Unit { name: "height_memory", ..UNIT };

static HEIGHT_BANKS: Unit = Unit { name: "height_banks", ..UNIT };

static TRAVERSE: Unit = Unit {
    name: "traverse",
    takes_rays: true,
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
