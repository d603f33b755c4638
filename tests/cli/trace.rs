//! `trace`: the same bytes from every engine.
use super::{engines, run, said};
use crate::budget::share;

/// Traces a file of rays with each of the engines and returns what all of them wrote.
fn same_bytes(rays: &str, engines: &[&str], sets: &[&str]) -> String {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("r.csv"), rays).unwrap();
    let sets: Vec<&str> = sets.iter().flat_map(|s| ["--set", s]).collect();
    let mut all = Vec::new();
    for e in engines {
        // Few registers: a harness of many takes long to compile.
        let out = run(
            dir.path(),
            &[&["trace", "--profile", "published", "--rays", "r.csv", "--engine", e, "--out", "h.csv"], &sets[..]]
                .concat(),
        );
        assert_eq!(out.status.code(), Some(0), "{e}: {}", String::from_utf8_lossy(&out.stderr));
        all.push(std::fs::read_to_string(dir.path().join("h.csv")).unwrap());
    }
    assert!(all.iter().all(|h| h == &all[0]), "{sets:?}: {all:?}");
    let refined = if sets.contains(&"mode.bilinear=true") { ",bi,bj,bu,bv,bt,patch" } else { "" };
    let header = all[0].lines().next();
    assert_eq!(header, Some(format!("ray,i,j,u,v,t,steps,crossings,ups,wall,limit{refined}").as_str()));
    assert_eq!(all[0].lines().count(), rays.lines().count());
    all.remove(0)
}

#[test]
fn engines_write_the_same_bytes() {
    same_bytes(
        "u,v,du,dv\n0.1,0.2,0.3,-0.4\n0.99999999,0.5,-1.5,0.25\n0.5,0.5,0,0\n0.3,0.3,20,0\n",
        &engines(),
        &["traverse.levels=6"],
    );
}

/// Refined hits stand beside the same block hits as without a refinement; rays that end above, below and nowhere are among them.
#[test]
fn engines_write_the_same_bytes_with_the_refinement() {
    let mut rays = "u,v,du,dv\n0.1,0.2,0.3,-0.4\n0.99999999,0.5,-1.5,0.25\n0.5,0.5,0,0\n0.3,0.3,20,0\n".to_string();
    for k in 0..60 {
        let turn = f64::from(k) * 0.61803;
        rays += &format!("{:.6},{:.6},{:.6},{:.6}\n", turn.fract(), (turn * 1.7).fract(), turn.sin() * 3.0, turn.cos());
    }
    let sets = ["traverse.levels=5", "map.kind=spikes", "mode.bilinear=true"];
    let plain = same_bytes(&rays, &["golden"], &sets[..2]);
    let refined = same_bytes(&rays, &engines(), &sets);
    let mut words = std::collections::BTreeSet::new();
    for (a, b) in plain.lines().zip(refined.lines()).skip(1) {
        let cells: Vec<&str> = b.split(',').collect();
        assert_eq!(cells.len(), 17, "{b}");
        assert_eq!(a, cells[..11].join(","));
        let block = [cells[1], cells[2], cells[3], cells[4], cells[5]];
        assert_eq!(cells[16] != "hit", cells[11..16] == block, "{b}");
        words.insert(cells[16].to_owned());
    }
    assert_eq!(words.into_iter().collect::<Vec<_>>(), ["above", "below", "hit", "none"]);
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("r.csv"), &rays).unwrap();
    let (code, text) = said(dir.path(), &["list", "--set", "mode.bilinear=true"]);
    assert_eq!(code, Some(0));
    for unit in ["bilinear_window", "patch_memory", "surface_gap", "secant_step", "bilinear_hit"] {
        assert!(text.contains(unit), "{unit} is missing in:\n{text}");
    }
}

/// Rays with finest levels of their own, one above the root; and the same hits as without a trim, in fewer iterations.
#[test]
fn engines_write_the_same_bytes_with_trim_and_level_of_detail() {
    let mut rays =
        "u,v,du,dv,lod\n0.1,0.2,0.3,-0.4,0\n0.99999999,0.5,-1.5,0.25,2\n0.5,0.5,0,0,1\n0.3,0.3,20,0,0\n".to_string();
    for k in 0..60 {
        let turn = f64::from(k) * 0.61803;
        rays += &format!(
            "{:.6},{:.6},{:.6},{:.6},{}\n",
            turn.fract(),
            (turn * 1.7).fract(),
            turn.sin() * 3.0,
            turn.cos(),
            k % 8
        );
    }
    // In the usual run each datapath once, and both trims.
    for (kind, trim) in
        [("watertight", "always"), ("fixed", "always"), ("fixed", "descent")].into_iter().step_by(share(2))
    {
        let kind = format!("datapath.kind={kind}");
        let of = |trim: &str, engines: &[&str]| {
            let mode = format!("mode.trim={trim}");
            same_bytes(&rays, engines, &[&kind, "mode.lod=true", &mode, "traverse.levels=5"])
        };
        let (plain, trimmed) = (of("none", &["golden"]), of(trim, &engines()));
        // ray, i, j, u, v, t; then steps, crossings and ups; then wall and limit.
        let place = |row: &str| {
            row.split(',').enumerate().filter(|(k, _)| !(6..9).contains(k)).map(|c| c.1.to_owned()).collect::<Vec<_>>()
        };
        assert!(plain.lines().map(place).eq(trimmed.lines().map(place)), "{kind} {trim}");
        let steps = |text: &str| {
            text.lines().skip(1).map(|l| l.split(',').nth(6).unwrap().parse::<u32>().unwrap()).sum::<u32>()
        };
        assert!(steps(&trimmed) < steps(&plain), "{kind} {trim}: {} of {}", steps(&trimmed), steps(&plain));
    }
}

#[test]
fn rays_without_a_hit_are_told() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("far.csv"), "u,v,du,dv\n0.5,0.5,100,0.2\n").unwrap();
    let args = ["trace", "--engine", "golden", "--rays", "far.csv", "--out", "h.csv"];
    let (code, text) = said(dir.path(), &args);
    assert_eq!(code, Some(5), "{text}");
    assert!(text.contains("1 of 1 can't be traced by this design"), "{text}");
    std::fs::write(dir.path().join("two.csv"), "u,v,du,dv\n0.5,0.5,100,0.2\n0.5,0.5,0.1,0.2\n").unwrap();
    let args = ["trace", "--engine", "golden", "--rays", "two.csv", "--out", "h.csv"];
    let (code, text) = said(dir.path(), &args);
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("1 of 2 can't be traced by this design"), "{text}");
}
