//! One iteration of a search by windows: from the slot's ray to the ray that goes back.
use super::params::{Estimate, Planes};
use super::plane_product::low_width;
use super::search::origin;
use super::window_address;
use super::window_span;
use super::{
    plane_product, plane_sum, window_advance, window_choice, window_end, window_exit, window_index, window_texel,
    window_way,
};
use crate::traversal::height_source::HeightPort;
use crate::traversal::loop_state::{Ray, Sizes};
use crate::traversal::slot_memory::SlotMemory;
use reliefrtl_config::{Design, Register};
use reliefrtl_ir::{Builder, Expr, Record, Sig};

const AXES: [&str; 2] = ["x", "y"];

/// Builds the iteration; a constant is read in the stage in which it meets what was computed of the ray.
pub fn iteration<'b>(
    b: &'b Builder,
    s: &Sizes,
    d: &Design,
    ray: &Ray<'b>,
    source: &mut dyn HeightPort<'b>,
    slots: Option<&SlotMemory<'b>>,
) -> Ray<'b> {
    let slots = slots.expect("a search by windows has slot memories");
    let ray = &ray.reg();
    let set = d.window_set();
    let (f, w) = (Expr::param("FRACTION_W"), Expr::param("RECIP_W"));
    let planes = Planes::of(b, &f, &w, &s.levels, &s.tile);
    // Names of widths: the nets of this module have those of the units.
    Estimate::of(b, &f, &s.levels, &s.tile);
    b.local("LowW", low_width(&planes), "bits of the lower part of an operand");
    let new = slots.new_words();
    let two = |name: &str| {
        AXES.map(|a| format!("{name}_{a}")).map(|n| (n.clone(), new[n.as_str()])).into_iter().collect::<Record<'b>>()
    };

    b.section("texel", "");
    let origin = slots.read_early("origin", &origin(s, new));
    let registered = |v: Sig<'b>| v.reg_if(d.latency.has(Register::WindowTexel));
    let texel = AXES.map(|a| {
        let of = |n: &str| origin[format!("{n}_{a}").as_str()];
        let ins = [("origin", of("origin")), ("neg", of("neg")), ("k", ray.get(if a == "x" { "k_x" } else { "k_y" }))];
        registered(b.inst(&window_texel(d), &format!("u_texel_{a}"), &[], &ins).only().named(&format!("texel_{a}")))
    });
    b.section("address", "");
    let (mut addresses, mut borders) = (Vec::new(), Vec::new());
    for (c, size) in set.sizes().iter().enumerate() {
        let bits = window_address::address_width(&s.levels, &Expr::from(size.grid_bits()));
        b.local(&format!("Address{c}W"), bits, &format!("bits of an address of windows {c}"));
        let ins = [("x", texel[0]), ("y", texel[1]), ("neg_x", origin["neg_x"]), ("neg_y", origin["neg_y"])];
        let o =
            b.inst(&window_address::window_address(d), &format!("u_address_{c}"), &window_address::size(*size), &ins);
        addresses.push(o["address"].named(&format!("address_{c}")));
        borders.push(AXES.map(|a| o[format!("border_{a}").as_str()].named(&format!("border_{a}_{c}"))));
    }
    b.section("height", "");
    let heights = source.read(ray, &addresses);
    // A ray whose words are not there yet stays as it is: as a finished one, its windows say nothing new.
    let stays = heights.missed.map_or(ray.get("done"), |missed| (ray.get("done") | missed).named("stays"));

    b.section("plane ahead", "That of the texel along each axis: C + kQ.");
    let step = slots.read("step", &two("q"), 2);
    let products = AXES.map(|a| {
        let k = ray.get(if a == "x" { "k_x" } else { "k_y" });
        let ins = [("k", k), ("q", step[format!("q_{a}").as_str()])];
        let o = b.inst(&plane_product(d), &format!("u_product_{a}"), &[], &ins);
        o.record().named(&format!("{a}_product"))
    });
    let at = products[0]["low"].stage().expect("a product has a stage");
    let first = slots.read("entry", &two("c"), at);
    let plane = [0, 1].map(|k| {
        let a = AXES[k];
        let ins = [("c", first[format!("c_{a}").as_str()]), ("low", products[k]["low"]), ("high", products[k]["high"])];
        b.inst(&plane_sum(d), &format!("u_plane_{a}"), &[], &ins).only().named(&format!("plane_{a}"))
    });

    let ahead = Ahead { step, plane, borders, heights: heights.words };
    let choice = ahead.choose(b, d, ray, stays, &planes);
    let hit = choice["hit"];
    b.section("advance", "");
    let mut ins: Vec<(&str, Sig<'_>)> = choice.iter().filter(|(n, _)| *n != "hit").collect();
    ins.extend(["t", "k_x", "k_y"].map(|n| (n, ray.get(n))));
    let o = b.inst(&window_advance::window_advance(d), "u_advance", &[], &ins);
    let (m, below) = (o["m"].named("m"), o["below"].named("is_below"));

    b.section("estimate", "Never ahead of the ray, and of a hit no further than its texel.");
    let travels = slots.read("speed", &two("travel"), m.stage().expect("m has a stage"));
    let ways = AXES.map(|a| {
        let ins = [("travel", travels[format!("travel_{a}").as_str()]), ("m", m)];
        b.inst(&window_way::window_way(d), &format!("u_way_{a}"), &[], &ins).only().named(&format!("way_{a}"))
    });
    let offsets = slots.read("offset", &two("offset"), ways[0].stage().expect("a way has a stage"));
    let k = [0, 1].map(|n| {
        let a = AXES[n];
        let passed = o[format!("passed_{a}").as_str()].named(&format!("passed_{a}"));
        let ins = [("passed", passed), ("way", ways[n]), ("offset", offsets[format!("offset_{a}").as_str()])];
        b.inst(&window_index::window_index(d), &format!("u_index_{a}"), &[], &ins).only().named(&format!("k_{a}_next"))
    });
    ended(b, s, ray, stays, hit, below).with(&[("k_x", k[0]), ("k_y", k[1]), ("t", m)])
}

/// What is known of the way ahead of a ray.
struct Ahead<'b> {
    /// Q of each axis.
    step: Record<'b>,
    /// The plane of the texel along each axis.
    plane: [Sig<'b>; 2],
    /// Of each size, the texels up to the border of the grid's cell.
    borders: Vec<[Sig<'b>; 2]>,
    /// Of each size, the highest code in its window.
    heights: Vec<Sig<'b>>,
}

impl<'b> Ahead<'b> {
    /// Which windows are empty, and what they say of the way ahead: the outputs of `window_choice`.
    fn choose(&self, b: &'b Builder, d: &Design, ray: &Ray<'b>, stays: Sig<'b>, planes: &Planes) -> Record<'b> {
        let set = d.window_set();
        b.section("windows", "Of each size where it ends, its highest code, and whether that can be met before.");
        let mut ins = vec![("stays".to_string(), stays)];
        let clocks = window_end(d).latency().expect("a pipeline");
        for (c, size) in set.sizes().iter().enumerate() {
            let ends = [0, 1].map(|k| {
                let a = AXES[k];
                if size.side == 1 {
                    b.unused(self.borders[c][k]);
                    let wide = planes.plane.clone() + super::params::SPAN_W;
                    let end = self.plane[k].zext(&wide).named(&format!("end_{a}_{c}"));
                    return end.at(end.stage().expect("a plane has a stage") + clocks);
                }
                let span = [("q", self.step[format!("q_{a}").as_str()]), ("border", self.borders[c][k])];
                let span =
                    b.inst(&window_span::window_span(d), &format!("u_span_{a}_{c}"), &window_span::size(*size), &span);
                let ins = [("plane", self.plane[k]), ("span", span.only().named(&format!("span_{a}_{c}")))];
                b.inst(&window_end::window_end(d), &format!("u_end_{a}_{c}"), &[], &ins)
                    .only()
                    .named(&format!("end_{a}_{c}"))
            });
            let exits = [("end_x", ends[0]), ("end_y", ends[1]), ("height", self.heights[c]), ("t", ray.get("t"))];
            let o = b.inst(&window_exit::window_exit(d), &format!("u_exit_{c}"), &[], &exits);
            for (name, v) in o.record().iter() {
                let v = v.named(&format!("{name}_{c}"));
                match (name, c) {
                    ("is_open", 0) => ins.push(("is_open".into(), v)),
                    ("is_open", _) => b.unused(v),
                    _ => ins.push((format!("{name}_{c}"), v)),
                }
            }
        }
        let coarsest = self.borders.last().expect("two sizes or more");
        AXES.iter().zip(coarsest).for_each(|(a, v)| ins.push((format!("border_{a}"), *v)));

        b.section("choice", "");
        let ins: Vec<(&str, Sig<'_>)> = ins.iter().map(|(n, v)| (n.as_str(), *v)).collect();
        b.inst(&window_choice::window_choice(d), "u_choice", &[], &ins).record().named("chosen")
    }
}

/// Steps, and whether the ray ends in this iteration. A finished ray moves no more: its windows say the same once more.
fn ended<'b>(b: &'b Builder, s: &Sizes, ray: &Ray<'b>, stays: Sig<'b>, hit: Sig<'b>, below: Sig<'b>) -> Ray<'b> {
    b.section(
        "end of the ray",
        "A finished ray takes no more steps. One that ends without a hit is given up: also in a simulation that does not know if it is one.",
    );
    let moves = (!stays).named("moves");
    let steps = (ray.get("steps") + moves.zext(16)).named("steps_next");
    let last =
        b.konst(&s.step_limit - 1, 16).named("step_limit_less_1").doc("steps before the last one that a ray may take");
    let last_step = ray.get("steps").eq(last).named("last_step");
    // The choice says no hit of a ray that stays.
    let waits = stays.id() != ray.get("done").id();
    let ends_now = if waits { ((hit | last_step) & moves).named("ends_now") } else { hit | last_step };
    let given_up = (ends_now & !hit & moves).named("given_up");
    let wall = stays.mux(ray.get("wall"), hit & below).named("wall_next");
    ray.with(&[
        ("done", (ray.get("done") | ends_now).named("done_next")),
        ("wall", wall),
        ("limit", (ray.get("limit") | given_up).named("limit_next")),
        ("steps", steps),
    ])
}
