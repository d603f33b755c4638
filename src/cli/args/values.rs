//! What a word on the command line stands for, where the type is not one of the command line's own.
use crate::config::Profile;
use crate::engine::EngineName;
use crate::project::Canary;
use crate::report::ModeSet;
use crate::vectors::Level;
use clap::ValueEnum;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// The name of a unit in a list.
pub fn unit_name(text: &str) -> std::result::Result<String, String> {
    let name = text.trim();
    if name.is_empty() { Err("a unit's name is empty".into()) } else { Ok(name.into()) }
}

impl ValueEnum for EngineName {
    fn value_variants<'a>() -> &'a [Self] {
        &Self::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(match self {
            Self::Golden => PossibleValue::new("golden").help("The bit-accurate model"),
            Self::Interp => PossibleValue::new("interp").help("The embedded interpreter of the emitted datapath"),
            Self::Icarus => PossibleValue::new("icarus").help("Icarus Verilog"),
            Self::Verilator => PossibleValue::new("verilator").help("Verilator"),
        })
    }
}

impl ValueEnum for Canary {
    fn value_variants<'a>() -> &'a [Self] {
        &Self::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(match self {
            Self::Flip => PossibleValue::new("flip").help("One bit of one expected word is flipped: exit code 1"),
            Self::Drop => {
                PossibleValue::new("drop").help("One input never enters, so its result never comes: exit code 6")
            }
            Self::Extra => PossibleValue::new("extra")
                .help("One input enters twice, so a result comes that is not expected: exit code 7"),
            Self::Empty => PossibleValue::new("empty").help("No vectors at all: exit code 5"),
        })
    }
}

impl ValueEnum for Level {
    fn value_variants<'a>() -> &'a [Self] {
        &Self::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(match self {
            Self::One => PossibleValue::new("1").help("Some 20 thousand rows of two operands, and the random ones"),
            Self::Two => PossibleValue::new("2").help("Some 440 thousand rows of two operands, and the random ones"),
            Self::Three => PossibleValue::new("3")
                .help("No tables: weighted random rows, of one seed after the other, until it is stopped"),
        })
    }
}

/// A profile by its name: the type is the configuration's, so that clap's trait cannot be given to it here.
pub fn profile() -> impl TypedValueParser<Value = Profile> {
    let value = |p: Profile| {
        PossibleValue::new(p.word()).help(match p {
            Profile::Published => "Those of the published unit: add 2, multiply 1, compare 1, divide 2 (PIDM-HW section 4.2). Where the divider is outside of the loop, it is as deep as the rest needs, and what the published numbers do not name has the registers that 84 MHz need on an ECP5",
            Profile::Balanced => "Between the two",
            Profile::Fast => "Every unit as deep as still pays",
        })
    };
    PossibleValuesParser::new(Profile::ALL.map(value)).try_map(|name| name.parse::<Profile>())
}

impl ValueEnum for ModeSet {
    fn value_variants<'a>() -> &'a [Self] {
        &Self::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(match self {
            Self::One => PossibleValue::new("one").help("Start level, two levels down, selective level-up"),
            Self::Table => PossibleValue::new("table")
                .help("The rows of the published table, three and four levels down, chord trim"),
            Self::All => PossibleValue::new("all").help("Every mode"),
        })
    }
}
