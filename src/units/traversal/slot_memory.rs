//! Words of a ray that its iterations read and none changes: they stand in memories of look-up tables, a word a slot, and travel through no stage.
//!
//! A group of words is written when its ray enters, and read in the stage that needs it; each group has a memory, as each memory has one read port.
use crate::stream::fifo_mem;
use reliefrtl_ir::{Builder, Expr, Record, Sig};

/// The memories of one loop.
pub struct SlotMemory<'b> {
    b: &'b Builder,
    /// Number of the slot in stage 0.
    slot: Sig<'b>,
    /// A ray enters the slot in stage 0.
    enters: Sig<'b>,
    /// Its words.
    new: Record<'b>,
    slots: u32,
}

impl<'b> SlotMemory<'b> {
    /// Counts the slots; `new` are the words of the ray that `enters` (1 bit) the slot of stage 0.
    pub fn new(b: &'b Builder, slots: u32, enters: Sig<'b>, new: Record<'b>) -> Self {
        b.section("slot number", "Words that no iteration changes stand in memories, by the number of the ray's slot.");
        let width = Expr::from(address_bits(slots));
        let slot = b.loop_reg("slot_q", &width, true).doc("number of the slot in stage 0");
        let is_last = slot.eq(b.lit(u64::from(slots - 1), &width)).named("is_last_slot");
        let next = is_last.mux(b.zeros(&width), slot + b.lit(1, &width)).named("slot_next");
        b.close(&[(slot, next)]);
        Self { b, slot, enters, new, slots }
    }

    /// The words of a new ray.
    pub fn new_words(&self) -> &Record<'b> {
        &self.new
    }

    /// `words` of the new ray, as each stage reads them; known in `stage`, which is 2 or later: what is written in stage 0 is there from stage 1 on.
    ///
    /// # Panics
    /// If `stage` is earlier.
    pub fn read(&self, name: &str, words: &Record<'b>, stage: u32) -> Record<'b> {
        assert!(stage >= 2, "{name}: a slot's words are known from stage 2 on");
        words.unbundle(self.memory(name, words, self.slot.at(stage - 1))).named(name)
    }

    /// The same in stage 1: the words of a ray that enters pass by the memory.
    pub fn read_early(&self, name: &str, words: &Record<'b>) -> Record<'b> {
        let enters = self.enters.reg();
        let held = words.unbundle(self.memory(name, words, self.slot)).named(&format!("{name}_read"));
        let new = words.named(&format!("{name}_new"));
        new.map(|field, v| enters.mux(v.reg(), held[field]).named(&format!("{name}_{field}")))
    }

    /// The words of the ray that comes to stage 0 from the last slot, there.
    pub fn read_for_result(&self, name: &str, words: &Record<'b>) -> Record<'b> {
        words.unbundle(self.memory(name, words, self.slot.at(self.slots - 1)).rebase_stage(0)).named(name)
    }

    fn memory(&self, name: &str, words: &Record<'b>, slot: Sig<'b>) -> Sig<'b> {
        let b = self.b;
        let data = words.bundle(b);
        let params =
            [("ADDR_W", address_bits(self.slots).into()), ("DATA_W", words.width()), ("DEPTH", self.slots.into())];
        let ins = [("write_en", self.enters), ("write_addr", self.slot), ("write_data", data), ("read_addr", slot)];
        let read = b.inst(&fifo_mem(), &format!("u_{name}"), &params, &ins)["read_data"];
        read.named(&format!("{name}_words"))
    }
}

/// Address bits of a memory of that many slots.
fn address_bits(slots: u32) -> u32 {
    (u32::BITS - (slots - 1).leading_zeros()).max(1)
}
