//! Which keys were given: where a datapath has no use for a key, a default that is written out is refused, and one that is not is ignored.
use std::collections::BTreeSet;

/// Paths of keys that stood in a file or after `--set`.
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
