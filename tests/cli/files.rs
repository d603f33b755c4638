//! How files and directories are written: whole or not at all, and nobody else's are touched.
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
