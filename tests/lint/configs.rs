//! The default configuration and a spread around it, emitted once for all tests.
use reliefrtl::config::{Config, DatapathKind};
use reliefrtl::emit::{self, Files};
use reliefrtl::format::{Rounding, Specials, Subnormals};
use reliefrtl::ir::Module;
use reliefrtl::units;
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

/// One emitted configuration.
pub struct Emitted {
    /// What it was made from: the assignments, or `default`.
    pub label: String,
    /// The configuration.
    pub config: Config,
    /// The units that the configuration asks for.
    pub units: Vec<Arc<Module>>,
    /// All modules: the units and what stands below them.
    pub modules: Vec<Arc<Module>>,
    /// The texts, by path.
    pub files: Files,
    /// The modules that no configuration before has in this text with all that stands below it, as they are printed.
    pub fresh: Vec<String>,
    /// The same on disk.
    pub dir: PathBuf,
}

impl Emitted {
    /// Names of the modules as they are printed.
    pub fn names(&self) -> Vec<String> {
        self.modules.iter().map(|m| format!("{}{}", self.config.emit.prefix, m.name)).collect()
    }
    /// Digest of a module's text and of all that stands below it.
    pub fn closure(&self, m: &Arc<Module>) -> blake3::Hash {
        let mut hash = blake3::Hasher::new();
        for below in m.hierarchy() {
            hash.update(self.files[&format!("rtl/{}{}.v", self.config.emit.prefix, below.name)].as_bytes());
        }
        hash.finalize()
    }
    /// The files of its fresh modules and of what stands below them.
    pub fn fresh_files(&self) -> Vec<String> {
        let prefix = &self.config.emit.prefix;
        let fresh = self.modules.iter().filter(|m| self.fresh.contains(&format!("{prefix}{}", m.name)));
        let files: BTreeSet<String> =
            fresh.flat_map(|m| m.hierarchy()).map(|m| format!("rtl/{prefix}{}.v", m.name)).collect();
        files.into_iter().collect()
    }
    /// Paths of the Verilog files, from the directory.
    pub fn verilog(&self) -> Vec<&str> {
        self.files.keys().map(String::as_str).filter(|f| f.ends_with(".v")).collect()
    }
}

/// Every level-up rule, every other mode, both ends of the sizes, combinational and deep units, other formats, a prefix. The largest maps have
/// their memory in one piece: of banks there would be thousands, which take a tool half a minute.
const SPREAD: &[&[&str]] = &[
    &[],
    &["mode.level_up=none"],
    &["mode.level_up=tevs"],
    &["mode.level_up=coherent"],
    &["mode.level_up=always"],
    &["mode.start_level=false"],
    &["mode.start_level=false", "mode.level_up=none", "mode.levels_down=1"],
    &["mode.levels_down=1"],
    &["mode.levels_down=3"],
    &["mode.levels_down=4"],
    &["latency.add=0", "latency.mul=0", "latency.div=0", "latency.compare=0", "latency.from_int=0", "latency.to_int=0"],
    &["latency.add=5", "latency.mul=3", "latency.div=7", "latency.compare=2", "latency.from_int=2", "latency.to_int=2"],
    &["latency.div=32", "latency.decision=4"],
    &["latency.divider=table"],
    &["latency.divider=table", "latency.div=9", "emit.units=fp_recip"],
    &[
        "latency.divider=table",
        "latency.div=4",
        "format.exp=5",
        "format.man=10",
        "traverse.levels=4",
        "traverse.tile_bits=2",
    ],
    &["latency.divider=table", "latency.div=6", "datapath.kind=published"],
    &["latency.divider=table", "latency.div=5", "mode.bilinear=true", "format.exp=6", "format.man=13"],
    &["latency.divider=table", "latency.div=2", "datapath.kind=fixed"],
    &["latency.divider=table", "latency.div=22", "datapath.kind=fixed", "datapath.search=windows"],
    &["emit.prefix=pdm_"],
    &["emit.timescale=1ns/1ps", "emit.default_nettype=none"],
    &["emit.prefix=", "emit.default_nettype=keep"],
    &["latency.node=2", "latency.memory=4", "latency.select=1", "latency.handshake=1", "latency.decision=2"],
    &[
        "latency.handshake=3",
        "latency.delay_line=3",
        "latency.div=20",
        "latency.add=6",
        "latency.mul=6",
        "mode.trim=always",
    ],
    &["latency.handshake=3", "latency.delay_line=4", "latency.div=13", "latency.divider=table", "mode.bilinear=true"],
    &["latency.handshake=3", "latency.delay_line=17", "latency.decision=5", "datapath.kind=fixed", "mode.lod=true"],
    &["format.exp=5", "format.man=10", "traverse.levels=4", "traverse.tile_bits=2"],
    &["format.exp=8", "format.man=23"],
    &["traverse.levels=2"],
    &["traverse.levels=12", "latency.memory=1"],
    &["traverse.levels=10"],
    &["traverse.height_bits=16"],
    &["traverse.tile_bits=1", "traverse.frac_bits=1", "traverse.tag_bits=1", "traverse.step_limit=1"],
    &["mode.trim=descent"],
    &["fetch.cells=4"],
    &[
        "fetch.cells=4",
        "mode.trim=always",
        "mode.lod=true",
        "mode.level_up=tevs",
        "datapath.kind=fixed",
        "latency.delay_line=3",
    ],
    &["mode.trim=always", "mode.start_level=false", "mode.level_up=none"],
    &["mode.trim=always", "mode.lod=true"],
    &["mode.trim=descent", "mode.lod=true", "mode.level_up=coherent", "traverse.levels=3", "mode.levels_down=4"],
    &["mode.lod=true", "mode.start_level=false", "mode.level_up=tevs", "mode.levels_down=1", "latency.decision=3"],
    &[
        "mode.trim=always",
        "mode.level_up=always",
        "format.exp=5",
        "format.man=10",
        "traverse.levels=4",
        "traverse.tile_bits=2",
    ],
    &[
        "mode.trim=always",
        "latency.add=0",
        "latency.mul=0",
        "latency.compare=0",
        "latency.from_int=0",
        "latency.to_int=0",
    ],
    &["traverse.tile_bits=8", "traverse.frac_bits=16", "traverse.tag_bits=32", "traverse.height_bits=2"],
    &["mode.bilinear=true"],
    &[
        "mode.bilinear=true",
        "mode.trim=always",
        "format.exp=8",
        "format.man=23",
        "traverse.levels=12",
        "latency.memory=1",
        "emit.prefix=pdm_",
    ],
    &[
        "mode.bilinear=true",
        "format.exp=5",
        "format.man=10",
        "traverse.levels=2",
        "traverse.tile_bits=2",
        "traverse.frac_bits=16",
        "latency.add=0",
        "latency.mul=0",
        "latency.div=0",
        "latency.compare=0",
        "latency.from_int=0",
        "latency.to_int=0",
    ],
    &["mode.bilinear=true", "traverse.height_bits=16", "traverse.frac_bits=1", "latency.mul=3", "latency.from_int=2"],
    &["datapath.kind=fixed", "mode.trim=descent", "mode.start_level=false", "mode.level_up=none"],
    &["datapath.kind=fixed", "mode.trim=always", "mode.lod=true"],
    &[
        "datapath.kind=fixed",
        "mode.trim=always",
        "mode.lod=true",
        "mode.level_up=always",
        "datapath.fraction_bits=28",
        "datapath.reciprocal_bits=31",
        "traverse.levels=12",
        "latency.memory=1",
        "latency.add=0",
        "latency.mul=0",
    ],
    &[
        "datapath.kind=fixed",
        "mode.trim=descent",
        "mode.lod=true",
        "datapath.fraction_bits=8",
        "datapath.reciprocal_bits=32",
        "traverse.levels=8",
        "traverse.tile_bits=1",
        "traverse.height_bits=2",
    ],
    &["datapath.kind=published"],
    &["datapath.kind=published", "mode.start_level=false", "mode.level_up=none", "mode.levels_down=1"],
    &["datapath.kind=published", "mode.level_up=coherent", "mode.levels_down=4", "datapath.nudge_bits=0"],
    &["datapath.kind=published", "format.exp=5", "format.man=10", "traverse.levels=2", "mode.level_up=tevs"],
    &[
        "datapath.kind=published",
        "format.exp=8",
        "format.man=23",
        "traverse.levels=12",
        "latency.memory=1",
        "latency.add=0",
        "latency.mul=0",
        "latency.div=0",
        "latency.compare=0",
        "latency.from_int=0",
        "latency.to_int=0",
    ],
    &[
        "datapath.kind=published",
        "traverse.height_bits=16",
        "traverse.tile_bits=8",
        "datapath.nudge_bits=16",
        "latency.div=9",
        "latency.compare=3",
        "latency.decision=4",
    ],
    &["datapath.kind=fixed"],
    &["datapath.kind=fixed", "datapath.fraction_bits=20", "datapath.reciprocal_bits=18", "mode.start_level=false"],
    &[
        "datapath.kind=fixed",
        "datapath.fraction_bits=12",
        "datapath.reciprocal_bits=10",
        "traverse.levels=12",
        "latency.memory=1",
    ],
    &["datapath.kind=fixed", "datapath.fraction_bits=28", "datapath.reciprocal_bits=31", "traverse.height_bits=16"],
    &[
        "datapath.kind=fixed",
        "datapath.fraction_bits=8",
        "datapath.reciprocal_bits=32",
        "latency.div=32",
        "latency.mul=3",
    ],
    &["datapath.kind=fixed", "latency.add=0", "latency.mul=0", "latency.div=0", "latency.compare=0"],
    &["datapath.kind=fixed", "datapath.search=windows"],
    &["emit.counters=none"],
    &["emit.counters=steps", "mode.trim=always", "mode.levels_down=1", "mode.level_up=none"],
    &["emit.counters=none", "mode.trim=always", "datapath.kind=fixed", "fetch.cells=4"],
    &["emit.counters=none", "datapath.kind=published", "mode.levels_down=1"],
    &["emit.counters=none", "datapath.kind=fixed", "datapath.search=windows"],
    &[
        "datapath.kind=fixed",
        "datapath.search=windows",
        "windows.set=1 4@2 16@4",
        "datapath.fraction_bits=20",
        "datapath.reciprocal_bits=20",
    ],
    &[
        "datapath.kind=fixed",
        "datapath.search=windows",
        "windows.set=1 3 9 27",
        "traverse.levels=10",
        "traverse.height_bits=16",
        "datapath.reciprocal_bits=31",
    ],
    EXTRA,
    &[
        "emit.units=fp_sqrt,fp_recip,fp_compare,fp_add3,fifo,arbiter",
        "format.exp=8",
        "format.man=23",
        "latency.sqrt=27",
        "latency.div=30",
        "latency.compare=0",
        "latency.add3=9",
    ],
];

/// The default configuration with every unit that no traversal needs, dividers that small formats can have, and a memory that any number of levels
/// elaborates in (banks are a generate loop, which Debian's Verilator does not unroll to the illegal count before it looks at the parameter's check).
pub const EXTRA: &[&str] =
    &["emit.units=fp_sqrt,fp_recip,fp_compare,fp_add3", "latency.div=2", "latency.sqrt=4", "latency.memory=1"];

/// Arithmetic alone, at what no traversal can have: format, clocks of all units; every choice is crossed with them.
const ALONE: &[(u32, u32, u32)] = &[
    (7, 16, 2),
    (4, 3, 0),
    (3, 2, 1),
    (8, 23, 6),
    (5, 10, 3),
    (2, 6, 4),
    (7, 16, 11),
    (6, 23, 1),
    (2, 2, 5),
    (8, 2, 2),
];

/// All configurations; written to disk at the first call.
pub fn all() -> &'static [Emitted] {
    static ALL: OnceLock<Vec<Emitted>> = OnceLock::new();
    ALL.get_or_init(|| {
        let spread = SPREAD.iter().map(|sets| (sets.iter().map(|s| s.to_string()).collect(), true));
        let all = spread.chain(alone().into_iter().map(|sets| (sets, false)));
        let mut all: Vec<Emitted> =
            all.enumerate().map(|(i, (sets, traverses))| emit_one(i, &sets, traverses)).collect();
        let mut seen = BTreeSet::new();
        for e in &mut all {
            let fresh = e.modules.iter().filter(|m| seen.insert(*e.closure(m).as_bytes()));
            e.fresh = fresh.map(|m| format!("{}{}", e.config.emit.prefix, m.name)).collect();
        }
        all
    })
}

/// The default configuration with every unit that no traversal needs, dividers that small formats can have, and a memory that any number of levels
/// elaborates in (banks are a generate loop, which Debian's Verilator does not unroll to the illegal count before it looks at the parameter's check).
pub fn extra() -> &'static Emitted {
    all().iter().find(|e| e.label == EXTRA.join(" ")).expect("the spread has it")
}

/// Assignments for every choice of rounding, subnormals and specials.
fn alone() -> Vec<Vec<String>> {
    let mut out = Vec::new();
    for rounding in Rounding::WORDS {
        for subnormals in Subnormals::WORDS {
            for specials in Specials::WORDS {
                let (exp, man, clocks) = ALONE[out.len() % ALONE.len()];
                let mut sets = vec![
                    format!("format.rounding={rounding}"),
                    format!("format.subnormals={subnormals}"),
                    format!("format.specials={specials}"),
                    format!("format.exp={exp}"),
                    format!("format.man={man}"),
                    EXTRA[0].to_string(),
                ];
                let kinds = ["add", "mul", "div", "compare", "from_int", "to_int", "sqrt", "add3"];
                sets.extend(kinds.map(|k| format!("latency.{k}={clocks}")));
                out.push(sets);
            }
        }
    }
    out
}

/// A traversal with its units, or arithmetic alone.
fn emit_one(index: usize, sets: &[String], traverses: bool) -> Emitted {
    let mut config = Config::default();
    let label = if sets.is_empty() { "default".to_owned() } else { sets.join(" ") };
    for set in sets {
        config.apply_set(set).unwrap_or_else(|e| panic!("{label}: {e}"));
    }
    let units = if traverses {
        config.validate().unwrap_or_else(|e| panic!("{label}: {e}"));
        units::all(&config.design())
    } else {
        units::arithmetic(&config.design())
    };
    let modules = emit::modules(&units).unwrap_or_else(|e| panic!("{label}: {e}"));
    let files = emit::rtl(&config, &modules);
    let dir = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("lint").join(index.to_string());
    // What an earlier run left there may have other files.
    let _ = std::fs::remove_dir_all(&dir);
    std::fs::create_dir_all(dir.join("rtl")).expect("target is writable");
    for (path, text) in &files {
        std::fs::write(dir.join(path), text).expect("target is writable");
    }
    Emitted { label, config, units, modules, files, fresh: Vec::new(), dir }
}

/// All Verilog files of all configurations; the count that every linter must reach.
pub fn file_count() -> usize {
    all().iter().map(|e| e.verilog().len()).sum()
}

#[test]
fn the_spread_is_what_it_says() {
    for e in all() {
        assert_eq!(e.verilog().len(), e.modules.len(), "{}: one file a module", e.label);
        let list: Vec<&str> = e.files["rtl/filelist.f"].lines().collect();
        let mut sorted = list.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, e.verilog(), "{}: the file list names every file once", e.label);
        let traverses = e.units.iter().any(|m| m.name == "traverse");
        let least = match e.config.datapath.kind {
            _ if !traverses => 15,
            DatapathKind::Fixed | DatapathKind::Windows => 17,
            DatapathKind::Watertight | DatapathKind::Published => 23,
        };
        assert!(e.units.len() >= least, "{}: {} units", e.label, e.units.len());
    }
    println!("{} files of {} configurations", file_count(), all().len());
    assert!(all().len() >= 60 && file_count() > 20 * all().len(), "{} files", file_count());
}
