//! Hard cases: maps and rays on which a traversal is most likely to go wrong, each a generator with a seed (`docs/hard-cases.md`).
mod case;
mod directions;
mod draw;
mod heights;
mod numbers;
mod picture;
mod places;

pub use case::{Case, HardScene};
pub use draw::Ray;
pub use numbers::Numbers;
pub use picture::footprints;

use reliefrtl_base::alike::nearest;
use reliefrtl_base::error::{Error, Result};

impl Case {
    /// All cases.
    pub fn all() -> impl Iterator<Item = &'static Self> {
        heights::CASES.iter().chain(directions::CASES).chain(places::CASES)
    }

    /// The case of this name.
    ///
    /// # Errors
    /// [`Error::Input`] with the nearest name.
    pub fn find(name: &str) -> Result<&'static Self> {
        Self::all().find(|case| case.name == name).ok_or_else(|| {
            let guess = nearest(name, Self::all().map(|case| case.name));
            let guess = guess.map_or(String::new(), |near| format!("did you mean {near}? "));
            Error::input(format!("there is no case {name:?}: {guess}`reliefrtl hard --list` shows all"))
        })
    }
}
