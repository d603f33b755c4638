//! What the usual run tries of long lists.

/// One in `usual` of a list is tried; `RELIEFRTL_SHARE=1`, as the full budget sets it, tries all.
///
/// # Panics
/// If `RELIEFRTL_SHARE` is no number from 1 on.
pub fn share(usual: usize) -> usize {
    let Ok(text) = std::env::var("RELIEFRTL_SHARE") else { return usual };
    match text.parse() {
        Ok(share) if share > 0 => share,
        _ => panic!("RELIEFRTL_SHARE is {text:?}: one in so many of a list is tried, so it is a number from 1 on"),
    }
}
