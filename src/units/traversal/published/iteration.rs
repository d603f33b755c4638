//! One iteration of `traverse`, stage by stage as PIDM-HW figure 7 has it: 15 stages at the published latencies.
use super::{
    boundary_time, crossing_test, descent_level, exit_plane, level_choice, nearer_plane, ray_point, surface_time,
};
use crate::float::{fp_from_int, fp_to_int};
use crate::traversal::height_source::HeightPort;
use crate::traversal::level_up::{level_up_at_once, reads_parity};
use crate::traversal::loop_state::{Ray, Sizes};
use crate::traversal::node_address::node_address;
use crate::traversal::start_level::start_level;
use reliefrtl_config::{Design, LevelUp};
use reliefrtl_ir::{Builder, Sig};

/// Builds the iteration; operands meet at the stage at which the latest of them is known.
pub(super) fn iteration<'b>(
    b: &'b Builder,
    s: &Sizes,
    d: &Design,
    ray: &Ray<'b>,
    source: &mut dyn HeightPort<'b>,
) -> Ray<'b> {
    let (t, l) = (&d.traverse, &d.latency);
    let idx = || [("IDX_W", s.idx.clone())];
    let int = [("INT_W", s.idx.clone())];
    let neg = ["x", "y"].map(|a| ray.get(&format!("d_{a}")).msb().named(&format!("{a}_neg")).id()).map(|i| b.sig(i));
    let first = ray.find("first");

    b.section("height address", "And the planes by which the ray can leave the node.");
    let mut planes = Vec::new();
    let mut evens = Vec::new();
    for (axis, neg) in ["x", "y"].into_iter().zip(neg) {
        let ins = [("level", ray.get("level")), ("x", ray.get(axis)), ("neg", neg)];
        let o = b.inst(&exit_plane(t, reads_parity(d)), &format!("u_plane_{axis}"), &idx(), &ins);
        planes.push(o["plane"].named(&format!("{axis}_plane")));
        evens.extend(o.get("even").map(|e| e.named(&format!("{axis}_even"))));
    }
    let address = node_address(b, s, d, "u_address", ray, ray.get("level")).named("address");

    b.section("height read", "");
    let heights = source.read(ray, &[address.reg()]);

    b.section("boundaries", "The two dividers of the loop.");
    let when = |axis: &str, plane: Sig<'b>, neg: Sig<'b>| {
        let (p, dir) = (ray.get(&format!("p_{axis}")), ray.get(&format!("d_{axis}")));
        let ins = [("plane", plane.reg()), ("neg", neg), ("p", p), ("d", dir)];
        b.inst(&boundary_time(d), &format!("u_time_{axis}"), &idx(), &ins).only().named(&format!("t_{axis}"))
    };
    let (t_x, t_y) = (when("x", planes[0], neg[0]), when("y", planes[1], neg[1]));

    b.section("surface", "Mode 1 asks for the ray's end instead.");
    let mut ins = vec![("height", heights.single()), ("t", ray.get("t"))];
    ins.extend(first.map(|f| ("first", f)));
    let o = b.inst(&surface_time(d), "u_surface", &[], &ins);
    let (m, below) = (o["m"].named("m"), o["below"].named("below"));

    b.section("nearer plane", "");
    let o = b.inst(&nearer_plane(d, reads_parity(d)), "u_nearer", &[], &[("t_x", t_x), ("t_y", t_y)]);
    let (t_exit, x_first) = (o["t_exit"].named("t_exit"), o.get("x_first").map(|x| x.named("x_first")));

    b.section("positions", "Hit position and node-crossing position, both before it is known which one counts.");
    let point = |axis: &str, what: &str, t: Sig<'b>| {
        let ins = [("p", ray.get(&format!("p_{axis}"))), ("d", ray.get(&format!("d_{axis}"))), ("t", t)];
        b.inst(&ray_point(d), &format!("u_{what}_{axis}"), &[], &ins).only().named(&format!("{axis}_{what}_at")).id()
    };
    let hit = ["x", "y"].map(|a| b.sig(point(a, "hit", m)));
    let cross = ["x", "y"].map(|a| b.sig(point(a, "cross", t_exit)));

    b.section("tests", "NC, MLD and LU tests, and the test for the end.");
    // The planes are carried as integers until just before they are compared.
    let from = fp_from_int(d.format, t.idx_bits(), l.from_int);
    let clocks = from.latency().expect("a pipeline");
    let late = cross[0].stage().map_or(0, |k| k - clocks);
    let edge = |axis: &str, plane: Sig<'b>| {
        b.inst(&from, &format!("u_edge_{axis}"), &int, &[("a", plane.at(late))])
            .only()
            .named(&format!("{axis}_edge"))
            .id()
    };
    let edges = [b.sig(edge("x", planes[0])), b.sig(edge("y", planes[1]))];
    let mut ins = vec![("x_hit", hit[0]), ("x_edge", edges[0]), ("x_neg", neg[0])];
    ins.extend([("y_hit", hit[1]), ("y_edge", edges[1]), ("y_neg", neg[1])]);
    ins.extend([("t", ray.get("t")), ("t_exit", t_exit)]);
    let o = b.inst(&crossing_test(d), "u_crossing", &[], &ins);
    let (exits, t_next) = (o["crosses"].named("exits_node"), o["t_next"].named("t_next"));
    let mut ins = vec![("level", ray.get("level"))];
    ins.extend(ray.find("crossed").map(|c| ("crossed", c)));
    let level_down = b.inst(&descent_level(t, &d.mode), "u_down", &[], &ins).only().named("level_down");
    let texel = |axis: &str, what: &str, at: Sig<'b>| {
        let to = fp_to_int(d.format, t.idx_bits(), l.to_int);
        b.inst(&to, &format!("u_{what}_texel_{axis}"), &int, &[("a", at)]).only().named(&format!("{axis}_{what}"))
    };
    let even = || x_first.map(|x| x.mux(evens[0], evens[1]).named("even"));
    let near = || ["x", "y"].map(|a| texel(a, "hit", hit[usize::from(a == "y")]));
    let up = climbs(b, s, d, ray, &even, &near);

    b.section("level decision", "");
    let mut ins = vec![("exits", exits), ("up", up), ("level", ray.get("level")), ("level_down", level_down)];
    ins.extend(first.map(|f| ("first", f)));
    ins.extend([("m", m), ("t_next", t_next)]);
    ins.extend([("x_hit", hit[0]), ("x_cross", cross[0]), ("y_hit", hit[1]), ("y_cross", cross[1])]);
    let o = b.inst(&level_choice(d), "u_decision", &[], &ins);
    let late = |port: &str, net: &str| (0..l.decision).fold(o[port].named(net), |v, _| v.reg());
    let hit = late("hit", "is_hit");
    let crosses = noted(b, ray, o["crosses"], || late("crosses", "crosses"));
    let level_next = late("level_next", "level_next");
    let [x_at, y_at, t_after] =
        [("x_next", "x_next_at"), ("y_next", "y_next_at"), ("t_out", "t_after")].map(|(p, n)| late(p, n));

    b.section("address conversion", "");
    let at = [texel("x", "next", x_at), texel("y", "next", y_at)];

    write_back(b, s, d, ray, heights.missed, Decided { hit, crosses, below, up, level: level_next, at, t: t_after })
}

/// Whether the ray `crosses` (1 bit), as `late` delays it, where a word of the ray takes note of that.
fn noted<'b>(b: &Builder, ray: &Ray<'b>, crosses: Sig<'b>, late: impl FnOnce() -> Sig<'b>) -> Option<Sig<'b>> {
    let notes = ray.notes_crossings();
    if !notes {
        b.unused(crosses.named("crosses"));
    }
    notes.then(late)
}

/// Whether a crossing goes one level up (1 bit); `near` makes the texel of the hit on both axes, where the rule asks for it.
fn climbs<'b>(
    b: &'b Builder,
    s: &Sizes,
    d: &Design,
    ray: &Ray<'b>,
    even: &dyn Fn() -> Option<Sig<'b>>,
    near: &dyn Fn() -> [Sig<'b>; 2],
) -> Sig<'b> {
    match level_up_at_once(d) {
        None => b.zeros(1),
        Some(unit) => {
            let mut ins = vec![("level", ray.get("level"))];
            ins.extend(even().map(|e| ("even", e)));
            ins.extend(ray.find("prev").map(|p| ("prev_crossed", p)));
            let mut params = Vec::new();
            if d.mode.level_up == LevelUp::Selective {
                let near = near();
                ins.extend([("x_at", ray.get("x")), ("x_hit", near[0]), ("y_at", ray.get("y")), ("y_hit", near[1])]);
                params.push(("IDX_W", s.idx.clone()));
            }
            b.inst(&unit, "u_up", &params, &ins).only().named("up")
        }
    }
}

/// What an iteration decided, at the stages at which it was known.
struct Decided<'b> {
    /// The ray ends at a hit.
    hit: Sig<'b>,
    /// It crosses a plane; where the ray takes note of that.
    crosses: Option<Sig<'b>>,
    /// Its height parameter lies before it: the hit would be a wall.
    below: Sig<'b>,
    /// The level rises if it crosses.
    up: Sig<'b>,
    /// Level after the iteration.
    level: Sig<'b>,
    /// Texel after it.
    at: [Sig<'b>; 2],
    /// Parameter after it.
    t: Sig<'b>,
}

/// Counts the step, ends the ray at its limit, and keeps a finished ray, or one whose height is `missed`, as it is.
fn write_back<'b>(
    b: &'b Builder,
    s: &Sizes,
    d: &Design,
    ray: &Ray<'b>,
    missed: Option<Sig<'b>>,
    decided: Decided<'b>,
) -> Ray<'b> {
    let (first, [x, y]) = (ray.find("first"), decided.at);
    b.section("end", "A finished ray recirculates unchanged; mode 1 changes the level alone.");
    let end = x.stage().unwrap_or(0);
    let (hit, crosses) = (decided.hit.at(end), decided.crosses.map(|v| v.at(end)));
    let [level_next, t_after] = [decided.level, decided.t].map(|v| v.at(end));
    // A ray whose height is not there yet recirculates unchanged too, in mode 1 as well.
    let (waits, done) = (missed, ray.get("done"));
    let keeps = waits.map_or(done, |missed| (done | missed).named("keeps"));
    let stays = first.map_or(keeps, |f| (keeps | f).named("stays"));
    let moves = (!stays).named("moves");
    let level = match first {
        None => level_next,
        Some(first) => {
            let ins = [("x", ray.get("x")), ("y", ray.get("y")), ("x_end", x), ("y_end", y)];
            let start = b
                .inst(&start_level(&d.traverse), "u_start_level", &[("IDX_W", s.idx.clone())], &ins)
                .only()
                .named("start");
            first.mux(start, level_next)
        }
    };
    let steps = (ray.get("steps") + moves.zext(16)).named("steps_next");
    let last_step =
        steps.eq(b.konst(&s.step_limit, 16).named("step_limit").doc("iterations of a ray, at most")).named("last_step");
    // One that ends without a hit is given up: also in a simulation that does not know whether it is a hit.
    let ends_now = ((hit | last_step) & moves).named("ends_now");
    let given_up = (ends_now & !hit).named("given_up");
    let crossed_now = crosses.map(|crosses| (crosses & moves).named("crossed_now"));
    let counted = crossed_now.filter(|_| d.gives_crossings());
    let counted = counted.map(|crossed| (crossed, (decided.up & crossed).named("up_now")));
    let has_crossed = crossed_now.map(|now| ray.find("crossed").map_or(now, |c| c | now));
    let mut next = vec![
        ("level", keeps.mux(ray.get("level"), level)),
        ("x", stays.mux(ray.get("x"), x)),
        ("y", stays.mux(ray.get("y"), y)),
        ("t", stays.mux(ray.get("t"), t_after)),
        ("done", done | ends_now),
        ("wall", keeps.mux(ray.get("wall"), hit & decided.below)),
        ("limit", ray.get("limit") | given_up),
        ("steps", steps),
    ];
    if let Some((crossed, up)) = counted {
        let count = |name, event: Sig<'b>| (name, ray.get(name) + event.zext(16));
        next.extend([count("crossings", crossed), count("ups", up)]);
    }
    next.extend(has_crossed.map(|crossed| ("crossed", crossed)));
    let prev = |now: Sig<'b>| waits.zip(ray.find("prev")).map_or(now, |(missed, prev)| missed.mux(prev, now));
    next.extend(crossed_now.map(|now| ("prev", prev(now))));
    let still_first = |f: Sig<'b>| waits.map_or_else(|| b.zeros(1), |missed| (f & missed).named("still_first"));
    next.extend(first.map(|f| ("first", still_first(f))));
    ray.with(&next)
}
