//! The table of registers in `docs/units.md` is that of the configuration, and each value of their keys brings one.
//! `RELIEFRTL_REFRESH=1 cargo test --release --test repo registers` writes it anew.
use reliefrtl::config::Register;
use reliefrtl::config::keys::{KEYS, Legal};
use std::path::Path;

const REFRESH: &str = "RELIEFRTL_REFRESH=1 cargo test --release --test repo registers";
const BEGIN: &str = "<!-- registers: written by `RELIEFRTL_REFRESH=1 cargo test --release --test repo registers` -->\n";
const END: &str = "<!-- end of registers -->\n";

fn table() -> String {
    let row = |r: Register| {
        let f = r.facts();
        format!("| `latency.{}` | {} | {} |\n", f.key, f.from, f.between)
    };
    let rows: String = Register::ALL.into_iter().map(row).collect();
    format!("| key | from | a register between |\n| --- | --- | --- |\n{rows}")
}

#[test]
fn the_page_of_units_lists_the_registers() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/units.md");
    let text = std::fs::read_to_string(&file).unwrap();
    let (before, rest) = text.split_once(BEGIN).expect("docs/units.md marks where the registers begin");
    let (there, after) = rest.split_once(END).expect("docs/units.md marks where the registers end");
    if std::env::var_os("RELIEFRTL_REFRESH").is_some() {
        std::fs::write(&file, format!("{before}{BEGIN}{}{END}{after}", table())).unwrap();
        return;
    }
    assert_eq!(there, table(), "the registers of docs/units.md have drifted: refresh them with `{REFRESH}`");
}

#[test]
fn each_value_of_a_key_of_registers_brings_one() {
    let mut listed = Register::ALL.map(|r| (r.facts().key, r.facts().from)).to_vec();
    assert!(listed.is_sorted(), "by key and value: {listed:?}");
    // Of a divider the clocks are its own: a register beside it has a value of that key, too.
    listed.retain(|(key, _)| *key != "div");
    listed.dedup();
    for key in ["decision", "hit", "memory", "node", "select", "setup"] {
        let legal = KEYS.iter().find(|k| k.path == format!("latency.{key}")).unwrap().legal;
        let Legal::Whole(least, most) = legal else { panic!("latency.{key} is no number") };
        let mine: Vec<i64> = listed.iter().filter(|r| r.0 == key).map(|r| i64::from(r.1)).collect();
        assert_eq!(mine, (least + 1..=most).collect::<Vec<i64>>(), "latency.{key}");
        listed.retain(|r| r.0 != key);
    }
    assert!(listed.is_empty(), "{listed:?} are of another key");
}
