//! Where the bytes of a map come from: a file that is read as far as it is needed, or bytes in memory.
use reliefrtl_base::error::{Error, Result};
use reliefrtl_base::files::open_named;
use std::fs::File;
use std::io::{BufRead, BufReader, Cursor, Read, Seek};
use std::path::Path;

/// The most that is read from what can't be read twice (a pipe), in bytes.
const PIPED: u64 = 1 << 28;

/// Bytes that can be read more than once.
pub(super) struct Source<'a> {
    name: String,
    len: u64,
    bytes: Bytes<'a>,
}

enum Bytes<'a> {
    File(File),
    Owned(Vec<u8>),
    Borrowed(&'a [u8]),
}

/// What readers read from.
pub(super) trait Seekable: BufRead + Seek {}
impl<T: BufRead + Seek> Seekable for T {}
/// An open file or bytes, from the start.
pub(super) type Handle<'a> = Box<dyn Seekable + 'a>;

impl<'a> Source<'a> {
    /// Bytes in memory; `name` stands for the file.
    pub(super) fn bytes(bytes: &'a [u8], name: &str) -> Self {
        Self { name: name.to_owned(), len: bytes.len() as u64, bytes: Bytes::Borrowed(bytes) }
    }

    /// A file. What this process was given open (`/dev/stdin`) is read once, up to a limit.
    pub(super) fn file(path: &Path) -> Result<Self> {
        let failed = |error: std::io::Error| Error::file("read", path, error);
        let mut file = open_named(path)?;
        let meta = file.metadata().map_err(failed)?;
        let name = path.display().to_string();
        if meta.is_file() {
            return Ok(Self { name, len: meta.len(), bytes: Bytes::File(file) });
        }
        let mut bytes = Vec::new();
        file.by_ref().take(PIPED + 1).read_to_end(&mut bytes).map_err(failed)?;
        if bytes.len() as u64 > PIPED {
            return Err(Error::input(format!("{name} is no regular file: of such, at most {PIPED} bytes are read")));
        }
        Ok(Self { name, len: bytes.len() as u64, bytes: Bytes::Owned(bytes) })
    }

    /// The file's name, for sentences and for what only a name tells.
    pub(super) fn name(&self) -> &str {
        &self.name
    }

    /// Bytes.
    pub(super) const fn len(&self) -> u64 {
        self.len
    }

    /// The bytes from the start. Only one handle of a source is read at a time.
    pub(super) fn open(&self) -> Result<Handle<'_>> {
        Ok(match &self.bytes {
            Bytes::Owned(bytes) => Box::new(Cursor::new(bytes.as_slice())),
            Bytes::Borrowed(bytes) => Box::new(Cursor::new(*bytes)),
            Bytes::File(file) => {
                let mut file = file;
                file.rewind().map_err(|error| Error::file("read", &self.name, error))?;
                Box::new(BufReader::with_capacity(1 << 16, file))
            }
        })
    }
}
