//! What of all that could be measured is measured.
use super::design::{BEST, DesignSpec};
use crate::config::{Config, DatapathConfig, DatapathKind, LevelUp, MapKind, ModeConfig, Trim, View};
use crate::format::FloatFormat;
use crate::measure::ROWS;
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
        let trims = [Trim::Descent, Trim::Always].map(|trim| ModeConfig { trim, ..BEST });
        let set = self.modes.unwrap_or(if self.extent == Extent::Full { ModeSet::All } else { ModeSet::Table });
        match set {
            ModeSet::One => vec![BEST],
            ModeSet::Table => {
                let few = self.extent == Extent::Tiny && self.scenes.is_none();
                let rows = if few { &ROWS[5..] } else { &ROWS[..] };
                let downs = [3, 4].map(|levels_down| ModeConfig { levels_down, ..ROWS[0].1 });
                let downs = downs.into_iter().filter(|_| self.extent != Extent::Tiny);
                rows.iter().map(|r| r.1).chain(downs).chain(trims).collect()
            }
            ModeSet::All => every_mode(),
        }
    }

    /// The designs to be measured: each datapath's formats in one mode, its modes in one format, and the configured design.
    pub fn designs(&self, c: &Config) -> Vec<DesignSpec> {
        let kind = |kind| DatapathConfig { kind, ..DatapathConfig::default() };
        let fixed =
            |f: u32| DatapathConfig { fraction_bits: f, reciprocal_bits: f.max(8), ..kind(DatapathKind::Fixed) };
        let published = |nudge_bits| DatapathConfig { nudge_bits, ..kind(DatapathKind::Published) };
        let watertight = kind(DatapathKind::Watertight);
        let chosen = |kind| self.datapaths.is_empty() || self.datapaths.contains(&kind);
        let (formats, fractions) = (self.formats(), self.fractions());
        // The published figures are those of its own format.
        let usual = FloatFormat::new(7, 16);
        let one = *formats.iter().find(|f| **f == usual).unwrap_or(&formats[0]);
        let bits = *fractions.iter().find(|f| **f == 24).unwrap_or(&fractions[0]);
        let mut out = Vec::new();
        let mut add = |datapath: DatapathConfig, f: FloatFormat, mode| {
            let design = DesignSpec::usual(c, datapath, f.exp, f.man, mode);
            if chosen(datapath.kind) && !out.contains(&design) {
                out.push(design);
            }
        };
        formats.iter().for_each(|f| add(watertight, *f, BEST));
        fractions.iter().for_each(|f| add(fixed(*f), usual, BEST));
        let own = if self.formats.is_empty() { &[usual][..] } else { &self.formats[..] };
        own.iter().for_each(|f| [7, 0].iter().for_each(|nudge| add(published(*nudge), *f, BEST)));
        for datapath in [watertight, fixed(bits), published(7)] {
            // The published datapath knows no trim.
            let known = |m: &ModeConfig| datapath.kind != DatapathKind::Published || m.trim == Trim::None;
            self.modes().into_iter().filter(known).for_each(|mode| add(datapath, one, mode));
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

fn every_mode() -> Vec<ModeConfig> {
    let mut out = Vec::new();
    for trim in Trim::ALL {
        for level_up in LevelUp::ALL {
            for levels_down in 1..=4 {
                for start_level in [false, true] {
                    out.push(ModeConfig { start_level, levels_down, level_up, trim, ..BEST });
                }
            }
        }
    }
    out
}
