//! Rust text as tokens, as far as imports and the lengths of functions need them.

/// A word, a number, `::`, or one other character; strings and characters are one token `"`, comments none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    pub text: String,
    /// From 1.
    pub line: usize,
}

impl Token {
    pub fn is(&self, text: &str) -> bool {
        self.text == text
    }

    pub fn is_word(&self) -> bool {
        self.text.starts_with(|c: char| c.is_alphabetic() || c == '_')
    }
}

/// The text that is left to read, and its line.
struct Reader<'a> {
    rest: &'a str,
    line: usize,
}

impl Reader<'_> {
    /// Goes on by `bytes`, counting lines.
    fn skip(&mut self, bytes: usize) {
        let (gone, rest) = self.rest.split_at(bytes);
        self.line += gone.matches('\n').count();
        self.rest = rest;
    }

    fn skip_comment(&mut self) {
        let mut depth = 0;
        loop {
            match self.rest {
                r if r.starts_with("/*") => depth += 1,
                r if r.starts_with("*/") => depth -= 1,
                r => {
                    self.skip(r.chars().next().expect("the comment is closed").len_utf8());
                    continue;
                }
            }
            self.skip(2);
            if depth == 0 {
                return;
            }
        }
    }

    /// Skips what stands between `"` and `"`, the first of which is next.
    fn skip_string(&mut self) {
        self.skip(1);
        while !self.rest.starts_with('"') {
            let n = if self.rest.starts_with('\\') { 2 } else { self.rest.chars().next().expect("closed").len_utf8() };
            self.skip(n);
        }
        self.skip(1);
    }

    /// Skips a raw string, whose `#` or `"` is next.
    fn skip_raw(&mut self) {
        let hashes = self.rest.len() - self.rest.trim_start_matches('#').len();
        let end = format!("\"{}", "#".repeat(hashes));
        let close = self.rest[hashes + 1..].find(&end).expect("a raw string is closed");
        self.skip(hashes + 1 + close + end.len());
    }

    /// Skips a character; `false` if it is a lifetime.
    fn skip_char(&mut self) -> bool {
        let mut chars = self.rest[1..].chars();
        let first = chars.next().unwrap_or(' ');
        if first == '\\' {
            let close = self.rest[3..].find('\'').expect("a character is closed");
            self.skip(3 + close + 1);
            return true;
        }
        let is_char = chars.next() == Some('\'');
        self.skip(if is_char { 2 + first.len_utf8() } else { 1 });
        is_char
    }
}

/// All tokens of a file.
pub fn tokens(text: &str) -> Vec<Token> {
    let mut r = Reader { rest: text, line: 1 };
    let mut out = Vec::new();
    while let Some(c) = r.rest.chars().next() {
        let line = r.line;
        let word = |s: &str| s.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(s.len());
        let raw = |s: &str| s.starts_with('"') || s.trim_start_matches('#').starts_with('"');
        let text = match c {
            c if c.is_whitespace() => {
                r.skip(c.len_utf8());
                continue;
            }
            '/' if r.rest.starts_with("//") => {
                r.skip(r.rest.find('\n').unwrap_or(r.rest.len()));
                continue;
            }
            '/' if r.rest.starts_with("/*") => {
                r.skip_comment();
                continue;
            }
            '"' => {
                r.skip_string();
                "\"".to_owned()
            }
            '\'' => String::from(if r.skip_char() { "\"" } else { "'" }),
            ':' if r.rest.starts_with("::") => {
                r.skip(2);
                "::".to_owned()
            }
            c if c.is_alphanumeric() || c == '_' => {
                let n = word(r.rest);
                let (text, after) = (r.rest[..n].to_owned(), &r.rest[n..]);
                match text.as_str() {
                    "r" | "br" if raw(after) => {
                        r.skip(n);
                        r.skip_raw();
                        "\"".to_owned()
                    }
                    // A byte string or character: the letter is no word.
                    "b" if after.starts_with(['"', '\'']) => {
                        r.skip(n);
                        continue;
                    }
                    _ => {
                        r.skip(n);
                        text
                    }
                }
            }
            c => {
                r.skip(c.len_utf8());
                c.to_string()
            }
        };
        out.push(Token { text, line });
    }
    out
}

/// The position of the bracket that closes the one at `open`.
pub fn closing(tokens: &[Token], open: usize) -> usize {
    let mut depth = 0;
    for (k, t) in tokens.iter().enumerate().skip(open) {
        match t.text.as_str() {
            "{" | "(" | "[" => depth += 1,
            "}" | ")" | "]" => depth -= 1,
            _ => continue,
        }
        if depth == 0 {
            return k;
        }
    }
    panic!("line {}: the bracket is not closed", tokens[open].line);
}

#[test]
fn text_is_taken_apart() {
    let seen = |s: &str| tokens(s).iter().map(|t| t.text.clone()).collect::<Vec<_>>().join(" ");
    assert_eq!(seen("a::b /* c /* d */ */ + 'x' // e\n'f"), "a :: b + \" ' f");
    assert_eq!(seen(r##"r#"x"y"# b'\'' "\"{" b"z" '\u{1}' 0x1f"##), "\" \" \" \" \" 0x1f");
    assert_eq!(tokens("a\n/* \n */ \"\n\" b").iter().map(|t| t.line).collect::<Vec<_>>(), [1, 3, 4]);
    assert_eq!(closing(&tokens("f ( a [ b ] ) c"), 1), 6);
}
