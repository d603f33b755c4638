//! Every key of the configuration in one table: its meaning, its legal values.
//!
//! The commented file, the schema's ranges, the checks and their sentences all come from here.
use super::{
    Border, ByteOrder, Counters, DefaultNettype, Divider, ExtraUnit, LevelUp, MapKind, Rounding, Search, Specials,
    Subnormals, Trim, View,
};
use reliefrtl_base::alike::{nearest_by, similarity};
use std::fmt;

/// What a key accepts.
#[derive(Clone, Copy, Debug)]
pub enum Legal {
    /// A whole number, both ends included.
    Whole(i64, i64),
    /// One of these whole numbers.
    Numbers(&'static [i64]),
    /// A finite number, both ends included.
    Real(f64, f64),
    /// `true` or `false`.
    Flag,
    /// One of these words.
    Word(&'static [&'static str]),
    /// One or more of these words, none twice.
    Words(&'static [&'static str]),
    /// Any number of these words, none twice.
    SomeWords(&'static [&'static str]),
    /// A path; the key may be absent.
    Path,
    /// A finite number; the key may be absent.
    Number,
    /// A finite number or an infinity; the key may be absent.
    Mark,
    /// Some text; the key may be absent.
    Text,
    /// Two finite numbers, the smaller first, or `auto`; the key may be absent.
    Range,
    /// Width and height; the key may be absent.
    Size,
    /// A set of windows; the key may be absent.
    Set,
    /// Nothing, or a Verilog identifier of at most 32 characters.
    Prefix,
    /// Nothing, or the operand of a `` `timescale``.
    Timescale,
}

impl fmt::Display for Legal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Whole(low, i64::MAX) => write!(f, "{low} to 2^63 - 1"),
            Self::Whole(low, high) => write!(f, "{low} to {high}"),
            Self::Numbers(list) => f.write_str(&list.iter().map(i64::to_string).collect::<Vec<_>>().join(" and ")),
            Self::Real(low, high) => write!(f, "{low} to {high}"),
            Self::Flag => f.write_str("true or false"),
            Self::Word(words) | Self::Words(words) | Self::SomeWords(words) => f.write_str(&words.join(", ")),
            Self::Path => f.write_str("a path"),
            Self::Number => f.write_str("a number"),
            Self::Mark => f.write_str("a number, or inf for both infinities"),
            Self::Text => f.write_str("text in quotes"),
            Self::Range => f.write_str("[low, high] with low below high, or \"auto\""),
            Self::Size => f.write_str("[width, height], each 1 to 2^31 - 1"),
            Self::Set => f.write_str("2 to 5 windows, 1 first, each a side or side@grid (the grid a power of two up to 16, the side a multiple of it), side - grid rising, up to 63"),
            Self::Prefix => f.write_str("empty, or letters, digits and _ with no digit first, at most 32"),
            Self::Timescale => f.write_str("empty, or unit/precision of 1, 10 or 100 s, ms, us, ns, ps or fs, like 1ns/1ps, the precision no coarser than the unit"),
        }
    }
}

impl Legal {
    /// Whether the key may be absent; `--set key=none` then removes it.
    pub(super) const fn optional(self) -> bool {
        matches!(self, Self::Path | Self::Number | Self::Mark | Self::Text | Self::Range | Self::Size | Self::Set)
    }

    /// Adds the range to a JSON schema entry; types and words are there already.
    pub(super) fn describe(&self, entry: &mut serde_json::Map<String, serde_json::Value>) {
        match *self {
            Self::Whole(low, high) => {
                entry.insert("minimum".into(), low.into());
                entry.insert("maximum".into(), high.into());
            }
            Self::Real(low, high) => {
                entry.insert("minimum".into(), low.into());
                entry.insert("maximum".into(), high.into());
            }
            Self::Numbers(list) => {
                entry.insert("enum".into(), list.into());
            }
            Self::Words(_) => {
                entry.insert("minItems".into(), 1.into());
                entry.insert("uniqueItems".into(), true.into());
            }
            Self::SomeWords(_) => {
                entry.insert("uniqueItems".into(), true.into());
            }
            Self::Prefix => {
                entry.insert("pattern".into(), "^([A-Za-z_][A-Za-z0-9_]{0,31})?$".into());
            }
            Self::Timescale => {
                entry.insert("pattern".into(), "^(10{0,2}([munpf]?s)/10{0,2}([munpf]?s))?$".into());
            }
            Self::Flag | Self::Word(_) | Self::Path | Self::Number | Self::Mark => {}
            Self::Text | Self::Range | Self::Size | Self::Set => {}
        }
    }
}

/// One key.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// `section.name`.
    pub path: &'static str,
    /// What it means, for the comment above it.
    pub about: &'static str,
    /// What it accepts.
    pub legal: Legal,
}

impl Key {
    /// Section and name.
    pub fn split(&self) -> (&'static str, &'static str) {
        self.path.split_once('.').expect("every key stands in a section")
    }
}

const fn key(path: &'static str, about: &'static str, legal: Legal) -> Key {
    Key { path, about, legal }
}

/// The sections that shape the hardware.
pub const HARDWARE: [&str; 6] = ["format", "traverse", "mode", "datapath", "latency", "convert"];

/// The sections in the order of the file, with their headings.
pub const SECTIONS: &[(&str, &str)] = &[
    ("format", "Number format of the datapath: 1 sign bit, exp exponent bits, man fraction bits."),
    ("traverse", "Sizes of the traverse unit; each is a Verilog parameter."),
    ("datapath", "Which arithmetic traces the rays."),
    ("windows", "The windows of datapath.search = \"windows\"."),
    ("fetch", "How much of the pyramid one iteration reads."),
    (
        "mode",
        "Choices of the traversal. They change the number of steps, never the hit (of the published datapath: now and then).",
    ),
    (
        "latency",
        "Clocks from operand to result of each kind of unit, and how the divider is built; the pipelines rebalance around them.",
    ),
    ("convert", "Widths of the conversions alone: `--unit fp_to_fixed` and the like."),
    ("map", "The height map, and how it lies on the quad of 200 x 200 world units."),
    ("view", "The pictures whose pixels give the rays."),
    ("vectors", "Stimulus: how much, and from which random bits."),
    ("emit", "What the emitted files look like."),
];

const CLOCKS: Legal = Legal::Whole(0, 16);
const SEED: Legal = Legal::Whole(0, i64::MAX);

/// Every key, in the order of the file.
pub const KEYS: &[Key] = &[
    key("format.exp", "EXP_W: exponent bits", Legal::Whole(2, 8)),
    key("format.man", "MAN_W: fraction bits, the hidden one not counted; traversal needs 7", Legal::Whole(2, 23)),
    key("format.rounding", "rounding; traversal needs nearest-even", Legal::Word(Rounding::WORDS)),
    key(
        "format.subnormals",
        "numbers below the smallest normal one become zero of their sign, or are numbers; traversal needs flush",
        Legal::Word(Subnormals::WORDS),
    ),
    key(
        "format.specials",
        "infinities and NaN, or every code a number and results that saturate; traversal needs ieee",
        Legal::Word(Specials::WORDS),
    ),
    key("format.nan", "one NaN comes out: sign 0, top fraction bit 1, rest 0", Legal::Word(&["canonical"])),
    key("traverse.levels", "LEVELS: the map has 2^levels x 2^levels texels", Legal::Whole(2, 12)),
    key("traverse.height_bits", "HEIGHT_W: bits of a height code; at most format.man + 1", Legal::Whole(2, 16)),
    key("traverse.tile_bits", "TILE_W: a ray travels less than 2^tile_bits tiles along each axis", Legal::Whole(1, 8)),
    key("traverse.frac_bits", "FRAC_W: fraction bits of the hit position inside its texel", Legal::Whole(1, 16)),
    key("traverse.tag_bits", "TAG_W: bits of a ray's tag", Legal::Whole(1, 32)),
    key("traverse.step_limit", "STEP_LIMIT: iterations after which a ray is given up", Legal::Whole(1, 65535)),
    key(
        "datapath.kind",
        "plane parameters in floating point; moved positions as published; plane parameters in fixed point",
        Legal::Word(&["watertight", "published", "fixed"]),
    ),
    key(
        "datapath.search",
        "fixed: the nodes of a pyramid one by one, or windows ahead of the ray all at once; the hits are the same",
        Legal::Word(Search::WORDS),
    ),
    key(
        "datapath.nudge_bits",
        "published: a crossing lands 2^-nudge_bits texels beyond its plane; 0 is no nudge",
        Legal::Whole(0, 16),
    ),
    key("datapath.fraction_bits", "fixed: fraction bits of entry point, travel and ray parameter", Legal::Whole(8, 28)),
    key("datapath.reciprocal_bits", "fixed: significant bits of the travel's reciprocal", Legal::Whole(8, 32)),
    key(
        "windows.set",
        "side@grid in texels of each window, fine to coarse; without it 1 4@2 12@4 40@8, and with fewer than 3 levels 1 2@2",
        Legal::Set,
    ),
    key(
        "fetch.cells",
        "cells that are read and judged in one iteration, one or four siblings; the hits are the same",
        Legal::Numbers(&[1, 4]),
    ),
    key("mode.start_level", "start at the lowest level whose node holds the whole ray, not at the root", Legal::Flag),
    key(
        "mode.levels_down",
        "levels per descent until the first crossing; without it 2, with fetch.cells = 4 it is 3 and at most 3",
        Legal::Whole(1, 4),
    ),
    key(
        "mode.levels_down_after",
        "levels per descent after the first crossing; without it 1, and 2 with fetch.cells = 4, where alone it may be other than 1",
        Legal::Whole(1, 3),
    ),
    key("mode.level_up", "when a crossing goes one level up", Legal::Word(LevelUp::WORDS)),
    key(
        "mode.trim",
        "exchange a node for the smallest one that holds the ray's way through it, before its height is read",
        Legal::Word(Trim::WORDS),
    ),
    key("mode.lod", "the finest level is an input of each ray", Legal::Flag),
    key(
        "mode.bilinear",
        "refine the hit to the surface interpolated between the centres of texels (watertight, without mode.lod)",
        Legal::Flag,
    ),
    key("latency.add", "fp_add, in clocks", CLOCKS),
    key("latency.mul", "fp_mul, in clocks", CLOCKS),
    key("latency.div", "fp_div, fp_recip and the fixed-point reciprocal, in clocks", Legal::Whole(0, 32)),
    key(
        "latency.divider",
        "how fp_div and the fixed-point reciprocal are built; digit rows, or a table of reciprocals and multipliers for few clocks (2 or more; format.man up to 16, default choices of the format; datapath.reciprocal_bits up to 31)",
        Legal::Word(Divider::WORDS),
    ),
    key("latency.compare", "fp_lt and fp_compare, in clocks", CLOCKS),
    key("latency.from_int", "fp_from_int and fp_from_fixed, in clocks", CLOCKS),
    key("latency.to_int", "fp_to_int and fp_to_fixed, in clocks", CLOCKS),
    key("latency.sqrt", "fp_sqrt, in clocks", Legal::Whole(0, 32)),
    key("latency.add3", "fp_add3, in clocks", CLOCKS),
    key(
        "latency.decision",
        "clocks of the decision: a register before level_decision (2), one inside level_up (3), one after level_decision (4), a second inside level_up and one inside multi_level_down (5); published: all after it",
        Legal::Whole(1, 5),
    ),
    key(
        "latency.node",
        "registers after a node's exit planes (1), after the choice of the slot's ray (2), and between a node's extent and its planes (3); not the published datapath",
        Legal::Whole(0, 3),
    ),
    key(
        "latency.memory",
        "the read of a height, in clocks; from 2 on the memory is in banks with a register after each",
        Legal::Whole(1, 4),
    ),
    key(
        "latency.select",
        "registers after the choice of one of two ray parameters; the watertight datapath",
        Legal::Whole(0, 1),
    ),
    key(
        "latency.setup",
        "registers in the setup between its units: after each step of the bias, and after the start level; the watertight datapath",
        Legal::Whole(0, 1),
    ),
    key(
        "latency.hit",
        "registers of the hit position: after its difference (1), and after the clamp (2); not the published datapath",
        Legal::Whole(0, 2),
    ),
    key(
        "latency.handshake",
        "what decouples ready: a spill_register after setup and after the hit (1), the decision which ray retires registered as well (2), a credit_fifo instead of the spill registers, and no clock enable before it (3)",
        Legal::Whole(0, 3),
    ),
    key(
        "latency.delay_line",
        "what waits this many clocks or longer does so in a memory of look-up tables instead of registers; 0: nothing does, else 3 or more",
        Legal::Whole(0, 17),
    ),
    key(
        "convert.int_bits",
        "INT_W of a conversion alone (--unit); 2 to 61 - format.man, or 0 for what the traversal needs",
        Legal::Whole(0, 59),
    ),
    key(
        "convert.frac_bits",
        "FRAC_W of a conversion alone, where it has one, fraction bits among convert.int_bits",
        Legal::Whole(0, 59),
    ),
    key("map.kind", "a procedural map, or file", Legal::Word(MapKind::WORDS)),
    key("map.file", "the image if kind is file; relative to this file", Legal::Path),
    key("map.seed", "seed of the procedural maps", SEED),
    key("map.scale", "height of a full-height texel, in world units", Legal::Real(0.0, 1000.0)),
    key("map.repeat", "how many times the map repeats along each side of the quad", Legal::Whole(1, 64)),
    key("map.resample", "whether an image of another size or depth may be resampled to fit", Legal::Flag),
    key(
        "map.border",
        "what lies beyond the map's border; clamp and mirror take a map of 2^(levels-1) texels a side, which is prepared into 2^levels",
        Legal::Word(Border::WORDS),
    ),
    key("map.range", "heights of the file, in its units, that become 0 and full height", Legal::Range),
    key(
        "map.nodata",
        "the file's value for no data, if the file does not say so itself; inf: both infinities",
        Legal::Mark,
    ),
    key("map.fill", "height of texels without data, in the file's units; without it they are an error", Legal::Number),
    key("map.channel", "the channel that holds the heights, where a file has several", Legal::Text),
    key("map.part", "the part or page, by name or number from 0, where a file has several", Legal::Text),
    key("map.size", "width and height of a file without a header (R16, RAW, HGT)", Legal::Size),
    key("map.byte_order", "which byte of a sample comes first in R16 and RAW", Legal::Word(ByteOrder::WORDS)),
    key("map.max_texels", "files of more texels are refused before anything is allocated", Legal::Whole(1, 1 << 40)),
    key("map.lossy", "whether a file compressed with loss (JPEG, lossy WebP) may be read", Legal::Flag),
    key("map.crop", "whether a larger file is cut to its first columns and rows", Legal::Flag),
    key("map.pad", "whether a smaller file is continued by its last column and row", Legal::Flag),
    key("view.names", "which views", Legal::Words(View::WORDS)),
    key("view.width", "width of the picture, in pixels", Legal::Whole(1, 8192)),
    key("view.height", "height of the picture, in pixels", Legal::Whole(1, 8192)),
    key("view.stride", "every n-th pixel in each direction is traced", Legal::Whole(1, 256)),
    key("vectors.generator", "where random bits come from", Legal::Word(&["chacha8"])),
    key("vectors.seed", "its seed", SEED),
    key("vectors.arithmetic", "vectors of each arithmetic unit", Legal::Whole(1, 1_000_000)),
    key("vectors.rays", "rays of each view", Legal::Whole(1, 1_000_000)),
    key(
        "vectors.planned",
        "whether rays planned to reach every refusal, limit, exponent and a spread of the texels are traced, too",
        Legal::Flag,
    ),
    key("emit.prefix", "put before the name of every emitted module and file", Legal::Prefix),
    key(
        "emit.timescale",
        "the `timescale of every emitted file; with none, a file takes that of whatever was read before it",
        Legal::Timescale,
    ),
    key(
        "emit.default_nettype",
        "what undeclared nets are after every emitted file; keep says nothing of them, before or after",
        Legal::Word(DefaultNettype::WORDS),
    ),
    key("emit.units", "units besides what the traversal needs", Legal::SomeWords(ExtraUnit::WORDS)),
    key(
        "emit.counters",
        "what traverse counts beside each hit; iterations, node crossings and levels gone up, iterations alone, or nothing",
        Legal::Word(Counters::WORDS),
    ),
    key("emit.clock_mhz", "clock that the constraints in flow/ ask for, in MHz", Legal::Whole(1, 1000)),
];

/// The key of this path.
pub fn find(path: &str) -> Option<&'static Key> {
    KEYS.iter().find(|key| key.path == path)
}

/// The known key nearest to a mistyped one; a right name in the wrong section counts almost as much as a near path, and so does one word of a
/// name (`mode.down` for `mode.levels_down`), most where the section is right.
/// None if no key is like it.
pub fn nearest(path: &str) -> Option<&'static str> {
    let (section, name) = path.rsplit_once('.').unwrap_or(("", path));
    let score = |key: &&Key| {
        let (known_section, known) = key.split();
        let word = known.split('_').map(|w| similarity(name, w)).fold(0.0, f64::max);
        let word = if section == known_section { 0.9 * word } else { 0.8 * word };
        similarity(path, key.path).max(0.95 * similarity(name, known)).max(word)
    };
    nearest_by(KEYS, score).map(|key| key.path)
}

/// Whether a key is `what`, or stands in that section, which is written with a point at its end.
pub(super) fn stands_in(path: &str, what: &str) -> bool {
    path == what || what.ends_with('.') && path.starts_with(what)
}
