//! What every choice between words has: all of them, and each by its name in the TOML file.

/// A number of words, each with its name in the TOML file.
macro_rules! words {
    ($type:ident: $($variant:ident = $word:literal),+ $(,)?) => {
        impl $type {
            /// All, in the order of the documentation.
            pub const ALL: [Self; [$($word),+].len()] = [$(Self::$variant),+];
            /// Their words in the TOML file, in the same order.
            pub const WORDS: &'static [&'static str] = &[$($word),+];
            /// The word in the TOML file and on the command line.
            pub const fn word(self) -> &'static str {
                match self { $(Self::$variant => $word),+ }
            }
        }
        impl std::fmt::Display for $type {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str(self.word())
            }
        }
        impl std::str::FromStr for $type {
            type Err = reliefrtl_base::error::Error;
            fn from_str(word: &str) -> reliefrtl_base::error::Result<Self> {
                Self::ALL.iter().copied().find(|one| one.word() == word).ok_or_else(|| {
                    reliefrtl_base::error::Error::input(format!("{word:?} is not one of {}", Self::WORDS.join(", ")))
                })
            }
        }
    };
}
