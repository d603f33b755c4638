//! What a traversal searches: the loop's state, what stands in the slots' memories, the memories of heights and how they are loaded.
use super::height_memory::pyramid_words;
use super::height_source::Load;
use super::loop_state::{Field, Ray, Sizes, level_state};
use super::node_address::node_address;
use super::slot_memory::SlotMemory;
use crate::quantity::{BIT, CODES, WORDS};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Record, Sig};

/// Builds the ray that leaves, from the loop's registers and the slot memories.
pub type Leaving = for<'b> fn(&'b Builder, &Sizes, &Ray<'b>, &SlotMemory<'b>) -> Ray<'b>;

/// What the addresses of an iteration need of a ray's constants, where these stand in slot memories.
pub type AddressWords = for<'b> fn(&Sizes, &Record<'b>) -> Record<'b>;
/// Builds the addresses that an iteration of a ray reads, one for each memory, from the ray and these words; for what the instances are called after.
pub type Addresses = for<'b> fn(&'b Builder, &Sizes, &Design, &str, &Ray<'b>, &Record<'b>) -> Vec<Sig<'b>>;

/// The parts of one search.
pub struct Search {
    /// What `traverse` does with it, in one sentence.
    pub summary: &'static str,
    /// Its throughput.
    pub throughput: &'static str,
    /// What was chosen, by name.
    pub choices: fn(&Design) -> Vec<(&'static str, String)>,
    /// What else was chosen, and shows in the text: for the banner.
    pub described: fn(&Design) -> Vec<(String, String)>,
    /// What the file of the memories' first words holds.
    pub image: fn(&Design) -> String,
    /// Declares the load ports, one each memory.
    pub loads: for<'b> fn(&'b Builder, &Sizes, &Design) -> Vec<Load<'b>>,
    /// What an iteration changes.
    pub state: fn(&Sizes, &Design) -> Vec<Field>,
    /// Where constants of a ray stand in slot memories: all that a result needs of a ray that leaves; the loop's words come first.
    pub leaving: Option<Leaving>,
    /// What `addresses` reads of them.
    pub address_words: AddressWords,
    /// For a source that looks up what the next iteration reads.
    pub addresses: Addresses,
}

/// Names the texel of a ray, of which an address takes bits.
pub(super) fn name_texel(name: &str, ray: &Ray<'_>) {
    ["x", "y"].iter().for_each(|axis| {
        ray.get(axis).named(&format!("{name}_{axis}"));
    });
}

/// The nodes of a pyramid, one an iteration.
pub static PYRAMID: Search = Search {
    summary: "traces rays against a height field: a looping pipeline, one node a clock",
    throughput: "one iteration (one node) per clock; a ray takes as many iterations as its path needs",
    choices: |d| {
        vec![("levels_down", d.mode.levels_down.to_string()), ("level_up", d.mode.level_up.word().to_string())]
    },
    described: |d| {
        let chosen = (PYRAMID.choices)(d);
        d.mode.words().into_iter().filter(|(name, _)| !chosen.iter().any(|c| c.0 == name)).collect()
    },
    image: |d| {
        let more =
            if d.mode.bilinear { "; with .0 to .3 after its name, files of every fourth word of level 0" } else { "" };
        format!("file for $readmemh with the words of the pyramid, level 0 first{more}; \"\": none")
    },
    loads: |b, s, _| {
        vec![Load {
            en: b.input_static("load_en", 1, BIT, "write a word of the pyramid (while idle is 1)"),
            addr: b.input_static("load_addr", s.levels.clone() * 2 + 1, WORDS, "address: level 0 first, the root last"),
            data: b.input_static("load_data", &s.height, CODES, "largest height in that node"),
            words: pyramid_words(&s.levels),
            file: "",
        }]
    },
    state: level_state,
    leaving: None,
    address_words: |_, _| Record::default(),
    addresses: |b, s, d, name, ray, _| {
        name_texel(name, ray);
        let address = node_address(b, s, d, &format!("u_{name}_address"), ray, ray.get("level"));
        vec![address.named(&format!("{name}_address"))]
    },
};
