//! One iteration of a datapath that compares plane parameters: from the slot's ray to the ray that goes back.
use super::height_source::{HeightPort, Heights};
use super::level_up::{latency as level_up_clocks, level_up, reads_parity};
use super::loop_state::{Ray, Sizes};
use super::multi_level_down::multi_level_down;
use super::node_address::node_address;
use super::node_planes::node_planes;
use super::plane_units::PlaneUnits;
use super::trim;
use super::trim_return::trim_return;
use reliefrtl_config::{Design, LevelUp, Trim};
use reliefrtl_ir::{Builder, Sig};

/// Builds the iteration; operands meet at the stage at which the latest of them is known.
pub fn plane_iteration<'b>(
    b: &'b Builder,
    s: &Sizes,
    d: &Design,
    ray: &Ray<'b>,
    source: &mut dyn HeightPort<'b>,
    units: &PlaneUnits,
) -> Ray<'b> {
    let idx = || [("IDX_W", s.idx.clone())];
    // The choice between two rays and the node's planes are long on their own: a clock after each, as latency.node has it.
    let chosen = if d.latency.node > 1 { ray.reg() } else { ray.clone() };
    let ray = &chosen;

    let [px, py] = node(b, s, d, ray);
    let plane_times = || {
        b.section("plane parameters", "");
        let when = |axis: &str, plane: Sig<'b>| {
            let ins = [vec![("plane", plane)], ray.constants(axis, units.plane_inputs)].concat();
            b.inst(&(units.plane_time)(d), &format!("u_time_{axis}"), &idx(), &ins)[0].named(&format!("t_{axis}")).id()
        };
        [b.sig(when("x", px[2])), b.sig(when("y", py[2]))].map(|t| t.id())
    };
    let (heights, [t_x, t_y], read) = if d.mode.trim == Trim::None {
        let heights = read_heights(b, s, d, ray, source, ray.get("level"));
        (heights, plane_times().map(|t| b.sig(t)), ray.get("level"))
    } else {
        let times = plane_times().map(|t| b.sig(t));
        let read = trim::trim(b, s, d, ray, units, [[px[0], px[1]], [py[0], py[1]]], times);
        b.section("address", "");
        (read_heights(b, s, d, ray, source, read), times, read)
    };

    b.section("height test", "");
    let o = b.inst(&(units.height_test)(d), "u_height_test", &[], &[("height", heights.single()), ("t", ray.get("t"))]);
    let (m, below) = (o[0].named("m"), o[1].named("below"));

    b.section("predicted hit", "");
    let reach = |axis: &str| {
        let ins = [ray.constants(axis, units.predicted_inputs), vec![("m", m)]].concat();
        let e = b.inst(&(units.predicted_hit)(d), &format!("u_predict_{axis}"), &idx(), &ins)[0];
        e.named(&format!("{axis}_hit")).id()
    };
    let (hit_x, hit_y) = (b.sig(reach("x")), b.sig(reach("y")));

    b.section("node crossing", "");
    let ins = [("t", ray.get("t")), ("m", m), ("t_x", t_x), ("t_y", t_y)];
    let o = b.inst(&(units.node_crossing)(d), "u_crossing", &[], &ins);
    let (inside, x_first, t_next) = (o[0].named("is_inside"), o[1].named("x_first"), o[2].named("t_next"));

    b.section("multi-level down", "");
    let mut ins = vec![("level", read)];
    ins.extend(ray.find("crossed").map(|c| ("crossed", c)));
    ins.extend(ray.find("lod").map(|lod| ("lod", lod)));
    ins.extend([("x_low", px[0]), ("x_high", px[1]), ("x_hit", hit_x)]);
    ins.extend([("y_low", py[0]), ("y_high", py[1]), ("y_hit", hit_y)]);
    let o = b.inst(&multi_level_down(d), "u_down", &idx(), &ins);
    let (level_down, x_down, y_down) = (o[0].named("level_down"), o[1].named("x_down"), o[2].named("y_down"));

    let even = || x_first.mux(px[4], py[4]).named("even");
    let (across, grown) = climb(b, s, d, ray, read, &even, [hit_x, hit_y]);

    b.section("level decision", "");
    let late = |v: Sig<'b>| if d.latency.decision > 1 { v.reg() } else { v };
    let mut ins = vec![("is_inside", late(inside)), ("x_first", late(x_first)), (across.0, late(across.1))];
    ins.extend(ray.find("lod").map(|lod| ("lod", late(lod))));
    ins.extend([("level", late(read)), ("level_down", late(level_down)), ("m", late(m)), ("t_next", late(t_next))]);
    ins.extend([("x_at", late(ray.get("x"))), ("x_down", late(x_down)), ("x_beyond", late(px[3]))]);
    ins.extend([("y_at", late(ray.get("y"))), ("y_down", late(y_down)), ("y_beyond", late(py[3]))]);
    let o = b.inst(&(units.level_decision)(d), "u_decision", &idx(), &ins);
    // The last of the clocks stands between the decision and what is written back.
    let done = |v: Sig<'b>| if d.latency.decision > 3 { v.reg() } else { v };
    let (hit, crosses) = (done(o[0].named("hit")), o[1].named("crosses"));
    let names = ["level_next", "x_next", "y_next", "t_after"];
    let n: Vec<Sig<'b>> = o[2..].iter().zip(names).map(|(v, n)| done(v.named(n))).collect();

    write_back(b, s, ray, heights.missed, Decided { hit, crosses, below, grown, next: [n[0], n[1], n[2], n[3]] }, &done)
}

/// The words of the ray's node of a level.
fn read_heights<'b>(
    b: &'b Builder,
    s: &Sizes,
    d: &Design,
    ray: &Ray<'b>,
    source: &mut dyn HeightPort<'b>,
    level: Sig<'b>,
) -> Heights<'b> {
    let address = node_address(b, s, d, "u_address", ray, level).named("address");
    b.section("height", "");
    source.read(ray, &[address])
}

/// Extent and exit planes of the ray's node, along x and along y: low, high, plane, beyond, and whether the plane is even where the rule asks.
fn node<'b>(b: &'b Builder, s: &Sizes, d: &Design, ray: &Ray<'b>) -> [Vec<Sig<'b>>; 2] {
    b.section("node", "Extent and exit planes of the node, and its address in memory.");
    let parity = reads_parity(d);
    ["x", "y"].map(|axis| {
        let ins = [("level", ray.get("level")), ("x", ray.get(axis)), ("neg", ray.get(&format!("neg_{axis}")))];
        let o = b.inst(&node_planes(d, parity), &format!("u_planes_{axis}"), &[("IDX_W", s.idx.clone())], &ins);
        let names = ["low", "high", "plane", "beyond", "even"];
        let reg = |v: Sig<'b>| if d.latency.node > 0 { v.reg() } else { v };
        o.iter().zip(names).map(|(v, n)| reg(v.named(&format!("{axis}_{n}")))).collect()
    })
}

/// What a crossing does to the level: the operand of `level_decision` by its port name, and whether the level rises (1 bit).
fn climb<'b>(
    b: &'b Builder,
    s: &Sizes,
    d: &Design,
    ray: &Ray<'b>,
    read: Sig<'b>,
    even: &dyn Fn() -> Sig<'b>,
    predicted: [Sig<'b>; 2],
) -> ((&'static str, Sig<'b>), Sig<'b>) {
    b.section("level up", "");
    let up = match level_up(d, level_up_clocks(d)) {
        None => b.zeros(1),
        Some(unit) => {
            let mut ins = vec![("level", read)];
            match d.mode.level_up {
                LevelUp::Coherent => ins.extend(ray.find("prev").map(|p| ("prev_crossed", p))),
                LevelUp::Tevs => ins.push(("even", even())),
                LevelUp::Selective => {
                    // The plane of a trimmed node bounds larger ones too.
                    let leaves = match d.mode.trim {
                        Trim::None => even(),
                        Trim::Descent | Trim::Always => {
                            (even() | read.lt(ray.get("level")).named("is_trimmed")).named("leaves_parent")
                        }
                    };
                    ins.push(("even", leaves));
                    ins.extend([
                        ("x_at", ray.get("x")),
                        ("x_hit", predicted[0]),
                        ("y_at", ray.get("y")),
                        ("y_hit", predicted[1]),
                    ]);
                }
                LevelUp::None | LevelUp::Always => {}
            }
            let params = if d.mode.level_up == LevelUp::Selective { vec![("IDX_W", s.idx.clone())] } else { vec![] };
            b.inst(&unit, "u_up", &params, &ins)[0].named("up")
        }
    };

    match (d.mode.trim, d.mode.level_up) {
        (Trim::None, _) => (("up", up), up),
        (_, LevelUp::None) => (("level_across", ray.get("level")), up),
        _ => {
            let ins = [("level", ray.get("level")), ("level_read", read), ("up", up)];
            let o = b.inst(&trim_return(d), "u_return", &[], &ins);
            (("level_across", o[0].named("level_across")), o[1].named("grown"))
        }
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
    /// The level rises if it crosses.
    grown: Sig<'b>,
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
    let steps_before = b.konst(&s.step_limit - 1, 16).named("steps_before_last");
    let last_step = ray.get("steps").eq(steps_before).named("last_step");
    let ends_now = hit | last_step;
    let ends_now = waits.map_or(ends_now, |_| ends_now & moves).named("ends_now");
    let given_up = (ends_now & !hit & moves).named("given_up");
    let crossed_now = (crosses & moves).named("crossed_now");
    let up_now = done((grown & crossed_now).named("up_now"));
    let crossed_now = done(crossed_now);
    b.section("write back", "A finished ray recirculates unchanged.");
    let keep = |new: Sig<'b>, old: &str| stays.mux(ray.get(old), new);
    let [level, x, y, t] =
        [(next[0], "level"), (next[1], "x"), (next[2], "y"), (next[3], "t")].map(|(new, old)| keep(new, old));
    let has_crossed = ray.find("crossed").map_or(crossed_now, |c| c | crossed_now);
    // Of a ray that ends here it does not matter whether it descended.
    let descended = if ray.find("descended").is_some() { (!crossed_now).named("descended_now") } else { crossed_now };
    // What the iteration before was, a ray that waits still says of the one before that.
    let held = |new: Sig<'b>, old: &str| match (waits, ray.find(old)) {
        (Some(missed), Some(old)) => missed.mux(old, new),
        _ => new,
    };
    let (prev, descended) = (held(crossed_now, "prev"), held(descended, "descended"));
    ray.with(&[
        ("level", level),
        ("x", x),
        ("y", y),
        ("t", t),
        ("done", ray.get("done") | ends_now),
        ("wall", keep(hit & below, "wall")),
        ("limit", ray.get("limit") | given_up),
        ("steps", steps),
        ("crossings", ray.get("crossings") + crossed_now.zext(16)),
        ("ups", ray.get("ups") + up_now.zext(16)),
        ("crossed", has_crossed),
        ("prev", prev),
        ("descended", descended),
    ])
}
