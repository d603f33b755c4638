//! A vector set as files: `vectors.json` (description), `stimulus.hex` and `expected.hex` (`$readmemh`), `vectors.csv` and `rows.json`
//! (the same rows, for other programs).
//!
//! A hex file starts with the number of rows and the bits of a row, `expected.hex` of rays whose hits do not say their iterations with the iterations of
//! the longest ray and of all rays besides; each row is one line of words, separated by blanks, first column first.
use super::campaign::Campaign;
use super::set::{Column, Counts, Iterations, VectorSet};
use crate::emit::Files;
use crate::error::{Error, Result};
use crate::files::read_text_of_tree;
use crate::ir::Binding;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

/// Version of the layout.
const SCHEMA: u32 = 2;

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Description {
    schema: u32,
    unit: String,
    parameters: Binding,
    generator: String,
    seed: u64,
    rows: usize,
    counts: Counts,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    campaign: Option<Campaign>,
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    events: BTreeMap<String, usize>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    iterations: Option<Iterations>,
    policy: String,
    inputs: Vec<Column>,
    outputs: Vec<Column>,
    blake3: String,
}

/// What the policy says of planned rays.
const PLANNED: &str = "texels and corners of rays";

/// How the rows were chosen, in their order.
fn policy(s: &VectorSet) -> String {
    let c = &s.counts;
    let corners = match s.campaign {
        None if s.planned => PLANNED,
        None => "landmarks crossed with each other, then corner tables",
        Some(_) => "corner tables crossed with each other",
    };
    let parts = [
        (c.exhaustive, "every input once"),
        (c.corners, corners),
        (c.random, "weighted random"),
        (c.found, "words found to tell the unit from one with a slip in it"),
        (c.rays, "what rays through the map bring"),
    ];
    let there: Vec<&str> = parts.iter().filter(|p| p.0 > 0).map(|p| p.1).collect();
    there.join(", then ")
}

/// The files of a set, by name.
pub fn set_files(s: &VectorSet) -> Files {
    let d = Description {
        schema: SCHEMA,
        unit: s.unit.clone(),
        parameters: s.params.clone(),
        generator: "ChaCha8".into(),
        seed: s.seed,
        rows: s.stimulus.len(),
        counts: s.counts,
        campaign: s.campaign,
        events: s.events.clone(),
        iterations: s.iterations,
        policy: policy(s),
        inputs: s.inputs.clone(),
        outputs: s.outputs.clone(),
        blake3: s.hash(),
    };
    let json = serde_json::to_string_pretty(&d).expect("a description is plain data") + "\n";
    let mut csv = names(&s.inputs).chain(names(&s.outputs)).collect::<Vec<_>>().join(",") + "\n";
    for (a, b) in s.stimulus.iter().zip(&s.expected) {
        let row: Vec<String> = a.iter().chain(b).map(|v| format!("{v:x}")).collect();
        csv += &(row.join(",") + "\n");
    }
    Files::from([
        ("vectors.json".into(), json),
        ("stimulus.hex".into(), hex(&s.unit, &s.inputs, &s.stimulus, None)),
        ("expected.hex".into(), hex(&s.unit, &s.outputs, &s.expected, s.iterations)),
        ("vectors.csv".into(), csv),
        ("rows.json".into(), rows_json(s)),
    ])
}

/// Rows as JSON: one object a line, column names and hex words.
fn rows_json(s: &VectorSet) -> String {
    let row = |(a, b): (&Vec<u64>, &Vec<u64>)| {
        let cells = s.inputs.iter().chain(&s.outputs).zip(a.iter().chain(b));
        let cells: Vec<String> = cells.map(|(c, v)| format!("\"{}\":\"{v:x}\"", c.name)).collect();
        format!("{{{}}}", cells.join(","))
    };
    let rows: Vec<String> = s.stimulus.iter().zip(&s.expected).map(row).collect();
    format!("[\n{}\n]\n", rows.join(",\n"))
}

/// Stimulus and expected rows of a `vectors.csv` with these columns.
///
/// # Errors
/// Other columns, or a cell that is no hex number of the column's width.
pub fn read_csv(text: &str, inputs: &[Column], outputs: &[Column]) -> Result<Rows> {
    let mut lines = text.lines();
    let want: Vec<String> = names(inputs).chain(names(outputs)).collect();
    if lines.next().is_none_or(|h| h.split(',').ne(want.iter().map(String::as_str))) {
        return Err(Error::input(format!("vectors.csv starts with the columns {}", want.join(","))));
    }
    let cells = lines.enumerate().map(|(i, l)| (i + 2, l.split(',').map(str::to_string).collect::<Vec<_>>()));
    split_rows(cells, inputs, outputs, "vectors.csv")
}

/// Stimulus and expected rows of a `rows.json` with these columns.
///
/// # Errors
/// As [`read_csv`].
pub fn read_json(text: &str, inputs: &[Column], outputs: &[Column]) -> Result<Rows> {
    let rows: Vec<std::collections::BTreeMap<String, String>> =
        serde_json::from_str(text).map_err(|e| Error::input(format!("rows.json is not a list of rows: {e}")))?;
    let cell = |r: &std::collections::BTreeMap<String, String>, n: String| r.get(&n).cloned().unwrap_or_default();
    let cells = rows
        .iter()
        .enumerate()
        .map(|(i, r)| (i + 2, names(inputs).chain(names(outputs)).map(|n| cell(r, n)).collect()));
    split_rows(cells, inputs, outputs, "rows.json")
}

/// Stimulus and expected rows.
pub type Rows = (Vec<Vec<u64>>, Vec<Vec<u64>>);

fn split_rows(
    cells: impl Iterator<Item = (usize, Vec<String>)>,
    inputs: &[Column],
    outputs: &[Column],
    at: &str,
) -> Result<Rows> {
    let (mut a, mut b) = (Vec::new(), Vec::new());
    for (line, words) in cells {
        if words.len() != inputs.len() + outputs.len() {
            return Err(Error::input(format!("{at}, line {line}: {} cells", words.len())));
        }
        let row = words.iter().zip(inputs.iter().chain(outputs)).map(|(w, c)| {
            let v = u64::from_str_radix(w, 16).ok().filter(|v| v & !crate::bits::mask(c.width) == 0);
            v.ok_or_else(|| Error::input(format!("{at}, line {line}: {w:?} is no hex number of {} bits", c.width)))
        });
        let mut row = row.collect::<Result<Vec<u64>>>()?;
        b.push(row.split_off(inputs.len()));
        a.push(row);
    }
    Ok((a, b))
}

fn names(c: &[Column]) -> impl Iterator<Item = String> + '_ {
    c.iter().map(|c| c.name.clone())
}

/// `$readmemh` text of rows, with the iterations of their rays in its head where they are given.
pub fn hex(unit: &str, columns: &[Column], rows: &[Vec<u64>], iterations: Option<Iterations>) -> String {
    let cols: Vec<String> = columns.iter().map(|c| format!("{}[{}]", c.name, c.width)).collect();
    let bits: u32 = columns.iter().map(|c| c.width).sum();
    let cols = cols.join(" ");
    let (said, head) = iterations.map_or_else(Default::default, |n| {
        (", iterations of the longest ray and of all", format!(" {:x} {:x}", n.most, n.sum))
    });
    let mut out = format!(
        "// unit {unit}; number of rows and bits of a row{said}, then a row a line: {cols}\n{:x} {bits:x}{head}\n",
        rows.len()
    );
    for r in rows {
        for (i, (v, c)) in r.iter().zip(columns).enumerate() {
            let digits = c.width.div_ceil(4) as usize;
            write!(out, "{}{v:0digits$x}", if i == 0 { "" } else { " " }).expect("writing to a string can't fail");
        }
        out.push('\n');
    }
    out
}

/// Reads a set back; the flag tells whether the rows are those that the description pins. (Replaying comes first: a row that
/// was changed shows as the mismatch that it is.)
///
/// # Errors
/// A missing file, a wrong schema, a word that is no hex number or too wide, a wrong count: one sentence.
pub fn read_set(dir: &Path) -> Result<(VectorSet, bool)> {
    let text = |name: &str| read_text_of_tree(dir.join(name));
    let at = |name: &str| dir.join(name).display().to_string();
    let d: Description = serde_json::from_str(&text("vectors.json")?)
        .map_err(|e| Error::input(format!("{} is not a vector description: {e}", at("vectors.json"))))?;
    if d.schema != SCHEMA {
        return Err(Error::input(format!(
            "{} has schema {}, this program reads {SCHEMA}",
            at("vectors.json"),
            d.schema
        )));
    }
    if let Some(column) = d.inputs.iter().chain(&d.outputs).find(|column| !(1..=64).contains(&column.width)) {
        let (at, width) = (at("vectors.json"), column.width);
        return Err(Error::input(format!("{at}: column {} has {width} bits, 1 to 64 are legal", column.name)));
    }
    let stimulus = rows(&text("stimulus.hex")?, &d.inputs, None, &at("stimulus.hex"))?;
    let expected = rows(&text("expected.hex")?, &d.outputs, d.iterations, &at("expected.hex"))?;
    let set = VectorSet {
        unit: d.unit,
        params: d.parameters,
        seed: d.seed,
        counts: d.counts,
        campaign: d.campaign,
        planned: d.policy.starts_with(PLANNED),
        events: d.events,
        iterations: d.iterations,
        inputs: d.inputs,
        outputs: d.outputs,
        stimulus,
        expected,
    };
    let whole = set.hash() == d.blake3 && set.stimulus.len() == d.rows && set.counts.total() == d.rows;
    Ok((set, whole))
}

fn rows(text: &str, columns: &[Column], iterations: Option<Iterations>, at: &str) -> Result<Vec<Vec<u64>>> {
    let mut lines = text.lines().enumerate().map(|(i, l)| (i + 1, l.split("//").next().unwrap_or("").trim()));
    let mut lines = lines.by_ref().filter(|(_, l)| !l.is_empty());
    let word = |line: usize, w: &str, width: u32| {
        let v = u64::from_str_radix(w, 16)
            .map_err(|_| Error::input(format!("{at}, line {line}: {w} is not a hex number")))?;
        if v & !crate::bits::mask(width) != 0 {
            return Err(Error::input(format!("{at}, line {line}: {w} does not fit {width} bits")));
        }
        Ok(v)
    };
    let (line, head) =
        lines.next().ok_or_else(|| Error::NothingRan(format!("{at} is empty: it starts with the number of rows")))?;
    let (count, more) = head.split_once(' ').ok_or_else(|| {
        Error::input(format!("{at}, line {line}: {head}, where the number of rows and the bits of a row stand"))
    })?;
    let (bits, counted) = match iterations {
        None => (more.trim(), ""),
        Some(_) => more.trim().split_once(' ').unwrap_or((more, "")),
    };
    let (count, bits) = (word(line, count, 32)? as usize, word(line, bits, 32)?);
    if let Some(Iterations { most, sum }) = iterations.filter(|n| counted.trim() != format!("{:x} {:x}", n.most, n.sum))
    {
        return Err(Error::input(format!(
            "{at} announces the iterations \"{}\", vectors.json describes {most:x} {sum:x}",
            counted.trim()
        )));
    }
    let described: u64 = columns.iter().map(|c| u64::from(c.width)).sum();
    if bits != described {
        return Err(Error::input(format!("{at} announces rows of {bits} bits, vectors.json describes {described}")));
    }
    // What the head announces is compared with what is there, not allocated.
    let mut out = Vec::new();
    for (line, l) in lines {
        let words: Vec<&str> = l.split_whitespace().collect();
        if words.len() != columns.len() {
            return Err(Error::input(format!(
                "{at}, line {line}: {} words, {} columns are described",
                words.len(),
                columns.len()
            )));
        }
        out.push(words.iter().zip(columns).map(|(w, c)| word(line, w, c.width)).collect::<Result<_>>()?);
    }
    if out.len() != count {
        return Err(Error::input(format!("{at} announces {count} rows and has {}", out.len())));
    }
    Ok(out)
}
