//! Words of a text file, one after the other, without the file in memory.
use super::opened::broken;
use crate::source::Handle;
use reliefrtl_base::error::Result;
use std::io::{BufRead, Seek};

/// No number is longer.
const LONGEST: usize = 64;

/// Reads words separated by white space.
pub(super) struct Words<'a> {
    handle: Handle<'a>,
    kind: &'static str,
    /// `#` starts a comment that goes on to the end of its line.
    comments: bool,
}

impl<'a> Words<'a> {
    /// The words from where the handle stands.
    pub(super) fn new(handle: Handle<'a>, kind: &'static str, comments: bool) -> Self {
        Self { handle, kind, comments }
    }

    fn peek(&mut self) -> Result<Option<u8>> {
        loop {
            match self.handle.fill_buf() {
                Ok(bytes) => return Ok(bytes.first().copied()),
                Err(error) if error.kind() == std::io::ErrorKind::Interrupted => {}
                Err(error) => return Err(broken(self.kind, error)),
            }
        }
    }

    /// The first byte of the next word.
    fn skip(&mut self) -> Result<Option<u8>> {
        let mut comment = false;
        loop {
            let Some(byte) = self.peek()? else { return Ok(None) };
            if comment {
                comment = byte != b'\n' && byte != b'\r';
            } else if self.comments && byte == b'#' {
                comment = true;
            } else if !byte.is_ascii_whitespace() {
                return Ok(Some(byte));
            }
            self.handle.consume(1);
        }
    }

    /// The next word, of at most 64 bytes; what comes after it was not read.
    pub(super) fn next(&mut self) -> Result<Option<String>> {
        let Some(mut byte) = self.skip()? else { return Ok(None) };
        let mut word = Vec::new();
        while !(byte.is_ascii_whitespace() || self.comments && byte == b'#') {
            if word.len() == LONGEST {
                return Err(broken(
                    self.kind,
                    format!("{:?}... is no word of it", String::from_utf8_lossy(&word[..20])),
                ));
            }
            word.push(byte);
            self.handle.consume(1);
            match self.peek()? {
                Some(next) => byte = next,
                None => break,
            }
        }
        Ok(Some(String::from_utf8_lossy(&word).into_owned()))
    }

    /// The next byte that is no white space.
    pub(super) fn byte(&mut self) -> Result<Option<u8>> {
        let byte = self.skip()?;
        if byte.is_some() {
            self.handle.consume(1);
        }
        Ok(byte)
    }

    /// The rest of the line, without the end of the line.
    pub(super) fn line(&mut self) -> Result<String> {
        let mut line = Vec::new();
        while let Some(byte) = self.peek()? {
            self.handle.consume(1);
            if byte == b'\n' {
                break;
            }
            if line.len() < 1000 {
                line.push(byte);
            }
        }
        Ok(String::from_utf8_lossy(&line).trim().to_owned())
    }

    /// A whole number that `what` stands for.
    pub(super) fn whole(&mut self, what: &str) -> Result<u64> {
        self.digits(|| what.to_owned())
    }

    /// The whole number of column `x` of row `y`.
    pub(super) fn whole_at(&mut self, x: usize, y: usize) -> Result<u64> {
        self.digits(|| format!("pixel ({x}, {y})"))
    }

    fn digits(&mut self, what: impl Fn() -> String) -> Result<u64> {
        let word = self.next()?.ok_or_else(|| broken(self.kind, format!("it ends before {}", what())))?;
        let digits = word.bytes().all(|byte| byte.is_ascii_digit());
        word.parse().ok().filter(|_| digits).ok_or_else(|| {
            let shown: String = word.chars().take(20).collect();
            broken(self.kind, format!("{shown:?} is not a number where {} should stand", what()))
        })
    }

    /// The number at column `x` of row `y`.
    pub(super) fn number(&mut self, x: usize, y: usize) -> Result<f64> {
        let word = self.next()?.ok_or_else(|| broken(self.kind, format!("it ends before pixel ({x}, {y})")))?;
        word.parse().map_err(|_| {
            let shown: String = word.chars().take(20).collect();
            broken(self.kind, format!("{shown:?} is not a number where pixel ({x}, {y}) should stand"))
        })
    }

    /// Where the handle stands.
    pub(super) fn place(&mut self) -> Result<u64> {
        self.handle.stream_position().map_err(|error| broken(self.kind, error))
    }

    /// Refuses anything but white space.
    pub(super) fn end(&mut self) -> Result<()> {
        match self.next()? {
            None => Ok(()),
            Some(word) => {
                let shown: String = word.chars().take(20).collect();
                Err(broken(self.kind, format!("{shown:?} stands after its last pixel")))
            }
        }
    }
}
