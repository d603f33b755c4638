//! The tables that judge: cost against error, position error, decisions, worst cases.
use super::figures::DesignPoint;
use super::measurement::{Measurement, Witness};
use super::plan::Plan;
use super::replay::command;
use super::table::{Table, grouped, real};
use crate::measure::spread::{BINS, bound, upper};
use serde_json::{Value, json};

/// "k of N", or "0 of N (95 % bound 3/N)".
pub fn of(k: u64, n: u64) -> String {
    let (count, all) = (grouped(k), grouped(n));
    if k == 0 { format!("0 of {all} (95 % bound {:.1e})", bound(n)) } else { format!("{count} of {all}") }
}

/// A dot of the Pareto plot a row.
pub fn pareto(points: &[DesignPoint<'_>]) -> Table {
    let mut t = Table::new(
        "pareto",
        &[
            ("design", "design"),
            ("mode", "mode"),
            ("word_bits", "word bits"),
            ("cycles", "cycles / ray"),
            ("counted_bits", "counted bits"),
            ("luts", "LUTs"),
            ("multipliers", "multipliers"),
            ("mhz", "MHz"),
            ("ns_ray", "ns / ray"),
            ("luts_x_ns", "LUTs × ns / ray"),
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
    for d in points {
        let yes = |b: bool| json!(if b { "●" } else { "" });
        let (rate, zero) = d.aggregate.rate_or_bound();
        t.push(vec![
            json!(d.design.label()),
            json!(d.design.way()),
            json!(d.design.word_bits()),
            real(d.aggregate.cycles()),
            json!(d.size),
            json!(d.placed.map(|s| s.luts)),
            json!(d.placed.map(|s| s.multipliers)),
            d.placed.map_or(Value::Null, |s| real(s.mhz)),
            d.placed.map_or(Value::Null, |s| real(s.nanoseconds(d.aggregate.cycles()))),
            d.area_time().map_or(Value::Null, real),
            json!(d.aggregate.rays()),
            json!(d.aggregate.wrong()),
            json!(d.aggregate.limits()),
            real(d.aggregate.rate()),
            if zero { real(rate) } else { Value::Null },
            real(d.aggregate.largest(|c| c.uv_all.p50)),
            real(d.uv_p99()),
            real(d.aggregate.largest(|c| c.uv_all.max)),
            yes(d.front_rate),
            yes(d.front_uv),
        ]);
    }
    t
}

/// The histogram of the position error of the headline designs.
pub fn histogram(plan: &Plan, points: &[DesignPoint<'_>]) -> Table {
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
    for h in &plan.headlines {
        let Some(dot) = points.iter().find(|d| *d.design == h.design) else { continue };
        let (all, right) = (dot.aggregate.bins(true), dot.aggregate.bins(false));
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
pub fn matrix(plan: &Plan, points: &[DesignPoint<'_>]) -> Table {
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
    for h in &plan.headlines {
        let Some(dot) = points.iter().find(|d| *d.design == h.design) else { continue };
        let (m, n) = (dot.aggregate.matrix(), dot.aggregate.rays());
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
pub fn worst(plan: &Plan, points: &[DesignPoint<'_>]) -> Table {
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
    type Find = (&'static str, fn(&Measurement) -> f64, fn(&Measurement) -> &Option<Witness>);
    let finds: [Find; 5] = [
        ("largest uv error, texel", |c| c.uv_all.max, |c| &c.worst_uv),
        ("largest t error, height range", |c| c.t_max, |c| &c.worst_t),
        ("most iterations", |c| f64::from(c.steps_max), |c| &c.worst_steps),
        ("most wrong texels of a view, part", |c| c.wrong as f64 / c.judged().max(1) as f64, |c| &c.first_wrong),
        ("most given up of a view, part", |c| c.limits as f64 / c.judged().max(1) as f64, |c| &c.first_limit),
    ];
    for h in &plan.headlines {
        let Some(dot) = points.iter().find(|d| *d.design == h.design) else { continue };
        for (what, value, witness) in finds {
            let Some(measurement) = dot.aggregate.worst(value) else { continue };
            let Some(w) = witness(measurement) else { continue };
            let texel = |t: [u32; 2]| format!("{}, {}", t[0], t[1]);
            t.push(vec![
                json!(h.design.label()),
                json!(what),
                if what == "most iterations" { json!(measurement.steps_max) } else { real(value(measurement)) },
                json!(measurement.spec.map.name),
                json!(measurement.spec.view),
                json!(w.ray),
                json!(w.words.join(" ")),
                json!(texel(w.got)),
                json!(w.exact.map(texel)),
                real(w.margin),
                json!(command(plan, measurement, w)),
            ]);
        }
    }
    t
}
