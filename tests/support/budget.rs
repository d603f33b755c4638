//! What the usual run tries of long lists.

/// One in `usual` of a list is tried; `RELIEFRTL_SHARE=1`, as the full budget sets it, tries all.
pub fn share(usual: usize) -> usize {
    std::env::var("RELIEFRTL_SHARE").map_or(usual, |v| v.parse().expect("RELIEFRTL_SHARE is a number"))
}
