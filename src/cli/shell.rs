//! Words of a command as a shell reads them.

/// A word as a shell reads it back; in quotes only where it needs them.
pub fn word(text: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "_-+./=,:@%".contains(c);
    if !text.is_empty() && text.chars().all(plain) { text.to_owned() } else { quoted(text) }
}

/// A word in quotes, whatever stands in it.
pub fn quoted(text: &str) -> String {
    format!("'{}'", text.replace('\'', "'\\''"))
}

/// The words of a command that was put together by [`word`].
pub fn words(command: &str) -> Vec<String> {
    let (mut all, mut now, mut inside) = (Vec::new(), None::<String>, false);
    let mut text = command.chars();
    while let Some(c) = text.next() {
        match c {
            '\'' => {
                inside = !inside;
                now.get_or_insert_default();
            }
            '\\' if !inside => now.get_or_insert_default().extend(text.next()),
            c if c.is_whitespace() && !inside => all.extend(now.take()),
            c => now.get_or_insert_default().push(c),
        }
    }
    all.extend(now);
    all
}

#[cfg(test)]
mod tests {
    use super::{word, words};

    #[test]
    fn a_word_is_read_back() {
        let all = ["synth", "t=/a b/it's", "", "--set", "a\\b", "\"x\" $(y)", "new\nline"];
        assert_eq!(words(&all.map(word).join(" ")), all);
        assert_eq!(word("t=/a/b-1.v"), "t=/a/b-1.v");
    }
}
