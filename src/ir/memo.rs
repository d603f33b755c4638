//! A digest that is computed once.
use std::sync::OnceLock;

/// A digest that is computed once; a copy of the module, which may be altered, computes its own.
#[derive(Debug, Default)]
pub struct Memo(pub(super) OnceLock<u32>);

impl Clone for Memo {
    fn clone(&self) -> Self {
        Self::default()
    }
}
