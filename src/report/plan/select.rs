//! What of all that could be measured is measured.
use super::design::DesignSpec;
use crate::config::modes::{BEST, combinations, deeper, published_rows, trimmed};
use crate::config::{Config, DatapathConfig, DatapathKind, Design, MapKind, ModeConfig, Trim, View, datapaths};
use crate::format::FloatFormat;
use crate::scene::RaySet;
use std::path::PathBuf;

/// How much is measured where nothing is chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Extent {
    /// One map, three designs, few rays: for tests.
    Tiny,
    /// A few minutes.
    #[default]
    Standard,
    /// Every width, every mode.
    Full,
}

/// Modes that are compared on one format of each datapath.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModeSet {
    /// Start level, two levels down, selective level-up.
    One,
    /// The rows of the published table, three and four levels down, chord trim.
    Table,
    /// Every mode.
    All,
}

impl ModeSet {
    /// All, smallest first.
    pub const ALL: [Self; 3] = [Self::One, Self::Table, Self::All];
}

/// What is chosen. What is empty is not narrowed.
#[derive(Clone, Debug, Default)]
pub struct Selection {
    /// How much where nothing is chosen.
    pub extent: Extent,
    /// A height map, instead of own ones.
    pub map: Option<PathBuf>,
    /// Own maps.
    pub maps: Vec<MapKind>,
    /// A directory with the maps of the published tables.
    pub scenes: Option<PathBuf>,
    /// log2 of the maps' sides; the first is the one at which designs are compared.
    pub levels: Vec<u32>,
    /// Views and tables of rays.
    pub views: Vec<RaySet>,
    /// At most so many rays of a view, evenly over its picture.
    pub most: Option<usize>,
    /// Datapaths.
    pub datapaths: Vec<DatapathKind>,
    /// Floating-point formats.
    pub formats: Vec<FloatFormat>,
    /// Fraction bits of fixed point.
    pub fractions: Vec<u32>,
    /// Modes.
    pub modes: Option<ModeSet>,
    /// Files of `synth` with areas and clocks.
    pub synth: Vec<PathBuf>,
    /// Names of the units that trace whole rays: their areas and clocks are those of a design.
    pub traversals: Vec<&'static str>,
}

impl Selection {
    /// The views to be measured: standard ones in the order of [`View::ALL`], then the user's.
    pub fn views(&self) -> Vec<RaySet> {
        if self.views.is_empty() {
            return View::ALL.iter().map(|v| RaySet::view(*v)).collect();
        }
        let mut views = self.views.clone();
        views.sort_by_key(|set| set.standard().map_or(View::ALL.len(), |v| v as usize));
        views
    }

    /// The modes that are compared on one arithmetic.
    fn modes(&self) -> Vec<ModeConfig> {
        let set = self.modes.unwrap_or(if self.extent == Extent::Full { ModeSet::All } else { ModeSet::Table });
        match set {
            ModeSet::One => vec![BEST],
            ModeSet::Table => {
                let few = self.extent == Extent::Tiny && self.scenes.is_none();
                let rows = published_rows().skip(if few { 5 } else { 0 });
                let downs = deeper().filter(|_| self.extent != Extent::Tiny);
                rows.chain(downs).chain(trimmed()).collect()
            }
            ModeSet::All => combinations(BEST, &Trim::ALL),
        }
    }

    /// The designs to be measured: each datapath's formats in one mode, its modes in one format, and the configured design.
    pub fn designs(&self, c: &Config) -> Vec<DesignSpec> {
        let chosen = |kind: &DatapathKind| self.datapaths.is_empty() || self.datapaths.contains(kind);
        let (formats, fractions) = (self.formats(), self.fractions());
        // The published figures are those of its own format.
        let usual = FloatFormat::new(7, 16);
        let own = if self.formats.is_empty() { vec![usual] } else { self.formats.clone() };
        let one = *formats.iter().find(|f| **f == usual).unwrap_or(&formats[0]);
        let bits = *fractions.iter().find(|f| **f == 24).unwrap_or(&fractions[0]);
        let at = |kind, f: u32| DatapathConfig {
            kind,
            fraction_bits: f,
            reciprocal_bits: f.max(8),
            ..DatapathConfig::default()
        };
        let mut out = Vec::new();
        let mut add = |datapath: DatapathConfig, f: FloatFormat, mode| {
            let design = DesignSpec::usual(c, datapath, f.exp, f.man, mode);
            if !out.contains(&design) {
                out.push(design);
            }
        };
        // What a datapath does not read, no design says: of its values those that make no difference fall together.
        for kind in datapaths().filter(chosen) {
            let nudged = kind.facts().reads.nudge_bits;
            for format in if nudged { &own } else { &formats } {
                for fraction in &fractions {
                    for nudge_bits in if nudged { &[7, 0][..] } else { &[0] } {
                        add(DatapathConfig { nudge_bits: *nudge_bits, ..at(kind, *fraction) }, *format, BEST);
                    }
                }
            }
        }
        for kind in datapaths().filter(chosen) {
            self.modes().into_iter().filter(kind.facts().has_mode).for_each(|mode| add(at(kind, bits), one, mode));
        }
        // Another search of the same numbers: by its usual set, or by all.
        let one_way = self.extent == Extent::Tiny || self.modes == Some(ModeSet::One);
        for kind in datapaths().filter(chosen).filter(|_| !one_way) {
            let design = Design { datapath: at(kind, bits), ..c.design() };
            for other in (kind.facts().searches)(&design) {
                let mut spec = DesignSpec::usual(c, other.datapath, one.exp, one.man, BEST);
                if self.modes == Some(ModeSet::All) {
                    spec.windows = other.windows.set;
                }
                if !out.contains(&spec) {
                    out.push(spec);
                }
            }
        }
        let configured = configured(c);
        if self.extent != Extent::Tiny && !out.contains(&configured) {
            out.push(configured);
        }
        out
    }

    fn formats(&self) -> Vec<FloatFormat> {
        let (exps, mans): (Vec<u32>, Vec<u32>) = match self.extent {
            _ if !self.formats.is_empty() => return self.formats.clone(),
            Extent::Tiny => (vec![7], vec![7, 16]),
            Extent::Standard => ((5..=8).collect(), vec![7, 10, 13, 16, 19, 23]),
            Extent::Full => ((5..=8).collect(), (7..=23).collect()),
        };
        exps.iter().flat_map(|e| mans.iter().map(|m| FloatFormat::new(*e, *m))).collect()
    }

    fn fractions(&self) -> Vec<u32> {
        match self.extent {
            _ if !self.fractions.is_empty() => self.fractions.clone(),
            Extent::Tiny => vec![24],
            Extent::Standard => (8..=28).step_by(4).collect(),
            Extent::Full => (8..=28).collect(),
        }
    }
}

/// The configuration's design. What a refinement does to a block hit, and coarser levels of it, are no part of these figures.
pub fn configured(c: &Config) -> DesignSpec {
    let mode = ModeConfig { lod: false, bilinear: false, ..c.mode };
    DesignSpec::new(c, c.datapath, c.format.exp, c.format.man, mode)
}
