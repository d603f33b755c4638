//! What a ray carries on after an iteration that compares plane parameters.
use super::loop_state::{Ray, Sizes};
use super::plane_units::PlaneUnits;
use reliefrtl_config::{Design, Register};
use reliefrtl_ir::{Builder, Sig};

/// What an iteration found.
pub(super) struct Found<'b> {
    /// A height is met before the ray leaves.
    pub(super) inside: Sig<'b>,
    /// It leaves by the x plane.
    pub(super) x_first: Sig<'b>,
    /// The height's parameter lies before the ray's: a hit would be a wall.
    pub(super) below: Sig<'b>,
    /// Parameter of a hit or a descent.
    pub(super) m: Sig<'b>,
    /// Parameter of a crossing.
    pub(super) t_next: Sig<'b>,
    /// Level of what was read.
    pub(super) read: Sig<'b>,
    /// What a crossing does to the level, by the port of `level_decision` that takes it.
    pub(super) across: (&'static str, Sig<'b>),
    /// The level rises if the ray crosses; where that is counted.
    pub(super) grown: Option<Sig<'b>>,
    /// Level of a descent.
    pub(super) level_down: Sig<'b>,
    /// The ray's texel, x first.
    pub(super) at: [Sig<'b>; 2],
    /// Texel of a descent.
    pub(super) down: [Sig<'b>; 2],
    /// First texel beyond the exit planes.
    pub(super) beyond: [Sig<'b>; 2],
}

impl<'b> Found<'b> {
    /// The ray after the iteration: hit, descent or crossing.
    pub(super) fn decide(
        self,
        b: &'b Builder,
        s: &Sizes,
        d: &Design,
        ray: &Ray<'b>,
        units: &PlaneUnits,
        missed: Option<Sig<'b>>,
    ) -> Ray<'b> {
        let Self { inside, x_first, below, m, t_next, read, across, grown, level_down, at, down, beyond } = self;
        b.section("level decision", "");
        let late = |v: Sig<'b>| v.reg_if(d.latency.has(Register::BeforeDecision));
        let mut ins = vec![("is_inside", late(inside)), ("x_first", late(x_first)), (across.0, late(across.1))];
        ins.extend(ray.find("lod").map(|lod| ("lod", late(lod))));
        ins.extend([("level", late(read)), ("level_down", late(level_down)), ("m", late(m)), ("t_next", late(t_next))]);
        ins.extend([("x_at", late(at[0])), ("x_down", late(down[0])), ("x_beyond", late(beyond[0]))]);
        ins.extend([("y_at", late(at[1])), ("y_down", late(down[1])), ("y_beyond", late(beyond[1]))]);
        let o = b.inst(&(units.level_decision)(d), "u_decision", &[("IDX_W", s.idx.clone())], &ins);
        let done = |v: Sig<'b>| v.reg_if(d.latency.has(Register::AfterDecision));
        let (hit, crosses) = (done(o["hit"].named("hit")), o["crosses"].named("crosses"));
        let next = [("level_next", "level_next"), ("x_next", "x_next"), ("y_next", "y_next"), ("t_out", "t_after")];
        let next = next.map(|(port, net)| done(o[port].named(net)));
        let decided = Decided { hit, crosses, below, grown, next };
        write_back(b, s, ray, missed, decided, &done)
    }
}

/// What an iteration decided.
struct Decided<'b> {
    /// The ray ends at a hit.
    hit: Sig<'b>,
    /// It crosses a plane.
    crosses: Sig<'b>,
    /// Its height parameter lies before it: the hit would be a wall.
    below: Sig<'b>,
    /// The level rises if it crosses; where that is counted.
    grown: Option<Sig<'b>>,
    /// Level, x, y, t after the iteration.
    next: [Sig<'b>; 4],
}

/// Counts the step, ends the ray at its limit, and keeps a finished ray, or one whose height is `missed`, as it is.
fn write_back<'b>(
    b: &'b Builder,
    s: &Sizes,
    ray: &Ray<'b>,
    missed: Option<Sig<'b>>,
    decided: Decided<'b>,
    done: &dyn Fn(Sig<'b>) -> Sig<'b>,
) -> Ray<'b> {
    let Decided { hit, crosses, below, grown, next } = decided;
    b.section(
        "end of the ray",
        "A finished ray takes no more steps. One that ends without a hit is given up, in simulation also one whose hit is unknown (x).",
    );
    // Nor does one whose height is not there yet.
    let waits = missed;
    let stays = waits.map_or(ray.get("done"), |missed| (ray.get("done") | missed).named("stays"));
    let moves = (!stays).named("moves");
    let steps = (ray.get("steps") + moves.zext(16)).named("steps_next");
    let last =
        b.konst(&s.step_limit - 1, 16).named("step_limit_less_1").doc("steps before the last one that a ray may take");
    let last_step = ray.get("steps").eq(last).named("last_step");
    let ends_now = hit | last_step;
    let ends_now = waits.map_or(ends_now, |_| ends_now & moves).named("ends_now");
    let given_up = (ends_now & !hit & moves).named("given_up");
    let crossed_now = ray.notes_crossings().then(|| (crosses & moves).named("crossed_now"));
    let up_now = grown.zip(crossed_now).map(|(grown, crossed)| done((grown & crossed).named("up_now")));
    let crossed_now = crossed_now.map(done);
    if crossed_now.is_none() {
        b.unused(crosses);
    }
    b.section("write back", "A finished ray recirculates unchanged.");
    let keep = |new: Sig<'b>, old: &str| stays.mux(ray.get(old), new);
    let [level, x, y, t] =
        [(next[0], "level"), (next[1], "x"), (next[2], "y"), (next[3], "t")].map(|(new, old)| keep(new, old));
    let noted = crossed_now.map_or_else(Vec::new, |crossed| noted(ray, waits, crossed));
    let mut next = vec![
        ("level", level),
        ("x", x),
        ("y", y),
        ("t", t),
        ("done", ray.get("done") | ends_now),
        ("wall", keep(hit & below, "wall")),
        ("limit", ray.get("limit") | given_up),
        ("steps", steps),
    ];
    if let Some((crossed, up)) = crossed_now.zip(up_now) {
        let count = |name, event: Sig<'b>| (name, ray.get(name) + event.zext(16));
        next.extend([count("crossings", crossed), count("ups", up)]);
    }
    next.extend(noted);
    ray.with(&next)
}

/// What a ray carries on of whether it `crossed` in this iteration: crossed, prev, descended. A ray that waits still says what the iteration before
/// it was.
fn noted<'b>(ray: &Ray<'b>, waits: Option<Sig<'b>>, crossed: Sig<'b>) -> Vec<(&'static str, Sig<'b>)> {
    let has_crossed = ray.find("crossed").map_or(crossed, |c| c | crossed);
    // Of a ray that ends here it does not matter whether it descended.
    let descended = if ray.find("descended").is_some() { (!crossed).named("descended_now") } else { crossed };
    let held = |new: Sig<'b>, old: &str| match (waits, ray.find(old)) {
        (Some(missed), Some(old)) => missed.mux(old, new),
        _ => new,
    };
    let (prev, descended) = (held(crossed, "prev"), held(descended, "descended"));
    vec![("crossed", has_crossed), ("prev", prev), ("descended", descended)]
}
