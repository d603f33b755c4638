//! The proofs of units that stand between streams, and what each of them finds.
use super::yosys::{SMALL, ok, run};
use crate::budget::share;

/// The units of streams that no traversal needs.
const STREAMS: [&str; 2] = ["--set", "emit.units=fifo,arbiter"];

/// Unit, and a change of one token.
const SPOILED: [(&str, &str, &str); 13] = [
    // Written while full; popped while no receiver is ready; counted wrongly.
    ("fifo", "~occupancy_q[PtrW]", "1'b1"),
    ("fifo", "& out_ready", "| out_ready"),
    ("fifo", "occupancy_q + ", "occupancy_q - "),
    ("fifo", "pop & ~push", "pop"),
    // A word twice; one that is not there.
    ("fifo", ".read_addr(read_next)", ".read_addr(read_ptr)"),
    ("fifo", "occupancy_q[0] & ~pop", "occupancy_q[0]"),
    // A grant that moves while it waits; one that is kept after its word went; one without a request.
    ("arbiter", "(|kept_q) ? kept_q : lowest", "lowest"),
    ("arbiter", "grant & ~{4{out_ready}}", "grant"),
    ("arbiter", "chosen & in_valid", "chosen"),
    // Unfair: the lowest always first; those that were served not last; the turn goes on without a transfer.
    ("arbiter", "(|preferred) ? preferred : in_valid", "in_valid"),
    ("arbiter", "~(grant | (grant - 4'd1))", "~grant"),
    ("arbiter", "transfer ? above_grant : asked_first_q", "above_grant"),
    // The word of another.
    ("arbiter", "in_data[2*W-1:W]", "in_data[W-1:0]"),
];

#[test]
fn streams_are_proved_and_a_spoiled_one_is_disproved() {
    let dir = tempfile::tempdir().unwrap();
    ok(dir.path(), &[&["build"], &STREAMS[..], &SMALL].concat());
    let prove = |unit| [&["prove", "--unit", unit, "--dir", "out"], &STREAMS[..]].concat();
    for unit in ["fifo", "arbiter"] {
        ok(dir.path(), &prove(unit));
    }
    for (unit, from, to) in SPOILED.into_iter().step_by(share(4)) {
        let file = dir.path().join(format!("out/rtl/relief_{unit}.v"));
        let text = std::fs::read_to_string(&file).unwrap();
        assert!(text.contains(from), "{unit} has no {from}");
        std::fs::write(&file, text.replacen(from, to, 1)).unwrap();
        let out = run(dir.path(), &prove(unit));
        let said = String::from_utf8_lossy(&out.stderr).into_owned();
        assert_eq!(out.status.code(), Some(1), "{unit}: {from} -> {to}: {said}");
        assert!(said.contains("disproved"), "{unit}: {from} -> {to}: {said}");
        std::fs::write(&file, text).unwrap();
    }
}
