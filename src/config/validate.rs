//! What must hold of a whole configuration.
use super::keys::KEYS;
use super::{Border, Config, MapKind, MapRange, Search, Trim, check, datapaths};
use reliefrtl_base::error::{Error, Result};

impl Config {
    /// Checks every value and what holds between them, and reports all problems at once.
    ///
    /// # Errors
    /// [`Error::Input`]; each problem names its keys, their values and the legal range.
    pub fn validate(&self) -> Result<()> {
        let mut problems = self.range_problems()?;
        // A sum of numbers that are out of range themselves tells nothing new.
        if problems.is_empty() {
            self.choice_problems(&mut problems);
            self.convert_problem(&mut problems);
            self.datapath.kind.facts().limits.iter().for_each(|limit| limit(self, &mut problems));
            self.search_problems(&mut problems);
            self.fetch_problems(&mut problems);
            self.mode_problems(&mut problems);
            self.bilinear_problems(&mut problems);
            self.map_problems(&mut problems);
            problems.extend(self.design().divider_problems());
            problems.extend(self.line_problem());
        }
        report(problems)
    }

    fn range_problems(&self) -> Result<Vec<String>> {
        for (key, seed) in [("map.seed", self.map.seed), ("vectors.seed", self.vectors.seed)] {
            if i64::try_from(seed).is_err() {
                return Err(Error::input(format!("{key} = {seed} is too large: 0 to 2^63 - 1 are legal")));
            }
        }
        let table = self.table()?;
        let value = |section: &str, name: &str| table.get(section)?.as_table()?.get(name);
        Ok(KEYS
            .iter()
            .filter_map(|key| {
                let (section, name) = key.split();
                check::problem(key, value(section, name)?)
            })
            .collect())
    }

    fn line_problem(&self) -> Option<String> {
        let least = self.latency.delay_line;
        (1..3)
            .contains(&least)
            .then(|| format!("latency.delay_line = {least} is too short for a memory: 0 (none) or 3 to 17 are legal"))
    }

    /// A traversal in floating point is watertight by an argument about one choice of the format (`docs/datapath.md`).
    fn choice_problems(&self, problems: &mut Vec<String>) {
        if !self.datapath.kind.facts().reads.format {
            return;
        }
        let plain = Config::default().format;
        let chosen = [
            ("rounding", self.format.rounding.word(), plain.rounding.word()),
            ("subnormals", self.format.subnormals.word(), plain.subnormals.word()),
            ("specials", self.format.specials.word(), plain.specials.word()),
        ];
        for (key, word, needed) in chosen {
            if word != needed {
                problems.push(format!(
                    "format.{key} = \"{word}\" is for arithmetic alone (`emit --unit fp_add`, `check --unit fp_add`): a traversal needs \"{needed}\""
                ));
            }
        }
    }

    /// A traversal knows the widths that it converts.
    fn convert_problem(&self, problems: &mut Vec<String>) {
        for (key, value) in [("int_bits", self.convert.int_bits), ("frac_bits", self.convert.frac_bits)] {
            if value > 0 {
                problems.push(format!(
                    "convert.{key} = {value} is for conversions alone (`emit --unit fp_to_fixed`, `check --unit fp_to_fixed`): a traversal needs 0"
                ));
            }
        }
    }

    /// A search that the datapath does not have.
    fn search_problems(&self, problems: &mut Vec<String>) {
        let path = self.datapath.kind.facts();
        if self.datapath.search != Search::default() {
            problems.push(format!(
                "datapath.search = \"windows\" and datapath.kind = \"{}\" exclude each other: a search by windows needs datapath.kind = \"fixed\"",
                path.word
            ));
        }
    }

    /// What the datapath does not have.
    fn mode_problems(&self, problems: &mut Vec<String>) {
        let path = self.datapath.kind.facts();
        for (key, set, has) in
            [("mode.trim", self.mode.trim != Trim::None, path.has_trim), ("mode.lod", self.mode.lod, path.has_lod)]
        {
            // What it ignores was refused by name.
            if set && !has && !path.ignores(key) {
                problems.push(format!("{key} is set, but datapath.kind = \"{}\" does not have it", path.word));
            }
        }
    }

    /// Where the bilinear refinement is (`docs/bilinear.md`, Parameters).
    fn bilinear_problems(&self, problems: &mut Vec<String>) {
        if !self.mode.bilinear {
            return;
        }
        let path = self.datapath.kind.facts();
        if !path.has_bilinear {
            let (key, word) = self.datapath.kind.chosen_by();
            let having = datapaths().filter(|k| k.facts().has_bilinear).map(|k| format!("\"{}\"", k.word()));
            problems.push(format!(
                "mode.bilinear = true and {key} = \"{word}\" exclude each other: the refinement needs datapath.kind = {}",
                having.collect::<Vec<_>>().join(" or ")
            ));
            return;
        }
        if self.mode.lod {
            problems.push(
                "mode.bilinear = true and mode.lod = true exclude each other: a hit in a node of a coarser level has no texels to interpolate, so one of them must be false"
                    .to_owned(),
            );
        }
        let (height, frac, man) = (self.traverse.height_bits, self.traverse.frac_bits, self.format.man);
        let depth = height + 2 * frac + man;
        if depth > 60 {
            problems.push(format!(
                "traverse.frac_bits = {frac} is too large for mode.bilinear with traverse.height_bits = {height} and format.man = {man}: height_bits + 2 * frac_bits + man = {depth} may be at most 60"
            ));
        }
    }

    fn map_problems(&self, problems: &mut Vec<String>) {
        match (self.map.kind, &self.map.file) {
            (MapKind::File, None) => problems.push("map.kind = \"file\" needs an image: set map.file".to_owned()),
            (kind, Some(_)) if kind != MapKind::File => problems.push(format!(
                "map.file is set but map.kind = \"{kind}\" does not read it: set map.kind = \"file\" or remove map.file"
            )),
            _ => {}
        }
        if let (Some(fill), Some(MapRange::Limits([low, high]))) = (self.map.fill, self.map.range)
            && !(low..=high).contains(&fill)
        {
            problems
                .push(format!("map.fill = {fill} lies outside map.range = [{low}, {high}]: a height in it is needed"));
        }
        if self.map.border == Border::Clamp && self.map.repeat != 1 {
            problems.push(format!(
                "map.repeat = {} and map.border = \"clamp\" exclude each other: a map that is continued by its border texels lies on the quad once",
                self.map.repeat
            ));
        }
    }
}

/// No problem, one sentence, or a list.
pub fn report(problems: Vec<String>) -> Result<()> {
    match problems.as_slice() {
        [] => Ok(()),
        [one] => Err(Error::input(one.clone())),
        all => {
            let list: String = all.iter().map(|problem| format!("\n  - {problem}")).collect();
            Err(Error::input(format!("{} problems:{list}", all.len())))
        }
    }
}
