//! What the parts of a module's text have in common: the module, its names, the text so far.
use super::apart::Apart;
use super::bundle::Bundles;
use super::layout::{COLUMNS, range};
use super::style::Style;
use super::widths::named;
use reliefrtl_ir::{Expr, Module, Names};

/// A module's text under construction.
pub(super) struct Printer<'m> {
    pub names: Names<'m>,
    pub bundles: Bundles,
    pub apart: Apart,
    pub m: &'m Module,
    pub style: &'m Style,
    pub out: String,
}

/// Whether `word` occurs in `text` as a whole word.
pub(super) fn has_word(text: &str, word: &str) -> bool {
    text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).any(|w| w == word)
}

impl Printer<'_> {
    /// A line of the body; it is broken when the whole body stands.
    pub fn line(&mut self, s: &str) {
        self.out += s;
        self.out.push('\n');
    }

    /// A declaration: kind and range, name, value (or nothing), comment (or nothing).
    pub fn declaration(&mut self, kind: &str, width: &Expr, net: &str, value: &str, doc: Option<&str>) {
        let r = self.range(width);
        let blank = if r.is_empty() { "" } else { " " };
        let comment = doc.map_or(String::new(), |d| format!("  // {d}"));
        self.line(&format!("  {kind} {r}{blank}{net}{value};{comment}"));
    }

    /// The range of a width in the body: by the `localparam` that has the same value everywhere, where there is one.
    pub fn range(&self, w: &Expr) -> String {
        range(&named(self.m, w))
    }

    /// A comment that starts with `head`; further lines stand under the text that follows it.
    pub fn comment(&mut self, indent: &str, head: &str, text: &str) {
        let mut line = format!("{indent}// {head}");
        for word in text.split_whitespace() {
            if line.len() + 1 + word.len() > COLUMNS {
                self.out += line.trim_end();
                self.out.push('\n');
                line = format!("{indent}// {}", " ".repeat(head.len()));
            } else if !line.ends_with(' ') {
                line.push(' ');
            }
            line += word;
        }
        self.out += line.trim_end();
        self.out.push('\n');
    }

    /// A heading.
    pub fn rule(&mut self, text: &str) {
        let head = format!("\n  // ---- {text} ");
        self.line(&format!("{head}{}", "-".repeat(91usize.saturating_sub(head.len()))));
    }

    /// The heading of a step of the body, and why it is done so.
    pub fn heading(&mut self, stage: u32, title: &str, reason: &str) {
        let text = match (self.names.staged, title) {
            (true, "") => format!("stage {stage}"),
            (true, t) => format!("stage {stage}: {t}"),
            (false, t) => t.to_string(),
        };
        self.rule(&text);
        if !reason.is_empty() {
            self.comment("  ", "", reason);
        }
    }
}
