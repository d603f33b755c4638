//! The memories of blocks: one for each of four siblings, loaded word by word as the pyramid of nodes is.
use super::{block_address, block_words};
use crate::quantity::{BIT, CODES, WORDS};
use crate::traversal::height_source::Load;
use crate::traversal::loop_state::{Sizes, level_state};
use crate::traversal::node_address::node_address;
use crate::traversal::search::{PYRAMID, Search, name_texel};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Sig};

/// What stands after the names of the memories' files.
const FILES: [&str; 4] = [".0", ".1", ".2", ".3"];

pub(in crate::traversal) static BLOCKS: Search = Search {
    summary: "traces rays against a height field: a looping pipeline, a block of four cells a clock",
    throughput: "one iteration (four cells) per clock; a ray takes as many iterations as its path needs",
    choices: |d| {
        let after = ("levels_down_after", d.levels_down_after().to_string());
        [("cells", d.fetch.cells.to_string())].into_iter().chain((PYRAMID.choices)(d)).chain([after]).collect()
    },
    described: |d| (PYRAMID.described)(d).into_iter().filter(|word| word.0 != "levels_down_after").collect(),
    image: |_| {
        "with .0 to .3 after its name, files for $readmemh of every fourth word of the pyramid; \"\": none".to_string()
    },
    loads,
    state: level_state,
    leaving: None,
    address_words: PYRAMID.address_words,
    addresses: |b, s, d, name, ray, _| {
        name_texel(name, ray);
        let cell = node_address(b, s, d, &format!("u_{name}_address"), ray, ray.get("level"));
        let cell = cell.named(&format!("{name}_cell_address"));
        b.unused(cell.slice(0, 2));
        vec![cell.slice(2, block_address(&s.levels)); FILES.len()]
    },
};

/// The four memories; the two lowest bits of an address in the pyramid tell siblings apart. The root, which has none, is left out.
fn loads<'b>(b: &'b Builder, s: &Sizes, _: &Design) -> Vec<Load<'b>> {
    let whole = s.levels.clone() * 2 + 1;
    let en = b.input_static("load_en", 1, BIT, "write a word of the pyramid (while idle is 1)");
    let addr = b.input_static("load_addr", &whole, WORDS, "address: level 0 first, the root last, which is not kept");
    let data = b.input_static("load_data", &s.height, CODES, "largest height in that node");
    b.section(
        "load",
        "Siblings are neighbours in the pyramid: each goes into a memory of its own, at their block's address.",
    );
    let root = b.konst(block_words(&s.levels) * 4, &whole).named("root_address").doc("address of the root's word");
    let keeps = (en & !addr.eq(root)).named("load_is_inner");
    let word = addr.slice(2, block_address(&s.levels)).named("load_block");
    let (odd_column, odd_row) = (addr.bit(0), addr.bit(1));
    let mine = |k: usize| {
        let column = if k % 2 == 1 { odd_column } else { !odd_column };
        column & if k / 2 == 1 { odd_row } else { !odd_row }
    };
    let load = |k: usize| Load {
        en: (keeps & mine(k)).named(&format!("load_en_{k}")),
        addr: word,
        data,
        words: block_words(&s.levels),
        file: FILES[k],
    };
    (0..FILES.len()).map(load).collect()
}

/// The level of the cells of the block that a node is: one less, and the finest for a texel.
pub(in crate::traversal) fn cells_level(level: Sig<'_>) -> Sig<'_> {
    (level - level.any().zext(level.width())).named("cells_level")
}
