//! What a name that is not known was meant to be.

/// How much two names are alike, 0 to 1 (Damerau and Levenshtein's distance by the longer one's length).
pub fn similarity(a: &str, b: &str) -> f64 {
    strsim::normalized_damerau_levenshtein(a, b)
}

/// The first of the names that `score` puts highest; none if the best is not above 0.4: a guess that shares next to nothing with what was
/// typed only distracts.
pub fn nearest_by<T>(names: impl IntoIterator<Item = T>, score: impl Fn(&T) -> f64) -> Option<T> {
    let scored = names.into_iter().map(|name| (score(&name), name)).filter(|(alike, _)| *alike > 0.4);
    scored.reduce(|best, other| if other.0 > best.0 { other } else { best }).map(|(_, name)| name)
}

/// The name most like `typed`; none if no name is like it.
pub fn nearest<'a>(typed: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    nearest_by(names, |name| similarity(typed, name))
}
