//! `traverse`: the looping pipeline (PIDM-HW section 4.2, figure 7).
//!
//! A ray is set up once, then goes round the loop, one node an iteration, one iteration a clock. A slot that is free, or
//! whose ray has just left, takes the next ray. A ray that is done goes round unchanged until it can leave, so
//! back-pressure stops neither the others nor loses anything. The number of stages follows from the latencies.
use super::between::Between;
use super::bilinear::{bilinear_hit, latency as bilinear_clocks};
use super::datapath::Datapath;
use super::height_memory::MEM_INIT;
use super::loop_state::{Ray, Sizes, fields};
use super::stream_delay::{stream_delay, valid_delay, word_delay};
use super::stream_queue::PLACES;
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
    // The proof of the handshake follows each ray by its tag.
    b.visible("tag");
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
    let in_valid = b.input("in_valid", 1, "bit", "a ray is offered");
    let o_in_ready = b.output("in_ready", 1, "bit", "it is taken at the next edge");
    let in_tag = b.input("in_tag", &s.tag, "bits", "comes back with the result");
    let (entry, travel) = (&s.numbers.entry, &s.numbers.travel);
    let u = b.input("in_u", &entry.0, entry.1, "entry point at the top plane, 0 <= u < 1");
    let v = b.input("in_v", &entry.0, entry.1, "entry point at the top plane, 0 <= v < 1");
    let du = b.input("in_du", &travel.0, travel.1, "u travelled while the height falls from 1 to 0");
    let dv = b.input("in_dv", &travel.0, travel.1, "v travelled while the height falls from 1 to 0");
    let lod = d.mode.lod.then(|| b.input("in_lod", &s.level_w, "levels", "the finest level at which the ray may end"));
    let o_valid = b.output("out_valid", 1, "bit", "a result is offered");
    let out_ready = b.input_static("out_ready", 1, "bit", "it is taken at the next edge");
    let o = Outputs::declare(&b, &s);
    let o_refined = d.mode.bilinear.then(|| Refined::declare(&b, &s));
    let o_busy = b.output("slot_busy", 1, "bit", "the slot that starts now holds a ray: counts the loop's load");
    let o_idle =
        b.output("idle", 1, "bit", "no ray is inside: neither in set-up, nor in the loop, nor waiting as a result");

    // The state registers are declared first; what they hold is decided at the end of the loop.
    let fields = fields(&s, d, path);
    let back = Ray::registers(&b, &fields);
    let (clocks_setup, clocks_hit) = ((path.setup_clocks)(d), (path.hit_clocks)(d));
    let finish = if d.mode.bilinear { bilinear_clocks(&d.latency) } else { clocks_hit };

    b.section("leave", "A ray that is done leaves when the output pipeline moves.");
    let (skids, queues) = (d.latency.handshake > 0, d.latency.handshake > 2);
    let hit_valid = b.wire("hit_valid", 1);
    // What lets the output pipeline move: a free place in its register, or whoever takes the result.
    let hit_room = if skids { b.wire("hit_room", 1) } else { (!hit_valid | out_ready).unstaged().named("hit_ce") };
    // Before a queue nothing ever stops.
    let hit_ce = if queues { b.lit(1, 1) } else { hit_room };
    // Where two registers stand in the way of ready, it is decided a clock before: what finds both places of the waiting results empty finds
    // the output pipeline moving a clock later.
    let decided = (d.latency.handshake > 1).then(|| b.loop_decision("leaves", true, true));
    let leaves = decided.unwrap_or_else(|| (back.valid & back.get("done") & hit_room).named("leaves"));
    let is_free = (!back.valid | leaves).named("is_free");

    b.section("set up", "The setup pipeline holds while its ray finds no free slot.");
    let setup_valid = b.wire("setup_valid", 1);
    let setup_room =
        if skids { b.wire("setup_room", 1) } else { (!setup_valid | is_free).unstaged().named("setup_ce") };
    let setup_ce = if queues { b.lit(1, 1) } else { setup_room };
    let set_out = if queues { (in_valid & setup_room).named("sets_out") } else { in_valid };
    let module = (path.setup)(d);
    let mut ins = vec![("u", u), ("v", v), ("du", du), ("dv", dv), ("ce", setup_ce)];
    ins.extend(lod.map(|lod| ("lod", lod)));
    let outs = b.inst(&module, "u_setup", &[], &ins);
    let names: Vec<&str> = module.data_outputs().map(|(_, p)| p.name.as_str()).collect();
    let outs: Vec<Sig<'_>> = outs
        .into_iter()
        .zip(&names)
        .map(|(x, n)| x.restage(0).named(&format!("{}_{n}", if skids { "set" } else { "new" })))
        .collect();
    let track = stream_delay("setup_delay", clocks_setup, d.traverse.tag_bits);
    let ins = [("in_valid", set_out), ("in_data", in_tag), ("ce", setup_ce)];
    let o_track = b.inst(&track, "u_setup_delay", &[("W", s.tag.clone())], &ins);
    let (mut is_set, mut new_tag, mut outs) = (o_track[0].restage(0), o_track[1].restage(0), outs);
    if skids {
        let words: Vec<Sig<'_>> = outs.iter().copied().chain([new_tag.named("set_tag")]).collect();
        let valid = is_set.named("is_set");
        let between =
            Between { name: "setup", valid, room: setup_room, take: is_free, sets_out: queues.then_some(set_out) };
        let new: Vec<String> = names.iter().map(|n| format!("new_{n}")).chain(["new_tag".into()]).collect();
        (is_set, outs) = between.pass(&b, &words, &new);
        new_tag = outs.pop().expect("the tag was put in last");
    }
    let setup = |name: &str| {
        let at = names.iter().position(|n| *n == name);
        outs[at.unwrap_or_else(|| panic!("{} has no output {name}", module.name))]
    };
    b.connect(setup_valid, is_set.named("setup_tracked"));
    let new_tag = new_tag.named("new_tag");
    b.drive(o_in_ready, setup_room, None);
    let admits = (setup_valid & is_free).named("admits");

    b.section("slot", "The new ray, or the one that comes back.");
    let new = Ray::fresh(&b, &fields, setup, new_tag);
    let keeps = ((back.valid & !leaves) | admits).named("keeps");
    b.drive(o_busy, keeps, None);
    let ray = if d.latency.node > 1 {
        // Who comes is known a clock before the words are chosen: the choice goes to every bit of a ray.
        back.cut_words().or_new(&fields, admits.cut(), &new.cut_words(), keeps.valid().cut())
    } else {
        back.or_new(&fields, admits, &new, keeps)
    };

    let next = (path.iteration)(&b, &s, d, &ray, &load);
    let mut loops = back.pairs(&next);
    // A queue has counted the ray that leaves now only in the next clock.
    let leaving = decided.map(|r| {
        let hit_moves = if queues {
            let now = b.wire("leaving_now", 1);
            b.connect(now, r);
            hit_room & !now
        } else {
            hit_room & !hit_valid
        };
        (r, (next.valid & next.get("done").named("ends") & hit_moves).named("leaves_next"))
    });
    loops.extend(leaving);
    let slots = b.close(&loops);
    // No more than every register holds, and both queues.
    let most = clocks_setup + slots + finish + 2 * PLACES;
    b.drive(
        o_idle,
        idle(&b, (in_valid & setup_room).named("came_in"), (hit_valid & out_ready).named("went_out"), most),
        None,
    );
    // Delayed, the decision would meet another hit_room than it was made with.
    assert!(leaving.is_none_or(|(_, v)| v.stage() == Some(slots - 1)), "who leaves is decided in the last slot");

    b.section("result", "The ray that leaves, from the state registers.");
    let hit = (path.hit)(d);
    let (mut fractions, mut texels) = (Vec::new(), Vec::new());
    for (name, axis) in [("u", "x"), ("v", "y")] {
        let mut ins = (path.hit_inputs)(&back, axis);
        ins.push(("ce", hit_ce));
        let o = b.inst(&hit, &format!("u_hit_{name}"), &[("IDX_W", s.idx.clone())], &ins);
        let mut fraction = o[0].unstaged();
        if finish > clocks_hit {
            let waits = word_delay("fraction_delay", finish - clocks_hit, 1);
            let ins = [("in_data", fraction.named(&format!("block_f{name}"))), ("ce", hit_ce)];
            fraction = b.inst(&waits, &format!("u_hit_f{name}"), &[("W", s.frac.clone())], &ins)[0].unstaged();
        }
        fractions.push(fraction.named(&format!("hit_f{name}")));
        texels.extend(o.get(1).map(|x| x.unstaged().named(&format!("hit_{}", if axis == "x" { "i" } else { "j" }))));
    }
    let (i, j) = match texels[..] {
        // In a node of a coarser level, the hit position says which texel it is.
        [i, j] => (i, j),
        _ => (back.get("x").slice(0, &s.levels), back.get("y").slice(0, &s.levels)),
    };
    let word = |name: &str| back.get(name);
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
    let r = b.inst(&delay, "u_hit_valid", &[], &[("in_valid", leaves), ("ce", hit_ce)]);
    let tracked = r[0].unstaged().named("hit_tracked");
    let refined = o_refined.is_some().then(|| refine(&b, d, &s, &back, &load, hit_ce));
    if skids {
        b.section("wait", "A result that nobody takes yet.");
        let found = refined.into_iter().flatten();
        let words: Vec<Sig<'_>> = outs.iter().chain(&fractions).copied().chain(found).collect();
        let names: Vec<String> = WAITING.iter().take(words.len()).map(|n| format!("waiting_{n}")).collect();
        let sets_out = queues.then_some(leaves);
        let between = Between { name: "hit", valid: tracked, room: hit_room, take: out_ready, sets_out };
        let (valid, mut all) = between.pass(&b, &words, &names);
        b.connect(hit_valid, valid.unstaged().named("hit_waits"));
        outs = all.drain(..outs.len()).collect();
        fractions = all.drain(..fractions.len()).collect();
        if let Some(o) = o_refined {
            let found: [Sig<'_>; 6] = all.try_into().unwrap_or_else(|_| panic!("a refined hit has six words"));
            o.drive(&b, &found, [outs[1], outs[2], fractions[0], fractions[1], outs[3]], outs[5]);
        }
    } else {
        b.connect(hit_valid, tracked);
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

/// Whether no ray is inside, where at most `most` are: rays are counted a clock after they came in or went out, so that no sum stands before a
/// handshake.
fn idle<'b>(b: &'b Builder, came_in: Sig<'b>, went_out: Sig<'b>, most: u32) -> Sig<'b> {
    b.section("idle", "Rays that came in and did not go out; the one that came in last is counted a clock later.");
    let width = u32::BITS - most.leading_zeros();
    let came = b.loop_reg("has_come_in", 1, true);
    let gone = b.loop_reg("has_gone_out", 1, true);
    let inside = b.loop_reg("rays_inside", width, true);
    let some = b.loop_reg("some_inside", 1, true);
    let fewer = (gone & !came).named("one_ray_less");
    let change = b.cat(&[fewer.rep(width - 1), came ^ gone]);
    let next = (inside + change).named("rays_next");
    b.close(&[(came, came_in), (gone, went_out), (inside, next), (some, next.any().named("some_next"))]);
    (!(some | came)).named("is_idle")
}

/// The refinement beside the hit position: code of the patch, texel, fractions, parameter.
fn refine<'b>(b: &'b Builder, d: &Design, s: &Sizes, back: &Ray<'b>, load: &Load<'b>, ce: Sig<'b>) -> [Sig<'b>; 6] {
    b.section("refine", "The hit moved to the surface between the centres of texels.");
    let mut ins = vec![("load_en", load.en), ("load_addr", load.addr), ("load_data", load.data), ("ce", ce)];
    ins.extend(["p_x", "d_x", "r_x", "p_y", "d_y", "r_y", "t"].map(|n| (n, back.get(n))));
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

/// What a result that waits is made of: what was carried, the fractions, and of a refined hit its six words.
const WAITING: [&str; 17] = [
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
