//! What stands in a file besides its module: licence, time scale, the default kind of nets.
use reliefrtl_config::{DefaultNettype, EmitConfig};
use reliefrtl_ir::{Module, Term};

/// The licence of everything that is emitted.
pub const SPDX: &str = "SPDX-License-Identifier: MIT OR Apache-2.0";

/// What the text has besides the module itself.
#[derive(Clone, Debug, Default)]
pub struct Style {
    /// Stands before every module name.
    pub prefix: String,
    /// The operand of `` `timescale``; empty: the file has none.
    pub timescale: String,
    /// What undeclared nets are after the file.
    pub default_nettype: DefaultNettype,
    /// Whether modules check what they were generated for. A module that is measured alone meets no other, and what it was measured on stays
    /// the same text.
    pub contract: bool,
}

impl From<&EmitConfig> for Style {
    fn from(c: &EmitConfig) -> Self {
        Self {
            prefix: c.prefix.clone(),
            timescale: c.timescale.clone(),
            default_nettype: c.default_nettype,
            contract: true,
        }
    }
}

/// A prefix, and the defaults for all else.
impl From<&str> for Style {
    fn from(prefix: &str) -> Self {
        Self { prefix: prefix.into(), contract: true, ..Self::default() }
    }
}

impl Style {
    /// What an instance of `m` has to ask for.
    pub fn terms(&self, m: &Module) -> Vec<Term> {
        if self.contract { m.contract() } else { Vec::new() }
    }

    /// The directives before a module.
    pub fn opening(&self) -> String {
        let scale = if self.timescale.is_empty() { String::new() } else { format!("`timescale {}\n", self.timescale) };
        let nets = if self.default_nettype == DefaultNettype::Keep { "" } else { "`default_nettype none\n" };
        scale + nets
    }

    /// The directives after a module. Yosys takes the last one of a file for the whole of it and starts the next file afresh, so there
    /// `none` has to stay the last.
    pub fn closing(&self) -> &'static str {
        match self.default_nettype {
            DefaultNettype::Wire => "`ifndef YOSYS\n`default_nettype wire\n`endif\n",
            DefaultNettype::None | DefaultNettype::Keep => "",
        }
    }

    /// A template's text, which has `none` before its module and `wire` after it, with the licence and the directives of this style.
    pub fn dress(&self, text: &str) -> String {
        let text = text.replacen("`default_nettype none\n", &self.opening(), 1);
        let body = text.strip_suffix("`default_nettype wire\n").unwrap_or(&text);
        format!("// {SPDX}\n{body}{}", self.closing())
    }
}
