//! What must hold of a whole configuration.
use super::keys::KEYS;
use super::{Border, Config, DatapathKind, MapKind, MapRange, Trim, check};
use crate::error::{Error, Result};

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
            self.width_problems(&mut problems);
            self.published_problems(&mut problems);
            self.trim_problems(&mut problems);
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
        if self.datapath.kind == DatapathKind::Fixed {
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

    /// The bounds that keep every intermediate result of the datapath inside its width (`docs/datapath.md`, Parameters).
    fn width_problems(&self, problems: &mut Vec<String>) {
        if self.datapath.kind == DatapathKind::Fixed {
            return self.fixed_problems(problems);
        }
        let (exp, man) = (self.format.exp, self.format.man);
        let (levels, height, tiles) = (self.traverse.levels, self.traverse.height_bits, self.traverse.tile_bits);
        let bias = (1u32 << (exp - 1)) - 1;
        if man < 7 {
            problems.push(format!("format.man = {man} is too small for the traverse unit: 7 to 23 are legal"));
        }
        if height > man + 1 {
            problems.push(format!(
                "traverse.height_bits = {height} is too large for format.man = {man}: at most format.man + 1 = {} is legal, so that a height code is exact",
                man + 1
            ));
        }
        let index = self.traverse.idx_bits();
        let position = index + self.traverse.frac_bits + man;
        if position > 60 {
            problems.push(format!(
                "traverse.frac_bits = {} is too large for a texel coordinate of {index} bits and format.man = {man}: levels + tile_bits + 2 + frac_bits + man = {position} may be at most 60",
                self.traverse.frac_bits
            ));
        }
        if index > 24 {
            problems.push(format!(
                "traverse.levels = {levels} and traverse.tile_bits = {tiles} make a texel coordinate of {index} bits: levels + tile_bits + 2 may be at most 24"
            ));
        }
        if levels + tiles + 1 > bias {
            problems.push(format!(
                "format.exp = {exp} is too small for traverse.levels = {levels} and traverse.tile_bits = {tiles}: levels + tile_bits + 1 = {} may be at most 2^(exp-1) - 1 = {bias}",
                levels + tiles + 1
            ));
        }
        if man > bias + levels {
            problems.push(format!(
                "format.man = {man} is too large for format.exp = {exp} and traverse.levels = {levels}: at most 2^(exp-1) - 1 + levels = {} is legal",
                bias + levels
            ));
        }
        if self.mode.trim != Trim::None && self.datapath.kind == DatapathKind::Watertight && man + 4 > bias {
            problems.push(format!(
                "mode.trim = \"{}\" needs exponents of more bits for format.man = {man}: format.man + 4 = {} may be at most 2^(exp-1) - 1 = {bias}",
                if self.mode.trim == Trim::Always { "always" } else { "descent" },
                man + 4
            ));
        }
        if height + 2 > bias {
            problems.push(format!(
                "format.exp = {exp} is too small for traverse.height_bits = {height}: height_bits + 2 = {} may be at most 2^(exp-1) - 1 = {bias}",
                height + 2
            ));
        }
    }

    /// What the published datapath asks for besides (`docs/published.md`, Parameters).
    fn published_problems(&self, problems: &mut Vec<String>) {
        if self.datapath.kind != DatapathKind::Published {
            return;
        }
        let (index, nudge, man) = (self.traverse.idx_bits(), self.datapath.nudge_bits, self.format.man);
        if index + nudge + man > 60 {
            problems.push(format!(
                "datapath.nudge_bits = {nudge} is too large for a texel coordinate of {index} bits and format.man = {man}: levels + tile_bits + 2 + nudge_bits + man = {} may be at most 60",
                index + nudge + man
            ));
        }
    }

    /// The published datapath is as it was published: without chord trim and level of detail.
    fn trim_problems(&self, problems: &mut Vec<String>) {
        if self.datapath.kind != DatapathKind::Published {
            return;
        }
        for (key, set) in [("mode.trim", self.mode.trim != Trim::None), ("mode.lod", self.mode.lod)] {
            if set {
                problems.push(format!("{key} is set, but datapath.kind = \"published\" does not have it"));
            }
        }
    }

    /// Where the bilinear refinement is (`docs/bilinear.md`, Parameters).
    fn bilinear_problems(&self, problems: &mut Vec<String>) {
        if !self.mode.bilinear {
            return;
        }
        let kind = self.datapath.kind;
        if kind != DatapathKind::Watertight {
            problems.push(format!(
                "mode.bilinear = true and datapath.kind = \"{}\" exclude each other: the refinement needs datapath.kind = \"watertight\"",
                kind.word()
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

    /// As [`Config::width_problems`], of the fixed-point datapath (`docs/fixed.md`, Parameters).
    fn fixed_problems(&self, problems: &mut Vec<String>) {
        let (f, w) = (self.datapath.fraction_bits, self.datapath.reciprocal_bits);
        let (levels, height, tiles) = (self.traverse.levels, self.traverse.height_bits, self.traverse.tile_bits);
        let mut most = |what: &str, value: u32, why: &str, limit: u32| {
            if value > limit {
                problems.push(format!("{what} = {value} is too large: {why} may be at most {limit}"));
            }
        };
        most("traverse.levels", levels, "with datapath.fraction_bits a texel's corner is exact, so it", f);
        most("traverse.height_bits", height, "with datapath.fraction_bits a height code is exact, so it", f);
        let index = self.traverse.idx_bits();
        most("traverse.levels + traverse.tile_bits + 2", index, "a texel coordinate", 24);
        most("datapath.fraction_bits + traverse.tile_bits", f + tiles, "a travel's magnitude", 32);
        let product = f + tiles + w;
        most("datapath.fraction_bits + traverse.tile_bits + datapath.reciprocal_bits", product, "their sum", 63);
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
pub(crate) fn report(problems: Vec<String>) -> Result<()> {
    match problems.as_slice() {
        [] => Ok(()),
        [one] => Err(Error::input(one.clone())),
        all => {
            let list: String = all.iter().map(|problem| format!("\n  - {problem}")).collect();
            Err(Error::input(format!("{} problems:{list}", all.len())))
        }
    }
}
