//! What a figure was measured on: a digest of the text that goes to the tools.
use super::flow::texts;
use crate::ir::Module;
use std::sync::Arc;

/// Directives that no gate comes from.
const DIRECTIVES: [&str; 3] = ["`timescale", "`default_nettype", "`resetall"];

/// The code of a text: without comments and such directives, each run of white space as one space.
fn code(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while !rest.is_empty() {
        let after = |end: Option<usize>, skip: usize| end.map_or("", |at| &rest[at + skip..]);
        if rest.starts_with("//") || DIRECTIVES.iter().any(|d| rest.starts_with(d)) {
            rest = after(rest.find('\n'), 0);
        } else if rest.starts_with("/*") {
            rest = after(rest.find("*/"), 2);
            out.push(' ');
        } else if rest.starts_with('"') {
            // None of ours holds a quote with a backslash.
            let end = rest[1..].find('"').map_or(rest.len(), |at| at + 2);
            out += &rest[..end];
            rest = &rest[end..];
        } else {
            let c = rest.chars().next().unwrap_or_default();
            out.push(c);
            rest = &rest[c.len_utf8()..];
        }
    }
    out.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Digest of what is measured of `module`: the code of its file, of all that it holds and of the registers around it. Comments, banners, a prefix before
/// the names and the order of files don't count.
pub fn digest(module: &Arc<Module>, copies: u32) -> String {
    let mut all: Vec<String> =
        texts(module, copies).into_iter().map(|(_, text)| code(&String::from_utf8_lossy(&text))).collect();
    all.sort();
    blake3::hash(all.join("\n").as_bytes()).to_hex()[..32].to_string()
}

#[cfg(test)]
mod tests {
    use super::code;

    #[test]
    fn comments_and_white_space_are_no_code() {
        let text = "// banner\n`default_nettype none\nmodule m; /* a\n b */ wire  a;\n  initial $display(\"a // b  c\"); // end\nendmodule\n";
        assert_eq!(code(text), "module m; wire a; initial $display(\"a // b c\"); endmodule");
        assert_ne!(code("wire a;"), code("wire b;"));
    }
}
