//! The state of a ray in the loop.
use super::cells;
use crate::float::FormatParams;
use crate::quantity::Quantity;
use reliefrtl_config::{Design, LevelUp, Trim};
use reliefrtl_ir::{Builder, Expr, Module, Sig};

/// Parameters of `traverse`.
pub struct Sizes {
    /// Widths of the datapath's numbers.
    pub numbers: Numbers,
    /// LEVELS.
    pub levels: Expr,
    /// Bits of a level number.
    pub level_w: Expr,
    /// HEIGHT_W.
    pub height: Expr,
    /// TILE_W.
    pub tile: Expr,
    /// FRAC_W.
    pub frac: Expr,
    /// TAG_W.
    pub tag: Expr,
    /// STEP_LIMIT.
    pub step_limit: Expr,
    /// Bits of an unwrapped texel coordinate.
    pub idx: Expr,
}

/// What the words at the ports of `traverse` are.
pub struct Numbers {
    /// Width and unit of an entry point, in tiles.
    pub entry: (Expr, Quantity),
    /// Width and unit of a travel, in tiles.
    pub travel: (Expr, Quantity),
    /// Width and unit of the ray parameter.
    pub time: (Expr, Quantity),
    /// The number format, where the numbers are floating-point ones.
    pub float: Option<FormatParams>,
}

impl Sizes {
    /// Declares them, with what they may be; `numbers` says what the datapath's numbers are, of LEVELS, HEIGHT_W and TILE_W.
    pub fn declare(b: &Builder, d: &Design, numbers: impl FnOnce(&Expr, &Expr, &Expr) -> Numbers) -> Self {
        let t = &d.traverse;
        let levels = b.param("LEVELS", t.levels, "the map has 2^LEVELS x 2^LEVELS texels");
        let height = b.param("HEIGHT_W", t.height_bits, "bits of a height code");
        let tile = b.param("TILE_W", t.tile_bits, "a ray travels less than 2^TILE_W tiles along each axis");
        let frac = b.param("FRAC_W", t.frac_bits, "fraction bits of the hit position");
        let tag = b.param("TAG_W", t.tag_bits, "bits of a ray's tag");
        let step_limit = b.param("STEP_LIMIT", t.step_limit, "iterations after which a ray is given up");
        b.require(2, &levels);
        b.require(&levels, 12);
        let numbers = numbers(&levels, &height, &tile);
        b.require(1, &frac);
        b.require(&frac, 16);
        b.require(1, &tag);
        b.require(&tag, 32);
        b.require(1, &step_limit);
        b.require(&step_limit, 65535);
        let level_w = b.local("LevelW", (&levels + 1).clog2(), "bits of a level");
        let idx = b.local("IdxW", &levels + &tile + 2, "bits of a signed, unwrapped texel coordinate");
        if let Some(f) = &numbers.float {
            b.require(&levels + &tile + 2 + &frac + &f.man, 60);
        }
        Self { numbers, levels, level_w, height, tile, frac, tag, step_limit, idx }
    }
}

/// How a word of the loop starts.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Start {
    /// As the output of that name of the datapath's setup says.
    Setup(&'static str),
    /// The ray's tag.
    Tag,
    /// Zero.
    Zero,
    /// One.
    One,
    /// 1 for what is not a ray.
    Refused,
}

/// A word that a ray carries.
pub struct Field {
    /// Its name; `loop_<name>_q` is its register.
    pub name: &'static str,
    /// Its net in the slot.
    pub net: &'static str,
    /// Bits.
    pub width: Expr,
    /// Its value for a new ray.
    pub start: Start,
    /// What it is, with its unit.
    pub doc: String,
}

impl Field {
    /// A field whose net has its name.
    pub fn new(name: &'static str, width: &Expr, start: Start) -> Self {
        Self { name, net: name, width: width.clone(), start, doc: String::new() }
    }

    /// The same, with what it is.
    pub fn doc(self, text: impl Into<String>) -> Self {
        Self { doc: text.into(), ..self }
    }
}

/// The datapath's constants of the ray, which are what the outputs of `setup` say, each with its meaning.
pub fn said_by(setup: &Module, constants: Vec<Field>) -> impl Iterator<Item = Field> {
    constants.into_iter().map(|f| match f.start {
        Start::Setup(port) => {
            let doc = setup.port(port).unwrap_or_else(|| panic!("{} has no {port}", setup.name)).1.meaning();
            f.doc(doc)
        }
        _ => f,
    })
}

/// The tag of a ray.
pub fn tag(s: &Sizes) -> Field {
    Field::new("tag", &s.tag, Start::Tag).doc("tag of the ray [bits]")
}

/// Whether a descent asks if something was crossed.
fn reads_crossed(d: &Design) -> bool {
    if d.fetch.blocks() { cells::reads_crossed(d) } else { d.mode.levels_down > 1 }
}

/// The state that an iteration over nodes, or over blocks of four cells, changes.
pub fn level_state(s: &Sizes, d: &Design) -> Vec<Field> {
    let bit = Expr::from(1);
    let counter = Expr::from(16);
    let blocks = d.fetch.blocks();
    let node = if blocks { "block" } else { "node" };
    let mut list = Vec::from([
        Field::new("level", &s.level_w, Start::Setup("level"))
            .doc(format!("level of {} [levels]", if blocks { "the block's cells" } else { "the node" })),
        Field::new("x", &s.idx, Start::Setup("first_x"))
            .doc(format!("a texel of the {node}, column, unwrapped [texels]")),
        Field::new("y", &s.idx, Start::Setup("first_y")).doc(format!("a texel of the {node}, row, unwrapped [texels]")),
        Field::new("t", &s.numbers.time.0, Start::Zero).doc(format!("ray parameter so far [{}]", s.numbers.time.1)),
        Field::new("done", &bit, Start::Refused).doc("finished: recirculates until it retires"),
        Field::new("wall", &bit, Start::Zero).doc("the hit is on the side of a texel"),
        Field::new("limit", &bit, Start::Refused).doc("given up, or not a ray"),
        Field::new("steps", &counter, Start::Zero).doc("nodes visited [iterations]"),
    ]);
    if d.gives_crossings() {
        list.extend([
            Field::new("crossings", &counter, Start::Zero).doc("iterations that crossed into a neighbour [iterations]"),
            Field::new("ups", &counter, Start::Zero).doc("levels gone up [levels]"),
        ]);
    }
    let finest = Field::new("lod", &s.level_w, Start::Setup("finest"));
    list.extend(d.mode.lod.then(|| finest.doc("finest level at which the ray may end [levels]")));
    // Only several levels down ask for the first, only coherent level-up for the second, only the trim of descents for the third.
    let flags = [
        (reads_crossed(d), "crossed", "has_crossed", "a node boundary was crossed already"),
        (d.mode.level_up == LevelUp::Coherent, "prev", "just_crossed", "the iteration before was a crossing"),
        (d.mode.trim == Trim::Descent, "descended", "just_descended", "the iteration before was a descent"),
    ];
    let flag = |f: &(bool, &'static str, &'static str, &str)| Field {
        net: f.2,
        ..Field::new(f.1, &bit, Start::Zero).doc(f.3)
    };
    list.extend(flags.iter().filter(|f| f.0).map(flag));
    list
}

/// A ray in the loop, word by word.
#[derive(Clone)]
pub struct Ray<'b> {
    /// The slot holds a ray.
    pub valid: Sig<'b>,
    words: Vec<(&'static str, Sig<'b>)>,
}

impl<'b> Ray<'b> {
    /// The loop's registers.
    pub fn registers(b: &'b Builder, fields: &[Field]) -> Self {
        let word = |f: &Field| {
            let name = format!("loop_{}_q", f.name);
            // Retiring depends on data: in a simulation, an unknown value finishes the ray and marks it as given up.
            let word = match f.start {
                Start::Refused => b.loop_decision(&name, false, true),
                _ => b.loop_reg(&name, f.width.clone(), false),
            };
            (f.name, word.doc(&f.doc))
        };
        Ray {
            valid: b.loop_reg("loop_valid_q", 1, true).doc("the slot holds a ray"),
            words: fields.iter().map(word).collect(),
        }
    }

    /// A new ray; `setup` gives the outputs of the datapath's setup by name. Whether the slot is filled is for [`Ray::or_new`] to say.
    pub fn fresh(b: &'b Builder, fields: &[Field], setup: impl Fn(&str) -> Sig<'b>, tag: Sig<'b>) -> Self {
        let refused = (!setup("ok")).named("new_refused");
        let word = |f: &Field| {
            let v = match f.start {
                Start::Setup(port) => setup(port),
                Start::Tag => tag,
                Start::Zero => b.zeros(f.width.clone()),
                Start::One => b.lit(1, f.width.clone()),
                Start::Refused => refused,
            };
            (f.name, v)
        };
        Ray { valid: refused, words: fields.iter().map(word).collect() }
    }

    /// A word by its name, if the design has it.
    pub fn find(&self, name: &str) -> Option<Sig<'b>> {
        self.words.iter().find(|w| w.0 == name).map(|w| w.1)
    }

    /// A word by its name.
    ///
    /// # Panics
    /// If the design has no such word.
    pub fn get(&self, name: &str) -> Sig<'b> {
        self.find(name).unwrap_or_else(|| panic!("a ray carries no {name}"))
    }

    /// Whether a word says whether, or how often, the ray crossed into a neighbour.
    pub fn notes_crossings(&self) -> bool {
        ["crossings", "crossed", "prev", "descended"].iter().any(|name| self.find(name).is_some())
    }

    /// Constants of an axis by the ports that read them: pairs of port and word, without `_x` or `_y`.
    pub fn constants(&self, axis: &str, ports: &[(&'static str, &'static str)]) -> Vec<(&'static str, Sig<'b>)> {
        ports.iter().map(|(port, word)| (*port, self.get(&format!("{word}_{axis}")))).collect()
    }

    /// The same ray with other values in some words; names that the design does not have are passed over.
    pub fn with(&self, changes: &[(&str, Sig<'b>)]) -> Self {
        let new = |w: &(&'static str, Sig<'b>)| changes.iter().find(|c| c.0 == w.0).map_or(w.1, |c| c.1);
        Ray { valid: self.valid, words: self.words.iter().map(|w| (w.0, new(w))).collect() }
    }

    /// `new` where `accept`, else the ray that recirculates; `valid` as given.
    pub fn or_new(&self, fields: &[Field], accept: Sig<'b>, new: &Self, valid: Sig<'b>) -> Self {
        let pick = |f: &Field| (f.name, accept.mux(new.get(f.name), self.get(f.name)).named(f.net));
        Ray { valid: valid.named("valid").valid(), words: fields.iter().map(pick).collect() }
    }

    /// The ray with more words.
    pub fn and(&self, more: Vec<(&'static str, Sig<'b>)>) -> Self {
        Ray { valid: self.valid, words: self.words.iter().copied().chain(more).collect() }
    }

    /// The words with their names.
    pub fn words(&self) -> impl Iterator<Item = (&'static str, Sig<'b>)> {
        self.words.iter().copied()
    }

    /// `other` where `take`, else this one: the ray that enters the slot.
    pub fn or_else(&self, take: Sig<'b>, other: &Self) -> Self {
        let pick =
            |w: &(&'static str, Sig<'b>)| (w.0, take.mux(other.get(w.0), w.1).named(&format!("entering_{}", w.0)));
        Ray { valid: self.valid, words: self.words.iter().map(pick).collect() }
    }

    /// The stage in which the last of the words is known.
    pub fn last_stage(&self) -> u32 {
        self.words.iter().filter_map(|w| w.1.stage()).max().unwrap_or(0)
    }

    /// The same ray, delayed to `stage`; a word that gets its first register there is named after `prefix`.
    pub fn delayed(&self, stage: u32, prefix: &str) -> Self {
        let last = self.last_stage();
        let word = |w: &(&'static str, Sig<'b>)| {
            let is_new = stage > last && w.1.stage() == Some(last);
            let v = if is_new { w.1.named(&format!("{prefix}_{}", w.0)) } else { w.1 };
            (w.0, v.at(stage))
        };
        Ray { valid: self.valid, words: self.words.iter().map(word).collect() }
    }

    /// The same ray, registered.
    pub fn reg(&self) -> Self {
        Ray { valid: self.valid.reg(), words: self.words_reg() }
    }

    /// The same ray with its words registered and its valid bit as it is.
    pub fn reg_words(&self) -> Self {
        Ray { valid: self.valid, words: self.words_reg() }
    }

    fn words_reg(&self) -> Vec<(&'static str, Sig<'b>)> {
        self.words.iter().map(|w| (w.0, w.1.reg())).collect()
    }

    /// Registers and what they take at the end of the loop.
    pub fn pairs(&self, next: &Self) -> Vec<(Sig<'b>, Sig<'b>)> {
        let words = self.words.iter().map(|w| (w.1, next.get(w.0)));
        std::iter::once((self.valid, next.valid)).chain(words).collect()
    }
}
