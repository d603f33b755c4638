//! The tables that list: every measurement, iterations, the points of the charts, maps, and what has no datapath.
use super::figures::{Aggregate, Series};
use super::measurement::Measurement;
use super::plan::{NotLegal, Plan};
use super::table::{Table, real};
use serde_json::{Value, json};

/// Every measurement, a row each.
pub fn measurements(measurements: &[Measurement]) -> Table {
    let keys = [
        "map",
        "seed",
        "levels",
        "codes",
        "view",
        "elevation",
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
    for c in measurements {
        let (m, d) = (&c.spec.map, &c.spec.design);
        let (a, r, u) = (&c.uv_all, &c.uv_right, &c.uv_unrounded);
        t.push(vec![
            json!(m.name),
            json!(m.seed),
            json!(m.levels),
            json!(m.codes),
            json!(c.spec.view),
            c.spec.elevation.map_or(Value::Null, real),
            json!(c.spec.stride),
            json!(d.label()),
            json!(d.word_bits()),
            json!(d.way()),
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

/// Iterations of every design, map size and view.
pub fn steps(plan: &Plan, measurements: &[Measurement]) -> Table {
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
    for h in plan.designs.iter().filter(|d| plan.headlines.iter().any(|h| h.design.same_arithmetic(d))) {
        let mut levels: Vec<u32> = plan.maps.iter().map(|s| s.spec.levels).collect();
        levels.sort_unstable();
        levels.dedup();
        for n in levels {
            for view in plan.rays.iter().filter(|r| r.elevation.is_none()).map(|r| &r.set.name) {
                let p = Aggregate::new(measurements, |c| {
                    c.spec.design == *h && c.spec.map.levels == n && c.spec.view == *view
                });
                let Some(worst) = p.worst(|c| f64::from(c.steps_max)) else { continue };
                let mean = |f: &dyn Fn(&Measurement) -> f64| {
                    p.measurements.iter().map(|c| f(c)).sum::<f64>() / p.measurements.len() as f64
                };
                t.push(vec![
                    json!(h.label()),
                    json!(h.way()),
                    json!(n),
                    json!(view),
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
            t.push(vec![
                json!(s.by),
                json!(s.name),
                real(p.x),
                real(p.aggregate.cycles()),
                json!(p.aggregate.rays()),
                json!(p.aggregate.wrong() + p.aggregate.limits()),
                real(p.aggregate.rate()),
                real(p.aggregate.largest(|c| c.uv_all.p99)),
                real(p.aggregate.largest(|c| c.uv_all.max)),
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
        ("border", "beyond its border"),
        ("codes", "hash of the codes"),
    ];
    let mut t = Table::new("maps", &keys);
    for s in &plan.maps {
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
