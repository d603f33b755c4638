//! What README and `docs/traverse.md` promise: README is one screen, its links lead somewhere and its instance elaborates; of the guide, its bench prints what it says, its table lists the ports, its ray hits there.
use crate::simulators::skip;
use reliefrtl::config::Config;
use reliefrtl::units::traversal::traverse;
use std::path::{Path, PathBuf};
use std::process::Command;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn guide() -> String {
    std::fs::read_to_string(root().join("docs/traverse.md")).expect("the guide is text")
}

/// The one block of a language.
fn block(language: &str) -> String {
    let text = guide();
    let opening = format!("```{language}\n");
    assert_eq!(text.matches(&opening).count(), 1, "one block of {language}");
    let (_, rest) = text.split_once(&opening).expect("counted");
    rest.split_once("```\n").expect("the block ends").0.to_owned()
}

/// README, CONTRIBUTING and the pages of docs.
fn pages() -> Vec<PathBuf> {
    let docs = std::fs::read_dir(root().join("docs")).expect("a directory").map(|e| e.expect("an entry").path());
    let docs = docs.filter(|p| p.extension().is_some_and(|e| e == "md"));
    docs.chain(["README.md", "CONTRIBUTING.md"].map(|p| root().join(p))).collect()
}

#[test]
fn the_readme_is_one_screen_and_its_links_lead_somewhere() {
    let text = std::fs::read_to_string(root().join("README.md")).expect("text");
    assert!(text.lines().count() <= 90, "{} lines", text.lines().count());
    let mut links = 0;
    for page in pages() {
        let text = std::fs::read_to_string(&page).expect("text");
        for target in text.split("](").skip(1).filter_map(|rest| rest.split_once(')')).map(|(target, _)| target) {
            let file = target.split('#').next().unwrap_or_default();
            let there = file.is_empty() || file.contains("://") || page.parent().expect("a folder").join(file).exists();
            assert!(there, "{}: {target} leads nowhere", page.display());
            links += 1;
        }
    }
    assert!(links > 60, "{links} links");
}

/// Files of ours between backquotes, from the top or from `src/`; what has a `<part>` in it stands for several.
#[test]
fn files_that_pages_name_are_there() {
    let mut named = 0;
    for page in pages() {
        let text = std::fs::read_to_string(&page).expect("text");
        for file in text.lines().flat_map(|line| line.split('`').skip(1).step_by(2)) {
            let ours = file.contains('/') && file.ends_with(".rs") && !file.contains(['<', '*', ' ']);
            let there = ["", "src"].iter().any(|from| root().join(from).join(file).exists());
            assert!(!ours || there, "{}: there is no {file}", page.display());
            named += usize::from(ours);
        }
    }
    assert!(named > 40, "{named} files");
}

#[test]
fn the_instance_of_the_readme_elaborates() {
    if skip() {
        return;
    }
    let readme = std::fs::read_to_string(root().join("README.md")).expect("text");
    let (_, rest) = readme.split_once("```verilog\n").expect("an instance");
    let instance = rest.split_once("```\n").expect("the block ends").0;
    let module = traverse(&Config::default().design()).module;
    let net = |p: &reliefrtl::ir::Port| {
        // A net has the name of its port, without `out_` where that is no handshake.
        let pin = format!(".{}(", p.name);
        let (_, rest) = instance.split_once(&pin).unwrap_or_else(|| panic!("the instance connects no {}", p.name));
        format!(
            "wire [{}:0] {};\n",
            p.width.eval(&module.default_binding()) - 1,
            rest.split_once(')').expect("closed").0
        )
    };
    let nets: String = module.ports.iter().map(net).collect();
    let dir = tempfile::tempdir().expect("a temporary directory");
    let source = dir.path().join("top.v");
    std::fs::write(&source, format!("module top;\n{nets}{instance}endmodule\n")).expect("writable");
    let mut c = Command::new("iverilog");
    let out =
        c.args(["-g2005", "-Wall", "-y", "rtl", "-s", "top", "-t", "null"]).arg(&source).current_dir(root()).output();
    let out = out.expect("Icarus Verilog is not installed: run `sh tools/test.sh`, or set RELIEFRTL_NO_SIMULATORS=1");
    let said = String::from_utf8_lossy(&out.stderr).into_owned() + &String::from_utf8_lossy(&out.stdout);
    assert!(out.status.success() && said.is_empty(), "{said}");
}

#[test]
fn the_bench_prints_what_the_guide_says() {
    if skip() {
        return;
    }
    let dir = tempfile::tempdir().expect("a temporary directory");
    let (source, program) = (dir.path().join("one_ray.v"), dir.path().join("one_ray.vvp"));
    std::fs::write(&source, block("verilog")).expect("writable");
    let missing = "Icarus Verilog is not installed: run `sh tools/test.sh`, or set RELIEFRTL_NO_SIMULATORS=1";
    let run = |c: &mut Command| {
        let out = c.current_dir(root()).output().expect(missing);
        let said = String::from_utf8_lossy(&out.stderr).into_owned();
        assert!(out.status.success() && said.is_empty(), "{c:?}: {said}");
        String::from_utf8(out.stdout).expect("text")
    };
    let mut compile = Command::new("iverilog");
    run(compile.args(["-g2005", "-Wall", "-y", "rtl", "-o"]).args([&program, &source]));
    assert_eq!(run(Command::new("vvp").arg("-n").arg(&program)), block("text"));
}

#[test]
fn the_table_lists_the_ports() {
    let module = traverse(&Config::default().design()).module;
    let text = guide();
    let rows = text.lines().skip_while(|l| !l.starts_with("| port |")).skip(2).take_while(|l| l.starts_with('|'));
    let first = |row: &str| row.split('|').nth(1).unwrap_or_default().to_owned();
    let mut listed: Vec<String> = rows
        .flat_map(|r| first(r).split(',').map(|n| n.trim().trim_matches('`').to_owned()).collect::<Vec<_>>())
        .collect();
    let mut ports: Vec<String> = module.ports.iter().map(|p| p.name.clone()).collect();
    listed.sort();
    ports.sort();
    assert_eq!(listed, ports);
}

#[test]
fn the_ray_hits_where_the_guide_says() {
    let dir = tempfile::tempdir().expect("a temporary directory");
    let (rays, hits) = (dir.path().join("ray.csv"), dir.path().join("hit.csv"));
    let row = "0.25,0.5,1.5,0.75";
    assert!(guide().contains(&format!("`{row}`")));
    std::fs::write(&rays, format!("u,v,du,dv\n{row}\n")).expect("writable");
    for engine in ["golden", "interp"] {
        let mut c = Command::new(env!("CARGO_BIN_EXE_reliefrtl"));
        c.args(["trace", "--engine", engine, "--rays"]).arg(&rays).arg("--out").arg(&hits);
        let out = c.output().expect("the program is built");
        assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
        assert_eq!(std::fs::read_to_string(&hits).expect("written"), block("csv"), "{engine}");
    }
}
