//! Delay lines, handshakes, memories, and `traverse`: what has proofs, or rays for its vectors.
use super::super::unit::{UNIT, Unit};
use super::WIDTHS;
use crate::proofs::{BIT_LEVEL, Extra, PROOF, Proof, Reach};

/// The entries.
pub const UNITS: &[&Unit] =
    &[&DELAY_LINE, &STREAM_SKID, &WORD_SKID, &STREAM_QUEUE, &WORD_QUEUE, &HEIGHT_MEMORY, &HEIGHT_BANKS, &TRAVERSE];

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

static STREAM_SKID: Unit = Unit {
    name: "stream_skid",
    proofs: &[Proof {
        name: "stream_skid",
        units: &["stream_skid", WORD_SKID.name],
        claim: "words leave in the order in which they come, none lost and none twice, and an offered one stays, by induction",
        text: harness!("stream_skid"),
        reach: Reach::Induction(10),
        extra: Extra::Registers(&[
            ("first_valid", "dut.first_valid"),
            ("second_valid", "dut.second_valid"),
            ("some_valid", "dut.some_valid"),
            ("writes_second", "dut.writes_second"),
            ("reads_second", "dut.reads_second"),
            ("awake", "dut.awake"),
            ("first_word", "word.first"),
            ("second_word", "word.second"),
        ]),
        ..PROOF
    }],
    ..UNIT
};

static WORD_SKID: Unit = Unit { name: "word_skid", ..UNIT };

static STREAM_QUEUE: Unit = Unit {
    name: "stream_queue",
    proofs: &[Proof {
        name: "stream_queue",
        units: &["stream_queue", WORD_QUEUE.name],
        claim: "places are filled and read in turn, none that is taken is written, and an offered word stays, behind a pipeline of any length, by induction",
        text: harness!("stream_queue"),
        reach: Reach::Induction(24),
        extra: Extra::Registers(&[
            ("taken", "dut.taken"),
            ("held", "dut.held"),
            ("has_room", "dut.has_room"),
            ("has_set_out", "dut.has_set_out"),
            ("has_gone", "dut.has_gone"),
            ("is_offered", "dut.is_offered"),
        ]),
        ..PROOF
    }],
    ..UNIT
};

static WORD_QUEUE: Unit = Unit { name: "word_queue", ..UNIT };

static HEIGHT_MEMORY: Unit = Unit { name: "height_memory", ..UNIT };

static HEIGHT_BANKS: Unit = Unit { name: "height_banks", ..UNIT };

static TRAVERSE: Unit = Unit {
    name: "traverse",
    proofs: &[Proof {
        name: "traverse",
        units: &["traverse"],
        claim: "no ray is lost, none comes twice, and an offered result stays, by induction",
        text: harness!("traverse"),
        extra: Extra::RaysOfTheLoop { counted: harness!("traverse_counted") },
        ..PROOF
    }],
    ..UNIT
};
