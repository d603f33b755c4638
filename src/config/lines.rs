//! On which line of a TOML text a key stands.
use reliefrtl_base::error::{Error, Result};
use reliefrtl_base::files::{SETTINGS, read_named_text};
use std::collections::HashMap;

/// The line of each section and key.
pub struct Lines {
    name: String,
    of: HashMap<String, usize>,
}

impl Lines {
    /// Reads the text; `name` stands for the file.
    pub fn of(text: &str, name: &str) -> Result<Self> {
        let table = toml::de::DeTable::parse(text).map_err(|error| syntax(text, name, &error))?;
        let mut of = HashMap::new();
        for (section, value) in table.get_ref() {
            of.insert(section.get_ref().to_string(), line(text, section.span().start));
            for (entry, _) in value.get_ref().as_table().into_iter().flatten() {
                of.insert(format!("{}.{}", section.get_ref(), entry.get_ref()), line(text, entry.span().start));
            }
        }
        Ok(Self { name: name.to_owned(), of })
    }

    /// File and line of this path.
    pub fn at(&self, path: &str) -> String {
        match self.of.get(path) {
            Some(line) => format!("{}, line {line}", self.name),
            None => self.name.clone(),
        }
    }
}

fn line(text: &str, offset: usize) -> usize {
    1 + text.as_bytes()[..offset.min(text.len())].iter().filter(|&&byte| byte == b'\n').count()
}

/// What the TOML reader said, in one sentence with the place.
pub fn syntax(text: &str, name: &str, error: &toml::de::Error) -> Error {
    let place = match error.span() {
        Some(span) => format!("{name}, line {}", line(text, span.start)),
        None => name.to_owned(),
    };
    Error::input(format!("not TOML ({place}): {}", error.message().trim().replace('\n', " ")))
}

/// The text of a TOML file.
pub fn read(path: &std::path::Path) -> Result<String> {
    read_named_text(path, SETTINGS)
}
