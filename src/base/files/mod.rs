//! Writing files so that a reader never meets half of one: beside the target first, then renamed.
mod beside;
mod inside;
mod listed;
mod out_dir;
mod read;
mod sink;
mod staging;
mod system;
pub use inside::{digest_inside, read_inside, write_inside};
pub use listed::{Altered, MANIFEST, altered, tree_of};
pub use out_dir::{OutDir, Part};
pub use read::{
    MARK, SETTINGS, TABLE, only_files_in, open_named, read_named, read_named_text, read_of_tree, read_text_of_tree,
};
pub use sink::{STANDARD_OUTPUT, Sink, standard_failed};
pub use staging::{Scratch, abandon};

use crate::error::{Error, Result};
use std::path::Path;
use system::{dangling, make_directory, writable};

/// Writes what `path` names: a file appears whole beside its final place and is renamed, so that the old one stays until then; a device or FIFO is
/// written to; of a link, what it leads to; `-` is standard output.
///
/// # Errors
/// As [`Sink::new`] and [`Sink::write`].
pub fn write_atomic(path: impl AsRef<Path>, bytes: &[u8]) -> Result<()> {
    Sink::new(path)?.write(bytes)
}

/// Makes a directory that files are written into one by one, where it is not there, removes what dead processes left there, and sees that it can be
/// written.
///
/// # Errors
/// If it is a file, a link to nothing, or can't be written.
pub fn open_directory(path: &Path) -> Result<()> {
    if !path.exists() && std::fs::symlink_metadata(path).is_ok_and(|m| m.is_symlink()) {
        return Err(dangling("into ", path, "directory"));
    }
    if path.exists() && !path.is_dir() {
        let path = path.display();
        return Err(Error::input(format!("cannot write into {path}: it is a file, not a directory")));
    }
    make_directory(path)?;
    staging::sweep(path);
    writable(path).map_err(|error| Error::file("write into", path, error))
}
