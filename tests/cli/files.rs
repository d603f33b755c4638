//! How files and directories are written: whole or not at all, and no others are touched.
use reliefrtl::error::Error;
use reliefrtl::files::{MANIFEST, OutDir, Part, write_atomic};
use std::fs;
use std::path::Path;

fn sentence<T: std::fmt::Debug>(result: Result<T, Error>) -> String {
    let error = result.expect_err("it must be refused");
    assert_eq!(error.exit_code(), 2);
    error.to_string()
}

#[test]
fn files_appear_whole() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("a.txt");
    write_atomic(&path, b"one").unwrap();
    write_atomic(&path, b"two").unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"two");
    assert_eq!(names(directory.path()), ["a.txt"], "nothing is left beside it");
    let missing = directory.path().join("no/a.txt");
    assert_eq!(
        sentence(write_atomic(&missing, b"x")),
        format!("cannot write {}: {} is not a directory", missing.display(), directory.path().join("no").display())
    );
    assert_eq!(
        sentence(write_atomic(directory.path(), b"x")),
        format!("cannot write {}: it is a directory", directory.path().display())
    );
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let mode = fs::metadata(&path).unwrap().permissions().mode();
        assert_eq!(mode & 0o400, 0o400);
        assert_eq!(mode & 0o111, 0);
    }
}

fn names(directory: &Path) -> Vec<String> {
    let mut names: Vec<_> =
        fs::read_dir(directory).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

fn emit(target: &Path, files: &[(&str, &str)]) -> Result<usize, Error> {
    let mut out = OutDir::new(target)?;
    for (path, text) in files {
        out.add(path, text.as_bytes())?;
    }
    Ok(out.commit()?.len())
}

#[test]
fn a_directory_appears_whole_and_is_replaced_whole() {
    let directory = tempfile::tempdir().unwrap();
    let target = directory.path().join("deep/out");
    assert_eq!(emit(&target, &[("a.v", "a"), ("sub/b.v", "b")]).unwrap(), 2);
    assert_eq!(names(&target), [MANIFEST, "a.v", "sub"]);
    emit(&target, &[("a.v", "a2"), ("c.v", "c")]).unwrap();
    assert_eq!(names(&target), [MANIFEST, "a.v", "c.v"], "what is not generated any more is gone");
    assert_eq!(fs::read(target.join("a.v")).unwrap(), b"a2");
    assert_eq!(names(&directory.path().join("deep")), ["out"], "nothing is left beside it");
    // Given up half way: nothing changed.
    let mut out = OutDir::new(&target).unwrap();
    out.add("a.v", b"a3").unwrap();
    drop(out);
    assert_eq!(fs::read(target.join("a.v")).unwrap(), b"a2");
    assert_eq!(names(&directory.path().join("deep")), ["out"]);
}

#[test]
fn files_of_other_origin_stay() {
    let directory = tempfile::tempdir().unwrap();
    let target = directory.path().join("out");
    emit(&target, &[("a.v", "a"), ("b.v", "b"), ("old/c.v", "c"), ("old/d.v", "d")]).unwrap();
    fs::write(target.join("notes.txt"), "mine").unwrap();
    fs::write(target.join("b.v"), "b, edited").unwrap();
    let edited = sentence(emit(&target, &[("b.v", "b2")]));
    assert!(edited.contains("b.v was edited since it was generated and would be overwritten"), "{edited}");
    emit(&target, &[("a.v", "a2"), ("new/e.v", "e")]).unwrap();
    assert_eq!(
        names(&target),
        [MANIFEST, "a.v", "b.v", "new", "notes.txt"],
        "edited and foreign files stay, the rest is gone"
    );
    let taken = sentence(emit(&target, &[("notes.txt", "generated")]));
    assert!(
        taken.ends_with(
            "notes.txt was not generated here and would be overwritten: move it away or choose another output directory"
        ),
        "{taken}"
    );
    assert_eq!(fs::read(target.join("notes.txt")).unwrap(), b"mine");
    assert_eq!(fs::read(target.join("a.v")).unwrap(), b"a2", "refused before anything was moved");
    for path in ["../x", "/x", "", "a/../../x", MANIFEST] {
        assert_eq!(
            sentence(emit(&target, &[(path, "x")])),
            format!("{path:?} is not a place inside the output directory")
        );
    }
    let file = directory.path().join("file");
    fs::write(&file, "").unwrap();
    assert_eq!(
        sentence(emit(&file, &[])),
        format!("cannot write into {}: it is a file, not a directory", file.display())
    );
    let below = sentence(emit(&file.join("out"), &[]));
    assert!(below.starts_with("cannot create "), "{below}");
}

fn write(target: &Path, part: Part, files: &[(&str, &str)]) -> Result<usize, Error> {
    let mut out = OutDir::part(target, part)?;
    for (path, text) in files {
        out.add(path, text.as_bytes())?;
    }
    Ok(out.commit()?.len())
}

/// What writes a part leaves the rest alone, if it comes from the same configuration.
#[test]
fn parts_make_one_tree() {
    let directory = tempfile::tempdir().unwrap();
    let target = directory.path().join("out");
    let part = |config: &str, replaces| Part { config: config.into(), replaces, alone_in: &[] };
    write(&target, part("1", &["rtl/", "list"]), &[("rtl/a.v", "a"), ("rtl/b.v", "b"), ("list", "a b")]).unwrap();
    write(&target, part("1", &["golden/"]), &[("golden/a.hex", "a"), ("golden/b.hex", "b")]).unwrap();
    write(&target, part("1", &["golden/b.hex"]), &[("golden/b.hex", "b2")]).unwrap();
    assert_eq!(names(&target), [MANIFEST, "golden", "list", "rtl"]);
    assert_eq!(names(&target.join("golden")), ["a.hex", "b.hex"]);
    write(&target, part("1", &["rtl/", "list"]), &[("rtl/a.v", "a2"), ("list", "a")]).unwrap();
    assert_eq!(names(&target.join("rtl")), ["a.v"], "of what this run replaces, the rest is gone");
    let before = fs::read(target.join(MANIFEST)).unwrap();
    let other = sentence(write(&target, part("2", &["rtl/", "list"]), &[("rtl/a.v", "x"), ("list", "x")]));
    assert!(other.contains("holds golden/a.hex of another configuration"), "{other}");
    let alone = Part { config: "1".into(), replaces: &[], alone_in: &["rtl/", "list"] };
    let crowded = sentence(write(&target, alone.clone(), &[("rtl/c.v", "c"), ("list", "c")]));
    assert!(crowded.contains("holds rtl/a.v of another run, which the new manifest would not list"), "{crowded}");
    assert_eq!(fs::read(target.join(MANIFEST)).unwrap(), before, "refused before anything was moved");
    // The whole tree goes where it is written whole; then another configuration is as good.
    emit(&target, &[("rtl/a.v", "y")]).unwrap();
    assert_eq!(names(&target), [MANIFEST, "rtl"]);
    write(&target, Part { config: "3".into(), ..alone }, &[("rtl/a.v", "z")]).unwrap();
    assert_eq!(names(directory.path()), ["out"]);
}

/// Whatever lies in an output directory that no run of ours has listed is neither opened nor followed; what is in the way is named.
#[cfg(unix)]
#[test]
fn nothing_foreign_is_opened() {
    use std::os::unix::fs::symlink;
    let directory = tempfile::tempdir().unwrap();
    let target = directory.path().join("out");
    emit(&target, &[("a.v", "a"), ("sub/b.v", "b")]).unwrap();
    let fifo = |name: &str| {
        assert!(std::process::Command::new("mkfifo").arg(target.join(name)).status().unwrap().success());
    };
    fifo("p");
    fifo("sub/p");
    // 40 GB that take no room: read, they would take a minute.
    fs::File::create(target.join("huge")).unwrap().set_len(40 << 30).unwrap();
    symlink("/dev/zero", target.join("endless")).unwrap();
    symlink("..", target.join("up")).unwrap();
    let start = std::time::Instant::now();
    emit(&target, &[("a.v", "a2"), ("sub/b.v", "b2")]).unwrap();
    assert!(start.elapsed() < std::time::Duration::from_secs(10));
    assert_eq!(fs::read(target.join("sub/b.v")).unwrap(), b"b2");
    assert_eq!(names(&target), [MANIFEST, "a.v", "endless", "huge", "p", "sub", "up"]);
    // An edited one of ours that has grown is told by its size.
    fs::OpenOptions::new().write(true).open(target.join("a.v")).unwrap().set_len(40 << 30).unwrap();
    let grown = sentence(emit(&target, &[("a.v", "a3")]));
    assert!(grown.contains("a.v was edited since it was generated"), "{grown}");
    fs::write(target.join("a.v"), "a2").unwrap();
    assert!(start.elapsed() < std::time::Duration::from_secs(10));
    for (path, what, is) in [
        ("p", "out/p", "a FIFO"),
        ("up/x.v", "out/up", "a link"),
        ("endless", "out/endless", "a link"),
        ("sub", "out/sub", "a directory"),
    ] {
        let told = sentence(emit(&target, &[("a.v", "a4"), (path, "x")]));
        assert!(told.contains(&format!("{what} is {is}")), "{told}");
        assert_eq!(fs::read(target.join("a.v")).unwrap(), b"a2", "refused before anything was moved");
    }
    assert_eq!(names(directory.path()), ["out"], "nothing was written above");
    // Even where the list itself says so: paths that leave the directory, links in the place of files, a list that is none.
    fs::write(directory.path().join("outside"), "x").unwrap();
    let digest = blake3::hash(b"x").to_hex();
    fs::write(target.join(MANIFEST), format!("{digest} 1 ../outside\n{digest} 1 up/outside\n{digest} 1 p\n")).unwrap();
    emit(&target, &[("c.v", "c")]).unwrap();
    assert!(directory.path().join("outside").exists() && target.join("p").exists());
    fs::remove_file(target.join(MANIFEST)).unwrap();
    fifo(MANIFEST);
    let told = sentence(emit(&target, &[("d.v", "d")]));
    assert!(told.contains(".reliefrtl-files is a FIFO"), "{told}");
    assert_eq!(names(directory.path()), ["out", "outside"]);
}

/// A mount point and a directory in one that can't be written are filled file by file; one that can't be written at all is told at once.
#[cfg(target_os = "linux")]
#[test]
fn a_mount_point_is_written_in_place() {
    let directory = tempfile::tempdir().unwrap();
    let (target, inner) = (directory.path().join("out"), directory.path().join("bound"));
    fs::create_dir_all(target.join("sub")).unwrap();
    fs::create_dir_all(&inner).unwrap();
    let mount = |args: &[&str], at: &Path| {
        std::process::Command::new("mount").args(args).arg(at).output().is_ok_and(|o| o.status.success())
    };
    let unmount = |at: &Path| assert!(std::process::Command::new("umount").arg(at).status().unwrap().success());
    /// Leaves nothing mounted, however the test ends.
    struct Unmounted(std::path::PathBuf);
    impl Drop for Unmounted {
        fn drop(&mut self) {
            for at in [self.0.join("sub"), self.0.clone(), self.0.clone()] {
                let _ = std::process::Command::new("umount").arg("-lq").arg(at).output();
            }
        }
    }
    let _unmounted = Unmounted(target.clone());
    let written = |target: &Path| {
        emit(target, &[("a.v", "a"), ("sub/b.v", "b")]).unwrap();
        emit(target, &[("a.v", "a2"), ("sub/c.v", "c")]).unwrap();
        assert_eq!(names(target), [MANIFEST, "a.v", "sub"]);
        assert_eq!(names(&target.join("sub")), ["c.v"]);
    };
    // Where mounting is not allowed, what stands for it is a place that can't be renamed: the working directory's way is the same.
    if mount(&["-t", "tmpfs", "tmpfs"], &target) {
        written(&target);
        // Another file system inside: the rename goes over its border.
        assert!(mount(&["-t", "tmpfs", "tmpfs"], &target.join("sub")));
        fs::remove_file(target.join(MANIFEST)).unwrap();
        fs::remove_file(target.join("a.v")).unwrap();
        written(&target);
        unmount(&target.join("sub"));
        unmount(&target);
        // A directory of the same file system, bound to its place.
        assert!(mount(&["--bind", inner.to_str().unwrap()], &target));
        written(&target);
        unmount(&target);
        assert!(mount(&["-t", "tmpfs", "-o", "ro", "tmpfs"], &target));
        let told = sentence(OutDir::new(&target));
        assert!(told.contains("cannot write into") && told.contains("ead-only file"), "{told}");
        let told = sentence(write_atomic(target.join("x"), b"x"));
        assert!(told.contains("ead-only file"), "{told}");
        let told = sentence(OutDir::new(target.join("new")));
        assert!(told.contains("ead-only file"), "{told}");
        // A directory that can be written in one that can't.
        unmount(&target);
        assert!(mount(&["--bind", target.to_str().unwrap()], &target));
        assert!(mount(&["-t", "tmpfs", "tmpfs"], &target.join("sub")));
        assert!(mount(&["-o", "remount,ro,bind"], &target));
        assert!(fs::write(target.join("x"), "").is_err());
        written(&target.join("sub"));
        unmount(&target.join("sub"));
        unmount(&target);
    } else {
        eprintln!("not allowed to mount: only a directory of its own is tried");
        written(&inner);
    }
}
