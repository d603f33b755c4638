//! One value against what its key accepts, as a sentence.
use super::WindowSet;
use super::keys::{Key, Legal};
use reliefrtl_base::alike::nearest;
use toml::Value;

/// What is wrong with `value` for `key`; `None` if nothing is.
///
/// The sentence names the key, the value and what is legal; the caller adds where it stands.
pub fn problem(key: &Key, value: &Value) -> Option<String> {
    let path = key.path;
    let legal = key.legal;
    let shown = show(value);
    match (legal, value) {
        (Legal::Whole(low, high), Value::Integer(number)) => range(path, &shown, legal, *number < low, *number > high),
        (Legal::Numbers(list), Value::Integer(number)) if list.contains(number) => None,
        (Legal::Numbers(_), _) => Some(format!("{path} = {shown} is neither of what is legal: {legal}")),
        (Legal::Whole(..), _) => Some(format!("{path} = {shown} is not a whole number: {legal} are legal")),
        (Legal::Real(low, high), Value::Integer(number)) => {
            let number = *number as f64;
            range(path, &shown, legal, number < low, number > high)
        }
        (Legal::Real(low, high), Value::Float(number)) if !number.is_nan() => {
            range(path, &shown, legal, *number < low, *number > high)
        }
        (Legal::Real(..), _) => Some(format!("{path} = {shown} is not a number: {legal} are legal")),
        (Legal::Path | Legal::Text, Value::String(text)) if text.contains('\0') => {
            Some(format!("{path} = {shown} has a NUL in it, which no name has"))
        }
        (Legal::Path, Value::String(text)) if text.is_empty() => Some(format!("{path} is empty: a path is legal")),
        (Legal::Flag, Value::Boolean(_)) | (Legal::Path, Value::String(_)) => None,
        (Legal::Flag, _) => Some(format!("{path} = {shown} is neither true nor false")),
        (Legal::Path, _) => Some(format!("{path} = {shown} is not a path in quotes")),
        (Legal::Number, value) if number(value).is_some() => None,
        (Legal::Number, _) => Some(format!("{path} = {shown} is not a finite number")),
        (Legal::Mark, Value::Float(mark)) if !mark.is_nan() => None,
        (Legal::Mark, Value::Integer(_)) => None,
        (Legal::Mark, _) => Some(format!("{path} = {shown} is not {legal} (what is not a number has no data anyway)")),
        (Legal::Text, Value::String(text)) if !text.is_empty() => None,
        (Legal::Text, _) => Some(format!("{path} = {shown} is not a text in quotes")),
        (Legal::Range, value) if is_range(value) => None,
        (Legal::Range, _) => Some(format!("{path} = {shown} is no range: {legal} is legal")),
        (Legal::Set, Value::String(text)) => {
            text.parse::<WindowSet>().err().map(|problem| format!("{path} = {shown} {problem}"))
        }
        (Legal::Set, _) => Some(format!("{path} = {shown} is no set of windows: {legal}, is legal")),
        (Legal::Size, value) if is_size(value) => None,
        (Legal::Size, _) => Some(format!("{path} = {shown} is no size: {legal}, is legal")),
        (Legal::Word(words), Value::String(word)) => word_problem(path, word, words),
        (Legal::Word(_), _) => Some(format!("{path} = {shown} is not one of {legal}")),
        (Legal::SomeWords(_), Value::Array(list)) if list.is_empty() => None,
        (Legal::Words(words) | Legal::SomeWords(words), Value::Array(list)) => words_problem(path, list, words),
        (Legal::Words(_) | Legal::SomeWords(_), _) => {
            Some(format!("{path} = {shown} is not a list in brackets of {legal}"))
        }
        (Legal::Prefix, Value::String(text)) if is_prefix(text) => None,
        (Legal::Timescale, Value::String(text)) if is_timescale(text) => None,
        (Legal::Timescale, _) => Some(format!("{path} = {shown} is no time scale: {legal}")),
        (Legal::Prefix, _) => Some(format!("{path} = {shown} can't stand before a module's name: {legal}")),
    }
}

/// A finite number.
fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Integer(number) => Some(*number as f64),
        Value::Float(number) if number.is_finite() => Some(*number),
        _ => None,
    }
}

fn is_range(value: &Value) -> bool {
    match value {
        Value::String(word) => word == "auto",
        Value::Array(list) => match list.as_slice() {
            [low, high] => {
                number(low).zip(number(high)).is_some_and(|(low, high)| low < high && (high - low).is_finite())
            }
            _ => false,
        },
        _ => false,
    }
}

fn is_size(value: &Value) -> bool {
    let side = |value: &Value| value.as_integer().is_some_and(|side| (1..=i64::from(i32::MAX)).contains(&side));
    value.as_array().is_some_and(|list| list.len() == 2 && list.iter().all(side))
}

fn range(path: &str, shown: &str, legal: Legal, below: bool, above: bool) -> Option<String> {
    let side = match (below, above) {
        (true, _) => "small",
        (_, true) => "large",
        _ => return None,
    };
    Some(format!("{path} = {shown} is too {side}: {legal} are legal"))
}

fn word_problem(path: &str, word: &str, words: &[&str]) -> Option<String> {
    if words.contains(&word) {
        return None;
    }
    let list = words.join(", ");
    let near = nearest(word, words.iter().copied()).filter(|_| words.len() > 1);
    let guess = near.map_or(String::new(), |near| format!("; did you mean {near:?}?"));
    let one_of = if words.len() == 1 { "" } else { "one of " };
    Some(format!("{path} = {word:?} is not {one_of}{list}{guess}"))
}

fn words_problem(path: &str, list: &[Value], words: &[&str]) -> Option<String> {
    if list.is_empty() {
        return Some(format!("{path} is empty: at least one of {} is needed", words.join(", ")));
    }
    let mut seen = Vec::new();
    for value in list {
        let Value::String(word) = value else {
            return Some(format!("{path} holds {}, which is not one of {}", show(value), words.join(", ")));
        };
        if let Some(problem) = word_problem(path, word, words) {
            return Some(problem);
        }
        if seen.contains(&word) {
            return Some(format!("{path} names {word:?} twice: once is enough"));
        }
        seen.push(word);
    }
    None
}

/// True if `text` may stand before a module's name: the start of an identifier, at most 32 characters.
pub fn is_prefix(text: &str) -> bool {
    text.len() <= 32
        && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        && !text.starts_with(|c: char| c.is_ascii_digit())
}

/// True for nothing, or `unit/precision` as a `timescale` takes it.
fn is_timescale(text: &str) -> bool {
    // In powers of ten of a femtosecond.
    let exponent = |time: &str| {
        let at = time.find(|c: char| !c.is_ascii_digit())?;
        let count = ["1", "10", "100"].iter().position(|n| *n == &time[..at])?;
        let unit = ["fs", "ps", "ns", "us", "ms", "s"].iter().position(|n| *n == &time[at..])?;
        Some(3 * unit + count)
    };
    let times = || {
        let (unit, precision) = text.split_once('/')?;
        Some((exponent(unit)?, exponent(precision)?))
    };
    text.is_empty() || times().is_some_and(|(unit, precision)| precision <= unit)
}

/// A number in at most some twenty characters: a power of ten stands after a very small or very large one.
pub fn plain(number: f64) -> String {
    if number == 0.0 || !number.is_finite() || (1e-6..1e16).contains(&number.abs()) {
        number.to_string()
    } else {
        format!("{number:e}")
    }
}

/// A value as it would stand in the file, cut if it is long.
pub fn show(value: &Value) -> String {
    let text = match value {
        Value::String(text) => format!("{text:?}"),
        Value::Float(number) => {
            let text = plain(*number);
            // As TOML has it: a whole number is another thing.
            if text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'-') { text + ".0" } else { text }
        }
        Value::Array(list) => format!("[{}]", list.iter().map(show).collect::<Vec<_>>().join(", ")),
        other => other.to_string(),
    };
    let mut line = text.replace('\n', " ");
    if line.chars().count() > 60 {
        line = line.chars().take(57).chain("...".chars()).collect();
    }
    line
}
