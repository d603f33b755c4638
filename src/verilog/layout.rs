//! Ranges, literals and line breaks.
use reliefrtl_ir::{Atom, Expr, Func};

/// The longest line that is printed, in columns.
pub const COLUMNS: usize = 100;

/// `[EXP_W-1:0]`, or nothing for one bit.
pub fn range(w: &Expr) -> String {
    if w.as_const() == Some(1) { String::new() } else { format!("[{}:0]", tight(&(w.clone() - 1))) }
}

/// An expression without blanks, as it stands in ranges.
pub fn tight(e: &Expr) -> String {
    e.to_string().replace(' ', "")
}

/// `{N{1'b0}}` or `{N{1'b1}}`.
pub fn fill(w: &Expr, bit: u8) -> String {
    match w.as_const() {
        Some(1) => format!("1'b{bit}"),
        Some(k) if bit == 0 => format!("{k}'d0"),
        Some(k) => format!("{{{k}{{1'b1}}}}"),
        None => format!("{{{}{{1'b{bit}}}}}", group(w)),
    }
}

/// A literal of `w` bits.
pub fn literal(v: u64, w: &Expr) -> String {
    let need = (64 - v.leading_zeros()).max(1);
    match w.as_const() {
        Some(1) => format!("1'b{v}"),
        Some(k) => format!("{k}'d{v}"),
        None if v == 0 => fill(w, 0),
        None => format!("{{{}, {need}'{}{v}}}", fill(&(w.clone() - need), 0), if need == 1 { "b" } else { "d" }),
    }
}

/// Parentheses where the expression is not a single name or number.
pub fn group(w: &Expr) -> String {
    let (terms, k) = w.parts();
    let single = match (terms, k) {
        ([], k) => k >= 0,
        ([(Atom::Param(_) | Atom::Local(..), 1)], 0) => true,
        _ => false,
    };
    if single { w.to_string() } else { format!("({w})") }
}

/// An expression without the one pair of parentheses that holds all of it.
pub fn bare(text: &str) -> &str {
    let mut depth = 0i32;
    let mut inside = |c: char| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        depth >= 0
    };
    let inner = text.strip_prefix('(').and_then(|t| t.strip_suffix(')'));
    inner.filter(|t| t.chars().all(&mut inside)).unwrap_or(text)
}

/// True where a constant may need more than 31 bits on the way.
pub fn is_wide(e: &Expr) -> bool {
    e.parts().0.iter().any(|(a, _)| matches!(a, Atom::Call(Func::Div, _)))
}

/// A constant expression in 64-bit arithmetic (no negative intermediate values).
pub fn wide(e: &Expr) -> String {
    let (terms, k) = e.parts();
    let mut out = String::new();
    for (a, c) in terms {
        let text = match a {
            Atom::Call(Func::Pow2, x) => format!("(64'd1 << {})", group(&x[0])),
            Atom::Param(name) | Atom::Local(name, _) => name.clone(),
            Atom::Call(Func::Div, x) => format!("(({}) / ({}))", wide(&x[0]), wide(&x[1])),
            other => panic!("{other} can't stand in a wide constant"),
        };
        if !out.is_empty() || *c < 0 {
            out += if *c < 0 { " - " } else { " + " };
        }
        out += &if c.abs() == 1 { text } else { format!("64'd{} * {text}", c.abs()) };
    }
    match k {
        0 => out,
        k if k < 0 => format!("{out} - 64'd{}", -k),
        k if out.is_empty() => format!("64'd{k}"),
        k => format!("{out} + 64'd{k}"),
    }
}

/// Breaks a long line at the blanks that lie least deep in parentheses; continuation lines are indented by 4 more.
pub fn wrap(line: &str) -> String {
    if line.len() <= COLUMNS || line.trim_start().starts_with("//") {
        return format!("{line}\n");
    }
    let indent = line.len() - line.trim_start().len();
    let mut depth = 0i32;
    let mut best: Option<(i32, usize)> = None;
    for (i, c) in line.char_indices() {
        match c {
            '(' | '{' | '[' => depth += 1,
            ')' | '}' | ']' => depth -= 1,
            ' ' if i > indent + 8 && i <= COLUMNS => {
                // A choice is broken before its colon; between condition and choice only where nothing else is left.
                let rank = depth * 2 + i32::from(line[..i].ends_with(" ?"));
                if breaks_well(&line[..i], &line[i + 1..]) && best.is_none_or(|(least, _)| rank <= least) {
                    best = Some((rank, i));
                }
            }
            _ => {}
        }
    }
    match best {
        Some((_, at)) => {
            let opens = ["wire", "assign", "localparam", "."].iter().any(|w| line.trim_start().starts_with(w));
            let rest = format!("{}{}", " ".repeat(indent + if opens { 4 } else { 0 }), &line[at + 1..]);
            format!("{}\n{}", line[..at].trim_end(), wrap(&rest))
        }
        None => format!("{line}\n"),
    }
}

/// A break stands after `=`, `?`, `,` or before `:` and after binary operators.
fn breaks_well(before: &str, after: &str) -> bool {
    let ends = ["=", "?", ",", "|", "&", "^", "+"]
        .iter()
        .any(|e| before.ends_with(&format!(" {e}")) || (*e == "," && before.ends_with(',')));
    ends || after.starts_with(": ")
}

/// A concatenation over as many lines as it takes: what opens it, its members, what closes it.
pub fn filled<'a>(open: &str, members: impl IntoIterator<Item = &'a String>, close: &str) -> String {
    let (mut out, mut line) = (String::new(), open.to_string());
    let mut members = members.into_iter().peekable();
    while let Some(m) = members.next() {
        let end = if members.peek().is_some() { "," } else { close };
        if line.len() + m.len() + end.len() > COLUMNS && line.trim_start().len() > 1 {
            out += &format!("{}\n", line.trim_end());
            line = " ".repeat(open.len());
        }
        line += &format!("{m}{end} ");
    }
    out + line.trim_end() + "\n"
}
