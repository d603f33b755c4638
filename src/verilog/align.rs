//! Columns: names of neighbouring declarations, pins and assignments stand below each other.

/// Ranges longer than this stand out instead of pushing their neighbours' names away.
const LONGEST: usize = 24;

/// What is aligned in a line: its kind, what stands before the column, and what from there on.
#[derive(PartialEq, Clone, Copy)]
enum Kind {
    Wire,
    Reg,
    Pin,
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
    let text = line.trim_start();
    if text.starts_with('.') && indent == 4 {
        let at = line.find('(')?;
        return Some((Kind::Pin, line[..at].trim_end(), &line[at..]));
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
        for (before, after) in &run {
            // Pins have their parenthesis at the column, all others a blank before it.
            let gap = if kind == Kind::Pin { "" } else { " " };
            out += &format!("{before:column$}{gap}{after}\n");
        }
        i += run.len();
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_aligned_and_nothing_else() {
        let text = "  wire a;\n  wire [3:0] b = a <= c;\n  assign x = y;\n  reg [W-1:0] q;\n  reg r;\n  // c\n    .clk(clk),\n    \
                    .in_data(x)\n      a <= b;\n      long_name <= c;\n";
        let expected = "  wire       a;\n  wire [3:0] b = a <= c;\n  assign x = y;\n  reg [W-1:0] q;\n  reg         r;\n  // c\n    \
                        .clk    (clk),\n    .in_data(x)\n      a         <= b;\n      long_name <= c;\n";
        assert_eq!(aligned(text), expected);
        assert_eq!(aligned(expected), expected);
    }
}
