//! Columns: names of neighbouring declarations, their comments, and assignments stand below each other.
use super::layout::COLUMNS;

/// Ranges longer than this stand out instead of pushing their neighbours' names away.
const LONGEST: usize = 24;

/// What stands before a comment.
pub(super) const COMMENT: &str = "  // ";

/// What is aligned in a line: its kind, what stands before the column, and what from there on.
#[derive(PartialEq, Clone, Copy)]
enum Kind {
    Wire,
    Reg,
    Store(usize),
}

fn parts(line: &str) -> Option<(Kind, &str, &str)> {
    let indent = line.len() - line.trim_start().len();
    let declared = |kind: Kind, word: &str| {
        let rest = line.strip_prefix("  ")?.strip_prefix(word)?.strip_prefix(' ')?;
        // The range, if there is one, ends with the first `] `: expressions in ranges have no blanks.
        let at = if rest.trim_start().starts_with('[') { rest.find("] ")? + 1 } else { 0 };
        let at = line.len() - rest.len() + at;
        Some((kind, line[..at].trim_end(), line[at..].trim_start()))
    };
    if let Some(found) = declared(Kind::Wire, "wire").or_else(|| declared(Kind::Reg, "reg")) {
        return Some(found);
    }
    let at = line.find(" <= ")?;
    let is_name = line[indent..at].trim_end().chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    (is_name && line.ends_with(';')).then(|| (Kind::Store(indent), line[..at].trim_end(), &line[at + 1..]))
}

/// Aligns every run of neighbouring lines of one kind.
pub fn aligned(text: &str) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let mut out = String::with_capacity(text.len() * 2);
    let mut i = 0;
    while i < lines.len() {
        let Some((kind, ..)) = parts(lines[i]) else {
            out += lines[i];
            out.push('\n');
            i += 1;
            continue;
        };
        let run: Vec<(&str, &str)> = lines[i..]
            .iter()
            .map_while(|l| parts(l).filter(|p| p.0 == kind).map(|(_, before, after)| (before, after)))
            .collect();
        let most = if matches!(kind, Kind::Wire | Kind::Reg) { LONGEST + "  wire ".len() } else { usize::MAX };
        let column = run.iter().map(|(before, _)| before.len()).filter(|n| *n <= most).max().unwrap_or(0);
        let lines: Vec<String> = run.iter().map(|(before, after)| format!("{before:column$} {after}")).collect();
        out += &commented(&lines);
        i += run.len();
    }
    out
}

/// Lines of a run with their comments below each other; what has no room for its comment has it on a line before.
pub(super) fn commented(lines: &[String]) -> String {
    let one_line = |l: &&str| !l.contains('\n');
    let split = |l: &str| {
        Some(l).filter(one_line)?.split_once(COMMENT).map(|(code, text)| (code.to_string(), text.to_string()))
    };
    let fits = |code: &str, text: &str, column: usize| code.len().max(column) + COMMENT.len() + text.len() <= COLUMNS;
    let alone = lines.iter().filter_map(|l| split(l)).filter(|(code, text)| fits(code, text, 0));
    let column = alone.map(|(code, _)| code.len()).max().unwrap_or(0);
    let line = |l: &String| match split(l) {
        None => format!("{l}\n"),
        Some((code, text)) if fits(&code, &text, column) => format!("{code:column$}{COMMENT}{text}\n"),
        Some((code, text)) if fits(&code, &text, 0) => format!("{code}{COMMENT}{text}\n"),
        Some((code, text)) => format!("{}{code}\n", above(&text)),
    };
    lines.iter().map(line).collect()
}

/// A comment on lines of its own.
pub(super) fn above(text: &str) -> String {
    let (mut out, mut line) = (String::new(), "  //".to_owned());
    for word in text.split(' ') {
        if line.len() + 1 + word.len() > COLUMNS {
            out += &format!("{line}\n");
            line = "  //".to_owned();
        }
        line += &format!(" {word}");
    }
    out + &line + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_aligned_and_nothing_else() {
        let text = "  wire a;\n  wire [3:0] b = a <= c;\n  assign x = y;\n  reg [W-1:0] q;\n  reg r;\n  // c\n      a <= b;\n      long_name <= c;\n";
        let expected = "  wire       a;\n  wire [3:0] b = a <= c;\n  assign x = y;\n  reg [W-1:0] q;\n  reg         r;\n  // c\n      \
                        a         <= b;\n      long_name <= c;\n";
        assert_eq!(aligned(text), expected);
        assert_eq!(aligned(expected), expected);
    }
}
