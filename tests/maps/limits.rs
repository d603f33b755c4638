//! Small files that announce much: a sentence and exit code 2, within two seconds of processor time and a small address space.
use super::make::{Tiff, dds, plain_exr, png};
use std::path::Path;
use std::process::{Command, Output};
use std::time::{Duration, Instant};

/// Runs with 4 GB of address space and two seconds of processor time, after which the system ends it.
fn run(dir: &Path, args: &[&str]) -> Output {
    Command::new("sh")
        .args(["-c", "ulimit -v 4000000; ulimit -t 2; exec \"$0\" \"$@\"", env!("CARGO_BIN_EXE_reliefrtl")])
        .args(args)
        .current_dir(dir)
        .output()
        .unwrap()
}

/// Refused by name, in one sentence that has this in it, without waiting for anything.
fn refused(dir: &Path, args: &[&str], what: &str) {
    let start = Instant::now();
    let out = run(dir, args);
    let text = String::from_utf8_lossy(&out.stderr).into_owned();
    assert_eq!(out.status.code(), Some(2), "{args:?}: {text}");
    assert_eq!(text.lines().count(), 1, "one sentence: {text}");
    assert!(text.contains(what), "{args:?}: {text}");
    assert!(start.elapsed() < Duration::from_secs(20), "{args:?} took {:?}", start.elapsed());
}

/// Four bytes of a file replaced.
fn with(mut file: Vec<u8>, from: &[u8], to: &[u8]) -> Vec<u8> {
    let places: Vec<usize> = (0..=file.len() - from.len()).filter(|at| file[*at..].starts_with(from)).collect();
    assert!(!places.is_empty(), "nothing to replace");
    places.iter().for_each(|at| file[*at..at + to.len()].copy_from_slice(to));
    file
}

const LARGE: u32 = 100_000;

/// Files of each kind, well-formed, and the same that announce 100000 x 100000, or as much as they can.
fn files() -> Vec<(&'static str, Vec<u8>, Vec<u8>)> {
    let grey = png(7, png::BitDepth::Eight, png::ColorType::Grayscale, &[9; 49], |_| ());
    let mut crc = flate2::Crc::new();
    let header = [b"IHDR".as_slice(), &LARGE.to_be_bytes(), &LARGE.to_be_bytes(), &[8, 0, 0, 0, 0]].concat();
    crc.update(&header);
    let mut large = grey.clone();
    large[12..29].copy_from_slice(&header);
    large[29..33].copy_from_slice(&crc.sum().to_be_bytes());
    let mut list = vec![("a.png", grey, large)];
    for (name, big_tiff) in [("a.tif", false), ("big.tif", true)] {
        let small = Tiff { big_tiff, ..Tiff::grey(7, 8, &[9; 49]) };
        // Side and rows a strip are the only sevens of four bytes.
        let file = Tiff { rows_per_strip: 7, ..small }.bytes();
        list.push((name, file.clone(), with(file, &[7, 0, 0, 0], &LARGE.to_le_bytes())));
    }
    list.push(("a.exr", plain_exr(7), plain_exr(LARGE)));
    let side = |magic: &str, max: &str, data: &[u8]| {
        let one = |n: u32| [format!("{magic}\n{n} {n}\n{max}").as_bytes(), data].concat();
        (one(7), one(LARGE))
    };
    for (name, magic, max, data) in [
        ("a1.pbm", "P1", "", vec![b'1'; 49]),
        ("a.pgm", "P2", "9\n", b"1 ".repeat(49)),
        ("a.ppm", "P3", "9\n", b"1 ".repeat(3 * 49)),
        ("a4.pbm", "P4", "", vec![0; 7]),
        ("a5.pgm", "P5", "255\n", vec![9; 49]),
        ("a6.ppm", "P6", "255\n", vec![9; 3 * 49]),
        ("a.pfm", "Pf", "-1\n", vec![0; 4 * 49]),
    ] {
        let (small, large) = side(magic, max, &data);
        list.push((name, small, large));
    }
    let pam =
        |n: u32| [format!("P7\nWIDTH {n}\nHEIGHT {n}\nDEPTH 1\nMAXVAL 255\nENDHDR\n").as_bytes(), &[9; 49]].concat();
    list.push(("a.pam", pam(7), pam(LARGE)));
    let asc = |n: u32| format!("ncols {n}\nnrows {n}\n{}", "0 ".repeat(49)).into_bytes();
    list.push(("a.asc", asc(7), asc(LARGE)));
    let texels = [9u8; 49];
    let mut bmp = Vec::new();
    image::codecs::bmp::BmpEncoder::new(&mut bmp).encode(&texels, 7, 7, image::ExtendedColorType::L8).unwrap();
    list.push(("a.bmp", bmp.clone(), with(bmp, &[7, 0, 0, 0, 7, 0, 0, 0], &[LARGE.to_le_bytes(); 2].concat())));
    let mut tga = Vec::new();
    let encoder = image::codecs::tga::TgaEncoder::new(&mut tga);
    image::ImageEncoder::write_image(encoder, &texels, 7, 7, image::ExtendedColorType::L8).unwrap();
    list.push(("a.tga", tga.clone(), with(tga, &[7, 0, 7, 0], &[255; 4])));
    let mut webp = Vec::new();
    let encoder = image::codecs::webp::WebPEncoder::new_lossless(&mut webp);
    image::ImageEncoder::write_image(encoder, &texels, 7, 7, image::ExtendedColorType::L8).unwrap();
    // After the signature byte 14 bits each of width - 1 and height - 1: 16383 x 16383.
    let at = webp.windows(4).position(|w| w == b"VP8L").unwrap() + 9;
    let mut large = webp.clone();
    large[at..at + 3].copy_from_slice(&[0xfe, 0xbf, 0xff]);
    large[at + 3] |= 0x0f;
    list.push(("a.webp", webp, large));
    let surface = dds(7, 7, ddsfile::DxgiFormat::R8_UNorm, &texels);
    list.push((
        "a.dds",
        surface.clone(),
        with(surface, &[7, 0, 0, 0, 7, 0, 0, 0], &[LARGE.to_le_bytes(), LARGE.to_le_bytes()].concat()),
    ));
    list
}

/// Few texels, but a side that the library does not take.
#[test]
fn a_side_of_a_bmp_has_a_limit_of_its_own() {
    let mut bmp = Vec::new();
    image::codecs::bmp::BmpEncoder::new(&mut bmp).encode(&[9; 49], 7, 7, image::ExtendedColorType::L8).unwrap();
    let sides = [LARGE.to_le_bytes(), (-3i32).to_le_bytes()].concat();
    let wide = with(bmp, &[7, 0, 0, 0, 7, 0, 0, 0], &sides);
    let told = reliefrtl::scene::decode(&wide, "m.bmp").expect_err("too wide").to_string();
    assert_eq!(told, "m.bmp: not a readable BMP: it is 100000 x 3, and up to 65535 columns and rows are read of one");
}

#[test]
fn what_announces_much_is_refused_before_it_is_read() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("r.csv"), "u,v,du,dv\n0.5,0.5,0.1,0.1\n").unwrap();
    let small = ["--set", "traverse.levels=3", "--rays", "r.csv", "--engine", "golden", "--out", "h.csv"];
    for (name, good, large) in files() {
        let args = [&["trace", "--map", name], &small[..]].concat();
        std::fs::write(dir.path().join(name), &good).unwrap();
        let out = run(dir.path(), &[&args[..], &["--pad", "--set", "map.range=auto"]].concat());
        assert_eq!(out.status.code(), Some(0), "{name}: {}", String::from_utf8_lossy(&out.stderr));
        std::fs::write(dir.path().join(name), &large).unwrap();
        let limit = "more than map.max_texels = 67108864: if they are meant, ask for them with --max-texels";
        refused(dir.path(), &args, limit);
        // Asked for, it is not there.
        refused(dir.path(), &[&args[..], &["--max-texels", "10000000000"]].concat(), name);
        for cut in [4, good.len() / 4, good.len() / 2, good.len() - 1] {
            std::fs::write(dir.path().join(name), &good[..cut]).unwrap();
            // A last separator, a checksum or a footer is no texel.
            let out = run(dir.path(), &[&args[..], &["--resample"]].concat());
            assert!(matches!(out.status.code(), Some(0 | 2)), "{name} cut to {cut}");
            assert!(cut == good.len() - 1 || out.status.code() == Some(2), "{name} cut to {cut}");
        }
    }
    let size = ["--set", "map.size=[100000,100000]"];
    std::fs::write(dir.path().join("a.raw"), [0; 98]).unwrap();
    refused(
        dir.path(),
        &[&["trace", "--map", "a.raw"], &small[..], &size].concat(),
        "which are no 100000 x 100000 heights",
    );
    std::fs::write(dir.path().join("a.hgt"), [0; 98]).unwrap();
    refused(dir.path(), &[&["trace", "--map", "a.hgt"], &small[..], &size].concat(), "are not the 98 bytes");
}

/// Files at the limit, all of whose texels are announced and few there: what is there is read, and no more.
#[test]
fn what_announces_the_limit_is_read_as_far_as_it_goes() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("r.csv"), "u,v,du,dv\n0.5,0.5,0.1,0.1\n").unwrap();
    let row = vec![9u8; 8192];
    let mut grey = Vec::new();
    let mut encoder = png::Encoder::new(&mut grey, 8192, 8192);
    encoder.set_color(png::ColorType::Grayscale);
    let mut writer = encoder.write_header().unwrap();
    let mut stream = writer.stream_writer().unwrap();
    (0..8192).for_each(|_| std::io::Write::write_all(&mut stream, &row).unwrap());
    stream.finish().unwrap();
    writer.finish().unwrap();
    let pam = b"P7\nWIDTH 8192\nHEIGHT 8192\nDEPTH 1\nMAXVAL 255\nENDHDR\n";
    let bmp = [
        b"BM".as_slice(),
        &[54, 0, 0, 0, 0, 0, 0, 0, 54, 0, 0, 0, 40, 0, 0, 0, 0, 32, 0, 0, 0, 32, 0, 0, 1, 0, 24, 0],
        &[0; 24],
    ]
    .concat();
    let tga = [&[0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 32, 0, 32, 24, 0][..], &[255, 1, 1, 1].repeat(200)].concat();
    let files = [
        ("a.png", grey[..grey.len() * 9 / 10].to_vec()),
        ("a.pam", [&pam[..], &row].concat()),
        ("a.asc", [b"ncols 8192\nnrows 8192\n".as_slice(), &b"0 ".repeat(8192)].concat()),
        ("a.exr", plain_exr(8192)),
        ("a.bmp", bmp),
        ("a.tga", tga),
    ];
    for (name, file) in files {
        std::fs::write(dir.path().join(name), &file).unwrap();
        for more in [&["--resample"][..], &["--resample", "--set", "map.range=auto"]] {
            let args = [
                "trace",
                "--map",
                name,
                "--set",
                "traverse.levels=3",
                "--rays",
                "r.csv",
                "--engine",
                "golden",
                "--out",
                "h.csv",
            ];
            refused(dir.path(), &[&args[..], more].concat(), name);
        }
    }
}

#[test]
fn counts_in_vector_files_are_not_allocated() {
    let dir = tempfile::tempdir().unwrap();
    for verb in ["emit", "vectors"] {
        let out = run(dir.path(), &[verb, "--unit", "fp_lt", "--out", "o", "--set", "vectors.arithmetic=20"]);
        assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
    }
    let golden = dir.path().join("o/golden/fp_lt");
    let check = ["check", "--unit", "fp_lt", "--dir", "o", "--set", "vectors.arithmetic=20"];
    assert_eq!(run(dir.path(), &check).status.code(), Some(0));
    for name in ["stimulus.hex", "expected.hex"] {
        let whole = std::fs::read_to_string(golden.join(name)).unwrap();
        let (comment, rest) = whole.split_once('\n').unwrap();
        let (_, rest) = rest.split_once(' ').unwrap();
        std::fs::write(golden.join(name), format!("{comment}\nffffffff {rest}")).unwrap();
        refused(dir.path(), &check, "announces 4294967295 rows and has");
        std::fs::write(golden.join(name), whole).unwrap();
    }
    let whole = std::fs::read_to_string(golden.join("vectors.json")).unwrap();
    for (from, to) in [("\"width\": ", "\"width\": 42949672"), ("\"rows\": ", "\"rows\": 42949672")] {
        std::fs::write(golden.join("vectors.json"), whole.replacen(from, to, 1)).unwrap();
        let out = run(dir.path(), &check);
        assert_eq!(out.status.code(), Some(2), "{}", String::from_utf8_lossy(&out.stderr));
    }
}
