//! One error type for the whole crate, and the exit codes it maps to.
mod finding;

pub use finding::{Finding, Place};
use std::path::{Path, PathBuf};

/// Exit codes of the command line (and of the emitted benches).
pub mod exit {
    /// Everything that was asked for was done and agreed.
    pub const OK: i32 = 0;
    /// A result differs from the expected one.
    pub const MISMATCH: i32 = 1;
    /// The command line, the configuration or an input file is wrong.
    pub const USAGE: i32 = 2;
    /// A tool that was asked for is not installed.
    pub const TOOL_MISSING: i32 = 3;
    /// A tool was started and failed.
    pub const TOOL_FAILED: i32 = 4;
    /// Nothing was checked.
    pub const NOTHING_RAN: i32 = 5;
    /// A result that was expected never came.
    pub const DROPPED: i32 = 6;
    /// A result came that was not expected.
    pub const EXTRA: i32 = 7;
    /// Whoever read standard output was gone before all of it was written: 128 and the number of SIGPIPE.
    pub const READER_GONE: i32 = 141;
}

/// Everything that can go wrong for a user, one sentence each: what was wrong, what would be right, where.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// Wrong command line, configuration or input data; the text is the whole sentence.
    #[error("{0}")]
    Input(String),
    /// A file could not be read or written.
    #[error("cannot {verb} {path}: {source}", path = .path.display())]
    File {
        /// `read`, `write`, `create`, ...
        verb: &'static str,
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// Results differ.
    #[error("{0}")]
    Mismatch(Finding),
    /// An expected result never came.
    #[error("{0}")]
    Dropped(String),
    /// A result came that was not expected.
    #[error("{0}")]
    Extra(String),
    /// A tool is not installed.
    #[error("{0}")]
    ToolMissing(String),
    /// A tool failed.
    #[error("{0}")]
    ToolFailed(String),
    /// Nothing was checked.
    #[error("{0}")]
    NothingRan(String),
}

/// The crate's result.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// An input error from a finished sentence.
    pub fn input(text: impl Into<String>) -> Self {
        Self::Input(text.into())
    }

    /// A mismatch from a finished sentence.
    pub fn mismatch(text: impl Into<String>) -> Self {
        Self::Mismatch(Finding { text: text.into(), place: None })
    }

    /// A file error.
    pub fn file(verb: &'static str, path: impl AsRef<Path>, source: std::io::Error) -> Self {
        Self::File { verb, path: path.as_ref().to_path_buf(), source }
    }

    /// What kind of error it is, in one word.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Input(_) => "input",
            Self::File { .. } => "file",
            Self::Mismatch(_) => "mismatch",
            Self::Dropped(_) => "dropped",
            Self::Extra(_) => "extra",
            Self::ToolMissing(_) => "tool-missing",
            Self::ToolFailed(_) => "tool-failed",
            Self::NothingRan(_) => "nothing-ran",
        }
    }

    /// The documented exit code of this error.
    pub fn exit_code(&self) -> i32 {
        match self {
            Self::Input(_) | Self::File { .. } => exit::USAGE,
            Self::Mismatch(_) => exit::MISMATCH,
            Self::Dropped(_) => exit::DROPPED,
            Self::Extra(_) => exit::EXTRA,
            Self::ToolMissing(_) => exit::TOOL_MISSING,
            Self::ToolFailed(_) => exit::TOOL_FAILED,
            Self::NothingRan(_) => exit::NOTHING_RAN,
        }
    }
}
