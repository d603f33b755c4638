//! The table of units: what `synth` measured of each.
use super::plan::Plan;
use super::table::{Table, real};
use serde_json::{Value, json};

/// Area and clock of every unit in the files of `synth`, in their order.
pub fn units(plan: &Plan) -> Table {
    let columns = [
        ("unit", "unit"),
        ("latency", "clocks"),
        ("target", "target"),
        ("luts", "LUTs"),
        ("carries", "carry cells"),
        ("multipliers", "multipliers"),
        ("memories", "block memories"),
        ("flip_flops", "flip-flops"),
        ("mhz", "MHz"),
        ("path", "critical path"),
    ];
    let mut t = Table::new("units", &columns);
    for u in &plan.units {
        let path = u.clock.as_ref().map(|c| format!("{} > {}", c.critical.from, c.critical.to));
        t.push(vec![
            json!(u.unit),
            json!(u.latency),
            json!(u.target),
            json!(u.luts),
            json!(u.carries),
            json!(u.multipliers),
            json!(u.memories),
            json!(u.flip_flops),
            u.clock.as_ref().map_or(Value::Null, |c| real(c.median)),
            json!(path.filter(|p| p != " > ")),
        ]);
    }
    t
}
