//! Proofs that take minutes: they go through in the full budget, and `data/proofs.json` says of which text. The test run sees that this is the text
//! that is emitted now.
//! `RELIEFRTL_REFRESH=1 cargo test --release --test proofs stored -- --ignored` proves them and writes the file anew.
use super::yosys::{SMALL, ok};
use rayon::prelude::*;
use reliefrtl::config::{Config, Profile};
use reliefrtl::project::text;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// Options of a design, and its proofs.
type Design = (&'static [&'static str], &'static [&'static str]);
const LONG: [Design; 5] = [
    (&["--profile", "published"], &["traverse"]),
    (&["--set", "latency.handshake=2", "--set", "datapath.kind=published"], &["traverse"]),
    (&["--set", "latency.handshake=3"], &["traverse"]),
    (&["--profile", "fast"], &["traverse", "delay_line"]),
    (
        &["--set", "datapath.kind=fixed", "--set", "mode.trim=always"],
        &["fixed_predicted_hit", "fixed_chord_end", "fixed_plane_time"],
    ),
];

/// A proof that went through, and the text that it is of.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct Proof {
    command: String,
    digest: String,
}

fn file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data/proofs.json")
}

/// Digest of all that a proof reads, without its comments.
fn digest(options: &[&str], proof: &str) -> String {
    let mut c = Config::default();
    for pair in options.chunks(2) {
        match pair[0] {
            "--profile" => {
                c.latency = Profile::ALL.into_iter().find(|p| p.word() == pair[1]).unwrap().latency_for(&c.design())
            }
            _ => c.apply_set(pair[1]).unwrap(),
        }
    }
    c.validate().unwrap();
    let files = text(&c).unwrap().files;
    let own = format!("testbench/{}fv_{proof}.", c.emit.prefix);
    let mut hash = blake3::Hasher::new();
    for (path, text) in files.iter().filter(|(f, _)| f.starts_with("rtl/") && f.ends_with(".v") || f.starts_with(&own))
    {
        hash.update(path.as_bytes());
        let code = text.lines().map(|l| l.split("//").next().unwrap_or_default().trim_end());
        for line in code.filter(|l| !l.is_empty()) {
            hash.update(line.as_bytes()).update(b"\n");
        }
    }
    hash.finalize().to_hex()[..32].to_string()
}

/// Every long proof with the digest of the text that is emitted now, and its call.
fn now() -> Vec<(Proof, Vec<&'static str>)> {
    let calls = LONG.iter().flat_map(|(options, proofs)| proofs.iter().map(move |p| (*options, *p)));
    calls
        .map(|(options, proof)| {
            let call = [&["prove", "--unit", proof][..], options].concat();
            (Proof { command: format!("reliefrtl {}", call.join(" ")), digest: digest(options, proof) }, call)
        })
        .collect()
}

#[test]
fn long_proofs_are_of_the_text_that_is_emitted_now() {
    let stored: Vec<Proof> = serde_json::from_str(&std::fs::read_to_string(file()).unwrap()).unwrap();
    let now: Vec<Proof> = now().into_iter().map(|(p, _)| p).collect();
    assert_eq!(now.len(), 8);
    for (now, stored) in now.iter().zip(&stored) {
        assert_eq!(now, stored, "proved of another text: the first lines of this file say how it is proved anew");
    }
    assert_eq!(now.len(), stored.len());
}

#[test]
#[ignore = "minutes of proving; part of sh tools/test.sh --full"]
fn long_proofs_go_through() {
    let refresh = std::env::var("RELIEFRTL_REFRESH").is_ok_and(|v| v == "1");
    // What is stored for the text of now is not proved again to be stored.
    let stored: Vec<Proof> = serde_json::from_str(&std::fs::read_to_string(file()).unwrap()).unwrap();
    let proved: Vec<Proof> = now()
        .into_par_iter()
        .map(|(proof, call)| {
            if refresh && stored.contains(&proof) {
                return proof;
            }
            let dir = tempfile::tempdir().unwrap();
            ok(dir.path(), &[&call[..], &SMALL].concat());
            proof
        })
        .collect();
    if refresh {
        std::fs::write(file(), serde_json::to_string_pretty(&proved).unwrap() + "\n").unwrap();
    }
}

/// Another text has another digest, and a comment makes none.
#[test]
fn digests_are_those_of_the_code() {
    let of = |options: &[&str]| digest(options, "traverse");
    assert_ne!(of(&["--set", "latency.handshake=0"]), of(&["--set", "latency.handshake=3"]));
    assert_ne!(of(&[]), digest(&[], "lzc"));
    assert_eq!(of(&[]), of(&["--set", "emit.clock_mhz=100"]));
}
