//! The command that traces one ray of a configuration again.
use crate::config::Config;
use serde_json::Value;
use std::path::Path;

/// `--set key=value` of everything in `c` that is not the default.
pub fn settings(c: &Config) -> String {
    let plain = |c: &Config| serde_json::to_value(c).expect("a configuration is plain data");
    let (now, usual) = (plain(c), plain(&Config::default()));
    let mut out = String::new();
    for (section, keys) in now.as_object().into_iter().flatten() {
        for (key, value) in keys.as_object().into_iter().flatten() {
            let skip = usual[section].get(key) == Some(value)
                || section == "view"
                || key == "file"
                || key == "kind" && section == "map" && value == "file";
            if !skip {
                let value = value.as_str().map_or_else(|| Value::to_string(value), str::to_owned);
                // Brackets and blanks mean something to a shell.
                let plain = value.chars().all(|c| c.is_ascii_alphanumeric() || "._,-".contains(c));
                let value = if plain { value } else { format!("'{}'", value.replace('\'', "'\\''")) };
                out += &format!(" --set {section}.{key}={value}");
            }
        }
    }
    out
}

/// Traces a ray (u, v, du, dv, in tiles of the map) again with the configuration's design on its map, or on that of `file`.
pub fn trace_again(c: &Config, file: Option<&Path>, numbers: [f64; 4]) -> String {
    let mut c = c.clone();
    (c.vectors, c.latency, c.emit) = Default::default();
    let map = file.map_or(String::new(), |f| format!(" --map '{}'", f.display()));
    again(numbers, &(map + &settings(&c)))
}

/// A ray as a table, its hit as another.
pub fn again([u, v, du, dv]: [f64; 4], arguments: &str) -> String {
    format!(
        "printf 'u,v,du,dv\\n{u:?},{v:?},{du:?},{dv:?}\\n' > ray.csv && reliefrtl trace --engine golden --rays ray.csv --out hit.csv{arguments}; cat hit.csv"
    )
}
