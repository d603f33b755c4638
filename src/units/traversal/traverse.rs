//! `traverse`: the looping pipeline (PIDM-HW section 4.2, figure 7).
//!
//! A ray is set up once, then recirculates: one node per iteration, one iteration per clock. A slot that is free, or
//! whose ray retires in this clock, accepts the next ray. A finished ray recirculates unchanged until it can retire, so
//! held-pressure neither stalls the other rays nor loses any. The number of stages follows from the latencies.
use super::bilinear::{bilinear_hit, latency as bilinear_clocks};
use super::credit_fifo::SLOTS;
use super::datapath::Datapath;
use super::elastic_boundary::{Decoupling, ElasticBoundary};
use super::height_memory::MEM_INIT;
use super::loop_state::{Ray, Sizes, fields};
use super::stream_delay::{stream_delay, valid_delay, word_delay};
use crate::config::Design;
use crate::ir::{Binding, Builder, Module, Sig};
use crate::units::delay_line::in_lines;
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

/// Builds `traverse`.
pub fn traverse(d: &Design) -> Traverse {
    let t = in_registers(d);
    let module = in_lines(vec![t.module], d.latency.delay_line).pop().expect("one came in");
    Traverse { module, ..t }
}

fn in_registers(d: &Design) -> Traverse {
    let b = Builder::new(NAME, file!(), "traces rays against a height field: a looping pipeline, one node a clock");
    b.throughput("one iteration (one node) per clock; a ray takes as many iterations as its path needs");
    b.choice("datapath", d.datapath.kind.word());
    b.choice("levels_down", d.mode.levels_down);
    b.choice("level_up", d.mode.level_up.word());
    let path = Datapath::of(d);
    let s = Sizes::declare(&b, d, path);
    let more =
        if d.mode.bilinear { "; with .0 to .3 after its name, files of every fourth word of level 0" } else { "" };
    b.file_param(
        MEM_INIT,
        &format!("file for $readmemh with the words of the pyramid, level 0 first{more}; \"\": none"),
    );
    b.clock();
    b.reset();
    let load = Load {
        en: b.input_static("load_en", 1, "bit", "write a word of the pyramid (while idle is 1)"),
        addr: b.input_static("load_addr", s.levels.clone() * 2 + 1, "words", "where: level 0 first, the root last"),
        data: b.input_static("load_data", &s.height, "height codes", "largest height in that node"),
    };
    // The reader of a port list has to see a combinational path through the unit.
    let ready_doc = match Decoupling::of(d.latency.handshake) {
        Decoupling::Combinational => "input ready (transfer when valid && ready); depends combinationally on out_ready",
        Decoupling::SpillRegister | Decoupling::CreditFifo => "input ready (transfer when valid && ready); registered",
    };
    let in_valid = b.input("in_valid", 1, "bit", "input valid");
    let o_in_ready = b.output("in_ready", 1, "bit", ready_doc);
    let in_tag = b.input("in_tag", &s.tag, "bits", "identifies the ray: out_tag of its result");
    let (entry, travel) = (&s.numbers.entry, &s.numbers.travel);
    let u = b.input("in_u", &entry.0, entry.1, "entry point at the top plane, 0 <= u < 1");
    let v = b.input("in_v", &entry.0, entry.1, "entry point at the top plane, 0 <= v < 1");
    let du = b.input("in_du", &travel.0, travel.1, "u travelled while the height falls from 1 to 0");
    let dv = b.input("in_dv", &travel.0, travel.1, "v travelled while the height falls from 1 to 0");
    let lod = d.mode.lod.then(|| b.input("in_lod", &s.level_w, "levels", "the finest level at which the ray may end"));
    let o_valid = b.output("out_valid", 1, "bit", "output valid");
    let out_ready = b.input_static("out_ready", 1, "bit", "output ready (transfer when valid && ready)");
    let o = Outputs::declare(&b, &s);
    let o_refined = d.mode.bilinear.then(|| Refined::declare(&b, &s));
    let o_busy = b.output("slot_busy", 1, "bit", "the slot in stage 0 holds a ray; its mean is the loop's utilization");
    let o_idle = b.output("idle", 1, "bit", "no ray in flight: none in setup, in the loop or waiting at the output");

    // Loop state, read in stage 0 and written by the last stage.
    let module = (path.setup)(d);
    let fields = fields(&s, d, path, &module);
    let held = Ray::registers(&b, &fields);
    let (clocks_setup, clocks_hit) = ((path.setup_clocks)(d), (path.hit_clocks)(d));
    let finish = if d.mode.bilinear { bilinear_clocks(&d.latency) } else { clocks_hit };

    b.section(
        "retire",
        "A finished ray retires when the output pipeline is ready; until then it recirculates unchanged.",
    );
    let decoupling = Decoupling::of(d.latency.handshake);
    let (elastic, credits) = (decoupling != Decoupling::Combinational, decoupling == Decoupling::CreditFifo);
    let hit_valid = b.wire("hit_valid", 1).doc("a result is at the output");
    // Clock enable of the output pipeline: a slot of its spill register is free, or its result transfers.
    let hit_ready = if elastic {
        b.wire("hit_ready", 1).doc("the output pipeline moves")
    } else {
        (!hit_valid | out_ready).unstaged().named("hit_ce")
    };
    // The pipeline before a credit FIFO has no clock enable.
    let hit_ce = if credits { b.lit(1, 1) } else { hit_ready };
    // A registered decision is made one clock earlier: if both slots of the spill register are empty now, the output pipeline is ready then.
    let registered = Decoupling::retire_is_registered(d.latency.handshake)
        .then(|| b.loop_decision("retire", true, true).doc("the ray of stage 0 retires"));
    let retire = registered.unwrap_or_else(|| (held.valid & held.get("done") & hit_ready).named("retire"));
    let slot_free = (!held.valid | retire).named("slot_free");

    b.section(
        "setup",
        "The setup pipeline stalls while its last stage holds a ray and the slot in stage 0 is not free.",
    );
    let setup_valid = b.wire("setup_valid", 1).doc("a new ray waits for a free slot");
    let setup_ready = if elastic {
        b.wire("setup_ready", 1).doc("the setup pipeline moves")
    } else {
        (!setup_valid | slot_free).unstaged().named("setup_ce")
    };
    let setup_ce = if credits { b.lit(1, 1) } else { setup_ready };
    let issue = if credits { (in_valid & setup_ready).named("issue") } else { in_valid };
    let mut ins = vec![("u", u), ("v", v), ("du", du), ("dv", dv), ("ce", setup_ce)];
    ins.extend(lod.map(|lod| ("lod", lod)));
    let outs = b.inst(&module, "u_setup", &[], &ins);
    let names: Vec<&str> = module.data_outputs().map(|(_, p)| p.name.as_str()).collect();
    let outs: Vec<Sig<'_>> = outs
        .into_iter()
        .zip(&names)
        .map(|(x, n)| x.rebase_stage(0).named(&format!("{}_{n}", if elastic { "set" } else { "new" })))
        .collect();
    let track = stream_delay("setup_delay", clocks_setup, d.traverse.tag_bits);
    let ins = [("in_valid", issue), ("in_data", in_tag), ("ce", setup_ce)];
    let o_track = b.inst(&track, "u_setup_delay", &[("W", s.tag.clone())], &ins);
    let (mut is_set, mut new_tag, mut outs) = (o_track[0].rebase_stage(0), o_track[1].rebase_stage(0), outs);
    if elastic {
        let words: Vec<Sig<'_>> = outs.iter().copied().chain([new_tag.named("set_tag")]).collect();
        let valid = is_set.named("is_set");
        let issue = credits.then_some(issue);
        let boundary = ElasticBoundary { name: "setup", valid, ready: setup_ready, out_ready: slot_free, issue };
        let new: Vec<String> = names.iter().map(|n| format!("new_{n}")).chain(["new_tag".into()]).collect();
        (is_set, outs) = boundary.pass(&b, &words, &new);
        new_tag = outs.pop().expect("the tag was put in last");
    }
    let setup = |name: &str| {
        let at = names.iter().position(|n| *n == name);
        outs[at.unwrap_or_else(|| panic!("{} has no output {name}", module.name))]
    };
    b.connect(setup_valid, is_set);
    let new_tag = new_tag.named("new_tag");
    b.drive(o_in_ready, setup_ready, None);
    let accept = (setup_valid & slot_free).named("accept");

    b.section("slot", "Stage 0 holds the new ray, or the one that recirculates.");
    let new = Ray::fresh(&b, &fields, setup, new_tag);
    let slot_busy = ((held.valid & !retire) | accept).named("slot_busy");
    b.drive(o_busy, slot_busy, None);
    let ray = if d.latency.node > 1 {
        // The select is registered before the multiplexer: it fans out to every bit of a ray.
        held.reg_words().or_new(&fields, accept.reg(), &new.reg_words(), slot_busy.valid().reg())
    } else {
        held.or_new(&fields, accept, &new, slot_busy)
    };

    let next = (path.iteration)(&b, &s, d, &ray, &load);
    let mut loops = held.pairs(&next);
    // A credit FIFO counts the ray that retires now one clock late.
    let retiring = registered.map(|r| {
        let hit_free = if credits {
            let now = b.wire("retire_now", 1).doc("the ray of stage 0 retires");
            b.connect(now, r);
            hit_ready & !now
        } else {
            hit_ready & !hit_valid
        };
        (r, (next.valid & next.get("done").named("is_done") & hit_free).named("retire_next"))
    });
    loops.extend(retiring);
    let slots = b.close(&loops);
    // Rays in flight, at most: all pipeline stages and both FIFOs are full.
    let most = clocks_setup + slots + finish + 2 * SLOTS;
    b.drive(
        o_idle,
        idle(&b, (in_valid & setup_ready).named("in_transfer"), (hit_valid & out_ready).named("out_transfer"), most),
        None,
    );
    // Delayed, the decision would see another hit_ready than it was made with.
    assert!(retiring.is_none_or(|(_, v)| v.stage() == Some(slots - 1)), "retire is decided in the last slot");

    b.section("result", "The ray that retires, from the loop registers.");
    let hit = (path.hit)(d);
    let (mut fractions, mut texels) = (Vec::new(), Vec::new());
    for (name, axis) in [("u", "x"), ("v", "y")] {
        let mut ins = (path.hit_inputs)(&held, axis);
        ins.push(("ce", hit_ce));
        let o = b.inst(&hit, &format!("u_hit_{name}"), &[("IDX_W", s.idx.clone())], &ins);
        let mut fraction = o[0].unstaged();
        if finish > clocks_hit {
            let delay = word_delay("fraction_delay", finish - clocks_hit, 1);
            let ins = [("in_data", fraction.named(&format!("block_f{name}"))), ("ce", hit_ce)];
            fraction = b.inst(&delay, &format!("u_hit_f{name}"), &[("W", s.frac.clone())], &ins)[0].unstaged();
        }
        fractions.push(fraction.named(&format!("hit_f{name}")));
        texels.extend(o.get(1).map(|x| x.unstaged().named(&format!("hit_{}", if axis == "x" { "i" } else { "j" }))));
    }
    let (i, j) = match texels[..] {
        // In a node of a coarser level, the hit position says which texel it is.
        [i, j] => (i, j),
        _ => (held.get("x").slice(0, &s.levels), held.get("y").slice(0, &s.levels)),
    };
    let word = |name: &str| held.get(name);
    let parts =
        [word("tag"), i, j, word("t"), word("wall"), word("limit"), word("steps"), word("crossings"), word("ups")];
    let mut outs = Vec::new();
    for (part, name) in parts.iter().zip(Outputs::CARRIED) {
        if d.mode.lod && (name == "i" || name == "j") {
            outs.push(*part);
            continue;
        }
        let delay = word_delay("hit_delay", finish, 1);
        let ins = [("in_data", *part), ("ce", hit_ce)];
        let r = b.inst(&delay, &format!("u_hit_{name}"), &[("W", part.width())], &ins);
        outs.push(r[0].unstaged().named(&format!("hit_{name}")));
    }
    let delay = valid_delay("hit_valid_delay", finish);
    let r = b.inst(&delay, "u_hit_valid", &[], &[("in_valid", retire), ("ce", hit_ce)]);
    let found = r[0].unstaged();
    let refined = o_refined.is_some().then(|| refine(&b, d, &s, &held, &load, hit_ce));
    if elastic {
        b.section("output", "Results wait here until they transfer.");
        let more = refined.into_iter().flatten();
        let words: Vec<Sig<'_>> = outs.iter().chain(&fractions).copied().chain(more).collect();
        let names: Vec<String> = RESULT.iter().take(words.len()).map(|n| format!("result_{n}")).collect();
        let (valid, issue) = (found.named("hit_found"), credits.then_some(retire));
        let boundary = ElasticBoundary { name: "hit", valid, ready: hit_ready, out_ready, issue };
        let (valid, mut all) = boundary.pass(&b, &words, &names);
        b.connect(hit_valid, valid.unstaged());
        outs = all.drain(..outs.len()).collect();
        fractions = all.drain(..fractions.len()).collect();
        if let Some(o) = o_refined {
            let found: [Sig<'_>; 6] = all.try_into().unwrap_or_else(|_| panic!("a refined hit has six words"));
            o.drive(&b, &found, [outs[1], outs[2], fractions[0], fractions[1], outs[3]], outs[5]);
        }
    } else {
        b.connect(hit_valid, found);
        if let Some((o, found)) = o_refined.zip(refined) {
            o.drive(&b, &found, [outs[1], outs[2], fractions[0], fractions[1], outs[3]], outs[5]);
        }
    }
    b.drive(o_valid, hit_valid, None);
    o.drive(&b, &outs, &fractions);
    let at = |l: i64, h: i64| Binding::from([("LEVELS".into(), l), ("HEIGHT_W".into(), h)]);
    let module = b.finish(None, &[at(2, 8), at(3, 16), at(12, 8), at(12, 16)]);
    Traverse { module, slots, setup: clocks_setup, finish }
}

/// Whether no ray is in flight, where at most `most` are: transfers are counted one clock late, which keeps the adder off the handshake path.
fn idle<'b>(b: &'b Builder, in_transfer: Sig<'b>, out_transfer: Sig<'b>, most: u32) -> Sig<'b> {
    b.section("idle", "Rays in flight: input transfers less output transfers, counted one clock late.");
    let width = u32::BITS - most.leading_zeros();
    let entered = b.loop_reg("in_transfer_q", 1, true).doc("a ray entered in the clock before");
    let left = b.loop_reg("out_transfer_q", 1, true).doc("a result left in the clock before");
    let inside = b.loop_reg("in_flight", width, true).doc("rays in flight, up to the clock before that [rays]");
    let any = b.loop_reg("any_in_flight", 1, true).doc("in_flight is not 0");
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

/// The refinement beside the hit position: code of the patch, texel, fractions, parameter.
fn refine<'b>(b: &'b Builder, d: &Design, s: &Sizes, held: &Ray<'b>, load: &Load<'b>, ce: Sig<'b>) -> [Sig<'b>; 6] {
    b.section("refine", "Bilinear refinement: moves the hit to the surface interpolated between texel centres.");
    let mut ins = vec![("load_en", load.en), ("load_addr", load.addr), ("load_data", load.data), ("ce", ce)];
    ins.extend(["p_x", "d_x", "r_x", "p_y", "d_y", "r_y", "t"].map(|n| (n, held.get(n))));
    let o = b.inst(&bilinear_hit(d), "u_bilinear", &[("IDX_W", s.idx.clone())], &ins);
    let named = |k: usize, name: &str| o[k].unstaged().named(name);
    [
        named(0, "found_patch"),
        named(2, "found_i"),
        named(3, "found_j"),
        named(4, "found_fu"),
        named(5, "found_fv"),
        named(1, "found_t"),
    ]
}

/// Words of a result at the output boundary: those carried along, the fractions, and the six of a refined hit.
const RESULT: [&str; 17] = [
    "tag",
    "i",
    "j",
    "t",
    "wall",
    "limit",
    "steps",
    "crossings",
    "ups",
    "fu",
    "fv",
    "patch",
    "bi",
    "bj",
    "bfu",
    "bfv",
    "bt",
];

/// The load port of the pyramid.
pub struct Load<'b> {
    /// Write enable.
    pub en: Sig<'b>,
    /// Address, in words.
    pub addr: Sig<'b>,
    /// Height code.
    pub data: Sig<'b>,
}

/// Output ports of a result.
struct Outputs {
    carried: [usize; 9],
    fractions: [usize; 2],
}

impl Outputs {
    const CARRIED: [&'static str; 9] = ["tag", "i", "j", "t", "wall", "limit", "steps", "crossings", "ups"];

    fn declare(b: &Builder, s: &Sizes) -> Self {
        let tag = b.output("out_tag", &s.tag, "bits", "tag of the ray");
        let i = b.output("out_i", &s.levels, "texels", "hit texel, column (u)");
        let j = b.output("out_j", &s.levels, "texels", "hit texel, row (v)");
        let fu = b.output("out_fu", &s.frac, "1/2^FRAC_W texel", "position in the texel along u");
        let fv = b.output("out_fv", &s.frac, "1/2^FRAC_W texel", "position in the texel along v");
        let t = b.output("out_t", &s.numbers.time.0, s.numbers.time.1, "ray parameter: 0 at the top plane");
        let wall = b.output("out_wall", 1, "bit", "the hit is on the side of a texel");
        let limit = b.output("out_limit", 1, "bit", "given up: STEP_LIMIT reached, or not a ray (steps 0)");
        let steps = b.output("out_steps", 16, "iterations", "nodes visited");
        let crossings = b.output("out_crossings", 16, "iterations", "of these, node crossings");
        let ups = b.output("out_ups", 16, "levels", "levels gone up");
        Self { carried: [tag, i, j, t, wall, limit, steps, crossings, ups], fractions: [fu, fv] }
    }

    fn drive(&self, b: &Builder, carried: &[Sig<'_>], fractions: &[Sig<'_>]) {
        self.carried.iter().zip(carried).for_each(|(p, v)| b.drive(*p, *v, None));
        self.fractions.iter().zip(fractions).for_each(|(p, v)| b.drive(*p, *v, None));
    }
}

/// Output ports of a refined hit.
struct Refined {
    patch: usize,
    /// Texel, fractions, parameter.
    words: [usize; 5],
}

impl Refined {
    fn declare(b: &Builder, s: &Sizes) -> Self {
        b.require(&s.height + s.frac.clone() * 2 + &s.numbers.float.as_ref().expect("the watertight datapath").man, 60);
        let code = "surface between texel centres: 0 given up, 1 hit; not met: 2 above it, 3 below it";
        let patch = b.output("out_patch", 2, "code", code);
        let i = b.output("out_bi", &s.levels, "texels", "texel of the refined hit, column (u); not met: of the hit");
        let j = b.output("out_bj", &s.levels, "texels", "texel of the refined hit, row (v); not met: of the hit");
        let fu = b.output("out_bfu", &s.frac, "1/2^FRAC_W texel", "position of the refined hit in its texel along u");
        let fv = b.output("out_bfv", &s.frac, "1/2^FRAC_W texel", "position of the refined hit in its texel along v");
        let t = b.output("out_bt", &s.numbers.time.0, s.numbers.time.1, "ray parameter of the refined hit");
        Self { patch, words: [i, j, fu, fv, t] }
    }

    /// `found` as of [`refine`]; `block` are the hit's words where it finds nothing, and `limit` says that there is no hit.
    fn drive<'b>(&self, b: &'b Builder, found: &[Sig<'b>; 6], block: [Sig<'b>; 5], limit: Sig<'b>) {
        let ends = (!limit).named("has_hit");
        let patch = (found[0] & ends.rep(2)).named("patch");
        let is_met = (patch.bit(0) & !patch.bit(1)).named("is_met");
        b.drive(self.patch, patch, None);
        for ((port, new), old) in self.words.iter().zip(&found[1..]).zip(block) {
            b.drive(*port, is_met.mux(*new, old), None);
        }
    }
}
