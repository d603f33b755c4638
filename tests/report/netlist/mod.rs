//! The netlists that the emitted scripts write replay the shipped vectors in Icarus, from unknown registers.
//!
//! Small units are replayed in every test run; what takes minutes (the traversal, the newer Yosys) is measured by the ignored test below, which
//! keeps what it saw in `data/netlists.json`. A quick test holds that file against the text, the scripts and the cell models of now.
mod cells;
mod replay;
mod stored;

use crate::budget::share;
use crate::simulators::skip;
use rayon::prelude::*;
use replay::{Job, TARGETS, UNITS, replay};
use std::sync::Mutex;
use stored::Entry;

/// Every job at a small format; the traversal with five levels, of which the pyramid is a block memory, by both Yosys.
fn plan() -> Vec<Job> {
    let mut jobs = Vec::new();
    for newest in [false, true] {
        for target in &TARGETS {
            for unit in UNITS.into_iter().chain(["traverse"]) {
                jobs.push(Job { newest, target, unit, mapped: true });
                // The cross-check: no block memories, no multipliers.
                let checked = unit == "fp_mul" || unit == "traverse" && !newest;
                if !target.unmapped.is_empty() && checked {
                    jobs.push(Job { newest, target, unit, mapped: false });
                }
            }
        }
    }
    // What takes minutes stands last.
    jobs.sort_by_key(|j| (j.unit == "traverse", j.newest, !j.mapped));
    jobs
}

/// Arithmetic by the first Yosys, with multipliers and without.
#[test]
fn small_netlists_replay_the_vectors() {
    if skip() {
        return;
    }
    let quick = plan().into_iter().filter(|j| !j.newest && j.unit != "traverse");
    // One in three: each target, each unit, with and without multipliers.
    let quick: Vec<Job> = quick.step_by(share(3)).collect();
    assert!(TARGETS.iter().all(|t| quick.iter().any(|j| j.target.name == t.name)), "a target is left out");
    assert!(UNITS.iter().all(|u| quick.iter().any(|j| j.unit == *u)), "a unit is left out");
    let seen: Vec<Entry> = quick.par_iter().map(replay).collect();
    for e in &seen {
        println!("{}: 0 of {} mismatched", e.name(), e.rows);
        assert!(e.rows >= 50 && e.mismatched == 0, "{}: {} of {}", e.name(), e.mismatched, e.rows);
    }
}

/// Everything, as many at a time as there are cores. With `RELIEFRTL_REFRESH=1` only what the stored results are not of, and each result is stored at once;
/// without, all that is stored, and the results are the stored ones.
#[test]
#[ignore = "half an hour of synthesis and simulation; part of sh tools/test.sh --full"]
fn netlists_replay_as_the_stored_results_say() {
    if skip() {
        return;
    }
    let refresh = std::env::var("RELIEFRTL_REFRESH").is_ok_and(|v| v == "1");
    let kept = Mutex::new(stored::read());
    let wrong = Mutex::new(Vec::new());
    // What takes minutes stands last, so both cores have work to the end.
    plan().par_iter().with_max_len(1).for_each(|job| {
        let known = kept.lock().unwrap().iter().find(|e| e.is_of(job)).cloned();
        if refresh && known.as_ref().is_some_and(|e| e.digests == stored::digests_of(job)) {
            return;
        }
        let seen = replay(job);
        println!("{}: {} of {} mismatched", seen.name(), seen.mismatched, seen.rows);
        if refresh {
            let mut kept = kept.lock().unwrap();
            kept.retain(|e| !e.is_of(job));
            kept.push(seen.clone());
            kept.retain(|e| plan().iter().any(|j| e.is_of(j)));
            stored::write(&mut kept);
        } else if known.as_ref() != Some(&seen) {
            wrong.lock().unwrap().push(format!(
                "{}: {} of {}, and not what is stored",
                seen.name(),
                seen.mismatched,
                seen.rows
            ));
        }
        if seen.mismatched != 0 {
            wrong.lock().unwrap().push(format!("{}: {} of {} mismatched", seen.name(), seen.mismatched, seen.rows));
        }
    });
    let wrong = wrong.into_inner().unwrap();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A result of another text, script or model is no result.
#[test]
fn stored_results_are_of_the_text_that_is_emitted_now() {
    let kept = stored::read();
    let mut wrong = Vec::new();
    let (mut missing, mut stale) = (Vec::new(), Vec::new());
    for job in plan() {
        match kept.iter().find(|e| e.is_of(&job)) {
            None => missing.push(job.name()),
            Some(e) if e.mismatched != 0 || e.rows < 50 => {
                wrong.push(format!("{}: {} of {} mismatched", e.name(), e.mismatched, e.rows));
            }
            Some(e) if e.digests != stored::digests_of(&job) => stale.push(e.name()),
            Some(e) => {
                // With memories and multipliers there are some to replay, and without there are none.
                let hard = job.target.hard_of(&e.hard);
                let some = job.mapped && !job.target.memories.is_empty() && job.unit == "traverse";
                assert!(hard.0 > 0 || !some, "{}: no block memory", e.name());
                assert!(hard == (0, 0) || job.mapped, "{}: {:?}", e.name(), e.hard);
            }
        }
    }
    assert!(missing.is_empty(), "never replayed: {missing:?}");
    assert_eq!(kept.len(), plan().len(), "results that are not asked for");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let again =
        "RELIEFRTL_REFRESH=1 cargo test --release --test report netlists_replay -- --ignored measures them again";
    assert!(stale.is_empty(), "results of another text; {again}: {stale:?}");
}
