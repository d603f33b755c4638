//! Every unit in the interpreter against the golden model.
use super::{FORMATS, SETS, design};
use reliefrtl::catalogue::{bindings, check_interp, units, vector_set};
use reliefrtl::config::Profile;
use reliefrtl::ir::Binding;
use reliefrtl::vectors::Plan;

#[test]
fn units_equal_their_models_at_three_widths_and_five_sets() {
    let mut checked = 0;
    for (k, set) in SETS.into_iter().enumerate() {
        let (f, w) = FORMATS[k % FORMATS.len()];
        let mut d = design(f, w, set);
        d.latency = Profile::ALL[k % 3].latency(d.datapath.kind);
        for m in units(&d) {
            for b in std::iter::once(Binding::new()).chain(bindings(&d, &m)) {
                let set = vector_set(&d, &m, &b, Plan { rows: 1000, seed: 7 });
                let report = check_interp(&m, &set).unwrap();
                assert!(report.checked > 0, "{}", m.name);
                report.verdict(&set, &m).unwrap_or_else(|e| panic!("{e} (at {b:?})"));
                checked += report.checked;
            }
        }
    }
    println!("0 of {checked} mismatched (seed 7)");
    assert!(checked > 150_000, "only {checked} rows were checked");
}

/// The arithmetic of planes is small enough for all words.
#[test]
fn small_numbers_exhaustively() {
    let mut d = design(8, 8, "1 2@2");
    (d.traverse.levels, d.traverse.tile_bits, d.traverse.height_bits) = (2, 1, 2);
    for name in ["window_texel", "window_address"] {
        let m = reliefrtl::catalogue::find(&d, name).unwrap();
        let set = vector_set(&d, &m, &Binding::new(), Plan { rows: 1, seed: 1 });
        let report = check_interp(&m, &set).unwrap();
        assert!(report.checked > 60, "{name}: {}", report.checked);
        report.verdict(&set, &m).unwrap();
    }
}
