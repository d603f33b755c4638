//! What the bits of a port stand for.
use std::fmt::{self, Display, Formatter};

/// How the bits of a port are read.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// An edge.
    Clock,
    /// Yes or no.
    Bit,
    /// A whole number of what the quantity names, unsigned or of two's complement; or bits that are no number.
    Integer,
    /// A number of the design's floating-point format.
    Float,
}

/// The kind of a port and what it counts; displays as banners, comments and `manifest.json` say it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Quantity {
    kind: Kind,
    /// What is counted; "" where the kind says it all.
    of: &'static str,
}

/// A clock.
pub const CLOCK: Quantity = Quantity { kind: Kind::Clock, of: "" };
/// One bit, yes or no.
pub const BIT: Quantity = Quantity { kind: Kind::Bit, of: "" };
/// Bits as they are, or a number of no unit.
pub const BITS: Quantity = integer("bits");
/// A floating-point number of no unit.
pub const FLOAT: Quantity = float("");

/// A whole number of `of`, which may be a fraction: `integer("2^-8 texels")`.
pub const fn integer(of: &'static str) -> Quantity {
    Quantity { kind: Kind::Integer, of }
}

/// A floating-point number in units of `of`.
pub const fn float(of: &'static str) -> Quantity {
    Quantity { kind: Kind::Float, of }
}

impl Quantity {
    /// How the bits are read.
    pub fn kind(self) -> Kind {
        self.kind
    }
    /// Whether it is a floating-point number.
    pub fn is_float(self) -> bool {
        self.kind == Kind::Float
    }
}

impl Display for Quantity {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match (self.kind, self.of) {
            (Kind::Clock, _) => f.write_str("clock"),
            (Kind::Bit, _) => f.write_str("bit"),
            (Kind::Integer, of) => f.write_str(of),
            (Kind::Float, "") => f.write_str("float"),
            (Kind::Float, of) => write!(f, "float, {of}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_text_says_the_kind_and_what_is_counted() {
        let said = [CLOCK, BIT, BITS, FLOAT, integer("2^-8 texels"), float("texels")].map(|q| q.to_string());
        assert_eq!(said, ["clock", "bit", "bits", "float", "2^-8 texels", "float, texels"]);
        assert!(FLOAT.is_float() && float("texels").is_float() && !integer("floats").is_float());
    }
}
