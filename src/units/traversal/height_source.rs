//! Where heights come from: what the loop of `traverse` and a height memory tell each other.
//!
//! The address of a ray's next node is known at the end of the loop; the height is needed in the next iteration. A source looks the address up in
//! between ([`HeightPort::look_up`]). On a hit the next iteration reads the height ([`HeightPort::read`]). On a miss the ray recirculates unchanged and
//! looks up again, or the source parks it outside the loop and gives the slot to a parked ray that is ready, or to a new ray
//! ([`HeightPort::exchange`]). A source that never misses is [`super::OnChip`].
use super::loop_state::{Field, Ray, Sizes};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Expr, Record, Sig};

/// The addresses that the next iteration of a ray reads, one for each memory, from the ray's words: in a stage in which all of these are known.
pub type Addresses<'a, 'b> = &'a dyn Fn(&Ray<'b>) -> Vec<Sig<'b>>;

/// A memory of heights and its load port.
#[derive(Clone)]
pub struct Load<'b> {
    /// Write enable (1 bit).
    pub en: Sig<'b>,
    /// Address, in words.
    pub addr: Sig<'b>,
    /// Height code (HEIGHT_W bits).
    pub data: Sig<'b>,
    /// Words.
    pub words: Expr,
    /// What stands after the name of the file with its first words.
    pub file: &'static str,
}

/// The `traverse` that a source is put into.
#[derive(Clone, Copy)]
pub struct Place<'b> {
    /// The module under construction.
    pub b: &'b Builder,
    /// Its parameters.
    pub s: &'b Sizes,
    /// Its design.
    pub d: &'b Design,
    /// The memories, each with its load port.
    pub loads: &'b [Load<'b>],
}

/// What one read gives.
pub struct Heights<'b> {
    /// The words of the addresses (HEIGHT_W bits each), each in the stage in which it is known: one node's, or that of each window.
    pub words: Vec<Sig<'b>>,
    /// The lookup of this ray missed: the words are not those of the address, and the iteration leaves the ray as it is (1 bit). `None`: never.
    pub missed: Option<Sig<'b>>,
}

impl<'b> Heights<'b> {
    /// The height of an iteration that reads one node.
    ///
    /// # Panics
    /// If the source read more than one.
    pub fn single(&self) -> Sig<'b> {
        let [height] = self.words[..] else { panic!("{} words for an iteration of one node", self.words.len()) };
        height
    }
}

/// The slot in stage 0, as the loop has it before the source's answer.
pub struct Slot<'a, 'b> {
    /// The ray in the loop registers.
    pub held: &'a Ray<'b>,
    /// It retires in this clock (1 bit).
    pub retire: Sig<'b>,
    /// What slot memories hold of that ray; none without them.
    pub kept: Record<'b>,
}

/// What a source that keeps rays outside the loop does with the slot in stage 0.
pub struct Exchange<'b> {
    /// The held ray, whose lookup missed, is parked: the slot is free (1 bit).
    pub parks: Sig<'b>,
    /// A parked ray is ready: it takes the slot if that is free, before any new ray (1 bit).
    pub returns: Sig<'b>,
    /// That ray.
    pub ray: Ray<'b>,
    /// What was kept of it, for the slot memories.
    pub kept: Record<'b>,
}

/// A kind of height memory.
pub trait HeightSource {
    /// Words that a ray carries for the source, from a lookup to the iteration that reads; they come after all others. An address of a memory has the bits of its load port's.
    fn fields(&self, _: &Sizes, _loads: &[Load<'_>]) -> Vec<Field> {
        Vec::new()
    }
    /// Rays that are parked outside the loop, at most.
    fn places(&self) -> u32 {
        0
    }
    /// Whether a lookup can miss. Such a source needs the next address at the end of the loop, where a chord trim does not know it yet.
    fn misses(&self) -> bool;
    /// Puts the source into a `traverse`.
    fn open<'b>(&self, place: Place<'b>) -> Box<dyn HeightPort<'b> + 'b>;
}

/// A source in the loop of one `traverse`. The loop calls each function once, in this order.
pub trait HeightPort<'b> {
    /// The ray that has the slot in stage 0; `None` if a ray always keeps its slot until it retires.
    fn exchange(&mut self, _: &Slot<'_, 'b>) -> Option<Exchange<'b>> {
        None
    }
    /// The first lookup of a new ray, which `accept` (1 bit) puts into the slot of stage 0: the ray with the source's words.
    fn first(&mut self, new: Ray<'b>, _accept: Sig<'b>, _: Addresses<'_, 'b>) -> Ray<'b> {
        new
    }
    /// The words at `addresses`, one for each memory, for the ray in the slot.
    fn read(&mut self, ray: &Ray<'b>, addresses: &[Sig<'b>]) -> Heights<'b>;
    /// The lookup for the next iteration, at the end of the loop: the ray with the source's words. A finished ray looks nothing up.
    fn look_up(&mut self, next: Ray<'b>, _: Addresses<'_, 'b>) -> Ray<'b> {
        next
    }
}
