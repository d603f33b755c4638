//! `map.border`: what lies beyond the map's border, against maps that were continued by hand.
use crate::run;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use reliefrtl::config::{Border, Config, DatapathKind};
use reliefrtl::golden::{Pyramid, RayHit, encode_ray};
use reliefrtl::scene::border::{entered, own_place, own_texel, prepared};
use reliefrtl::trace::{saw_border, trace_golden};

/// The map's own levels.
const OWN: u32 = 4;
const SIDE: i64 = 1 << OWN;

fn map(seed: u64) -> Vec<u32> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    (0..SIDE * SIDE).map(|_| rng.random_range(0..=255) >> rng.random_range(0..4)).collect()
}

/// Rays in tiles of the map whose numbers are short: any scaling by two and any shift by quarters is exact.
fn rays(count: usize) -> Vec<[f64; 4]> {
    let mut rng = ChaCha8Rng::seed_from_u64(9);
    let mut number = |low: i32, high: i32| f64::from(rng.random_range(low..high)) / 1024.0;
    (0..count).map(|_| [number(0, 1024), number(0, 1024), number(-2200, 2200), number(-2200, 2200)]).collect()
}

/// Texel (unwrapped, in texels of the map) and parameter of rays over a field that `height` gives for any texel: traced on a map of
/// 16 x 16 tiles with the given map's origin in the middle, where no ray comes near the border.
fn by_hand(c: &Config, texels: &[u32], rays: &[[f64; 4]], own: fn(i64) -> i64) -> Vec<([i64; 2], u64)> {
    let mut d = c.design();
    d.traverse.levels = OWN + 4;
    let (side, middle) = (SIDE << 4, SIDE << 3);
    let at = |k: i64| own(k - middle);
    let field: Vec<u32> = (0..side * side).map(|k| texels[(at(k / side) * SIDE + at(k % side)) as usize]).collect();
    let pyramid = Pyramid::build(d.traverse.levels, 8, &field).unwrap();
    let words: Vec<_> = rays
        .iter()
        .map(|[u, v, du, dv]| encode_ray(&d, [u / 16.0 + 0.5, v / 16.0 + 0.5, du / 16.0, dv / 16.0]))
        .collect();
    let hits = trace_golden(&d, &pyramid, &words).unwrap();
    hits.iter().map(|h| ([h.i, h.j].map(|x| i64::from(x) - middle), h.t)).collect()
}

fn by_border(c: &Config, border: Border, texels: &[u32], rays: &[[f64; 4]]) -> Vec<(RayHit, bool)> {
    let d = c.design();
    let pyramid = Pyramid::build(OWN + 1, 8, &prepared(border, OWN, texels.to_vec())).unwrap();
    let inside: Vec<[f64; 4]> = rays.iter().map(|r| entered(border, *r)).collect();
    let words: Vec<_> = inside.iter().map(|r| encode_ray(&d, *r)).collect();
    let hits = trace_golden(&d, &pyramid, &words).unwrap();
    hits.into_iter().zip(&inside).map(|(h, r)| (h, saw_border(&d, border, r, &h))).collect()
}

fn config(kind: DatapathKind) -> Config {
    let mut c = Config::default();
    c.datapath.kind = kind;
    c.traverse.levels = OWN + 1;
    c
}

#[test]
fn borders_equal_maps_continued_by_hand() {
    let mirror = |k: i64| k.rem_euclid(2 * SIDE).min(2 * SIDE - 1 - k.rem_euclid(2 * SIDE));
    let clamp = |k: i64| k.clamp(0, SIDE - 1);
    let (texels, rays) = (map(3), rays(3000));
    type Folds = fn(i64) -> i64;
    let cases: [(Border, Folds); 2] = [(Border::Mirror, mirror), (Border::Clamp, clamp)];
    for (border, own) in cases {
        let c = config(DatapathKind::Watertight);
        let (got, expected) = (by_border(&c, border, &texels, &rays), by_hand(&c, &texels, &rays, own));
        let (mut beyond, mut over) = (0, 0);
        for (k, ((h, seen), (texel, t))) in got.iter().zip(&expected).enumerate() {
            // Half a side of the map on each side, of a border that is clamped.
            let inside = |x: &i64| border != Border::Clamp || (-SIDE / 2..SIDE + SIDE / 2).contains(x);
            assert_eq!(*seen, texel.iter().all(inside), "{border} ray {k}: {texel:?}");
            over += usize::from(texel.iter().any(|x| !(0..SIDE).contains(x)));
            if *seen {
                assert_eq!(h.t, *t, "{border} ray {k}");
                let at = [h.i, h.j].map(|x| i64::from(own_texel(border, OWN + 1, x)));
                assert_eq!(at, texel.map(own), "{border} ray {k}");
                let place = own_place(border, (f64::from(h.i) + 0.5) / f64::from(2 << OWN)) * SIDE as f64;
                let clamped = (place.floor() as i64).clamp(0, SIDE - 1);
                assert_eq!(clamped, at[0], "{border} ray {k}");
            } else {
                beyond += 1;
            }
        }
        println!("{border}: {over} of 3000 rays end beyond the border, {beyond} further than was prepared");
        assert!(over > 500 && (beyond > 20) == (border == Border::Clamp), "{over} {beyond}");
    }
}

#[test]
fn the_command_line() {
    let dir = tempfile::tempdir().unwrap();
    // One texel at the left border is high.
    let mut pgm = b"P5\n4 4\n255\n".to_vec();
    pgm.extend((0..16).map(|k| if k % 4 == 0 { 255u8 } else { 0 }));
    std::fs::write(dir.path().join("m.pgm"), pgm).unwrap();
    std::fs::write(dir.path().join("r.csv"), "u,v,du,dv\n0.5,0.5,-0.625,0\n0.5,0.5,1,0\n0.5,0.5,2,0\n0.5,0.5,0,0\n")
        .unwrap();
    let base = ["--map", "m.pgm", "--rays", "r.csv", "--out", "h.csv", "--set", "traverse.levels=3"];
    let trace = |border: &str, engine: &str| {
        let set = format!("map.border={border}");
        let args = [&["trace", "--engine", engine, "--set", &set][..], &base].concat();
        let (code, told, error) = run(dir.path(), &args);
        assert_eq!(code, 0, "{told}{error}");
        (std::fs::read_to_string(dir.path().join("h.csv")).unwrap(), told)
    };
    for border in ["mirror", "clamp"] {
        let (table, told) = trace(border, "golden");
        assert_eq!(table, trace(border, "interp").0);
        let lines: Vec<Vec<&str>> = table.lines().skip(1).map(|l| l.split(',').collect()).collect();
        let texels: Vec<(&str, &str)> = lines.iter().map(|l| (l[1], l[3])).collect();
        // Toward the left the high texel stands in the map itself, whatever comes after: the last place
        // in front of it is its own, 1 - 2^-12 texels. Straight down there is texel 2.
        assert_eq!((texels[0], texels[3]), (("0", "0.24993896484375"), ("2", "0.5")), "{border}: {table}");
        if border == "mirror" {
            // Texels 2 3 | 3 2 1 0: the far one's side is met at u = 1.75, which shows the place 0.25.
            assert_eq!(texels[2], ("0", "0.25"), "{table}");
            assert!(!told.contains("beyond"), "{told}");
        } else {
            // The plain goes on: one ray ends at u = 1.5, where the preparation ends.
            assert_eq!((lines[1][10], lines[2][10]), ("1", "1"), "{table}");
            assert!(told.contains("2 of 4 go on more than half a side beyond"), "{told}");
        }
    }
    let clamp = ["render", "--set", "map.border=clamp"];
    let (code, _, told) = run(dir.path(), &[&clamp[..], &["--set", "map.repeat=2"]].concat());
    assert!(code == 2 && told.contains("exclude each other"), "{told}");
    let (code, _, told) = run(dir.path(), &[&clamp[..], &["--map", "m.pgm"]].concat());
    assert!(code == 2 && told.contains("needs 128 x 128: use --set traverse.levels=3"), "{told}");
    std::fs::write(dir.path().join("r.csv"), "u,v,du,dv\n1.5,0.5,1,0\n").unwrap();
    let (code, _, told) = run(dir.path(), &[&["trace", "--set", "map.border=clamp"][..], &base].concat());
    assert!(code == 2 && told.contains("ray 0 enters at u = 1.5"), "{told}");
    let (code, _, told) = run(dir.path(), &["steps", "--scenes", "x", "--set", "map.border=mirror"]);
    assert!(code == 2 && told.contains("the published maps repeat"), "{told}");
    let (code, told, _) =
        run(dir.path(), &[&clamp[..], &["--view", "grazing", "--engine", "golden", "--set", "view.stride=8"]].concat());
    assert!(code == 0 && told.contains("are left out"), "{told}");
}
