//! The state of a ray in a search by windows, the memories of the windows, and what a result needs of a ray that leaves.
use super::params::{count_width, set_word};
use super::window_address::{address_width, size as address_params, window_address};
use super::window_texel;
use crate::quantity::{BIT, CODES, WORDS};
use crate::traversal::height_source::Load;
use crate::traversal::loop_state::{Field, Ray, Sizes, Start};
use crate::traversal::search::Search;
use crate::traversal::slot_memory::SlotMemory;
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Expr, Record, Sig};

pub(super) static WINDOWS: Search = Search {
    summary: "traces rays against a height field: a looping pipeline, the windows of all sizes a clock",
    throughput: "one iteration (a window of each size) per clock; a ray takes as many iterations as its path needs",
    choices: |d| vec![("windows", set_word(&d.window_set()))],
    described: |_| Vec::new(),
    image: |d| {
        let last = d.window_set().sizes().len() - 1;
        format!("with .0 to .{last} after its name, files for $readmemh with the words of each size; \"\": none")
    },
    loads,
    state,
    leaving: Some(leaving),
    address_words: origin,
    addresses: |b, _, d, name, ray, words| {
        let texel = ["x", "y"].map(|a| {
            let of = |n: &str| words[format!("{n}_{a}").as_str()];
            let ins =
                [("origin", of("origin")), ("neg", of("neg")), ("k", ray.get(if a == "x" { "k_x" } else { "k_y" }))];
            let o = b.inst(&window_texel(d), &format!("u_{name}_texel_{a}"), &[], &ins);
            o.only().named(&format!("{name}_texel_{a}"))
        });
        let address = |(c, size): (usize, &reliefrtl_config::Window)| {
            let ins = [("x", texel[0]), ("y", texel[1]), ("neg_x", words["neg_x"]), ("neg_y", words["neg_y"])];
            let o = b.inst(&window_address(d), &format!("u_{name}_address_{c}"), &address_params(*size), &ins);
            for a in ["x", "y"] {
                b.unused(o[format!("border_{a}").as_str()].named(&format!("{name}_border_{a}_{c}")));
            }
            o["address"].named(&format!("{name}_address_{c}"))
        };
        d.window_set().sizes().iter().enumerate().map(address).collect()
    },
};

/// The texel of a ray's entry along each axis, and which way it goes.
pub(super) fn origin<'b>(s: &Sizes, new: &Record<'b>) -> Record<'b> {
    let f = Expr::param("FRACTION_W");
    let of = |name: &str, a: &str| new[format!("{name}_{a}").as_str()];
    let origin = ["x", "y"].map(|a| (format!("origin_{a}"), of("p", a).slice(&f - &s.levels, &s.levels)));
    let neg = ["x", "y"].map(|a| (format!("neg_{a}"), of("neg", a)));
    origin.into_iter().chain(neg).collect()
}

/// What stands after the name of a memory's file.
const FILES: [&str; 5] = [".0", ".1", ".2", ".3", ".4"];

fn loads<'b>(b: &'b Builder, s: &Sizes, d: &Design) -> Vec<Load<'b>> {
    let set = d.window_set();
    let coarsest = set.sizes().iter().map(|w| w.grid_bits()).max().unwrap_or(0);
    b.require(i64::from(coarsest), &s.levels);
    let one = |(c, w): (usize, &reliefrtl_config::Window)| {
        let grid = Expr::from(w.grid_bits());
        let text = format!("write a word of the windows {w} (while idle is 1)");
        Load {
            en: b.input_static(&format!("load_en_{c}"), 1, BIT, &text),
            addr: b.input_static(
                &format!("load_addr_{c}"),
                address_width(&s.levels, &grid),
                WORDS,
                "address: row by row, a word each cell of the grid",
            ),
            data: b.input_static(&format!("load_data_{c}"), &s.height, CODES, "highest code in that window"),
            words: ((&s.levels - &grid) * 2).pow2(),
            file: FILES[c],
        }
    };
    set.sizes().iter().enumerate().map(one).collect()
}

fn state(s: &Sizes, _: &Design) -> Vec<Field> {
    let (bit, counter) = (Expr::from(1), Expr::from(16));
    let count = count_width(&s.levels, &s.tile);
    let planes = |name: &'static str, along: &str| {
        Field::new(name, &count, Start::Zero).doc(format!("planes passed along {along} [planes]"))
    };
    vec![
        planes("k_x", "u"),
        planes("k_y", "v"),
        Field::new("t", &s.numbers.time.0, Start::Zero).doc(format!("ray parameter so far [{}]", s.numbers.time.1)),
        Field::new("done", &bit, Start::Refused).doc("finished: recirculates until it retires"),
        Field::new("wall", &bit, Start::Zero).doc("the hit is on the side of a texel"),
        Field::new("limit", &bit, Start::Refused).doc("given up, or not a ray"),
        Field::new("steps", &counter, Start::Zero).doc("iterations so far [iterations]"),
    ]
}

/// Words of a result that stand in the slot memories.
const KEPT: [&str; 7] = ["tag", "p_x", "s_x", "neg_x", "p_y", "s_y", "neg_y"];

/// The ray of the loop registers with its constants, and its texel, which may lie on another tile.
fn leaving<'b>(b: &'b Builder, s: &Sizes, held: &Ray<'b>, slots: &SlotMemory<'b>) -> Ray<'b> {
    b.section(
        "texel of the result",
        "The entry's texel moved by the planes passed, unwrapped: the position in the texel needs the tile, too.",
    );
    let kept: Record<'b> = KEPT.iter().map(|n| (*n, slots.new_words()[*n])).collect();
    let kept = slots.read_for_result("kept", &kept);
    let mut more: Vec<(&'static str, Sig<'b>)> = KEPT.iter().map(|n| (*n, kept[*n])).collect();
    let f = Expr::param("FRACTION_W");
    for (axis, p, k, neg) in [("x", "p_x", "k_x", "neg_x"), ("y", "p_y", "k_y", "neg_y")] {
        let flip = kept[neg].rep(s.idx.clone()).named(&format!("{axis}_flip"));
        let first = kept[p].slice(&f - &s.levels, &s.levels).zext(&s.idx);
        let ahead = ((first ^ flip) + held.get(k).zext(&s.idx)).named(&format!("{axis}_ahead"));
        more.push((axis, (ahead ^ flip).named(&format!("{axis}_retiring"))));
    }
    held.and(more)
}
