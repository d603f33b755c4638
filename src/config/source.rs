//! Reading: a TOML file, and `--set`.
use super::check;
use super::keys::{self, Legal, SECTIONS};
use super::lines::{self, Lines, syntax};
use super::{Config, validate};
use reliefrtl_base::alike::nearest;
use reliefrtl_base::error::{Error, Result};
use std::path::Path;
use toml::{Table, Value};

impl Config {
    /// Reads a TOML file over the defaults. Every key is optional; an unknown key, a wrong type or a value out of range
    /// is an error that names file and line. A relative `map.file` starts at the file's directory.
    ///
    /// # Errors
    /// [`Error::File`] if the file can't be read, [`Error::Input`] with all problems if its text is wrong.
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let name = path.display().to_string();
        let text = lines::read(path)?;
        let mut config = Self::from_toml(&text, &name)?;
        if let (Some(file), Some(directory)) = (&config.map.file, path.parent()) {
            config.map.file = Some(directory.join(file));
        }
        Ok(config)
    }

    /// As [`Config::load`], from text; `name` stands for the file in the sentences.
    ///
    /// # Errors
    /// [`Error::Input`] with all problems.
    pub fn from_toml(text: &str, name: &str) -> Result<Self> {
        let lines = Lines::of(text, name)?;
        let table: Table = toml::from_str(text).map_err(|error| syntax(text, name, &error))?;
        let mut problems = Vec::new();
        for (section, value) in &table {
            if !SECTIONS.iter().any(|(known, _)| known == section) {
                problems.push(unknown_section(section, value, &lines));
                continue;
            }
            let Value::Table(entries) = value else {
                let shown = check::show(value);
                problems.push(format!(
                    "{section} = {shown} is not a section: write [{section}] and its keys below ({})",
                    lines.at(section)
                ));
                continue;
            };
            for (entry, value) in entries {
                let path = format!("{section}.{entry}");
                let place = lines.at(&path);
                match keys::find(&path) {
                    None => problems.push(unknown(&path, &place)),
                    Some(key) => problems.extend(check::problem(key, value).map(|text| format!("{text} ({place})"))),
                }
            }
        }
        validate::report(problems)?;
        // Everything below was checked above, so an error here is a key that the table describes wrongly.
        let mut config: Self = toml::from_str(text).map_err(|error| syntax(text, name, &error))?;
        let written = |key: &&keys::Key| {
            let (section, entry) = key.split();
            table.get(section).and_then(Value::as_table).is_some_and(|entries| entries.contains_key(entry))
        };
        keys::KEYS.iter().filter(written).for_each(|key| config.given.add(key.path));
        config.follow_cells(Self::default().usual_levels_down());
        Ok(config)
    }

    /// Applies one `key.path=value` as given to `--set`. The value is TOML; a bare word is a string, and a list of words
    /// may be written without brackets and quotes: `view.names=front,grazing`. The word none takes a key back that may be absent: `map.range=none`.
    ///
    /// # Errors
    /// [`Error::Input`]: no `=`, an unknown key, a wrong type, a value out of range. The configuration is then unchanged.
    pub fn apply_set(&mut self, assignment: &str) -> Result<()> {
        let Some((path, text)) = assignment.split_once('=') else {
            return Err(Error::input(format!("--set {assignment} has no value: write --set key=value")));
        };
        let (path, text) = (path.trim(), text.trim());
        if path.is_empty() {
            return Err(Error::input(format!("--set {assignment} names no key: write --set key=value")));
        }
        let key = keys::find(path).ok_or_else(|| Error::input(unknown(path, "--set")))?;
        let mut table = self.table()?;
        let (section, name) = key.split();
        let Value::Table(entries) = table.entry(section).or_insert_with(|| Value::Table(Table::new())) else {
            unreachable!("every section is a table");
        };
        if key.legal.optional() && text.is_empty() {
            let legal = key.legal;
            return Err(Error::input(format!("{path} has no value (--set): {legal} is legal, and none takes it back")));
        }
        if key.legal.optional() && text == "none" {
            entries.remove(name);
        } else {
            let value = parse(text, key.legal);
            if let Some(problem) = check::problem(key, &value) {
                return Err(Error::input(format!("{problem} (--set)")));
            }
            entries.insert(name.to_owned(), value);
        }
        let usual = self.usual_levels_down();
        let mut given = std::mem::take(&mut self.given);
        let read = table
            .try_into()
            .map_err(|error: toml::de::Error| Error::input(format!("{} (--set {assignment})", error.message())));
        *self = read?;
        if key.legal.optional() && text == "none" {
            given.remove(key.path)
        } else {
            given.add(key.path)
        }
        self.given = given;
        self.follow_cells(usual);
        Ok(())
    }

    /// The configuration as plain TOML values.
    pub(super) fn table(&self) -> Result<Table> {
        // TOML has signed 64-bit integers only; a larger seed can come from code, never from a file.
        Table::try_from(self)
            .map_err(|error| Error::input(format!("the configuration can't be written as TOML: {error}")))
    }
}

/// The value of `--set`: TOML if it is, else a string.
fn parse(text: &str, legal: Legal) -> Value {
    let parsed = toml::from_str::<Table>(&format!("value = {text}")).ok().filter(|table| table.len() == 1);
    let value = parsed.and_then(|mut table| table.remove("value")).unwrap_or_else(|| Value::String(text.to_owned()));
    match (legal, value) {
        // `map.file=1` or `emit.prefix=true` is a name that happens to read as something else.
        (Legal::Path | Legal::Word(_) | Legal::Prefix | Legal::Text | Legal::Set, value) if !value.is_str() => {
            Value::String(text.to_owned())
        }
        (Legal::Range | Legal::Size, Value::String(list)) if list.contains(',') => {
            let list = list.trim_matches(['[', ']']);
            let parsed = toml::from_str::<Table>(&format!("value = [{list}]")).ok();
            parsed.and_then(|mut table| table.remove("value")).unwrap_or_else(|| Value::String(text.to_owned()))
        }
        (Legal::SomeWords(_), Value::String(words)) if words.is_empty() => Value::Array(Vec::new()),
        (Legal::Words(_) | Legal::SomeWords(_), Value::String(words)) => Value::Array(
            words.trim_matches(['[', ']']).split(',').map(|word| Value::String(word.trim().to_owned())).collect(),
        ),
        (_, value) => value,
    }
}

fn unknown(path: &str, place: &str) -> String {
    match keys::nearest(path) {
        Some(near) => format!("unknown key {path} ({place}): did you mean {near}?"),
        None => format!("unknown key {path} ({place}): `reliefrtl config --print` shows all"),
    }
}

fn unknown_section(section: &str, value: &Value, lines: &Lines) -> String {
    if !value.is_table() {
        return unknown(section, &lines.at(section));
    }
    let known = || SECTIONS.iter().map(|(known, _)| *known);
    let guess = match nearest(section, known()) {
        Some(near) => format!("did you mean [{near}]?"),
        None => format!("there are {}", known().collect::<Vec<_>>().join(", ")),
    };
    format!("unknown section [{section}] ({}): {guess}", lines.at(section))
}
