//! `bank_address`: where the four texels of a patch stand in four memories, one for each parity of column and row.
//!
//! A patch has one texel of each parity, so each memory is read once. A word stands in its bank where the pyramid memory has it, less the two lowest bits
//! of its address: these are the parities (`docs/bilinear.md`, "The memory").
use crate::interleave::interleave;
use crate::quantity::{TEXELS, WORDS};
use crate::traversal::params::LevelParams;
use reliefrtl_config::TraverseConfig;
use reliefrtl_ir::{Binding, Builder, Module};
use std::sync::Arc;

/// Builds `bank_address`, combinational.
pub fn bank_address(t: &TraverseConfig) -> Arc<Module> {
    let b =
        Builder::new("bank_address", file!(), "addresses of a patch's four texels in the banks of even and odd texels");
    let levels = LevelParams::declare(&b, t).levels;
    let i = b.input("i", &levels, TEXELS, "first column of the patch; the other one is the next, wrapped");
    let j = b.input("j", &levels, TEXELS, "first row of the patch; the other one is the next, wrapped");
    let outs = [
        ("00", "even column, even row"),
        ("10", "odd column, even row"),
        ("01", "even column, odd row"),
        ("11", "odd column, odd row"),
    ]
    .map(|(name, doc)| b.output(&format!("address_{name}"), levels.clone() * 2 - 2, WORDS, doc));
    // An odd first texel stands beside the even one of the next pair.
    let half = &levels - 1;
    let pair = |x: reliefrtl_ir::Sig<'_>, name: &str| {
        let odd = x.slice(1, &half).named(&format!("{name}_odd"));
        let even = (odd + x.bit(0).zext(&half)).named(&format!("{name}_even"));
        [even.id(), odd.id()]
    };
    let (columns, rows) = (pair(i, "i"), pair(j, "j"));
    for (k, port) in outs.into_iter().enumerate() {
        let (column, row) = (b.sig(columns[k % 2]), b.sig(rows[k / 2]));
        b.drive(port, interleave(&b, &format!("u_morton_{k}"), column, row, &format!("word_{k}")));
    }
    b.finish(&[2, 3, 12].map(|l| Binding::from([("LEVELS".into(), l)])))
}
