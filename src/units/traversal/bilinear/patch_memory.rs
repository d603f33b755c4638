//! `patch_memory`: the map's texels on chip, four of them a clock: a patch.
//!
//! Four memories, one for each parity of column and row, so that a patch is one read of each. They are loaded with the pyramid, word by word; what is
//! not level 0 is left out.
use super::bank_address;
use crate::quantity::{BIT, CODES, TEXELS, WORDS};
use crate::traversal::height_memory;
use crate::traversal::params::LevelParams;
use reliefrtl_config::TraverseConfig;
use reliefrtl_ir::{Binding, Builder, Module, Sig};
use std::sync::Arc;

/// Builds `patch_memory`, of one clock.
pub fn patch_memory(t: &TraverseConfig) -> Arc<Module> {
    let b = Builder::new(
        "patch_memory",
        file!(),
        "the four height codes of a patch, from four memories, one for each parity",
    );
    let levels = LevelParams::declare(&b, t).levels;
    let height = b.param("HEIGHT_W", t.height_bits, "bits of a height code");
    super::common::preloaded(&b);
    b.require(2, &height);
    b.require(&height, 16);
    b.clock();
    let ce = b.clock_enable();
    let load_en = b.input_static("load_en", 1, BIT, "write a word of the pyramid");
    let load_addr = b.input_static("load_addr", levels.clone() * 2 + 1, WORDS, "address: level 0 first, the root last");
    let load_data = b.input_static("load_data", &height, CODES, "largest height in that node");
    let i = b.input("i", &levels, TEXELS, "first column of the patch; the other one is the next, wrapped");
    let j = b.input("j", &levels, TEXELS, "first row of the patch; the other one is the next, wrapped");
    let outs = [
        ("00", "first column, first row"),
        ("10", "second column, first row"),
        ("01", "first column, second row"),
        ("11", "second column, second row"),
    ]
    .map(|(name, doc)| b.output(&format!("code_{name}"), &height, CODES, doc));

    b.section(
        "load",
        "Level 0 fills the addresses whose top bit is 0; the two lowest bits are the parities of column and row.",
    );
    let word = levels.clone() * 2 - 2;
    let is_texel = (load_en & !load_addr.msb()).named("loads_texel");
    let to = load_addr.slice(2, &word).named("load_word");

    b.section("read", "A memory has no clock enable: while this pipeline holds, it reads again what it has read.");
    let addresses = b.inst(&bank_address(t), "u_address", &[], &[("i", i), ("j", j)]);
    let mut loops = Vec::new();
    let mut banks: Vec<Sig<'_>> = Vec::new();
    for (k, bank) in ["00", "10", "01", "11"].into_iter().enumerate() {
        let address = addresses[format!("address_{bank}").as_str()].named(&format!("address_{k}"));
        let held =
            b.loop_reg(&format!("read_addr_{k}"), word.clone(), false).doc("address read in the clock before [words]");
        loops.push((held, address));
        let (column, row) = (load_addr.bit(0), load_addr.bit(1));
        let mine = if k % 2 == 1 { column } else { !column } & if k / 2 == 1 { row } else { !row };
        let en = (is_texel & mine).named(&format!("load_{k}"));
        let read = ce.mux(address, held).named(&format!("read_{k}"));
        let params = [("ADDR_W", word.clone()), ("DATA_W", height.clone()), ("DEPTH", word.pow2())];
        let ins = [("write_en", en), ("write_addr", to), ("write_data", load_data), ("read_addr", read)];
        let memory = height_memory(2 * t.levels - 2, t.height_bits, 1 << (2 * t.levels - 2));
        let bank = b.inst_of_file(&memory, &format!("u_bank_{k}"), &params, &ins, &format!(".{k}")).only();
        banks.push(bank.named(&format!("bank_{k}")));
    }
    b.close(&loops);

    b.section("order", "From parities to first and second.");
    let (odd_i, odd_j) = (i.bit(0).named("odd_i").at(1), j.bit(0).named("odd_j").at(1));
    // By parity of the row, then of the column.
    let first = |row: usize| odd_i.mux(banks[2 * row + 1], banks[2 * row]).named(&format!("first_{row}")).id();
    let second = |row: usize| odd_i.mux(banks[2 * row], banks[2 * row + 1]).named(&format!("second_{row}")).id();
    let columns = [[first(0), first(1)], [second(0), second(1)]].map(|c| c.map(|id| b.sig(id)));
    for (k, port) in outs.into_iter().enumerate() {
        let [even, odd] = columns[k % 2];
        let code = if k / 2 == 0 { odd_j.mux(odd, even) } else { odd_j.mux(even, odd) };
        b.drive(port, code.named(&format!("ordered_{k}")));
    }
    let at = |l: i64, h: i64| Binding::from([("LEVELS".into(), l), ("HEIGHT_W".into(), h)]);
    b.finish(&[at(2, 2), at(3, 16), at(12, 8)])
}
