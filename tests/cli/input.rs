//! Bad input: one sentence, exit code 2, nothing left.
use super::{refused, said};
use std::process::Command;

#[test]
fn bad_input_gets_one_sentence() {
    refused(&["build", "--map", "broken.png"], "broken.png: not a readable PNG");
    refused(&["build", "--set", "format.expp=3"], "unknown key format.expp (--set): did you mean format.exp?");
    refused(&["build", "--set", "format.exp=1"], "format.exp = 1 is too small: 2 to 8 are legal");
    refused(&["build", "--set", "traverse.levels=13"], "traverse.levels = 13 is too large: 2 to 12 are legal");
    refused(&["trace", "--rays", "miss.csv", "--out", "h.csv"], "no column dv");
    refused(&["trace", "--rays", "let.csv", "--out", "h.csv"], "column v: \"x\" is not a number");
    refused(&["emit", "--unit", "traverze"], "did you mean traverse?");
    refused(&["emit", "--unit", "qqqq"], "no unit is named qqqq (`reliefrtl list` shows all)");
    refused(&["build", "--set", "xx.yy=3"], "unknown key xx.yy (--set): `reliefrtl config --print` shows all");
    refused(&["render", "--view", "side"], "none of front, oblique, grazing");
}

#[test]
fn an_output_never_replaces_an_input() {
    let dir = tempfile::tempdir().unwrap();
    let rays = "u,v,du,dv\n0.5,0.5,0.1,0.2\n";
    std::fs::write(dir.path().join("r.csv"), rays).unwrap();
    let (code, text) = said(dir.path(), &["trace", "--engine", "golden", "--rays", "r.csv", "--out", "./r.csv"]);
    assert_eq!(code, Some(2), "{text}");
    assert!(text.contains("would replace the input"), "{text}");
    assert_eq!(std::fs::read_to_string(dir.path().join("r.csv")).unwrap(), rays);
    let (code, _) = said(dir.path(), &["render", "--engine", "golden", "--out", "m.png", "--set", "view.stride=16"]);
    assert_eq!(code, Some(0));
    let before = std::fs::read(dir.path().join("m.png")).unwrap();
    let again = ["render", "--engine", "golden", "--map", "m.png", "--resample", "--out", "m.png"];
    assert_eq!(said(dir.path(), &again).0, Some(2));
    assert_eq!(std::fs::read(dir.path().join("m.png")).unwrap(), before);
}

/// What would wait for whoever is at its other end is refused, of every option that names an input.
#[cfg(unix)]
#[test]
fn an_input_is_a_regular_file() {
    let dir = tempfile::tempdir().unwrap();
    let fifo = |name: &str| assert!(Command::new("mkfifo").arg(dir.path().join(name)).status().unwrap().success());
    ["p", "p.toml", "p.csv", "p.json", "p.png"].iter().for_each(|name| fifo(name));
    std::fs::create_dir(dir.path().join("d.toml")).unwrap();
    let trace = ["trace", "--out", "h.csv"];
    let inputs: [(&[&str], &str, &str); 10] = [
        (&["list", "--config", "p.toml"], "p.toml", "a FIFO"),
        (&["list", "--config", "/dev/zero"], "/dev/zero", "a device"),
        (&["list", "--config", "d.toml"], "d.toml", "a directory"),
        (&["build", "--map", "p.png"], "p.png", "a FIFO"),
        (&["build", "--set", "map.kind=file", "--set", "map.file=/dev/zero"], "/dev/zero", "a device"),
        (&[&trace[..], &["--rays", "p.csv"]].concat(), "p.csv", "a FIFO"),
        (&[&trace[..], &["--rays", "/dev/tty"]].concat(), "/dev/tty", "a device"),
        (&[&trace[..], &["--view", "p.toml"]].concat(), "p.toml", "a FIFO"),
        (&["report", "--synth", "p.json"], "p.json", "a FIFO"),
        (&["synth", "--stale", "p.json"], "p.json", "a FIFO"),
    ];
    for (args, name, is) in inputs {
        let (code, text) = said(dir.path(), args);
        assert_eq!(code, Some(2), "{args:?}: {text}");
        assert!(text.contains(&format!("cannot read {name}: it is {is}, name a ")), "{args:?}: {text}");
    }
    // What is open already may be anything.
    let piped = |args: &[&str], bytes: &[u8]| {
        let (reader, mut writer) = std::io::pipe().unwrap();
        std::io::Write::write_all(&mut writer, bytes).unwrap();
        drop(writer);
        let mut c = Command::new(env!("CARGO_BIN_EXE_reliefrtl"));
        let out = c.args(args).current_dir(dir.path()).stdin(reader).output().unwrap();
        (out.status.code(), String::from_utf8_lossy(&out.stderr).into_owned())
    };
    let levels = ["--set", "traverse.levels=3"];
    let rays = b"\xef\xbb\xbfu,v,du,dv\n0.5,0.5,0.1,0.2\n";
    assert_eq!(piped(&[&trace[..], &["--rays", "/dev/stdin"], &levels].concat(), rays), (Some(0), String::new()));
    let toml = b"\xef\xbb\xbf[traverse]\nlevels = 99\n";
    let (code, text) = piped(&["list", "--config", "/dev/stdin"], toml);
    assert!(code == Some(2) && text.contains("traverse.levels = 99") && text.contains("line 2"), "{text}");
}

/// Of every verb and every output.
#[test]
fn no_output_replaces_any_input() {
    let dir = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(dir.path().join(name), text).unwrap();
    let files = [
        ("c.toml", "[traverse]\nlevels = 3\n"),
        ("r.vcd", "u,v,du,dv\n0.5,0.5,0.1,0.2\n"),
        ("m.lib", "library(x) {}\n"),
    ];
    files.iter().for_each(|(name, text)| write(name, text));
    let config = ["--config", "c.toml"];
    let cases: [&[&str]; 5] = [
        &["fit", "--set", "map.kind=flat", "--max-uv-error", "1", "--out", "c.toml"],
        &["trace", "--rays", "r.vcd", "--out", "h.csv", "--wave", "r.vcd"],
        &["trace", "--rays", "r.vcd", "--out", "c.toml"],
        &["synth", "--unit", "lzc", "--liberty", "m.lib", "--out", "./m.lib"],
        &["synth", "--unit", "lzc", "--target", "ice40", "--out", "c.toml"],
    ];
    for args in cases {
        let (code, text) = said(dir.path(), &[args, &config].concat());
        assert!(code == Some(2) && text.contains("would replace the input of that name"), "{args:?}: {text}");
    }
    for (name, text) in files {
        assert_eq!(std::fs::read_to_string(dir.path().join(name)).unwrap(), text);
    }
}

/// What is wrong, what would be right, and where; no number of hundreds of digits.
#[test]
fn a_sentence_says_what_is_right_and_where() {
    let dir = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &[u8]| std::fs::write(dir.path().join(name), text).unwrap();
    write("m.asc", format!("ncols 8\nnrows 8\n{}", "1e-300 ".repeat(64)).as_bytes());
    write("c.toml", b"[map]\nkind = \"file\"\nfile = \"\"\n");
    write("cut.tif", b"II*\0\x08\0");
    std::fs::create_dir(dir.path().join("empty")).unwrap();
    let tree = "name a tree that `build` wrote";
    let map = ["build", "--map", "m.asc", "--set", "traverse.levels=3"];
    write("whole.toml", b"[traverse]\nlevels = 10.0\n");
    write("nul.toml", b"[map]\nfile = \"a\\u0000b\"\n");
    write("semi.csv", b"u;v;du;dv\n0,1;0;0;0\n");
    write("tab.csv", b"u\tv\tdu\tdv\n0\t0\t0\t0\n");
    let most = "rays are more than 10000000, the most at once";
    let cases: [(&[&str], &[&str]); 20] = [
        (&["trace", "--out", "h.csv", "--rays="], &["--rays", "it names no file and no number"]),
        (&["synth", "--unit", "lzc", "--beside", "top="], &["--beside top=: write TOP=DIR"]),
        (&["hard", "--rays", "18446744073709551615"], &["18446744073709551615", most]),
        (&["bench", "--rays", "99999999999999999999999"], &["99999999999999999999999", most]),
        (&["hard", "--endure", "18446744073709551615"], &["rays of each case, more than 10000000, the most at once"]),
        (&["list", "--config", "whole.toml"], &["traverse.levels = 10.0 is not a whole number"]),
        (&["list", "--config", "nul.toml"], &["map.file = \"a\\0b\" has a NUL in it", "nul.toml, line 2"]),
        (&["trace", "--out", "h.csv", "--rays", "semi.csv"], &["no column u", "by commas, not by semicolons"]),
        (&["trace", "--out", "h.csv", "--rays", "tab.csv"], &["no column u", "by commas, not by tabs"]),
        (&["check", "--dir", "nodir"], &["--dir nodir is not there", tree]),
        (&["check", "--dir", "m.asc"], &["--dir m.asc is no directory", tree]),
        (&["check", "--dir", "empty"], &["--dir empty holds no directory golden", tree]),
        (&["prove", "--dir", "nodir"], &["--dir nodir is not there", tree]),
        (&["list", "--set", "map.range="], &["map.range has no value (--set): [low, high]", "none takes it back"]),
        (&["list", "--set", "map.file="], &["map.file has no value (--set): a path", "none takes it back"]),
        (&["list", "--set", "traverse.levels="], &["traverse.levels = \"\" is not a whole number"]),
        (&["list", "--set", "map.range=1e-320,0"], &["map.range = [1e-320, 0] is no range"]),
        (&["list", "--config", "c.toml"], &["map.file is empty: a path is legal (c.toml, line 3)"]),
        (&["build", "--map", "cut.tif"], &["cut.tif: not a readable TIFF: its data end early"]),
        (
            &[&map[..], &["--set", "map.range=0,1e-320"]].concat(),
            &["is 1e-300: map.range = [0, 1e-320]", "--set map.range=auto"],
        ),
    ];
    for (args, parts) in cases {
        let (code, text) = said(dir.path(), args);
        assert_eq!(code, Some(2), "{args:?}: {text}");
        parts.iter().for_each(|part| assert!(text.contains(part), "{args:?}: {part:?} is not in {text}"));
        assert!(text.lines().filter(|l| !l.is_empty()).count() <= 2 && text.len() < 400, "{args:?}: {text}");
    }
    let (code, text) = said(dir.path(), &[&map[..], &["--set", "map.range=0,2e-300", "--print-map"]].concat());
    assert!(code == Some(0) && text.contains("heights 1e-300 to 1e-300 (range 0 to 2e-300)"), "{text}");
}

/// Text files may begin with a byte order mark; text in another code is refused by its name.
#[test]
fn a_byte_order_mark_is_no_text() {
    let dir = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(dir.path().join(name), format!("\u{feff}{text}")).unwrap();
    write("c.toml", "[traverse]\nlevels = 3\n");
    write("camera.toml", "elevation = 40\nwidth = 8\nheight = 8\n");
    write("r.csv", "u,v,du,dv\n0.5,0.5,0.1,0.2\n");
    write("m.asc", &format!("ncols 8\nnrows 8\n{}", "0.5 ".repeat(64)));
    write("f.json", "[]");
    let trace = ["trace", "--config", "c.toml", "--out", "h.csv", "--engine", "golden"];
    let map = ["--map", "m.asc", "--set", "map.range=0,1"];
    for more in [&["--rays", "r.csv"], &["--view", "camera.toml"]] {
        let (code, text) = said(dir.path(), &[&trace[..], &map, more].concat());
        assert_eq!(code, Some(0), "{more:?}: {text}");
    }
    let (code, text) = said(dir.path(), &["synth", "--stale", "f.json"]);
    assert_eq!(code, Some(0), "{text}");
    let wide: Vec<u8> = "\u{feff}[traverse]".encode_utf16().flat_map(u16::to_le_bytes).collect();
    std::fs::write(dir.path().join("c.toml"), wide).unwrap();
    let (code, text) = said(dir.path(), &["list", "--config", "c.toml"]);
    assert!(code == Some(2) && text.contains("c.toml is not UTF-8 text: it looks like UTF-16"), "{text}");
}
