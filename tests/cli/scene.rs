//! Procedural maps, cameras, ray lists and pictures.
use reliefrtl::error::Error;
use reliefrtl::scene::{
    Camera, HeightMap, MapKind, Picture, ShadePoint, Shader, View, parse_rays, parse_table, procedural, to_codes,
};

fn sentence<T: std::fmt::Debug>(result: Result<T, Error>) -> String {
    let error = result.expect_err("it must be refused");
    assert_eq!(error.exit_code(), 2);
    error.to_string()
}

const NATURAL: [MapKind; 5] = [MapKind::Rocks, MapKind::Bricks, MapKind::Dunes, MapKind::Spikes, MapKind::Stairs];

fn map(kind: MapKind, levels: u32, seed: u64) -> HeightMap {
    procedural(kind, levels, seed).unwrap()
}

/// The digest pins every bit: a map that depends on the machine, the number of threads or the build would show here.
fn digest(kind: MapKind) -> String {
    let bytes: Vec<u8> = map(kind, 6, 1).samples.iter().flat_map(|height| height.to_le_bytes()).collect();
    blake3::hash(&bytes).to_hex()[..16].to_owned()
}

#[test]
fn natural_maps_fill_the_range_and_repeat_without_a_seam() {
    for kind in NATURAL {
        let one = map(kind, 8, 1);
        assert_eq!((one.width, one.height), (256, 256));
        let (low, high) = one.samples.iter().fold((1.0f64, 0.0f64), |(low, high), &h| (low.min(h), high.max(h)));
        assert_eq!((low, high), (0.0, 1.0), "{kind}");
        assert_eq!(one, map(kind, 8, 1), "{kind}");
        assert_eq!(one != map(kind, 8, 2), kind != MapKind::Stairs, "{kind}: the seed");
        // Across the seam the map changes no more than it does inside, on average.
        let step = |i: usize| (0..256).map(|j| (one.at(i, j) - one.at((i + 1) % 256, j)).abs()).sum::<f64>();
        let inside = (0..255).map(step).fold(0.0, f64::max);
        assert!(step(255) <= inside, "{kind}: {} > {inside}", step(255));
        let step = |j: usize| (0..256).map(|i| (one.at(i, j) - one.at(i, (j + 1) % 256)).abs()).sum::<f64>();
        let inside = (0..255).map(step).fold(0.0, f64::max);
        assert!(step(255) <= inside, "{kind}: {} > {inside}", step(255));
    }
}

#[test]
fn maps_are_equal_to_the_last_bit_everywhere() {
    let digests = NATURAL.map(|kind| format!("{kind} {}", digest(kind)));
    insta::assert_snapshot!(digests.join("\n"), @r"
    rocks 55359ef7f2263123
    bricks a13f61c3addff974
    dunes c3c1c5e469d9bb0d
    spikes 1b69667199dd1cd0
    stairs bf3c4e9b3a301241
    ");
}

#[test]
fn hard_cases() {
    let codes = |kind| to_codes(&map(kind, 3, 1), 3, 8, false).unwrap();
    assert_eq!(codes(MapKind::Flat), [128; 64]);
    let only =
        |kind, code| codes(kind).iter().enumerate().filter(|(_, c)| **c == code).map(|(at, _)| at).collect::<Vec<_>>();
    assert_eq!(only(MapKind::Spike, 255), [4 * 8 + 4]);
    assert_eq!(only(MapKind::Spike, 0).len(), 63);
    assert_eq!(only(MapKind::Pit, 0), [4 * 8 + 4]);
    assert_eq!(only(MapKind::Pit, 255).len(), 63);
    assert_eq!(codes(MapKind::Checker)[..10], [0, 255, 0, 255, 0, 255, 0, 255, 255, 0]);
    for levels in 2..=4 {
        for kind in NATURAL {
            assert_eq!(map(kind, levels, 1).samples.len(), 1 << (2 * levels));
        }
    }
    assert_eq!(sentence(procedural(MapKind::File, 3, 1)), "map.kind = \"file\" is read from an image, not made");
}

#[test]
fn the_standard_cameras() {
    let example = Camera::load(concat!(env!("CARGO_MANIFEST_DIR"), "/examples/camera.toml")).unwrap();
    assert_eq!(example, Camera::default());
    for view in [View::Front, View::Oblique, View::Grazing] {
        let rays = Camera::standard(view, 1024, 768).rays(20.0, 4, 4);
        assert!(rays.len() > 1000, "{view}: {}", rays.len());
        assert!(rays.is_sorted_by_key(|ray| (ray.py, ray.px)), "row by row");
        for ray in &rays {
            assert!((0.0..1.0).contains(&ray.u) && (0.0..1.0).contains(&ray.v), "{ray:?}");
            assert!(ray.du.is_finite() && ray.dv.is_finite() && ray.px % 4 == 0 && ray.py % 4 == 0);
        }
        assert_eq!(rays, Camera::standard(view, 1024, 768).rays(20.0, 4, 4));
    }
}

#[test]
fn a_ray_by_hand() {
    // From straight above, unturned: the picture's x axis is u, and up in the picture is +z, which is -v.
    let camera = Camera { elevation: 90.0, azimuth: 0.0, distance: 100.0, fov: 90.0, width: 2, height: 2 };
    let ray = camera.ray(1, 0, 20.0, 1).unwrap();
    // The pixel's centre is half the half picture out: direction (1/2, -1, 1/2), so it meets the plane at (50, 50).
    assert!((ray.u - 0.75).abs() < 1e-12 && (ray.v - 0.25).abs() < 1e-12, "{ray:?}");
    assert!((ray.du - 0.05).abs() < 1e-12 && (ray.dv + 0.05).abs() < 1e-12, "{ray:?}");
    // Four tiles: the entry point wraps, the way is four times as long.
    let ray = camera.ray(1, 0, 20.0, 4).unwrap();
    assert!(ray.u < 1e-9 || ray.u > 1.0 - 1e-9, "{ray:?}");
    assert!((ray.du - 0.2).abs() < 1e-12, "{ray:?}");
    // Looking up from the horizon, nothing is met.
    assert_eq!(Camera::standard(View::Grazing, 1024, 768).ray(512, 0, 20.0, 1), None);
    assert_eq!(camera.picture_size(2), (1, 1));
    assert_eq!(Camera::default().picture_size(3), (342, 256));
}

#[test]
fn the_published_geometry() {
    // The convention, once more, in plain floating point with the library's functions.
    for (view, e, a, distance) in
        [(View::Front, 90.0f64, 36.4f64, 200.0), (View::Oblique, 22.0, 36.4, 200.0), (View::Grazing, 3.0, 100.0, 240.0)]
    {
        let (se, ce, sa, ca) = (e.to_radians().sin(), e.to_radians().cos(), a.to_radians().sin(), a.to_radians().cos());
        let (f, r) = ([-sa * ce, -se, ca * ce], [ca, 0.0, sa]);
        let up = [f[1] * r[2] - f[2] * r[1], f[2] * r[0] - f[0] * r[2], f[0] * r[1] - f[1] * r[0]];
        let tan = 22.5f64.to_radians().tan();
        let mut met = 0;
        for (px, py) in [(512, 384), (100, 400), (900, 500), (300, 700)] {
            let x = (2.0 * (f64::from(px) + 0.5) / 1024.0 - 1.0) * tan * 1024.0 / 768.0;
            let y = (1.0 - 2.0 * (f64::from(py) + 0.5) / 768.0) * tan;
            let d: [f64; 3] = std::array::from_fn(|c| f[c] + x * r[c] + y * up[c]);
            let s = distance * f[1] / d[1];
            let (mx, mz) = (-distance * f[0] + s * d[0], -distance * f[2] + s * d[2]);
            let inside = mx.abs() < 100.0 && mz.abs() < 100.0 && d[1] < 0.0;
            let ray = Camera::standard(view, 1024, 768).ray(px, py, 10.0, 1);
            assert_eq!(ray.is_some(), inside, "{view} {px} {py}");
            if let Some(ray) = ray {
                met += 1;
                let expected = [mx / 200.0 + 0.5, 0.5 - mz / 200.0, 0.05 * d[0] / -d[1], -0.05 * d[2] / -d[1]];
                for (got, wanted) in [ray.u, ray.v, ray.du, ray.dv].into_iter().zip(expected) {
                    assert!((got - wanted).abs() < 1e-9, "{view} {px} {py}: {got} {wanted}");
                }
            }
        }
        assert!(met > 0, "{view}");
    }
}

#[test]
fn camera_files() {
    let camera = Camera::from_toml("elevation = 40\nfov = 30.5\nwidth = 320\n", "c.toml").unwrap();
    assert_eq!(camera, Camera { elevation: 40.0, fov: 30.5, width: 320, ..Camera::default() });
    let refused = |text| sentence(Camera::from_toml(text, "c.toml"));
    assert_eq!(refused("\nelevation = 0.05"), "elevation = 0.05 is too small: 0.1 to 90 are legal (c.toml, line 2)");
    let level = refused("\nelevation = 0");
    assert!(
        level.contains("the camera stands above the plane, at an elevation of 0.1 to 90 (c.toml, line 2)"),
        "{level}"
    );
    assert_eq!(refused("elevaton = 10"), "unknown key elevaton (c.toml, line 1): did you mean elevation?");
    assert_eq!(refused("fov = nan"), "fov = NaN is not a number: 1 to 170 are legal (c.toml, line 1)");
    assert_eq!(refused("width = 1.5"), "width = 1.5 is not a whole number: 1 to 8192 are legal (c.toml, line 1)");
    assert!(refused("width = 0\nheight = 9000").starts_with("2 problems:\n"));
    assert_eq!(
        sentence(Camera { distance: 0.5, ..camera }.validate()),
        "distance = 0.5 is too small: 1 to 100000 are legal"
    );
}

#[test]
fn ray_lists() {
    let rays = parse_rays(b"name, dv ,du,v,u\na,-4,3e-1,.5,0\r\n\nb,0,0,0,0.25\n", "r.csv").unwrap();
    assert_eq!(rays, [[0.0, 0.5, 0.3, -4.0], [0.25, 0.0, 0.0, 0.0]]);
    assert_eq!(parse_rays(b"\xef\xbb\xbfu,v,du,dv\n1,2,3,4", "r.csv").unwrap(), [[1.0, 2.0, 3.0, 4.0]]);
    let refused = |text: &[u8]| sentence(parse_rays(text, "r.csv"));
    assert_eq!(refused(b""), "r.csv is empty: a header u,v,du,dv and one line a ray are needed");
    assert_eq!(refused(b" \n\n"), "r.csv is empty: a header u,v,du,dv and one line a ray are needed");
    assert_eq!(refused(b"u,v,du,dv\n"), "r.csv holds no ray: a line below the header is needed");
    assert_eq!(refused(b"u,v,du\n0,0,0\n"), "r.csv, line 1: no column dv: the header must name u, v, du and dv");
    assert_eq!(refused(b"0,0,0,0\n"), "r.csv, line 1: no column u: the header must name u, v, du and dv");
    assert_eq!(
        refused(b"u,v,du,dv,u\n0,0,0,0,0\n"),
        "r.csv, line 1, column 5: a second column u: each stands there once"
    );
    assert_eq!(refused(b"u,v,du,dv\n0,0,0,0\n0,0,x,0\n"), "r.csv, line 3, column du: \"x\" is not a number");
    assert_eq!(refused(b"u,v,du,dv\n0,NaN,0,0\n"), "r.csv, line 2, column v: NaN is not a finite number");
    assert_eq!(refused(b"u,v,du,dv\n0,0,0,-inf\n"), "r.csv, line 2, column dv: -inf is not a finite number");
    assert_eq!(refused(b"u,v,du,dv\n0,0,0\n"), "r.csv, line 2, column dv: the number is missing");
    assert_eq!(
        refused(b"u,v,du,dv\n0,5,0,5,1,0,0,0\n"),
        "r.csv, line 2: 8 values for 4 columns: a decimal point, not a comma, is needed"
    );
    assert_eq!(refused(b"u,v,du,dv\n0,\xff,0,0\n"), "r.csv, line 2: is not UTF-8 text");
}

#[test]
fn columns_of_ray_lists() {
    let told = |text: &str, lod| sentence(parse_table(text.as_bytes(), "r.csv", lod));
    let twice = "r.csv, line 1, column 6: a second column lod: each stands there once";
    assert_eq!(told("u,v,du,dv,lod,lod\n0,0,0,0,2,0\n", true), twice);
    assert_eq!(told("u,v,du,dv,lod,lod\n0,0,0,0,2,0\n", false), twice);
    let misspelt = "r.csv, line 1, column 5: \"lot\" is none of u, v, du, dv and lod: did you mean lod?";
    assert_eq!(told("u,v,du,dv,lot\n0,0,0,0,2\n", false), misspelt);
    assert!(told("u,v,du,dv,level\n0,0,0,0,2\n", true).starts_with("r.csv, line 1, column 5: \"level\" is none of"));
    assert_eq!(told("u,v,du,Dv,dv\n0,0,0,0,2\n", false), "r.csv, line 1, column 4: \"Dv\" is written dv");
    // Another column does not matter where every expected one is there.
    let table = parse_table(b"u,v,du,dv,lod,name\n0,0,0,0,2,\"a, \"\"b\"\"\"\n", "r.csv", true).unwrap();
    assert_eq!((table.rays.len(), table.lods), (1, Some(vec![2])));
    assert_eq!(parse_table(b"u,v,du,dv\n0,0,0,0\n", "r.csv", true).unwrap().lods, None);
    // A quote that is not closed would swallow rays.
    let open = "u,v,du,dv,name\n0.1,0.1,0,0,a\n0.2,0.2,0,0,\"b\n0.3,0.3,0,0,c\n";
    assert_eq!(told(open, false), "r.csv, line 3, column 5: a quote is not closed");
    assert_eq!(told("\"u,v,du,dv\n0,0,0,0\n", false), "r.csv, line 1, column 1: a quote is not closed");
    assert_eq!(told("u,v,du,dv\n0,\"0\"\",0,0\n1,1,0,0\n", false), "r.csv, line 2, column 2: a quote is not closed");
    assert_eq!(parse_rays(b"\"u\",\"v\",du,dv\n\"0.5\",0,0,0\n", "r.csv").unwrap(), [[0.5, 0.0, 0.0, 0.0]]);
}

#[test]
fn pictures() {
    let codes = to_codes(&map(MapKind::Rocks, 5, 1), 5, 8, false).unwrap();
    let shader = Shader::new(&codes, 5, 8, 20.0, 1.0, MapKind::Rocks);
    let points: Vec<Option<ShadePoint>> = (0..64)
        .map(|at| {
            (at > 7).then(|| ShadePoint {
                u: f64::from(at % 8) / 8.0,
                v: f64::from(at / 8) / 8.0,
                t: 0.3,
                wall: at % 2 == 0,
            })
        })
        .collect();
    let picture = Picture::shaded(&shader, 8, 8, &points);
    assert_eq!((picture.width, picture.height, picture.pixels.len()), (8, 8, 64));
    assert!(picture.pixels[..8].iter().all(|pixel| *pixel == picture.pixels[0]), "background");
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("a.png");
    picture.save(&path).unwrap();
    let read = image::open(&path).unwrap().to_rgb8();
    assert_eq!(read.as_raw(), picture.pixels.as_flattened());
    assert_eq!(picture.shrunk(2).pixels.len(), 16);
    assert_eq!(picture.shrunk(1), picture);
    let grey = Picture::grey(&[0, 3, 1, 2], 2, 2);
    assert_eq!(grey.pixels, [[0; 3], [255; 3], [85; 3], [170; 3]]);
    for most in [0, 1, 3, 147, 65535] {
        let steps = Picture::steps(40, 30, &(0..1200).map(|at| (at % 3 > 0).then_some(most)).collect::<Vec<_>>());
        assert!(steps.width > 40 && steps.height == 30 && steps.pixels.len() == steps.width * 30);
    }
    // Extreme scales and a flat map are no division by zero.
    for scale in [0.0, 1000.0] {
        let shader = Shader::new(&[0; 16], 2, 8, scale, 64.0, MapKind::Flat);
        shader.colour(&ShadePoint { u: 0.0, v: 0.99, t: 1.0, wall: true });
    }
}
