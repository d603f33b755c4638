//! Which tables of corners are crossed, and which part of all rows is made.
use crate::error::{Error, Result};
use serde::{Deserialize, Serialize};

/// How large the tables are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Level {
    /// Some 20 thousand rows of two operands, and the random ones.
    #[serde(rename = "1")]
    One,
    /// Some 440 thousand rows of two operands, and the random ones.
    #[serde(rename = "2")]
    Two,
    /// No tables: weighted random rows, of one seed after the other, until it is stopped.
    #[serde(rename = "3")]
    Three,
}

impl Level {
    /// All, in the order of the help.
    pub const ALL: [Self; 3] = [Self::One, Self::Two, Self::Three];
}

/// One part of all rows, counted from 1: every `of`-th row, so that the parts are alike.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Shard {
    /// Which.
    pub index: u32,
    /// Of how many.
    pub of: u32,
}

impl Shard {
    /// All rows.
    pub const WHOLE: Self = Self { index: 1, of: 1 };
}

impl std::str::FromStr for Shard {
    type Err = Error;
    fn from_str(text: &str) -> Result<Self> {
        let parts = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
        let shard = parts.map(|(index, of)| Self { index, of });
        let wrong = || Error::input(format!("--shard {text} is no part of a whole: 3/16 is the third of 16 parts"));
        shard.filter(|s| s.index >= 1 && s.index <= s.of).ok_or_else(wrong)
    }
}

/// Tables crossed whole, then `plan.rows` weighted random rows; of these, one part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Campaign {
    /// Size of the tables.
    pub level: Level,
    /// Part.
    pub shard: Shard,
}
