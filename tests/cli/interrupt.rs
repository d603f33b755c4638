//! An ended run leaves nothing: no half a tree, no temporary directory, no program that it started; killed, nothing after the next run.
#![cfg(unix)]
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// Waits until something is so.
fn until(what: &str, mut is_so: impl FnMut() -> bool) {
    let start = Instant::now();
    while !is_so() {
        assert!(start.elapsed() < Duration::from_secs(60), "{what}: not within a minute");
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// Hidden names in a directory.
fn hidden(dir: &Path) -> Vec<String> {
    let entries = fs::read_dir(dir).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap());
    entries.filter(|name| name.starts_with(".reliefrtl-tmp-")).collect()
}

fn kill(signal: &str, process: &Child) {
    assert!(Command::new("kill").args([signal, &process.id().to_string()]).status().unwrap().success());
}

/// Processes whose environment holds this mark.
fn marked(mark: &str) -> Vec<String> {
    let of = |pid: &Path| {
        let environment = fs::read(pid.join("environ")).ok()?;
        let is_marked = environment.split(|b| *b == 0).any(|v| v == format!("MARK={mark}").as_bytes());
        // One that is dead and not yet waited for is no orphan.
        let status = fs::read_to_string(pid.join("status")).ok()?;
        let dead = status.lines().any(|l| l.starts_with("State:") && (l.contains('Z') || l.contains('X')));
        let words = fs::read(pid.join("cmdline")).ok()?;
        (is_marked && !dead)
            .then(|| format!("{} {}", pid.display(), String::from_utf8_lossy(&words).replace('\0', " ")))
    };
    fs::read_dir("/proc").unwrap().flatten().filter_map(|e| of(&e.path())).collect()
}

/// A directory for a run, and one for its temporary files.
struct Place {
    dir: tempfile::TempDir,
    mark: String,
}

impl Place {
    fn new() -> Self {
        let dir = tempfile::tempdir().unwrap();
        fs::create_dir(dir.path().join("tmp")).unwrap();
        let mark = dir.path().file_name().unwrap().to_string_lossy().into_owned();
        Self { dir, mark }
    }

    fn tmp(&self) -> PathBuf {
        self.dir.path().join("tmp")
    }

    fn command(&self, args: &[&str]) -> Command {
        // Under `nohup` the tests ignore SIGHUP, and so would the program: `env` takes that back, and becomes the program.
        let mut c = Command::new("env");
        c.args(["--default-signal=HUP", env!("CARGO_BIN_EXE_reliefrtl")]);
        c.args(args).current_dir(self.dir.path()).env("TMPDIR", self.tmp()).env("MARK", &self.mark);
        // What is kept built would be over before a signal meets it.
        c.env_remove("RELIEFRTL_BUILDS");
        c.stdout(Stdio::null()).stderr(Stdio::null());
        c
    }

    /// A simulator that never ends, with a child in its own group that never ends either, as `make` has compilers.
    fn sleeper(&self) -> PathBuf {
        let path = self.dir.path().join("sleeper");
        let text = "#!/bin/sh\necho > started\nsleep 1000 &\nsleep 1000\nwait\n";
        fs::write(&path, text).unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
        path
    }

    /// One whose first act is to kill whoever started it; a child in its own group never ends.
    fn killer(&self) -> PathBuf {
        let path = self.dir.path().join("killer");
        fs::write(&path, "#!/bin/sh\nsleep 1000 &\nkill -9 $PPID\nsleep 1000\n").unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
        path
    }

    /// Waits until the sleeper runs, with its child, in another directory than those that are `left` of a run before.
    fn sleeps(&self, left: &[String]) {
        until("the simulator starts", || {
            let started = |name: &String| !left.contains(name) && self.tmp().join(name).join("started").exists();
            hidden(&self.tmp()).iter().any(started)
                && marked(&self.mark).iter().filter(|p| p.contains("sleep 1000")).count() >= 2
        });
    }

    fn nothing_runs(&self, when: &str) {
        let start = Instant::now();
        while !marked(&self.mark).is_empty() {
            assert!(
                start.elapsed() < Duration::from_secs(60),
                "{when}: after a minute there are {:?}",
                marked(&self.mark)
            );
            std::thread::sleep(Duration::from_millis(5));
        }
    }
}

const CHECK: [&str; 7] = ["check", "--engine", "verilator", "--unit", "lzc", "--set", "vectors.arithmetic=20"];

#[test]
fn a_signal_ends_simulators_and_removes_directories() {
    for (signal, code) in [("-INT", 130), ("-TERM", 143), ("-HUP", 129), ("-TERM", 143), ("-INT", 130)] {
        let place = Place::new();
        let mut check = place.command(&CHECK).env("VERILATOR", place.sleeper()).spawn().unwrap();
        place.sleeps(&[]);
        kill(signal, &check);
        let start = Instant::now();
        assert_eq!(check.wait().unwrap().code(), Some(code), "{signal}");
        assert!(start.elapsed() < Duration::from_secs(10), "{signal} took {:?}", start.elapsed());
        assert_eq!(hidden(&place.tmp()), [""; 0], "{signal}");
        place.nothing_runs(signal);
    }
}

#[test]
fn killed_it_takes_its_simulators_along_and_the_next_run_cleans_up() {
    for _ in 0..3 {
        let place = Place::new();
        let mut check = place.command(&CHECK).env("VERILATOR", place.sleeper()).spawn().unwrap();
        place.sleeps(&[]);
        check.kill().unwrap();
        assert_eq!(check.wait().unwrap().signal(), Some(9));
        place.nothing_runs("SIGKILL");
        let left = hidden(&place.tmp());
        assert!(!left.is_empty());
        // One of a living process stays.
        let mut living = place.command(&CHECK).env("VERILATOR", place.sleeper()).spawn().unwrap();
        place.sleeps(&left);
        let before = hidden(&place.tmp());
        assert!(before.iter().all(|name| !left.contains(name)), "what a dead run left is gone");
        let next = ["check", "--engine", "interp", "--unit", "lzc", "--set", "vectors.arithmetic=20"];
        assert!(place.command(&next).status().unwrap().success());
        assert_eq!(hidden(&place.tmp()), before, "what a living run uses stays");
        assert!(!before.is_empty());
        kill("-INT", &living);
        assert_eq!(living.wait().unwrap().code(), Some(130));
        assert_eq!(hidden(&place.tmp()), [""; 0]);
    }
}

/// Killed before it has heard that the program runs: no other process can say what to end.
#[test]
fn killed_while_it_starts_a_program_it_takes_that_along() {
    for _ in 0..20 {
        let place = Place::new();
        let killed = place.command(&CHECK).env("VERILATOR", place.killer()).status().unwrap();
        assert_eq!(killed.signal(), Some(9));
        place.nothing_runs("SIGKILL by the program");
    }
}

/// With the real one, wherever the signal meets it.
#[test]
fn verilator_itself_leaves_nothing() {
    if !super::engines().contains(&"verilator") {
        return;
    }
    let check = ["check", "--engine", "verilator", "--set", "vectors.arithmetic=20", "--set", "vectors.planned=false"];
    let place = Place::new();
    for (signal, after) in [("-INT", 1500), ("-TERM", 2500), ("-KILL", 2000), ("-KILL", 3500), ("-INT", 3500)] {
        let mut run = place.command(&check).spawn().unwrap();
        std::thread::sleep(Duration::from_millis(after));
        kill(signal, &run);
        let ended = run.wait().unwrap();
        assert!(ended.code().is_some_and(|c| c == 130 || c == 143) || ended.signal() == Some(9), "{signal}: {ended}");
        place.nothing_runs(signal);
    }
    assert!(place.command(&["check", "--unit", "lzc", "--set", "vectors.arithmetic=20"]).status().unwrap().success());
    assert_eq!(hidden(&place.tmp()), [""; 0]);
}

/// A tree on its way is met when a file of it can't be written yet: the program is stopped there by a pipe without a reader.
#[test]
fn a_run_that_waits_for_a_reader_ends_at_a_signal() {
    for (signal, code) in [("-INT", 130), ("-TERM", 143)] {
        let place = Place::new();
        let dir = place.dir.path();
        fs::write(dir.join("r.csv"), "u,v,du,dv\n0.1,0.2,0.5,0.25\n").unwrap();
        assert!(Command::new("mkfifo").arg(dir.join("p")).status().unwrap().success());
        let args = ["trace", "--rays", "r.csv", "--out", "p", "--set", "traverse.levels=3"];
        let mut trace = place.command(&args).spawn().unwrap();
        let waits = |pid: u32| fs::read_to_string(format!("/proc/{pid}/wchan")).unwrap_or_default();
        let start = Instant::now();
        while !waits(trace.id()).contains("pipe")
            && !waits(trace.id()).contains("fifo")
            && start.elapsed() < Duration::from_secs(3)
        {
            std::thread::sleep(Duration::from_millis(10));
        }
        assert_eq!(trace.try_wait().unwrap(), None, "it waits for a reader");
        kill(signal, &trace);
        let start = Instant::now();
        assert_eq!(trace.wait().unwrap().code(), Some(code));
        assert!(start.elapsed() < Duration::from_secs(10));
        assert_eq!(hidden(dir), [""; 0]);
    }
}

/// The tree is staged beside its place before the work begins, so that a signal meets it there.
#[test]
fn an_interrupted_build_leaves_nothing() {
    for (signal, code) in [("-INT", Some(130)), ("-TERM", Some(143)), ("-KILL", None)] {
        let place = Place::new();
        let dir = place.dir.path();
        let mut build = place.command(&["build", "--set", "vectors.arithmetic=20000"]).spawn().unwrap();
        until("the tree is begun", || !hidden(dir).is_empty());
        kill(signal, &build);
        assert_eq!(build.wait().unwrap().code(), code);
        assert!(!dir.join("out").exists());
        if signal == "-KILL" {
            assert_eq!(hidden(dir).len(), 1);
            let small = ["emit", "--unit", "lzc"];
            assert!(place.command(&small).status().unwrap().success());
        }
        assert_eq!(hidden(dir), [""; 0], "{signal}");
    }
}

#[test]
fn codes_of_signals_are_documented() {
    let help = Command::new(env!("CARGO_BIN_EXE_reliefrtl")).arg("--help").output().unwrap();
    let help = String::from_utf8(help.stdout).unwrap();
    assert!(!help.contains('\u{1b}'), "colours are for terminals: {help}");
    let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/cli.md")).unwrap();
    for code in ["129", "130", "143"] {
        assert!(help.contains(code) && page.contains(code), "{code}");
    }
}
