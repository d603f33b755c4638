//! What a module was generated for. Parameters fit any instance; a latency, a rounding or a rule does not, and modules that differ in them
//! share a name. So each instance passes what it was generated for, and a module that is something else ends elaboration.
use super::module::{Body, Module, Op};
use std::fmt::Write;

/// A term of the contract of a module: a Verilog parameter that has one legal value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Term {
    /// Name as printed.
    pub name: &'static str,
    /// The legal value.
    pub value: i64,
    /// Meaning, one line.
    pub doc: &'static str,
}

impl Term {
    /// The value as Verilog: a number of clocks, or a digest in eight hex digits.
    pub fn literal(&self) -> String {
        if self.name == VARIANT { format!("32'h{:08x}", self.value) } else { self.value.to_string() }
    }
}

const LATENCY: &str = "LATENCY";
const VARIANT: &str = "VARIANT";

impl Module {
    /// The terms that an instance of this module has to meet, in printed order: its latency in clocks where that is fixed, and its variant.
    /// None for a primitive, whose text is the same in every configuration.
    pub fn contract(&self) -> Vec<Term> {
        if self.body != Body::Graph {
            return Vec::new();
        }
        let latency = self.latency.map(|clocks| Term {
            name: LATENCY,
            value: i64::from(clocks),
            doc: "clocks it was generated for; checked",
        });
        let variant = Term {
            name: VARIANT,
            value: i64::from(self.variant()),
            doc: "digest of what it was generated for; checked",
        };
        latency.into_iter().chain([variant]).collect()
    }

    /// Digest (31 bits) of everything in the module that parameters don't change, those below it included: ports, stages, operations.
    /// Default values, comments and the prefix are no part of it.
    pub fn variant(&self) -> u32 {
        *self.variant_memo.0.get_or_init(|| {
            let mut text = format!("{} {:?} {:?}\n", self.name, self.latency, self.body);
            let mut line = |l: std::fmt::Arguments<'_>| text.write_fmt(l).expect("writing to a string");
            self.choices.iter().for_each(|c| line(format_args!("choice {c:?}\n")));
            self.params.iter().for_each(|p| line(format_args!("param {}\n", p.name)));
            self.files.iter().for_each(|f| line(format_args!("file {}\n", f.name)));
            self.locals.iter().for_each(|l| line(format_args!("local {:?}\n", (&l.name, &l.value))));
            self.checks.iter().for_each(|c| line(format_args!("check {c:?}\n")));
            self.ports
                .iter()
                .for_each(|p| line(format_args!("port {} {:?} {:?} {:?}\n", p.name, p.dir, p.width, p.stage)));
            for n in &self.nodes {
                match &n.op {
                    Op::Konst(e) | Op::Slice { lo: e } => line(format_args!("{} {e:?} ", n.op.name())),
                    op => line(format_args!("{op:?} ")),
                }
                line(format_args!("{:?} {:?} {:?} {:?}\n", n.name, n.args, n.width, n.stage));
            }
            for i in &self.insts {
                line(format_args!("inst {} {} {:?} {:?} ", i.name, i.module.name, i.params, i.files));
                line(format_args!("{:?} {:?} ", i.inputs, i.stage));
                i.module.contract().iter().for_each(|t| line(format_args!("{} {} ", t.name, t.value)));
            }
            line(format_args!("outputs {:?} {:?}\n", self.outputs, self.unused));
            let hash = blake3::hash(text.as_bytes());
            let word: [u8; 4] = hash.as_bytes()[..4].try_into().expect("a hash has 32 bytes");
            u32::from_be_bytes(word) >> 1
        })
    }

    /// Name of the module that is missing where an instance asks for another value of `term`: it says what this module is, and what was
    /// chosen as far as `most` characters hold it.
    pub fn misfit(&self, term: &Term, most: usize) -> String {
        const END: &str = "_not_the_one_asked_for";
        let value = term.literal();
        let mut name = format!("{}_has_{}_{}", self.name, term.name, value.trim_start_matches("32'h"));
        let legal = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
        for (key, word) in self.choices.iter().filter(|_| term.name == VARIANT) {
            let plain = word.starts_with(|c: char| c.is_ascii_alphabetic());
            let text: String = if plain { format!("_{word}") } else { format!("_{key}_{word}") };
            if name.len() + text.len() + END.len() <= most {
                name.extend(text.chars().map(legal));
            }
        }
        name + END
    }
}
