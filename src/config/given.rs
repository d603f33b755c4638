//! Which keys somebody wrote: a default that is written out is another thing than a default, where a datapath has no use for the key.
use std::collections::BTreeSet;

/// Paths of keys that stood in a file or behind `--set`.
#[derive(Clone, Debug, Default)]
pub struct Given(BTreeSet<&'static str>);

impl Given {
    /// Whether the key was written.
    pub fn has(&self, path: &str) -> bool {
        self.0.contains(path)
    }

    /// The key was written.
    pub(super) fn add(&mut self, path: &'static str) {
        self.0.insert(path);
    }

    /// The key was taken back.
    pub(super) fn remove(&mut self, path: &str) {
        self.0.remove(path);
    }
}

/// Where a value comes from does not make another configuration.
impl PartialEq for Given {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}
