//! The configuration as a TOML file that explains itself.
use super::Config;
use super::keys::{KEYS, Legal, SECTIONS};
use std::fmt::Write;

impl Config {
    /// The complete configuration with a comment above every key: meaning and legal values. It reads back as the same
    /// configuration. A key without a value (`map.file`), or that is only written where it is not the default, is shown as a comment.
    ///
    /// # Panics
    /// If a seed is above 2^63 - 1, which [`Config::validate`] refuses.
    pub fn to_commented_toml(&self) -> String {
        let table = self.table().expect("a valid configuration can be written");
        let mut text = String::from(
            "# Configuration of reliefrtl. Every key is optional; what is missing has the default value.\n",
        );
        for (section, heading) in SECTIONS {
            // Writing to a string can't fail, here and below.
            let _ = write!(text, "\n# {heading}\n[{section}]\n");
            for key in KEYS.iter().filter(|key| key.split().0 == *section) {
                let name = key.split().1;
                let _ = match key.legal {
                    Legal::Flag | Legal::Path | Legal::Number | Legal::Mark | Legal::Text => {
                        writeln!(text, "# {}.", key.about)
                    }
                    legal => writeln!(text, "# {}: {legal}.", key.about.replace(':', ",")),
                };
                // What the datapath has no use for must not be given to it.
                let unread = self.datapath.kind.facts().ignores(key.path);
                let value = table.get(*section).and_then(|entries| entries.get(name)).filter(|_| !unread);
                let _ = match value {
                    Some(value) => writeln!(text, "{name} = {value}"),
                    None => writeln!(text, "# {name} = {}", example(key.path)),
                };
            }
        }
        text
    }
}

/// What a key without a value could be; the default of those that have one.
fn example(path: &str) -> String {
    match path {
        "datapath.search" => "\"pyramid\"".into(),
        "windows.set" => "\"1 4@2 12@4 40@8\"".into(),
        "fetch.cells" | "mode.levels_down_after" => "1".into(),
        "map.file" => "\"map.png\"".into(),
        "map.range" => "[0.0, 100.0]".into(),
        "map.nodata" => "-9999.0".into(),
        "map.fill" => "0.0".into(),
        "map.channel" => "\"Y\"".into(),
        "map.part" => "\"0\"".into(),
        "map.size" => "[1024, 1024]".into(),
        "map.byte_order" => "\"little\"".into(),
        "map.max_texels" => super::MapConfig::MAX_TEXELS.to_string(),
        "emit.counters" => "\"all\"".into(),
        "mode.start_level" => "true".into(),
        "mode.levels_down" => "2".into(),
        "mode.level_up" => "\"selective\"".into(),
        "mode.trim" => "\"none\"".into(),
        _ => "false".into(),
    }
}
