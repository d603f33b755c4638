//! The lines that a bench prints for machines: `@`, a word, and fields `name=value`.
//!
//! ```text
//! @fail unit=fp_add row=12 port=result exp=00ab got=00ac    the first output that differs, once; row from 0, words in hex
//! @done unit=fp_add checked=1000 wrong=3                    rows that were compared, and those of which some output differs
//! ```
use crate::error::Place;

/// What a bench said in such lines.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Said {
    /// Rows compared, and those that differ; `None` if the bench ended before it knew.
    pub done: Option<(usize, usize)>,
    /// Row, output port, expected and given word in hex (`x` for unknown digits).
    pub fail: Option<(usize, String, String, String)>,
}

impl Said {
    /// Reads what a bench printed; other lines, and fields that are not known here, are passed over.
    pub fn read(output: &str) -> Self {
        let mut said = Self::default();
        for line in output.lines() {
            let mut words = line.split_whitespace();
            let kind = words.next();
            let fields: Vec<(&str, &str)> = words.filter_map(|w| w.split_once('=')).collect();
            let text = |name: &str| fields.iter().find(|f| f.0 == name).map(|f| f.1);
            let number = |name: &str| text(name)?.parse().ok();
            match kind {
                Some("@done") => said.done = number("checked").zip(number("wrong")),
                Some("@fail") if said.fail.is_none() => {
                    let word = |name| text(name).map(str::to_string);
                    said.fail = (|| Some((number("row")?, word("port")?, word("exp")?, word("got")?)))();
                }
                _ => {}
            }
        }
        said
    }

    /// The first difference, if there is one.
    pub fn place(&self, unit: &str, engine: &str) -> Option<Place> {
        let (vector, output, expected, got) = self.fail.clone()?;
        let (checked, mismatched) = self.done?;
        let (unit, engine) = (unit.to_string(), engine.to_string());
        Some(Place { unit, engine, checked, mismatched, vector, output, stage: None, expected, got })
    }
}

#[cfg(test)]
mod tests {
    use super::Said;

    #[test]
    fn lines_for_machines_are_found_among_others() {
        let said = Said::read(
            "clocks: 7\nvector 3, y: expected 1, got 2\n@fail unit=u row=3 port=y exp=01 got=x2 new=1\n@fail unit=u row=9 port=z exp=1 got=0\n\
             @done unit=u checked=10 wrong=2\nFAIL tb_u: 2 of 10 mismatched\n",
        );
        assert_eq!(said.done, Some((10, 2)));
        assert_eq!(said.fail, Some((3, "y".into(), "01".into(), "x2".into())));
        let place = said.place("u", "icarus").unwrap();
        assert_eq!((place.vector, place.checked, place.mismatched), (3, 10, 2));
        assert_eq!(Said::read("FAIL tb_u: no vectors\n@done unit=u checked=many wrong=0"), Said::default());
    }
}
