//! The published tables (PIDM-HW tables 2, 3, 4) beside ours, cell by cell, and the claims they carry.
use super::measurement::Measurement;
use super::plan::Plan;
use super::table::{Table, real};
use crate::config::modes::{BEST, PLAIN, PUBLISHED_ROWS as ROWS};
use crate::config::{DatapathConfig, MapKind, ModeConfig, View};
use crate::measure::PUBLISHED;
use serde_json::{Value, json};

/// Table 2: probability of a node crossing in per cent; scene, then [10] and [12] for front, oblique, grazing.
const CROSSINGS: [(&str, [[f64; 2]; 3]); 4] = [
    ("rocks", [[22.4, 19.2], [54.5, 36.9], [76.4, 47.9]]),
    ("stones", [[3.8, 3.7], [17.9, 15.0], [51.5, 36.1]]),
    ("four", [[8.5, 8.1], [39.7, 28.3], [58.1, 37.9]]),
    ("saints", [[5.9, 5.5], [27.5, 21.6], [62.1, 39.8]]),
];
/// Table 3: iterations for 1 to 4 levels down, Rocks.
const DOWNS: [[f64; 3]; 4] = [[11.5, 19.7, 37.9], [8.9, 18.2, 37.8], [8.4, 18.2, 38.0], [9.6, 19.1, 42.7]];
/// What the paper claims its three ideas save against [10] and [12], in per cent.
const CLAIMS: [(usize, &str, f64, f64); 2] = [(0, "[10]", 16.0, 65.0), (1, "[12]", 5.0, 66.0)];

/// The measured cell of a published map: the usual datapath at 7/16 in `mode`.
fn ours<'a>(measurements: &'a [Measurement], scene: &str, view: View, mode: &ModeConfig) -> Option<&'a Measurement> {
    measurements.iter().find(|c| {
        let (m, d) = (&c.spec.map, &c.spec.design);
        let design =
            d.kind == DatapathConfig::default().kind && (d.exp, d.man) == (Some(7), Some(16)) && d.mode == *mode;
        m.kind == MapKind::File && m.name == scene && c.spec.view == view.word() && design
    })
}

/// All compared cells; empty without the maps.
pub fn table(measurements: &[Measurement]) -> Table {
    let mut t = Table::new(
        "published",
        &[
            ("table", "table"),
            ("scene", "scene"),
            ("row", "row"),
            ("view", "view"),
            ("published", "published"),
            ("ours", "ours"),
            ("ratio", "ours / published"),
        ],
    );
    let mut add = |table: &str, scene: &str, row: &str, view: View, published: Option<f64>, ours: f64| {
        let ratio = published.map_or(Value::Null, |p| real(ours / p));
        let published = published.map_or(Value::Null, real);
        t.push(vec![json!(table), json!(scene), json!(row), json!(view.word()), published, real(ours), ratio]);
    };
    for (scene, rows) in CROSSINGS {
        for (v, view) in View::ALL.iter().enumerate() {
            for (k, row) in ["[10]", "[12]"].iter().enumerate() {
                if let Some(c) = ours(measurements, scene, *view, &ROWS[k].1) {
                    let share = 100.0 * c.crossings_mean / c.steps_mean;
                    add("2: crossings, %", scene, row, *view, Some(rows[v][k]), share);
                }
            }
        }
    }
    for (n, means) in (1..).zip(DOWNS) {
        let mode = ModeConfig { levels_down: n, ..PLAIN };
        for (v, view) in View::ALL.iter().enumerate() {
            if let Some(c) = ours(measurements, "rocks", *view, &mode) {
                add("3: levels down", "rocks", &format!("n = {n}"), *view, Some(means[v]), c.steps_mean);
            }
        }
    }
    for p in &PUBLISHED {
        for (r, (row, mode)) in ROWS.iter().enumerate() {
            for (v, view) in View::ALL.iter().enumerate() {
                if let Some(c) = ours(measurements, p.scene, *view, mode) {
                    add("4: iterations", p.scene, row, *view, p.means[r][v], c.steps_mean);
                }
            }
        }
    }
    t
}

/// What a + b + c1 saves, cell by cell, published and measured.
pub fn claims(plan: &Plan, measurements: &[Measurement]) -> Table {
    let mut t = Table::new(
        "claims",
        &[
            ("scene", "scene"),
            ("view", "view"),
            ("against", "against"),
            ("claim", "claim"),
            ("published", "published, %"),
            ("ours", "ours, %"),
            ("holds", "ours within the claim"),
        ],
    );
    for p in PUBLISHED.iter().filter(|p| plan.maps.iter().any(|s| s.file.is_some() && s.spec.name == p.scene)) {
        for (v, view) in View::ALL.iter().enumerate() {
            for (row, against, low, high) in CLAIMS {
                let saved = |now: f64, before: f64| 100.0 * (1.0 - now / before);
                let published = p.means[6][v].zip(p.means[row][v]).map(|(now, before)| saved(now, before));
                let now = ours(measurements, p.scene, *view, &BEST).map(|c| c.steps_mean);
                let before = ours(measurements, p.scene, *view, &ROWS[row].1).map(|c| c.steps_mean);
                let Some((now, before)) = now.zip(before) else { continue };
                let measured = saved(now, before);
                // The claim is given in whole per cent.
                let holds = (low..=high).contains(&measured.round());
                let verdict = match (holds, measured < low) {
                    (true, _) => "yes",
                    (false, true) => "no: saves less",
                    (false, false) => "no: saves more",
                };
                t.push(vec![
                    json!(p.scene),
                    json!(view.word()),
                    json!(against),
                    json!(format!("{low:.0}–{high:.0} %")),
                    published.map_or(Value::Null, real),
                    real(measured),
                    json!(verdict),
                ]);
            }
        }
    }
    t
}

/// One sentence a claim: in how many cells it holds.
pub fn claim_words(claims: &Table) -> Vec<String> {
    let word = |(_, against, low, high): &(usize, &str, f64, f64)| {
        let mine: Vec<_> = claims.rows.iter().filter(|r| r[2] == *against).collect();
        let holds = mine.iter().filter(|r| r[6] == "yes").count();
        let saved = |k: usize| mine.iter().filter_map(move |r| r[k].as_f64());
        let (least, most) = (saved(5).fold(f64::INFINITY, f64::min), saved(5).fold(f64::NEG_INFINITY, f64::max));
        format!(
            "Claimed: {low:.0}–{high:.0} % fewer iterations than {against}. Ours: {least:.1} to {most:.1} %; inside the claim in {holds} of {} cells.",
            mine.len()
        )
    };
    if claims.rows.is_empty() { Vec::new() } else { CLAIMS.iter().map(word).collect() }
}
