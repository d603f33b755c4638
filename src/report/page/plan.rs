//! What is measured: maps, views, designs, modes; every combination is a cell.
use crate::config::{
    Border, Config, DatapathConfig, DatapathKind, Design, LevelUp, MapConfig, MapKind, ModeConfig, Trim, View,
};
use crate::error::Result;
use crate::golden::{Pyramid, Tracer};
use crate::report::{PUBLISHED, ROWS};
use crate::scene::{Camera, ViewRay, bordered_codes, load, procedural};
use crate::trace::rays_inside;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// How much is measured.
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

/// A map, as a cell names it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MapSpec {
    /// Kind, or file stem.
    pub name: String,
    /// Kind.
    pub kind: MapKind,
    /// Seed of a procedural map; 0 of a file.
    pub seed: u64,
    /// log2 of the side.
    pub levels: u32,
    /// Bits of a height code.
    pub height_bits: u32,
    /// World height of a full-height texel.
    pub scale: f64,
    /// Repeats along the quad.
    pub repeat: u32,
    /// What lies behind the border.
    pub border: Border,
    /// Twelve digits of blake3 over the height codes.
    pub codes: String,
}

/// A design, as a cell names it: what does not matter to its datapath is left out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DesignSpec {
    /// Datapath.
    pub kind: DatapathKind,
    /// EXP_W of a floating-point datapath.
    pub exp: Option<u32>,
    /// MAN_W of a floating-point datapath.
    pub man: Option<u32>,
    /// `published`: nudge.
    pub nudge_bits: Option<u32>,
    /// `fixed`: fraction bits.
    pub fraction_bits: Option<u32>,
    /// `fixed`: bits of the reciprocal.
    pub reciprocal_bits: Option<u32>,
    /// TILE_W.
    pub tile_bits: u32,
    /// FRAC_W.
    pub frac_bits: u32,
    /// STEP_LIMIT.
    pub step_limit: u32,
    /// Modes.
    pub mode: ModeConfig,
}

/// A map, ready to be traced.
pub struct Site {
    /// What it is.
    pub spec: MapSpec,
    /// Height codes.
    pub texels: Vec<u32>,
    /// Their pyramid.
    pub pyramid: Pyramid,
    /// The file it came from.
    pub file: Option<PathBuf>,
}

/// A combination that has no datapath.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NotLegal {
    /// Design and mode.
    pub design: String,
    /// log2 of the map's side.
    pub levels: u32,
    /// Why.
    pub reason: String,
}

/// All that is to be measured.
pub struct Plan {
    /// The configuration it started from.
    pub config: Config,
    /// How much.
    pub extent: Extent,
    /// Maps.
    pub sites: Vec<Site>,
    /// Designs with their modes, in the order of the page.
    pub designs: Vec<DesignSpec>,
    /// Every n-th pixel of a view, by [`View::ALL`]: about as many rays of each.
    pub strides: [u32; 3],
    /// Refused designs, once a map size.
    pub not_legal: Vec<NotLegal>,
    /// Site, view, design of every cell.
    pub cells: Vec<(usize, View, usize)>,
}

/// The mode that the page takes where it compares formats.
pub const BEST: ModeConfig = ModeConfig {
    start_level: true,
    levels_down: 2,
    level_up: LevelUp::Selective,
    trim: Trim::None,
    lod: false,
    bilinear: false,
};

/// Iterations after which a ray without nudge is given up: more than any ray of the usual maps needs.
const STUCK_LIMIT: u32 = 511;

impl DesignSpec {
    fn new(c: &Config, datapath: DatapathConfig, exp: u32, man: u32, mode: ModeConfig) -> Self {
        let fixed = datapath.kind == DatapathKind::Fixed;
        let published = datapath.kind == DatapathKind::Published;
        // Without its nudge more than half of the published datapath's rays stay in a texel for ever, and each costs the whole limit.
        let cap = match (published, datapath.nudge_bits) {
            (true, 0) => STUCK_LIMIT,
            (true, _) => 1023,
            _ => 8191,
        };
        Self {
            kind: datapath.kind,
            exp: (!fixed).then_some(exp),
            man: (!fixed).then_some(man),
            nudge_bits: published.then_some(datapath.nudge_bits),
            fraction_bits: fixed.then_some(datapath.fraction_bits),
            reciprocal_bits: fixed.then_some(datapath.reciprocal_bits),
            tile_bits: c.traverse.tile_bits,
            frac_bits: c.traverse.frac_bits,
            step_limit: c.traverse.step_limit.min(cap),
            mode,
        }
    }

    /// The configuration of this design on a map of 2^levels texels.
    pub fn config(&self, base: &Config, levels: u32) -> Config {
        let mut c = base.clone();
        (c.map, c.mode) = (MapConfig::default(), self.mode);
        (c.traverse.levels, c.traverse.tile_bits, c.traverse.frac_bits) = (levels, self.tile_bits, self.frac_bits);
        // A map eight times as wide is eight times as far to walk; who is stuck is stuck on any map.
        let wider = if self.nudge_bits == Some(0) { 0 } else { levels.saturating_sub(8).min(4) };
        c.traverse.step_limit = (self.step_limit << wider).min(65535);
        c.datapath = DatapathConfig { kind: self.kind, ..DatapathConfig::default() };
        c.format.exp = self.exp.unwrap_or(c.format.exp);
        c.format.man = self.man.unwrap_or(c.format.man);
        c.datapath.nudge_bits = self.nudge_bits.unwrap_or(c.datapath.nudge_bits);
        c.datapath.fraction_bits = self.fraction_bits.unwrap_or(c.datapath.fraction_bits);
        c.datapath.reciprocal_bits = self.reciprocal_bits.unwrap_or(c.datapath.reciprocal_bits);
        c
    }

    /// The design on a map of 2^levels texels.
    ///
    /// # Errors
    /// Why there is none.
    pub fn design(&self, base: &Config, levels: u32) -> Result<Design> {
        let c = self.config(base, levels);
        c.validate()?;
        let design = c.design();
        Tracer::new(&design)?;
        Ok(design)
    }

    /// Datapath and widths in a few words.
    pub fn label(&self) -> String {
        let float = format!("{}/{}", self.exp.unwrap_or(0), self.man.unwrap_or(0));
        match (self.kind, self.nudge_bits) {
            (DatapathKind::Watertight, _) => format!("watertight {float}"),
            (DatapathKind::Published, Some(0) | None) => format!("published {float}, no nudge"),
            (DatapathKind::Published, Some(n)) => format!("published {float}, nudge 2^-{n}"),
            (DatapathKind::Fixed, _) => format!("fixed Q.{}", self.fraction_bits.unwrap_or(0)),
        }
    }

    /// Bits of a word of a ray's entry point.
    pub fn word_bits(&self) -> u32 {
        self.fraction_bits.unwrap_or(1 + self.exp.unwrap_or(0) + self.man.unwrap_or(0))
    }

    /// Cycles a ray needs beside its iterations: the published datapath sends a ray through the loop once for its start.
    pub fn start_trips(&self) -> u32 {
        u32::from(self.kind == DatapathKind::Published)
    }

    /// Another mode of the same arithmetic.
    pub fn same_arithmetic(&self, other: &Self) -> bool {
        Self { mode: BEST, ..self.clone() } == Self { mode: BEST, ..other.clone() }
    }
}

/// A mode in a few words: that of the published table where it has one.
pub fn mode_label(m: &ModeConfig) -> String {
    let plain = ModeConfig { trim: Trim::None, lod: false, bilinear: false, ..*m };
    let up = serde_json::to_value(m.level_up).expect("plain data");
    let named = ROWS.iter().find(|(_, row)| *row == plain).map(|(name, _)| (*name).to_owned());
    let name = named.unwrap_or_else(|| {
        let start = if m.start_level { "start level" } else { "from root" };
        format!("{start}, {} down, up {}", m.levels_down, up.as_str().unwrap_or_default())
    });
    match m.trim {
        Trim::None => name,
        Trim::Descent => name + " + trim descent",
        Trim::Always => name + " + trim always",
    }
}

/// The modes that are compared on one arithmetic.
pub fn modes(extent: Extent) -> Vec<ModeConfig> {
    let trims = [Trim::Descent, Trim::Always].map(|trim| ModeConfig { trim, ..BEST });
    if extent != Extent::Full {
        let rows = if extent == Extent::Tiny { &ROWS[5..] } else { &ROWS[..] };
        let downs = [3, 4].map(|levels_down| ModeConfig { levels_down, ..ROWS[0].1 });
        let downs = downs.into_iter().filter(|_| extent == Extent::Standard);
        return rows.iter().map(|r| r.1).chain(downs).chain(trims).collect();
    }
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

fn designs(c: &Config, extent: Extent) -> Vec<DesignSpec> {
    let kind = |kind| DatapathConfig { kind, ..DatapathConfig::default() };
    let fixed = |f: u32| DatapathConfig { fraction_bits: f, reciprocal_bits: f.max(8), ..kind(DatapathKind::Fixed) };
    let published = |nudge_bits| DatapathConfig { nudge_bits, ..kind(DatapathKind::Published) };
    let watertight = kind(DatapathKind::Watertight);
    let (exps, mans, fractions): (Vec<u32>, Vec<u32>, Vec<u32>) = match extent {
        Extent::Tiny => (vec![7], vec![7, 16], vec![24]),
        Extent::Standard => ((5..=8).collect(), vec![7, 10, 13, 16, 19, 23], (8..=28).step_by(4).collect()),
        Extent::Full => ((5..=8).collect(), (7..=23).collect(), (8..=28).collect()),
    };
    let mut out = Vec::new();
    let mut add = |datapath, exp, man, mode| {
        let design = DesignSpec::new(c, datapath, exp, man, mode);
        if !out.contains(&design) {
            out.push(design);
        }
    };
    exps.iter().for_each(|e| mans.iter().for_each(|m| add(watertight, *e, *m, BEST)));
    fractions.iter().for_each(|f| add(fixed(*f), 7, 16, BEST));
    [7, 0].iter().for_each(|nudge| add(published(*nudge), 7, 16, BEST));
    for datapath in [watertight, fixed(24), published(7)] {
        // The published datapath knows no trim.
        let known = |m: &ModeConfig| datapath.kind != DatapathKind::Published || m.trim == Trim::None;
        modes(extent).into_iter().filter(known).for_each(|mode| add(datapath, 7, 16, mode));
    }
    out
}

impl Plan {
    /// The plan of a configuration; `scenes` is a directory with the maps of the published table.
    ///
    /// # Errors
    /// A map that can't be read.
    pub fn new(c: &Config, extent: Extent, scenes: Option<&std::path::Path>) -> Result<Self> {
        if scenes.is_some() {
            c.map.published_border()?;
        }
        let n = c.traverse.levels;
        let wide = 11.max(n);
        let own: &[(MapKind, u32)] = match extent {
            Extent::Tiny => &[(MapKind::Spikes, n)],
            _ => &[
                (MapKind::Rocks, n),
                (MapKind::Spikes, n),
                (MapKind::Dunes, n),
                (MapKind::Bricks, n),
                (MapKind::Rocks, wide),
            ],
        };
        let mut sites = Vec::new();
        for &(kind, levels) in own {
            let map = MapConfig { kind, file: None, ..c.map.clone() };
            sites.push(Site::new(c, &map, levels)?);
        }
        for p in PUBLISHED.iter().filter(|_| scenes.is_some()) {
            let file = scenes.map(|dir| dir.join(format!("{}.png", p.scene)));
            let map = MapConfig { kind: MapKind::File, file, scale: p.scale, repeat: p.repeat, ..c.map.clone() };
            sites.push(Site::new(c, &map, n)?);
        }
        let designs = designs(c, extent);
        let (mut cells, mut not_legal) = (Vec::new(), Vec::new());
        for (s, site) in sites.iter().enumerate() {
            let levels = site.spec.levels;
            for (d, spec) in designs.iter().enumerate() {
                match spec.design(c, levels) {
                    Ok(_) => cells.extend(View::ALL.iter().map(|view| (s, *view, d))),
                    Err(e) => {
                        let design = format!("{}, {}", spec.label(), mode_label(&spec.mode));
                        let refused = NotLegal { design, levels, reason: e.to_string().replace("\n  - ", " ") };
                        if !not_legal.contains(&refused) {
                            not_legal.push(refused);
                        }
                    }
                }
            }
        }
        let strides = if extent == Extent::Tiny { [64, 48, 16] } else { [8, 7, 2] };
        Ok(Self { config: c.clone(), extent, sites, designs, strides, not_legal, cells })
    }

    /// Every n-th pixel of a view.
    pub fn stride(&self, view: View) -> u32 {
        self.strides[view as usize]
    }
}

impl Site {
    /// The map of `map` with 2^levels texels along each side.
    ///
    /// # Errors
    /// A map that can't be read or does not fit.
    pub fn new(c: &Config, map: &MapConfig, levels: u32) -> Result<Self> {
        let height_bits = c.traverse.height_bits;
        let (heights, name) = match &map.file {
            Some(file) if map.kind == MapKind::File => {
                (load(file)?, file.file_stem().unwrap_or_default().to_string_lossy().into_owned())
            }
            _ => (procedural(map.kind, levels - map.border.levels(), map.seed)?, map.kind.word().to_owned()),
        };
        let texels = bordered_codes(&heights, map.border, levels, height_bits, map.resample)?;
        let pyramid = Pyramid::build(levels, height_bits, &texels)?;
        let bytes: Vec<u8> = texels.iter().flat_map(|code| code.to_le_bytes()).collect();
        let codes = blake3::hash(&bytes).to_hex()[..12].to_owned();
        let seed = if map.kind == MapKind::File { 0 } else { map.seed };
        let (kind, scale, repeat, border) = (map.kind, map.scale, map.repeat, map.border);
        let spec = MapSpec { name, kind, seed, levels, height_bits, scale, repeat, border, codes };
        Ok(Self { spec, texels, pyramid, file: map.file.clone() })
    }

    /// A camera's rays in tiles of the design, but for those that don't see what the map's border promises.
    ///
    /// # Errors
    /// No watertight design holds the map.
    pub fn rays(&self, c: &Config, camera: &Camera, stride: u32) -> Result<Vec<ViewRay>> {
        let s = &self.spec;
        let rays = camera.bordered_rays(s.border, s.scale, s.repeat, stride);
        let mut d = Design::default();
        (d.traverse.levels, d.traverse.height_bits, d.traverse.tile_bits) =
            (s.levels, s.height_bits, c.traverse.tile_bits);
        rays_inside(&d, s.border, &self.pyramid, rays)
    }
}
