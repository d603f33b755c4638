//! The figures of `data/figures.json`: of the text that is emitted now, and the ones that the documents show.
//! `RELIEFRTL_REFRESH=1 cargo test --release --test report tables` writes the tables of the documents anew.
use reliefrtl::config::Config;
use reliefrtl::measured::{Entry, all};
use reliefrtl::synth::digest;
use reliefrtl::units::traversal::traverse;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn stale(file: &Path) -> (Option<i32>, String) {
    let mut c = Command::new(env!("CARGO_BIN_EXE_reliefrtl"));
    let Output { status, stdout, stderr } =
        c.args(["synth", "--stale"]).arg(file).current_dir(root()).output().expect("the program runs");
    (status.code(), String::from_utf8_lossy(&stdout).into_owned() + &String::from_utf8_lossy(&stderr))
}

/// Emits the design of every figure.
#[test]
fn each_figure_is_of_the_text_that_is_emitted_now() {
    let (code, said) = stale(Path::new("data/figures.json"));
    assert_eq!(code, Some(0), "{said}");
    let measured = all().iter().filter(|e| e.digest.is_some()).count();
    assert!(said.contains(&format!("{measured} figures are of the text that is emitted now, 0 are not")), "{said}");
}

/// The clocks of the default tree were measured on the code that is committed; comments don't count, as for every figure.
#[test]
fn the_default_tree_was_placed_as_it_stands() {
    let design = Config::default().design();
    let code = digest(&traverse(&design).module, 1);
    let said = format!("whose code has the digest `{code}`");
    let text = std::fs::read_to_string(root().join("docs/clocks.md")).unwrap();
    assert!(text.contains(&said), "docs/clocks.md: place the tree again, sh flow/ecp5.sh 1 2 3; {code}");
}

/// A figure of another text is found, and the call that measures it again is named.
#[test]
fn a_figure_of_another_text_is_found() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("figures.json");
    let of = |digest: &str| {
        format!(
            r#"[{{"command":"reliefrtl synth --unit fp_lt --latency 1","unit":"fp_lt","latency":1,"target":"ecp5","digest":"{digest}"}}]"#
        )
    };
    std::fs::write(&file, of("0123456789abcdef0123456789abcdef")).unwrap();
    let (code, said) = stale(&file);
    assert_eq!(code, Some(1), "{said}");
    assert!(said.contains("reliefrtl synth --unit fp_lt --latency 1  # was measured on another text"), "{said}");
    assert!(said.contains("`reliefrtl synth --refresh "), "{said}");
    for (text, words) in [
        ("[{}]", "can't be made"),
        ("{", "is no list of figures"),
        (r#"[{"command":"reliefrtl synth --unit fp_lt,fp_add"}]"#, "not `reliefrtl synth` of one unit"),
        (r#"[{"command":"reliefrtl build"}]"#, "not `reliefrtl synth` of one unit"),
        (r#"[{"command":"reliefrtl synth --unit fp_ad","digest":"0"}]"#, "did you mean fp_add"),
    ] {
        std::fs::write(&file, text).unwrap();
        let (code, said) = stale(&file);
        assert!(code == Some(2) && said.contains(words), "{text}: {code:?} {said}");
    }
}

/// What was measured of a call, of the text that is emitted now.
fn figure(words: &str) -> Option<&'static Entry> {
    all().iter().find(|e| e.digest.is_some() && e.command == format!("reliefrtl synth {words}"))
}

/// The calls of units alone.
fn alone() -> Vec<&'static Entry> {
    let alone = |e: &&Entry| e.digest.is_some() && e.target == "ecp5" && e.unit != "traverse";
    all().iter().filter(alone).collect()
}

/// How a unit is called in a table.
fn name(e: &Entry) -> String {
    let table = e.command.contains("latency.divider=table");
    format!("`{}`{}", e.unit, if table { " by table" } else { "" })
}

fn mhz(e: &Entry) -> String {
    e.clock.as_ref().map_or("-".into(), |c| format!("{:.0}", c.median.floor()))
}

/// MHz of each seed.
fn seeds(e: &Entry) -> String {
    let clock = e.clock.as_ref().expect("a clock");
    clock.mhz.iter().map(|(seed, mhz)| format!("{seed}: {mhz:.1}")).collect::<Vec<_>>().join(", ")
}

/// The area of the same unit on Virtex-6.
fn virtex(e: &Entry) -> String {
    let call = e.command.trim_start_matches("reliefrtl synth ");
    figure(&format!("{call} --target xilinx")).map_or("-".into(), |x| format!("{} / {}", x.luts, x.multipliers))
}

fn units() -> String {
    let mut out = String::from(
        "| unit | L | ECP5 LUT4 / carry / mult / memory | ECP5 MHz (seeds) | Virtex-6 LUT / DSP |\n| --- | --- | --- | --- | --- |\n",
    );
    for e in alone() {
        let latency = e.latency.expect("arithmetic has a latency");
        let area = format!("{} / {} / {} / {}", e.luts, e.carries, e.multipliers, e.memories);
        out += &format!("| {} | {latency} | {area} | {} ({}) | {} |\n", name(e), mhz(e), seeds(e), virtex(e));
    }
    out
}

fn traversals() -> String {
    let mut out = String::from(
        "| `reliefrtl synth` | LUT4 / carry / mult / memory / LUT memory / FF | MHz (seeds) | critical path |\n| --- | --- | --- | --- |\n",
    );
    for e in all().iter().filter(|e| e.digest.is_some() && e.unit == "traverse") {
        let critical = &e.clock.as_ref().expect("a clock").critical;
        let area = [e.luts, e.carries, e.multipliers, e.memories, e.lut_memories, e.flip_flops].map(|n| n.to_string());
        let path = format!(
            "`{}` to `{}`: {:.1} ns cells, {:.1} ns wires",
            critical.from, critical.to, critical.logic_ns, critical.routing_ns
        );
        out +=
            &format!("| `{}` | {} | **{}** ({}) | {path} |\n", e.words().join(" "), area.join(" / "), mhz(e), seeds(e));
    }
    out
}

/// The table of the README: what stands in those of `docs/clocks.md`, in fewer words.
fn short() -> String {
    let mut out = String::from("| unit | L: ECP5 MHz | ECP5 LUT4 | Virtex-6 LUT / DSP |\n| --- | --- | --- | --- |\n");
    for (unit, more, latencies) in [
        ("fp_add", "", &[1, 2, 5, 8][..]),
        ("fp_mul", "", &[1, 2]),
        ("fp_lt", "", &[1, 2]),
        ("fp_div", "", &[4, 20]),
        ("fp_div", " --set latency.divider=table", &[4, 8]),
    ] {
        let of = |l: &u32| figure(&format!("--unit {unit} --latency {l}{more}")).map(|e| (*l, e));
        let found: Vec<_> = latencies.iter().filter_map(of).collect();
        let Some((_, first)) = found.first() else { continue };
        let row =
            |cell: fn(u32, &Entry) -> String| found.iter().map(|(l, e)| cell(*l, e)).collect::<Vec<_>>().join(", ");
        let clocks = row(|l, e| format!("{l}: {}", mhz(e)));
        out += &format!(
            "| {} | {clocks} | {} | {} |\n",
            name(first),
            row(|_, e| e.luts.to_string()),
            row(|_, e| virtex(e))
        );
    }
    let whole = |e: &&Entry| e.digest.is_some() && e.unit == "traverse";
    for e in all().iter().filter(whole) {
        let words = e.words();
        let call = words[2..].join(" ");
        out += &format!("| `traverse` `{call}` | {} ({}) | {} | - |\n", mhz(e), seeds(e), e.luts);
    }
    out
}

/// Holds (or, where it is asked for, writes) what stands between two marks of a document.
fn held(path: &str, mark: &str, table: &str) {
    let file: PathBuf = root().join(path);
    let text = std::fs::read_to_string(&file).unwrap();
    let begin = format!("<!-- {mark}: made of data/figures.json -->\n");
    let end = format!("<!-- end of {mark} -->");
    let at = text.find(&begin).unwrap_or_else(|| panic!("{path} has no line {begin}")) + begin.len();
    let to = at + text[at..].find(&end).unwrap_or_else(|| panic!("{path} has no line {end}"));
    if std::env::var("RELIEFRTL_REFRESH").is_ok_and(|v| v == "1") {
        std::fs::write(&file, format!("{}{table}{}", &text[..at], &text[to..])).unwrap();
        return;
    }
    assert_eq!(
        &text[at..to],
        table,
        "{path}: `RELIEFRTL_REFRESH=1 cargo test --release --test report tables` writes the table of {mark} anew"
    );
}

#[test]
fn the_documents_show_the_figures_that_were_measured() {
    held("docs/clocks.md", "units", &units());
    held("docs/clocks.md", "traversals", &traversals());
    held("README.md", "figures", &short());
}
