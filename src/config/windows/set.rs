//! A set of windows: text, rules, defaults.
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;

/// Windows of one size.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Window {
    /// S: texels a side, a multiple of `grid`.
    pub side: u32,
    /// g: every window begins at a multiple of it, along both axes; a power of two.
    pub grid: u32,
}

impl Window {
    /// The texel itself.
    pub const TEXEL: Self = Self { side: 1, grid: 1 };

    /// lg g.
    pub const fn grid_bits(self) -> u32 {
        self.grid.ilog2()
    }

    /// S / g: cells of the grid a side.
    pub const fn cells(self) -> u32 {
        self.side / self.grid
    }

    /// S - g: texels beyond the cell of the grid that the ray is in.
    pub const fn ahead(self) -> u32 {
        self.side - self.grid
    }
}

impl fmt::Display for Window {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.grid == 1 { write!(f, "{}", self.side) } else { write!(f, "{}@{}", self.side, self.grid) }
    }
}

impl FromStr for Window {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (side, grid) = text.split_once('@').unwrap_or((text, "1"));
        let number = |digits: &str| {
            let whole = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit());
            digits.parse::<u32>().ok().filter(|n| whole && *n > 0)
        };
        number(side).zip(number(grid)).map(|(side, grid)| Self { side, grid }).ok_or_else(|| {
            format!(
                "has {text:?}, which is no window: a side in texels, like 4, or a side and a grid, like 4@2, is legal"
            )
        })
    }
}

/// Windows of 2 to 5 sizes, finest first.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct WindowSet {
    count: usize,
    /// Those after `count` are [`Window::TEXEL`].
    sizes: [Window; Self::MOST],
}

impl WindowSet {
    /// The largest number of sizes.
    pub const MOST: usize = 5;
    /// The largest S - g.
    pub const FARTHEST: u32 = 63;
    /// The largest g.
    pub const COARSEST: u32 = 16;
    /// The smallest set, for maps on which [`WindowSet::USUAL`] does not fit. Its S - g does not rise: it is legal besides.
    const LEAST: [Window; 2] = [Window::TEXEL, Window { side: 2, grid: 2 }];
    /// The set where nothing else is asked for: as much memory as the pyramid.
    const USUAL: [Window; 4] =
        [Window::TEXEL, Window { side: 4, grid: 2 }, Window { side: 12, grid: 4 }, Window { side: 40, grid: 8 }];

    /// The set where nothing else is asked for, on a map with 2^`levels` texels a side.
    pub fn usual(levels: u32) -> Self {
        if levels < 3 { Self::unchecked(&Self::LEAST) } else { Self::unchecked(&Self::USUAL) }
    }

    /// Sets that have a name in `docs/windows.md`, smallest first, and the plain form.
    pub fn named() -> [Self; 6] {
        ["1 4@2 16@4", "1 4@2 12@4 40@8", "1 4@2 8@4 16@8 32@16", "1 4@2 12@4 24@8 64@16", "1 4 16", "1 3 9 27"]
            .map(|text| text.parse().expect("a legal set"))
    }

    /// The set of these sizes.
    ///
    /// # Errors
    /// What is wrong with it, to follow the set's name.
    pub fn new(sizes: &[Window]) -> Result<Self, String> {
        match problem(sizes) {
            Some(problem) => Err(problem),
            None => Ok(Self::unchecked(sizes)),
        }
    }

    fn unchecked(sizes: &[Window]) -> Self {
        let mut all = [Window::TEXEL; Self::MOST];
        all[..sizes.len()].copy_from_slice(sizes);
        Self { count: sizes.len(), sizes: all }
    }

    /// The sizes, finest first.
    pub fn sizes(&self) -> &[Window] {
        &self.sizes[..self.count]
    }

    /// What is wrong with the set on a map with 2^`levels` texels a side, to follow the set's name.
    pub fn misfit(&self, levels: u32) -> Option<String> {
        let side = 1u32 << levels;
        let coarse = self.sizes().iter().find(|w| w.grid > side)?;
        Some(format!(
            "has {coarse}, whose grid is larger than the map: with traverse.levels = {levels} g may be at most {side}"
        ))
    }

    /// Words of all maps together, on 2^`levels` texels a side.
    pub fn memory_words(&self, levels: u32) -> u64 {
        self.sizes().iter().map(|w| 1u64 << (2 * levels.saturating_sub(w.grid_bits()))).sum()
    }
}

/// What is wrong with a set, whatever the map; to follow the set's name.
fn problem(sizes: &[Window]) -> Option<String> {
    if !(2..=WindowSet::MOST).contains(&sizes.len()) {
        let s = if sizes.len() == 1 { "" } else { "s" };
        return Some(format!("has {} window{s}: 2 to {} are legal", sizes.len(), WindowSet::MOST));
    }
    if sizes[0] != Window::TEXEL {
        return Some(format!("begins with {}: the first window is the texel itself, 1", sizes[0]));
    }
    let alone = |w: &Window| {
        let Window { side, grid } = *w;
        if !grid.is_power_of_two() {
            Some(format!("has {w}, whose grid is not a power of two: 1, 2, 4, 8 and 16 are legal"))
        } else if grid > WindowSet::COARSEST {
            Some(format!("has {w}, whose grid is too coarse: 1, 2, 4, 8 and 16 are legal"))
        } else if side % grid != 0 {
            Some(format!(
                "has {w}, whose side is not a multiple of its grid: {}@{grid} is legal",
                side.next_multiple_of(grid)
            ))
        } else if w.ahead() > WindowSet::FARTHEST {
            Some(format!("has {w}, which is too large: S - g = {} may be at most {}", w.ahead(), WindowSet::FARTHEST))
        } else {
            None
        }
    };
    if let Some(problem) = sizes.iter().find_map(alone) {
        return Some(problem);
    }
    if sizes == WindowSet::LEAST {
        return None;
    }
    sizes.windows(2).find_map(|pair| {
        let (a, b) = (pair[0], pair[1]);
        if b.ahead() <= a.ahead() {
            let (from, to) = (a.ahead(), b.ahead());
            Some(format!(
                "has {b} after {a}: S - g must rise from window to window, and goes from {from} to {to} (1 2@2 alone is legal besides)"
            ))
        } else if b.grid < a.grid {
            Some(format!("has {b} after {a}: the grid must not become finer, so g may be {} or more here", a.grid))
        } else {
            None
        }
    })
}

impl FromStr for WindowSet {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let sizes = text.split_whitespace().map(str::parse).collect::<Result<Vec<Window>, _>>()?;
        Self::new(&sizes)
    }
}

impl fmt::Display for WindowSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sizes: Vec<String> = self.sizes().iter().map(Window::to_string).collect();
        f.write_str(&sizes.join(" "))
    }
}

impl fmt::Debug for WindowSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "WindowSet({self})")
    }
}

impl TryFrom<String> for WindowSet {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        text.parse().map_err(|problem| format!("windows.set = {text:?} {problem}"))
    }
}

impl From<WindowSet> for String {
    fn from(set: WindowSet) -> Self {
        set.to_string()
    }
}

impl schemars::JsonSchema for WindowSet {
    fn schema_name() -> Cow<'static, str> {
        "WindowSet".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({"type": "string", "pattern": "^\\s*1(@1)?(\\s+[0-9]+(@[0-9]+)?){1,4}\\s*$"})
    }
}
