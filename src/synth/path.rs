//! A critical path in the names of the emitted text.
use serde::Serialize;
use serde_json::Value;

/// The slowest path between two registers.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Critical {
    /// Register that it leaves.
    pub from: String,
    /// Register that it reaches.
    pub to: String,
    /// Named signals between them, in order.
    pub via: Vec<String>,
    /// Nanoseconds in cells, set-up and clock-to-output included.
    pub logic_ns: f64,
    /// Nanoseconds in wires.
    pub routing_ns: f64,
    /// Cells on the path.
    pub hops: usize,
}

/// What the tools append to a name of ours.
const MARKS: &[&str] =
    &["_LUT4", "_CCU2C", "_PFUMX", "_L6MUX21", "_TRELLIS_FF", "_MULT18X18D", "_DP16KD", "_SB_", "_DI", "_LSR", "$"];

/// The signal of the emitted text that a net or cell was named after; indices are dropped.
fn ours(name: &str) -> String {
    let cut = MARKS.iter().filter_map(|m| name.find(m)).min().unwrap_or(name.len());
    let name = name[..cut].trim_start_matches("u_unit.");
    name.split('[').next().unwrap_or_default().to_string()
}

/// Reads the path of the clock out of nextpnr's report.
pub(super) fn critical(report: &Value) -> Critical {
    let mut out = Critical::default();
    let empty = Vec::new();
    let paths = report["critical_paths"].as_array().unwrap_or(&empty);
    let clocked = |p: &&Value| [&p["from"], &p["to"]].iter().all(|e| e.as_str().is_some_and(|s| s.contains("edge")));
    let Some(path) = paths.iter().find(clocked).and_then(|p| p["path"].as_array()) else { return out };
    let round = |x: f64| (x * 1000.0).round() / 1000.0;
    for step in path {
        let delay = step["delay"].as_f64().unwrap_or(0.0);
        if step["type"] == "routing" {
            out.routing_ns = round(out.routing_ns + delay);
            let net = step["net"].as_str().unwrap_or_default();
            // A net that the tools named after the register after it says nothing about where it is.
            let name = ours(net);
            if !MARKS.iter().any(|m| net.contains(m)) && !out.via.contains(&name) {
                out.via.push(name);
            }
        } else {
            out.logic_ns = round(out.logic_ns + delay);
            out.hops += 1;
        }
    }
    out.hops = out.hops.saturating_sub(2);
    let cell = |at: Option<&Value>| at.and_then(|s| s["to"]["cell"].as_str()).map(ours).unwrap_or_default();
    (out.from, out.to) = (cell(path.first()), cell(path.last()));
    out.via.retain(|v| *v != out.from && *v != out.to);
    out
}

#[cfg(test)]
mod tests {
    use super::{critical, ours};
    use serde_json::json;

    #[test]
    fn names_are_ours() {
        assert_eq!(ours("u_unit.s1_sum_TRELLIS_FF_Q_12"), "s1_sum");
        assert_eq!(ours("u_unit.s1_sum[5]"), "s1_sum");
        assert_eq!(ours("a_rank2[0]"), "a_rank2");
    }

    #[test]
    fn a_path_has_two_ends() {
        let step = |kind: &str, net: &str, cell: &str, delay: f64| json!({"type": kind, "net": net, "to": {"cell": cell}, "delay": delay});
        let path = vec![
            step("clk-to-q", "", "a_rank2_TRELLIS_FF_Q", 0.4),
            step("routing", "a_rank2[3]", "x", 1.0),
            step("logic", "", "x", 0.2),
            step("routing", "u_unit.s0_sum[1]", "u_unit.s1_sum_TRELLIS_FF_Q", 0.6),
            step("setup", "", "u_unit.s1_sum_TRELLIS_FF_Q", 0.1),
        ];
        let c = critical(&json!({"critical_paths": [{"from": "posedge clk", "to": "posedge clk", "path": path}]}));
        assert_eq!((c.from.as_str(), c.to.as_str(), c.via, c.hops), ("a_rank2", "s1_sum", vec!["s0_sum".into()], 1));
        assert_eq!((c.logic_ns, c.routing_ns), (0.7, 1.6));
    }
}
