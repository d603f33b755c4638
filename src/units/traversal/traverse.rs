//! `traverse`: the looping pipeline (PIDM-HW section 4.2, figure 7).
//!
//! A ray is set up once, then recirculates: one node per iteration, one iteration per clock. A slot that is free, or
//! whose ray retires in this clock, accepts the next ray. A finished ray recirculates unchanged until it can retire, so
//! held-pressure neither stalls the other rays nor loses any. The number of stages follows from the latencies.
use super::bilinear::bilinear_hit;
use super::datapath::Datapath;
use super::height_memory::MEM_INIT;
use super::height_source::{HeightSource, Place, Slot};
use super::loop_state::{Field, Ray, Sizes};
use super::on_chip::OnChip;
use super::result::{Result, result_fields};
use super::search::Search;
use super::slot_memory::SlotMemory;
use crate::delay_line::in_lines;
use crate::quantity::{BIT, BITS, LEVELS};
use crate::stream::{Decoupling, InputStream, OutputStream, Pipeline, SLOTS};
use reliefrtl_config::{Design, Register, Trim};
use reliefrtl_ir::{Binding, Builder, Expr, Module, Record, Sig};
use std::sync::Arc;

/// Name of the module.
pub const NAME: &str = "traverse";

/// The traverse unit and what its schedule came out at.
pub struct Traverse {
    /// The top module.
    pub module: Arc<Module>,
    /// Slots of the loop: stages that an iteration passes.
    pub slots: u32,
    /// Clocks from a ray's acceptance to the loop.
    pub setup: u32,
    /// Clocks from the loop to the output.
    pub finish: u32,
}

/// Builds `traverse`, with the pyramid on chip.
pub fn traverse(d: &Design) -> Traverse {
    traverse_from(d, &OnChip)
}

/// Builds `traverse` with another source of heights.
///
/// # Panics
/// If the source may miss and the design trims: the node that a trim reads is not known at the end of the loop.
pub fn traverse_from(d: &Design, source: &dyn HeightSource) -> Traverse {
    assert!(!source.misses() || d.mode.trim == Trim::None, "a height source that misses has no chord trim");
    let mut t = in_registers(d, source, SLOTS);
    if Datapath::of(d).search.leaving.is_some() {
        // Slot memories have a word each slot, and the schedule says how many there are.
        t = in_registers(d, source, t.slots);
    }
    let module = in_lines(vec![t.module], d.latency.delay_line).pop().expect("one came in");
    Traverse { module, ..t }
}

/// `slots` is how many the loop is expected to have; where no memory is addressed by them, any number will do.
fn in_registers(d: &Design, source: &dyn HeightSource, slots: u32) -> Traverse {
    let path = Datapath::of(d);
    let search = path.search;
    let b = Builder::new(NAME, file!(), search.summary);
    describe(&b, d, search);
    let s = path.sizes(&b, d);
    b.file_param(MEM_INIT, &(search.image)(d));
    b.clock();
    b.reset();
    let loads = (search.loads)(&b, &s, d);
    let rays = ray_ports(&b, &s, d);
    let results = OutputStream::declare(&b, "out", &result_fields(&b, &s, d));
    let o_busy = b.output("slot_busy", 1, BIT, "the slot in stage 0 holds a ray; its mean is the loop's utilization");
    let o_idle = b.output(
        "idle",
        1,
        BIT,
        "no ray in flight; falls one clock after an input transfer, rises two after the last output transfer",
    );

    // Loop state, read in stage 0 and written by the last stage.
    let module = (path.setup)(d);
    let fields = path.fields(&s, d, (source, &loads), &module);
    let mut heights = source.open(Place { b: &b, s: &s, d, loads: &loads });
    let held = Ray::registers(&b, &fields);
    let clocks_setup = clocks(&module);
    let finish = if d.mode.bilinear { clocks(&bilinear_hit(d)) } else { clocks(&(path.hit)(d)) };

    b.section("retire", "A finished ray retires when the hit pipeline is ready; until then it recirculates unchanged.");
    let decoupling = Decoupling::of(d.latency.handshake);
    let hit = Pipeline::declare(&b, "hit", decoupling, results.ready);
    // A registered decision is made one clock earlier: if both slots of the spill register are empty now, the output pipeline is ready then.
    let registered = Decoupling::retire_is_registered(d.latency.handshake)
        .then(|| b.loop_decision("retire", true, true).doc("the ray of stage 0 retires"));
    let retire = registered.unwrap_or_else(|| (held.valid & held.get("done") & hit.ready).named("retire"));
    // What a source that parks rays takes out of a slot, and puts into another, are their constants, too.
    let memories_hold = search.leaving.is_some();
    let moves = (memories_hold && source.places() > 0).then(|| Moved::declare(&b, &s, &module));
    let memories = moves
        .as_ref()
        .map(|m| SlotMemory::new(&b, slots, m.enters.rebase_stage(0), m.words.map(|_, v| v.rebase_stage(0))));
    let kept = memories.as_ref().map(|m| m.read_for_result("held", m.new_words())).unwrap_or_default();
    let exchange = heights.exchange(&Slot { held: &held, retire, kept });
    let gives_up = exchange.as_ref().map_or(retire, |e| (retire | e.parks).named("gives_up_slot"));
    let slot_free = (!held.valid | gives_up).named("slot_free");
    // A parked ray takes the slot before a new one.
    let returns = exchange.as_ref().map(|e| (slot_free & e.returns).named("returns"));
    let slot_ready = returns.map_or(slot_free, |returns| (slot_free & !returns).named("slot_ready"));

    let (setup, new) = set_up(&b, d, &module, &rays, slot_ready);
    rays.ready(&b, setup.ready);
    let accept = (setup.valid & slot_ready).named("accept");

    b.section("slot", choice(d, memories_hold));
    let memories = memories.or_else(|| memories_hold.then(|| SlotMemory::new(&b, slots, accept, new.clone())));
    let words = new;
    let new = Ray::fresh(&b, &fields, |name| words[name], words["tag"]);
    let new = heights
        .first(new, accept, &|ray| (search.addresses)(&b, &s, d, "first", ray, &(search.address_words)(&s, &words)));
    let (enters, entering) = match exchange.as_ref().zip(returns) {
        Some((e, returns)) => ((accept | returns).named("enters"), new.or_else(returns, &e.ray)),
        None => (accept, new),
    };
    if let Some(((moved, e), returns)) = moves.zip(exchange.as_ref()).zip(returns) {
        moved.connect(&b, enters, &words, returns, &e.kept);
    }
    let slot_busy = ((held.valid & !gives_up) | enters).named("slot_busy");
    b.drive(o_busy, slot_busy);
    let entry = Entry { enters, ray: &entering, slot_busy };
    let ray = in_slot(d, &fields, &held, &entry, memories.is_some());

    let next = (path.iteration)(&b, &s, d, &ray, heights.as_mut(), memories.as_ref());
    let next = heights.look_up(next, &|ray| {
        let words = memories.as_ref().map(|m| (m, (search.address_words)(&s, m.new_words())));
        let words = words.map(|(m, words)| m.read("next_origin", &words, ray.last_stage()));
        (search.addresses)(&b, &s, d, "next", ray, &words.unwrap_or_default())
    });
    drop(heights);
    let mut loops = held.pairs(&next);
    let retiring = registered.map(|r| (r, retires_next(&b, r, &next, &hit, decoupling)));
    loops.extend(retiring);
    let slots = b.close(&loops);
    // Rays in flight, at most: all pipeline stages, both FIFOs and the places of the height source are full.
    let most = clocks_setup + slots + finish + 2 * SLOTS + source.places();
    b.section("idle", "Rays in flight: input transfers less output transfers, counted one clock late.");
    let in_transfer = (rays.valid & setup.ready).named("in_transfer");
    let out_transfer = (hit.valid & results.ready).named("out_transfer");
    b.drive(o_idle, idle(&b, in_transfer, out_transfer, most));
    // Delayed, the decision would see another hit_ready than it was made with.
    assert!(retiring.is_none_or(|(_, v)| v.stage() == Some(slots - 1)), "retire is decided in the last slot");

    let leaving = search.leaving.zip(memories.as_ref());
    let leaving = leaving.map_or_else(|| held.clone(), |(leaving, memories)| leaving(&b, &s, &held, memories));
    let result = Result { b: &b, d, path, sizes: &s, held: &leaving, loads: &loads, clocks: finish }.pass(&hit, retire);
    results.drive(&b, hit.valid, &result);
    let at = |l: i64, h: i64| Binding::from([("LEVELS".into(), l), ("HEIGHT_W".into(), h)]);
    let module = b.finish_streams(&[at(2, 8), at(3, 16), at(12, 8), at(12, 16)]);
    Traverse { module, slots, setup: clocks_setup, finish }
}

/// What the banner says of a design.
fn describe(b: &Builder, d: &Design, search: &Search) {
    b.throughput(search.throughput);
    b.choice("datapath", d.datapath.kind.word());
    (search.choices)(d).into_iter().for_each(|(name, word)| b.choice(name, word));
    (search.described)(d).into_iter().for_each(|(name, word)| b.describe(&name, word));
    d.counters_left().into_iter().for_each(|word| b.describe("counters", word));
}

/// Sends the rays through `setup`, up to a free slot: the pipeline, and the words of the ray at its end.
fn set_up<'b>(
    b: &'b Builder,
    d: &Design,
    module: &Arc<Module>,
    rays: &InputStream<'b>,
    slot_ready: Sig<'b>,
) -> (Pipeline<'b>, Record<'b>) {
    let decoupling = Decoupling::of(d.latency.handshake);
    b.section("setup", stalls(decoupling));
    let setup = Pipeline::declare(b, "setup", decoupling, slot_ready);
    let credits = decoupling == Decoupling::CreditFifo;
    let issue = if credits { (rays.valid & setup.ready).named("issue") } else { rays.valid };
    let operands = rays.data.iter().filter(|f| f.0 != "tag");
    let ins: Vec<(&str, Sig<'_>)> = operands.chain([("ce", setup.enable(b))]).collect();
    let constants = b.inst(module, "u_setup", &[], &ins).record().map(|_, v| v.rebase_stage(0));
    let words = (constants, [("tag", rays.data["tag"])].into());
    let new = setup.pass(b, clocks(module), issue, words, ["set", "new"]);
    (setup, new)
}

/// Clocks of a setup or a hit pipeline.
fn clocks(m: &Module) -> u32 {
    m.latency().expect("setup and hit are pipelines")
}

/// Declares the ports of a ray.
fn ray_ports<'b>(b: &'b Builder, s: &Sizes, d: &Design) -> InputStream<'b> {
    // The reader of a port list has to see a combinational path through the unit.
    let ready_doc = match Decoupling::of(d.latency.handshake) {
        Decoupling::Combinational => "input ready (transfer when valid && ready); depends combinationally on out_ready",
        Decoupling::SpillRegister | Decoupling::CreditFifo => "input ready (transfer when valid && ready); registered",
    };
    let (entry, travel) = (&s.numbers.entry, &s.numbers.travel);
    let mut ray = vec![
        ("tag", s.tag.clone(), BITS, "identifies the ray: out_tag of its result"),
        ("u", entry.0.clone(), entry.1, "entry point at the top plane, 0 <= u < 1"),
        ("v", entry.0.clone(), entry.1, "entry point at the top plane, 0 <= v < 1"),
        ("du", travel.0.clone(), travel.1, "u travelled while the height falls from 1 to 0"),
        ("dv", travel.0.clone(), travel.1, "v travelled while the height falls from 1 to 0"),
    ];
    ray.extend(d.mode.lod.then(|| ("lod", s.level_w.clone(), LEVELS, "the finest level at which the ray may end")));
    InputStream::declare(b, "in", ready_doc, &ray)
}

/// What comes into the slot of stage 0.
struct Entry<'a, 'b> {
    /// A ray enters (1 bit).
    enters: Sig<'b>,
    /// That ray.
    ray: &'a Ray<'b>,
    /// The slot holds a ray then (1 bit).
    slot_busy: Sig<'b>,
}

/// What enters the slot memories, where a ray that was parked brings its constants back. Known before the source's answer is: the memories that are
/// read for it stand before it.
struct Moved<'b> {
    enters: Sig<'b>,
    words: Record<'b>,
}

impl<'b> Moved<'b> {
    /// Declares the outputs of `setup`, and the tag.
    fn declare(b: &'b Builder, s: &Sizes, setup: &Module) -> Self {
        let outputs = setup.data_outputs().map(|(_, p)| (p.name.clone(), p.width.expanded()));
        let words = outputs.chain([("tag".to_owned(), s.tag.clone())]);
        let wire = |(name, width): (String, Expr)| (name.clone(), b.wire(&format!("slot_{name}"), width));
        Self { enters: b.wire("slot_is_written", 1), words: words.map(wire).collect() }
    }

    /// Drives them: the words of a new ray, or of one that `returns`.
    fn connect(&self, b: &'b Builder, enters: Sig<'b>, new: &Record<'b>, returns: Sig<'b>, kept: &Record<'b>) {
        b.connect(self.enters, enters);
        self.words.iter().for_each(|(name, wire)| b.connect(wire, returns.mux(kept[name], new[name])));
    }
}

/// When the setup pipeline stalls.
fn stalls(decoupling: Decoupling) -> &'static str {
    match decoupling {
        Decoupling::Combinational => {
            "The pipeline stalls while its last stage holds a ray and the slot in stage 0 is not free."
        }
        Decoupling::SpillRegister => {
            "The pipeline stalls, as a whole, while both words of the buffer after it are taken."
        }
        Decoupling::CreditFifo => "The pipeline never stalls: a ray is issued against a slot of the FIFO after it.",
    }
}

/// How the ray of a slot is chosen.
fn choice(d: &Design, in_memories: bool) -> &'static str {
    if registers_first(d, in_memories) {
        "A slot holds the new ray, or the one that recirculates. Both are registered before the choice: its select reaches every bit of a ray."
    } else {
        "A slot holds the new ray, or the one that recirculates."
    }
}

/// Whether both rays, and the select, are registered before one of them is chosen. Where slot memories hold the constants, a new ray starts from
/// zeros, and there is little to select.
fn registers_first(d: &Design, in_memories: bool) -> bool {
    d.latency.has(Register::SlotRays) && !in_memories
}

/// The ray that the slot of stage 0 holds: the one that enters, or else the one that recirculates.
fn in_slot<'b>(d: &Design, fields: &[Field], held: &Ray<'b>, entry: &Entry<'_, 'b>, in_memories: bool) -> Ray<'b> {
    let Entry { enters, ray, slot_busy } = *entry;
    if registers_first(d, in_memories) {
        held.reg_words().or_new(fields, enters.reg(), &ray.reg_words(), slot_busy.valid().reg())
    } else {
        held.or_new(fields, enters, ray, slot_busy)
    }
}

/// Whether the ray that comes to stage 0 retires there (1 bit), decided in the last slot; `retire` is that decision a clock later.
fn retires_next<'b>(
    b: &'b Builder,
    retire: Sig<'b>,
    next: &Ray<'b>,
    hit: &Pipeline<'b>,
    decoupling: Decoupling,
) -> Sig<'b> {
    let hit_free = if decoupling == Decoupling::CreditFifo {
        // A credit FIFO counts the ray that retires now one clock late.
        let now = b.wire("retire_now", 1).doc("the ray of stage 0 retires");
        b.connect(now, retire);
        hit.ready & !now
    } else {
        hit.ready & !hit.valid
    };
    let is_done = next.get("done").named("is_done").at(next.last_stage());
    (next.valid & is_done & hit_free).named("retire_next")
}

/// Whether no ray is in flight, where at most `most` are: transfers are counted one clock late, which keeps the adder off the handshake path.
fn idle<'b>(b: &'b Builder, in_transfer: Sig<'b>, out_transfer: Sig<'b>, most: u32) -> Sig<'b> {
    let width = u32::BITS - most.leading_zeros();
    let entered = b.loop_reg("in_transfer_q", 1, true).doc("input transfer in the previous clock");
    let left = b.loop_reg("out_transfer_q", 1, true).doc("output transfer in the previous clock");
    let inside = b.loop_reg("in_flight_q", width, true).doc("rays in flight, counted one clock late [rays]");
    let any = b.loop_reg("any_in_flight_q", 1, true).doc("rays are in flight");
    let down = (left & !entered).named("in_flight_down");
    let change = b.cat(&[down.rep(width - 1), entered ^ left]);
    let next = (inside + change).named("in_flight_next");
    b.close(&[
        (entered, in_transfer),
        (left, out_transfer),
        (inside, next),
        (any, next.any().named("any_in_flight_next")),
    ]);
    (!(any | entered)).named("is_idle")
}
