//! Operands that no plan comes by, and that tell a unit from its mutants: `found.txt` says of which kind.
use crate::config::Design;

const FOUND: &str = include_str!("found.txt");

/// Rows of a unit for inputs of these widths; none in a design of another format, where the words would mean something else.
pub(super) fn found_rows(d: &Design, unit: &str, widths: &[u32]) -> Vec<Vec<u64>> {
    let own = FOUND.lines().filter_map(|line| line.split_once(' ')).filter(|(name, _)| *name == unit);
    let words = own.map(|(_, words)| words.split(' ').map(|w| u64::from_str_radix(w, 16).expect("hex")).collect());
    let fits = |row: &Vec<u64>| row.len() == widths.len() && row.iter().zip(widths).all(|(word, w)| word >> w == 0);
    words.filter(|row| d.format == Design::default().format && fits(row)).collect()
}
