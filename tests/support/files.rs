//! Files of a test's own.
use std::path::Path;

/// Writes files below `dir`, with the folders that they stand in.
pub fn write<P: AsRef<Path>, T: AsRef<[u8]>>(dir: &Path, files: impl IntoIterator<Item = (P, T)>) {
    for (path, text) in files {
        let place = dir.join(path);
        std::fs::create_dir_all(place.parent().expect("a folder")).expect("the test's directory is writable");
        std::fs::write(place, text).expect("the test's directory is writable");
    }
}
