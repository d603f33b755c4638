//! Whether a tree is the one that the configuration emits, before it is checked.
use crate::config::keys::HARDWARE;
use crate::config::{Config, Counters};
use crate::emit::Files;
use crate::error::{Error, Result};
use crate::files::{read_of_tree, read_text_of_tree};
use crate::vectors::{Column, Rows, VectorSet, read_csv, read_json};
use serde_json::Value;
use std::path::Path;

/// The interpreter runs the datapath that the configuration emits, not the text in `dir`: refuses a tree where the two differ.
///
/// # Errors
/// A file that is missing or differs.
pub fn same_text(files: &Files, dir: &Path) -> Result<()> {
    for (name, text) in files.iter().filter(|(n, _)| n.ends_with(".v")) {
        let path = dir.join(name);
        let there = read_of_tree(&path)?;
        if there != text.as_bytes() {
            return Err(Error::input(format!(
                "{} is not what this configuration emits, and the interpreter would not see the difference: use --engine icarus or verilator",
                path.display()
            )));
        }
    }
    Ok(())
}

/// An engine runs the hardware in `dir`, whatever the configuration asks for: refuses a verdict on another design than that.
/// A tree without a manifest (vectors and a netlist, say) tells nothing of its configuration.
///
/// # Errors
/// A manifest that is none, or the first key of another value.
pub fn same_config(c: &Config, dir: &Path) -> Result<()> {
    let path = dir.join("manifest.json");
    let text = match read_of_tree(&path) {
        Err(Error::File { source, .. }) if source.kind() == std::io::ErrorKind::NotFound => return Ok(()),
        read => read?,
    };
    let manifest: Value = serde_json::from_slice(&text)
        .map_err(|e| Error::input(format!("{} is not the manifest of an emitted tree: {e}", path.display())))?;
    let asked = serde_json::to_value(c).expect("a configuration is plain data");
    let other = |key: &str, there: &Value, value: &Value| {
        Err(Error::input(format!(
            "{} was emitted with {key} = {there}, and {value} is asked for: give the configuration of the tree, or emit it anew",
            dir.display()
        )))
    };
    for section in HARDWARE {
        let there = &manifest["config"][section];
        let differs = |(key, value): &(&String, &Value)| there.get(key.as_str()).is_some_and(|x| x != *value);
        if let Some((key, value)) = asked[section].as_object().and_then(|keys| keys.iter().find(differs)) {
            return other(&format!("{section}.{key}"), &there[key], value);
        }
    }
    // Written only where it is not the default.
    let plain = serde_json::json!(Counters::default());
    let [there, value] = [&manifest["config"], &asked].map(|c| c["emit"].get("counters").unwrap_or(&plain));
    if there == value { Ok(()) } else { other("emit.counters", there, value) }
}

/// The exports hold the rows that the hex files hold: whoever reads those checks against the same set.
pub(super) fn same_rows(place: &Path, set: &VectorSet) -> Result<()> {
    type Read = fn(&str, &[Column], &[Column]) -> Result<Rows>;
    for (name, read) in [("vectors.csv", read_csv as Read), ("rows.json", read_json)] {
        let path = place.join(name);
        let text = read_text_of_tree(&path)?;
        let at = |e: &dyn std::fmt::Display| Error::input(format!("{}: {e}", place.display()));
        let (stimulus, expected) = read(&text, &set.inputs, &set.outputs).map_err(|e| at(&e))?;
        let differs = |a: &[Vec<u64>], b: &[Vec<u64>]| a.iter().zip(b).position(|(a, b)| a != b);
        let row = differs(&stimulus, &set.stimulus).into_iter().chain(differs(&expected, &set.expected)).min();
        if let Some(row) = row {
            return Err(at(&format!("{name} and the hex files differ in row {row}")));
        }
        if stimulus.len() != set.stimulus.len() {
            let (here, there) = (stimulus.len(), set.stimulus.len());
            return Err(at(&format!("{name} has {here} rows, the hex files have {there}")));
        }
    }
    Ok(())
}
