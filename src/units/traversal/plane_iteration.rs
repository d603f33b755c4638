//! One iteration of a datapath that compares plane parameters: from the slot's ray to the ray that goes back.
use super::climb::climb;
use super::height_source::{HeightPort, Heights};
use super::level_up::reads_parity;
use super::loop_state::{Ray, Sizes};
use super::multi_level_down::multi_level_down;
use super::node_address::node_address;
use super::node_planes::node_planes;
use super::plane_units::{Pair, PlaneUnits};
use super::trim;
use super::write_back::Found;
use reliefrtl_config::{Design, Register, Trim};
use reliefrtl_ir::{Builder, Record, Sig};

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
    let chosen = if d.latency.has(Register::SlotRay) { ray.reg() } else { ray.clone() };
    let ray = &chosen;

    b.section("node", "Extent and exit planes of the node, and its address in memory.");
    let [px, py] = extent(b, s, d, ray, ray.get("level"), true);
    let plane_times = || {
        b.section("plane parameters", "");
        times(b, s, d, ray, units, ["time", "t"], [px["plane"], py["plane"]]).map(|t| t.id())
    };
    let (heights, [t_x, t_y], read) = if d.mode.trim == Trim::None {
        let heights = read_heights(b, s, d, ray, source, ray.get("level"));
        (heights, plane_times().map(|t| b.sig(t)), ray.get("level"))
    } else {
        let times = plane_times().map(|t| b.sig(t));
        let read = trim::trim(b, s, d, ray, units, [[px["low"], px["high"]], [py["low"], py["high"]]], times);
        b.section("address", "");
        (read_heights(b, s, d, ray, source, read), times, read)
    };

    b.section("height test", "");
    let o = b.inst(&(units.height_test)(d), "u_height_test", &[], &[("height", heights.single()), ("t", ray.get("t"))]);
    let (m, below) = (o["m"].named("m"), o["below"].named("below"));

    b.section("predicted hit", "");
    let reach = |axis: &str| {
        let ins = [ray.constants(axis, units.predicted_inputs), vec![("m", m)]].concat();
        let e = b.inst(&(units.predicted_hit)(d), &format!("u_predict_{axis}"), &idx(), &ins).only();
        e.named(&format!("{axis}_hit")).id()
    };
    let (hit_x, hit_y) = (b.sig(reach("x")), b.sig(reach("y")));

    b.section("node crossing", "");
    let ins = [("t", ray.get("t")), ("m", m), ("t_x", t_x), ("t_y", t_y)];
    let o = b.inst(&(units.node_crossing)(d), "u_crossing", &[], &ins);
    let [inside, x_first, t_next] = ["is_inside", "x_first", "t_next"].map(|n| o[n].named(n));

    b.section("multi-level down", "");
    let mut ins = vec![("level", read)];
    ins.extend(ray.find("crossed").map(|c| ("crossed", c)));
    ins.extend(ray.find("lod").map(|lod| ("lod", lod)));
    ins.extend([("x_low", px["low"]), ("x_high", px["high"]), ("x_hit", hit_x)]);
    ins.extend([("y_low", py["low"]), ("y_high", py["high"]), ("y_hit", hit_y)]);
    let o = b.inst(&multi_level_down(d), "u_down", &idx(), &ins);
    let [level_down, x_down, y_down] = ["level_down", "x_down", "y_down"].map(|n| o[n].named(n));

    let even = || x_first.mux(px["even"], py["even"]).named("even");
    let (across, grown) = climb(b, s, d, ray, read, &even, [[ray.get("x"), ray.get("y")], [hit_x, hit_y]]);

    let at = [ray.get("x"), ray.get("y")];
    let (down, beyond) = ([x_down, y_down], [px["beyond"], py["beyond"]]);
    let found = Found { inside, x_first, below, m, t_next, read, across, grown, level_down, at, down, beyond };
    found.decide(b, s, d, ray, units, heights.missed)
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

/// Extent and exit planes of the ray's node of a level, along x and along y: low, high, plane, beyond, and whether the plane is even where the rule
/// asks. Without `bounds`, low and high are not used.
pub(super) fn extent<'b>(
    b: &'b Builder,
    s: &Sizes,
    d: &Design,
    ray: &Ray<'b>,
    level: Sig<'b>,
    bounds: bool,
) -> [Record<'b>; 2] {
    let parity = reads_parity(d);
    ["x", "y"].map(|axis| {
        let ins = [("level", level), ("x", ray.get(axis)), ("neg", ray.get(&format!("neg_{axis}")))];
        let o = b.inst(&node_planes(d, parity), &format!("u_planes_{axis}"), &[("IDX_W", s.idx.clone())], &ins);
        let reg = |v: Sig<'b>| v.reg_if(d.latency.has(Register::ExitPlanes));
        o.record().map(|n, v| {
            let v = v.named(&format!("{axis}_{n}"));
            if !bounds && ["low", "high"].contains(&n) {
                b.unused(v);
                return v;
            }
            reg(v)
        })
    })
}

/// Parameters of the planes along x and along y; instances and nets are named by axis.
pub(super) fn times<'b>(
    b: &'b Builder,
    s: &Sizes,
    d: &Design,
    ray: &Ray<'b>,
    units: &PlaneUnits,
    [instance, net]: [&str; 2],
    planes: Pair<'b>,
) -> Pair<'b> {
    [0, 1].map(|k| {
        let axis = ["x", "y"][k];
        let ins = [vec![("plane", planes[k])], ray.constants(axis, units.plane_inputs)].concat();
        let o = b.inst(&(units.plane_time)(d), &format!("u_{instance}_{axis}"), &[("IDX_W", s.idx.clone())], &ins);
        o.only().named(&format!("{net}_{axis}"))
    })
}
