//! One iteration over a block of four cells: from the slot's ray to the ray that goes back.
use super::block_descent::block_descent;
use super::block_middle::block_middle;
use super::{CELLS, ORDER, block_address};
use crate::traversal::climb::climb;
use crate::traversal::height_source::HeightPort;
use crate::traversal::level_up::reads_parity;
use crate::traversal::loop_state::{Ray, Sizes};
use crate::traversal::node_address::node_address;
use crate::traversal::node_planes::node_planes;
use crate::traversal::plane_iteration::{extent, times};
use crate::traversal::plane_units::{Pair, PlaneUnits};
use crate::traversal::trim;
use crate::traversal::write_back::Found;
use reliefrtl_config::{Design, Register, Trim};
use reliefrtl_ir::{Builder, Record, Sig};

const AXES: [&str; 2] = ["x", "y"];

/// Builds the iteration; operands meet at the stage at which the latest of them is known.
pub fn block_iteration<'b>(
    b: &'b Builder,
    s: &Sizes,
    d: &Design,
    ray: &Ray<'b>,
    source: &mut dyn HeightPort<'b>,
    units: &PlaneUnits,
) -> Ray<'b> {
    let idx = || [("IDX_W", s.idx.clone())];
    // As an iteration over nodes: a clock after the choice between two rays, as latency.node has it.
    let chosen = if d.latency.has(Register::SlotRay) { ray.reg() } else { ray.clone() };
    let ray = &chosen;

    b.section("block", "Extent and exit planes of the block, whose cells are a level finer.");
    let level_block = (ray.get("level") + b.lit(1, s.level_w.clone())).named("level_block");
    let [px, py] = extent(b, s, d, ray, level_block, d.mode.trim != Trim::None);
    b.section("exit parameters", "");
    let [far_x, far_y] = times(b, s, d, ray, units, ["time", "t"], [px["plane"], py["plane"]]);
    let read = if d.mode.trim == Trim::None {
        ray.get("level")
    } else {
        trim::trim(b, s, d, ray, units, [[px["low"], px["high"]], [py["low"], py["high"]]], [far_x, far_y])
    };

    b.section("middle", "The planes between the cells, and the block's address in memory.");
    let [mx, my] = AXES.map(|axis| {
        let ins = [("level", read), ("x", ray.get(axis)), ("neg", ray.get(&format!("neg_{axis}")))];
        let o = b.inst(&block_middle(d), &format!("u_middle_{axis}"), &idx(), &ins);
        let reg = |v: Sig<'b>| v.reg_if(d.latency.has(Register::ExitPlanes));
        let net = |port: &str| format!("{axis}_{}", if port == "first" { "first_far" } else { port });
        o.record().map(|port, v| reg(v.named(&net(port))))
    });
    let cell = node_address(b, s, d, "u_address", ray, read).named("cell_address");
    b.unused(cell.slice(0, 2));
    let address = cell.slice(2, block_address(&s.levels)).named("address");
    b.section("height", "");
    let heights = source.read(ray, &[address; CELLS.len()]);
    b.section("middle parameters", "");
    let [mid_x, mid_y] = times(b, s, d, ray, units, ["middle_time", "t_middle"], [mx["middle"], my["middle"]]);

    let planes = Planes { mid: [mid_x, mid_y], far: [far_x, far_y], past: [mx["past"], my["past"]] };
    let o = planes.choose(b, d, ray, units, &heights.words);
    let (inside, x_first, t_next) = (o["is_inside"], o["x_first"], o["t_next"]);

    b.section("cell", "Where the ray enters the chosen cell, and how far a descent into it may go.");
    let starts = [0, 1].map(|k| {
        let axis = AXES[k];
        let first = [&mx, &my][k]["first"];
        o[format!("is_far_{axis}").as_str()].mux(first, ray.get(axis)).named(&format!("{axis}_start")).reg().id()
    });
    let starts = starts.map(|v| b.sig(v));
    let bounds = [0, 1].map(|k| {
        let axis = AXES[k];
        let ins = [("level", read), ("x", starts[k]), ("neg", ray.get(&format!("neg_{axis}")))];
        let o = b.inst(&node_planes(d, reads_parity(d)), &format!("u_cell_{axis}"), &idx(), &ins);
        let unused = ["plane", "beyond", "even"].into_iter().filter_map(|n| Some((n, o.get(n)?)));
        unused.for_each(|(n, v)| b.unused(v.named(&format!("{axis}_cell_{n}"))));
        ["low", "high"].map(|n| o[n].named(&format!("{axis}_cell_{n}")))
    });

    b.section("height test", "");
    let ins = [("height", o["height"]), ("t", o["enters"])];
    let test = b.inst(&(units.height_test)(d), "u_height_test", &[], &ins);
    let (m, below) = (test["m"].named("m"), test["below"].named("below"));

    b.section("predicted hit", "");
    let predicted = AXES.map(|axis| {
        let ins = [ray.constants(axis, units.predicted_inputs), vec![("m", m)]].concat();
        let e = b.inst(&(units.predicted_hit)(d), &format!("u_predict_{axis}"), &idx(), &ins).only();
        e.named(&format!("{axis}_hit"))
    });

    b.section("descent", "");
    let mut ins = vec![("level", read)];
    ins.extend(ray.find("crossed").map(|c| ("crossed", c)));
    ins.extend(ray.find("lod").map(|lod| ("lod", lod)));
    ins.extend([("x_low", bounds[0][0]), ("x_high", bounds[0][1]), ("x_hit", predicted[0])]);
    ins.extend([("y_low", bounds[1][0]), ("y_high", bounds[1][1]), ("y_hit", predicted[1])]);
    let down = b.inst(&block_descent(d), "u_descent", &idx(), &ins);
    let level_down = down["level_down"].named("level_down");
    let down = ["x_down", "y_down"].map(|n| down[n].named(n));

    // The cells of the root's block are the coarsest.
    let top = b.konst(&s.levels - 1, &s.level_w).named("top_level").doc("the level below the root");
    let below_top = (!read.eq(top)).named("is_below_top");
    let even = || (x_first.mux(px["even"], py["even"]) & below_top).named("even");
    let (across, grown) = climb(b, s, d, ray, read, &even, [starts, predicted]);
    let beyond = [px["beyond"], py["beyond"]];
    let found = Found { inside, x_first, below, m, t_next, read, across, grown, level_down, at: starts, down, beyond };
    found.decide(b, s, d, ray, units, heights.missed)
}

/// What is known of a block's planes, x first.
struct Planes<'b> {
    /// Parameters of the middle planes.
    mid: Pair<'b>,
    /// Parameters of the exit planes.
    far: Pair<'b>,
    /// The ray is beyond the middle plane already (1 bit).
    past: Pair<'b>,
}

impl<'b> Planes<'b> {
    /// The first cell with a hit, or the last one: the outputs of `cell_choice`.
    fn choose(&self, b: &'b Builder, d: &Design, ray: &Ray<'b>, units: &PlaneUnits, heights: &[Sig<'b>]) -> Record<'b> {
        let planes = [("mid_x", self.mid[0]), ("mid_y", self.mid[1]), ("far_x", self.far[0]), ("far_y", self.far[1])];
        b.section("order of planes", "");
        let t = ray.get("t");
        let mut ins: Vec<(String, Sig<'b>)> = Vec::new();
        let order = b.inst(&(units.plane_order)(d), "u_order", &[], &[&[("t", t)][..], &planes].concat());
        for (name, ..) in ORDER {
            ins.push((name.to_string(), order[name].named(&format!("{name}_less"))));
        }
        b.section(
            "height codes of planes",
            "Rounded up while the memory is read: no height becomes a parameter before it is chosen.",
        );
        for (name, time) in planes {
            let limit = b.inst(&(units.depth_limit)(d), &format!("u_limit_{name}"), &[], &[("t", time)]).only();
            let name = format!("limit_{name}");
            ins.push((name.clone(), limit.named(&name)));
        }
        for (axis, past) in AXES.into_iter().zip(self.past) {
            let name = |what: &str| format!("{what}_{axis}");
            ins.extend([(name("past"), past), (name("neg"), ray.get(&name("neg")))]);
        }
        ins.extend(CELLS.iter().zip(heights).map(|(name, v)| ((*name).to_string(), *v)));
        ins.extend([("t", t)].iter().chain(&planes).map(|(name, v)| ((*name).to_string(), *v)));
        b.section("choice", "");
        let ins: Vec<(&str, Sig<'b>)> = ins.iter().map(|(n, v)| (n.as_str(), *v)).collect();
        let o = b.inst(&(units.cell_choice)(d), "u_choice", &[], &ins);
        o.record().map(|name, v| v.named(name))
    }
}
