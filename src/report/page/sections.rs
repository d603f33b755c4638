//! The tables of the report.
use super::cell::{Cell, Witness};
use super::figures::{Dot, Pool, Series, headlines};
use super::plan::{NotLegal, Plan, mode_label};
use super::replay::command;
use super::stats::{BINS, bound, upper};
use super::table::{Table, grouped, real};
use serde_json::{Value, json};

/// "k of N", or "0 of N (95 % bound 3/N)".
pub fn of(k: u64, n: u64) -> String {
    let (count, all) = (grouped(k), grouped(n));
    if k == 0 { format!("0 of {all} (95 % bound {:.1e})", bound(n)) } else { format!("{count} of {all}") }
}

/// Every cell, a row each.
pub fn cells(cells: &[Cell]) -> Table {
    let keys = [
        "map",
        "seed",
        "levels",
        "codes",
        "view",
        "stride",
        "design",
        "word_bits",
        "mode",
        "rays",
        "unjudged",
        "wrong_texels",
        "wrong_walls",
        "given_up",
        "cycles",
        "steps_mean",
        "steps_max",
        "steps_max_ray",
        "crossings_mean",
        "t_error_max",
        "uv_p50",
        "uv_p99",
        "uv_max",
        "uv_max_ray",
        "uv_right_p50",
        "uv_right_p99",
        "uv_right_max",
        "unrounded_wrong",
        "unrounded_uv_p50",
        "unrounded_uv_p99",
        "unrounded_uv_max",
    ];
    let mut t = Table::new("cells", &keys.map(|k| (k, "")));
    for c in cells {
        let (m, d) = (&c.spec.map, &c.spec.design);
        let (a, r, u) = (&c.uv_all, &c.uv_right, &c.uv_unrounded);
        t.push(vec![
            json!(m.name),
            json!(m.seed),
            json!(m.levels),
            json!(m.codes),
            json!(c.spec.view.word()),
            json!(c.spec.stride),
            json!(d.label()),
            json!(d.word_bits()),
            json!(mode_label(&d.mode)),
            json!(c.rays),
            json!(c.unjudged),
            json!(c.wrong),
            json!(c.wrong_walls),
            json!(c.limits),
            real(c.cycles()),
            real(c.steps_mean),
            json!(c.steps_max),
            json!(c.worst_steps.as_ref().map(|w| w.ray)),
            real(c.crossings_mean),
            real(c.t_max),
            real(a.p50),
            real(a.p99),
            real(a.max),
            json!(a.max_ray),
            real(r.p50),
            real(r.p99),
            real(r.max),
            json!(c.unrounded_wrong),
            real(u.p50),
            real(u.p99),
            real(u.max),
        ]);
    }
    t
}

/// A dot of the Pareto plot a row.
pub fn pareto(dots: &[Dot<'_>]) -> Table {
    let mut t = Table::new(
        "pareto",
        &[
            ("design", "design"),
            ("mode", "mode"),
            ("word_bits", "word bits"),
            ("cycles", "cycles / ray"),
            ("counted_bits", "counted bits"),
            ("cells_x_clock", "cells × clock"),
            ("rays", "rays"),
            ("wrong_texels", "wrong texels"),
            ("given_up", "given up"),
            ("wrong_rate", "wrong rate"),
            ("bound", "95 % bound if 0"),
            ("uv_p50", "uv p50, texel"),
            ("uv_p99", "uv p99"),
            ("uv_max", "uv max"),
            ("frontier_wrong", "frontier, wrong"),
            ("frontier_uv", "frontier, uv"),
        ],
    );
    for d in dots {
        let yes = |b: bool| json!(if b { "●" } else { "" });
        let (rate, zero) = d.pool.rate_or_bound();
        t.push(vec![
            json!(d.design.label()),
            json!(mode_label(&d.design.mode)),
            json!(d.design.word_bits()),
            real(d.pool.cycles()),
            json!(d.size),
            json!("not measured"),
            json!(d.pool.rays()),
            json!(d.pool.wrong()),
            json!(d.pool.limits()),
            real(d.pool.rate()),
            if zero { real(rate) } else { Value::Null },
            real(d.pool.largest(|c| c.uv_all.p50)),
            real(d.uv_p99()),
            real(d.pool.largest(|c| c.uv_all.max)),
            yes(d.front_rate),
            yes(d.front_uv),
        ]);
    }
    t
}

/// Iterations of every design, map size and view.
pub fn steps(plan: &Plan, cells: &[Cell]) -> Table {
    let mut t = Table::new(
        "steps",
        &[
            ("design", "design"),
            ("mode", "mode"),
            ("levels", "levels"),
            ("view", "view"),
            ("rays", "rays"),
            ("mean", "mean steps"),
            ("max", "max"),
            ("max_map", "on map"),
            ("max_ray", "ray"),
            ("crossings", "mean crossings"),
        ],
    );
    for h in plan.designs.iter().filter(|d| headlines(plan).iter().any(|h| h.design.same_arithmetic(d))) {
        let mut levels: Vec<u32> = plan.sites.iter().map(|s| s.spec.levels).collect();
        levels.sort_unstable();
        levels.dedup();
        for n in levels {
            for view in crate::config::View::ALL {
                let p = Pool::new(cells, |c| c.spec.design == *h && c.spec.map.levels == n && c.spec.view == *view);
                let Some(worst) = p.worst(|c| f64::from(c.steps_max)) else { continue };
                let mean = |f: &dyn Fn(&Cell) -> f64| p.cells.iter().map(|c| f(c)).sum::<f64>() / p.cells.len() as f64;
                t.push(vec![
                    json!(h.label()),
                    json!(mode_label(&h.mode)),
                    json!(n),
                    json!(view.word()),
                    json!(p.rays()),
                    real(mean(&|c| c.steps_mean)),
                    json!(worst.steps_max),
                    json!(worst.spec.map.name),
                    json!(worst.worst_steps.as_ref().map(|w| w.ray)),
                    real(mean(&|c| c.crossings_mean)),
                ]);
            }
        }
    }
    t
}

/// The points of all line charts.
pub fn series(series: &[Series<'_>]) -> Table {
    let mut t = Table::new(
        "series",
        &[
            ("by", "by"),
            ("design", "design"),
            ("x", "at"),
            ("cycles", "cycles / ray"),
            ("rays", "rays"),
            ("failed", "wrong or given up"),
            ("wrong_rate", "rate"),
            ("uv_p99", "uv p99, texel"),
            ("uv_max", "uv max"),
        ],
    );
    for s in series {
        for p in &s.points {
            let at =
                if s.by == "angle" { json!(crate::config::View::ALL[p.x as usize].word()) } else { json!(p.x as u64) };
            t.push(vec![
                json!(s.by),
                json!(s.name),
                at,
                real(p.pool.cycles()),
                json!(p.pool.rays()),
                json!(p.pool.wrong() + p.pool.limits()),
                real(p.pool.rate()),
                real(p.pool.largest(|c| c.uv_all.p99)),
                real(p.pool.largest(|c| c.uv_all.max)),
            ]);
        }
    }
    t
}

/// The histogram of the position error of the headline designs.
pub fn histogram(plan: &Plan, dots: &[Dot<'_>]) -> Table {
    let mut t = Table::new(
        "histogram",
        &[
            ("design", "design"),
            ("below", "below, texel"),
            ("right", "right texel"),
            ("all", "all that ended"),
            ("cumulative", "cumulative"),
        ],
    );
    for h in headlines(plan) {
        let Some(dot) = dots.iter().find(|d| *d.design == h.design) else { continue };
        let (all, right) = (dot.pool.bins(true), dot.pool.bins(false));
        let total: u64 = all.iter().sum();
        let mut sum = 0;
        for k in 0..BINS {
            sum += all[k];
            let part = real(sum as f64 / total.max(1) as f64);
            t.push(vec![json!(h.design.label()), real(upper(k)), json!(right[k]), json!(all[k]), part]);
        }
    }
    t
}

/// The decision matrices of the headline designs.
pub fn matrix(plan: &Plan, dots: &[Dot<'_>]) -> Table {
    let mut t = Table::new(
        "matrix",
        &[
            ("design", "design"),
            ("datapath", "datapath says"),
            ("oracle", "oracle says"),
            ("right", "right texel"),
            ("wrong", "wrong texel"),
            ("rays", "rays"),
            ("words", "in words"),
        ],
    );
    for h in headlines(plan) {
        let Some(dot) = dots.iter().find(|d| *d.design == h.design) else { continue };
        let (m, n) = (dot.pool.matrix(), dot.pool.rays());
        for (d, datapath) in ["top", "wall", "given up"].iter().enumerate() {
            for (o, oracle) in ["top", "wall"].iter().enumerate() {
                let [right, wrong] = m[d][o];
                // What is given up has no texel to be right or wrong.
                let words = match (d, d == o) {
                    (2, _) => format!("given up: {}", of(right + wrong, n)),
                    (_, true) => format!("wrong texel: {}", of(wrong, n)),
                    _ => format!("wrong texel: {}; right texel, other side: {}", of(wrong, n), of(right, n)),
                };
                t.push(vec![
                    json!(h.design.label()),
                    json!(datapath),
                    json!(oracle),
                    json!(right),
                    json!(wrong),
                    json!(n),
                    json!(words),
                ]);
            }
        }
    }
    t
}

/// The worst that each headline design does, with its witness and the command that shows it again.
pub fn worst(plan: &Plan, dots: &[Dot<'_>]) -> Table {
    let mut t = Table::new(
        "worst",
        &[
            ("design", "design"),
            ("what", "what"),
            ("value", "value"),
            ("map", "map"),
            ("view", "view"),
            ("ray", "ray"),
            ("words", "u v du dv (hex)"),
            ("got", "got"),
            ("exact", "exact"),
            ("margin", "margin"),
            ("command", "see it again"),
        ],
    );
    type Find = (&'static str, fn(&Cell) -> f64, fn(&Cell) -> &Option<Witness>);
    let finds: [Find; 5] = [
        ("largest uv error, texel", |c| c.uv_all.max, |c| &c.worst_uv),
        ("largest t error, height range", |c| c.t_max, |c| &c.worst_t),
        ("most iterations", |c| f64::from(c.steps_max), |c| &c.worst_steps),
        ("most wrong texels of a view, part", |c| c.wrong as f64 / c.judged().max(1) as f64, |c| &c.first_wrong),
        ("most given up of a view, part", |c| c.limits as f64 / c.judged().max(1) as f64, |c| &c.first_limit),
    ];
    for h in headlines(plan) {
        let Some(dot) = dots.iter().find(|d| *d.design == h.design) else { continue };
        for (what, value, witness) in finds {
            let Some(cell) = dot.pool.worst(value) else { continue };
            let Some(w) = witness(cell) else { continue };
            let texel = |t: [u32; 2]| format!("{}, {}", t[0], t[1]);
            t.push(vec![
                json!(h.design.label()),
                json!(what),
                if what == "most iterations" { json!(cell.steps_max) } else { real(value(cell)) },
                json!(cell.spec.map.name),
                json!(cell.spec.view.word()),
                json!(w.ray),
                json!(w.words.join(" ")),
                json!(texel(w.got)),
                json!(w.exact.map(texel)),
                real(w.margin),
                json!(command(plan, cell, w)),
            ]);
        }
    }
    t
}

/// Designs that have no datapath.
pub fn not_legal(refused: &[NotLegal]) -> Table {
    let mut t = Table::new("not_legal", &[("design", "design"), ("levels", "levels"), ("reason", "not legal")]);
    for r in refused {
        t.push(vec![json!(r.design), json!(r.levels), json!(r.reason)]);
    }
    t
}

/// The maps.
pub fn maps(plan: &Plan) -> Table {
    let keys = [
        ("map", "map"),
        ("side", "side, texels"),
        ("seed", "seed"),
        ("scale", "height, world"),
        ("repeat", "repeats"),
        ("border", "behind its border"),
        ("codes", "hash of the codes"),
    ];
    let mut t = Table::new("maps", &keys);
    for s in &plan.sites {
        let m = &s.spec;
        let seed = if s.file.is_some() { Value::Null } else { json!(m.seed) };
        t.push(vec![
            json!(m.name),
            json!(1u64 << m.levels),
            seed,
            real(m.scale),
            json!(m.repeat),
            json!(m.border.word()),
            json!(m.codes),
        ]);
    }
    t
}
