//! Mutated files and texts: whatever stands in them, a parser answers or refuses with a documented exit code, and takes no memory that
//! the input does not deserve. `RELIEFRTL_FUZZ` inputs a parser, 2000 without it; the same ones every time.
use super::keys;
use super::make::{Tiff, dds, exr, plain_exr, png};
use super::memory::peak;
use proptest::prelude::*;
use proptest::test_runner::{Config as Runs, RngAlgorithm, TestRng, TestRunner};
use reliefrtl::config::{Config, MapConfig};
use reliefrtl::error::Error;
use reliefrtl::scene::{Camera, decode_codes, parse_table};

/// More is taken by none of these inputs, which are of at most some thousand bytes: tables of decoders, and a header's limit.
const MEMORY: usize = 80 << 20;

/// One change of a file.
#[derive(Clone, Debug)]
enum Change {
    Set(usize, u8),
    Flip(usize, u8),
    /// Four bytes that counts and sizes like to be.
    Word(usize, u8),
    Cut(usize),
    Remove(usize, usize),
    Repeat(usize, usize),
    Insert(usize, Vec<u8>),
    /// The rest of another seed from here on.
    Splice(usize, usize),
}

fn change() -> impl Strategy<Value = Change> {
    let at = any::<usize>();
    prop_oneof![
        4 => (at, any::<u8>()).prop_map(|(at, byte)| Change::Set(at, byte)),
        4 => (at, 0u8..8).prop_map(|(at, bit)| Change::Flip(at, bit)),
        3 => (at, 0u8..10).prop_map(|(at, which)| Change::Word(at, which)),
        1 => at.prop_map(Change::Cut),
        1 => (at, 0usize..40).prop_map(|(at, count)| Change::Remove(at, count)),
        1 => (at, 0usize..40).prop_map(|(at, count)| Change::Repeat(at, count)),
        1 => (at, proptest::collection::vec(any::<u8>(), 0..9)).prop_map(|(at, bytes)| Change::Insert(at, bytes)),
        1 => (at, any::<usize>()).prop_map(|(at, seed)| Change::Splice(at, seed)),
    ]
}

impl Change {
    fn apply(&self, file: &mut Vec<u8>, seeds: &[Vec<u8>]) {
        let len = file.len().max(1);
        let place = |at: usize| (at % len).min(file.len());
        match self {
            Self::Set(at, byte) => {
                let at = place(*at);
                file.get_mut(at).into_iter().for_each(|b| *b = *byte);
            }
            Self::Flip(at, bit) => {
                let at = place(*at);
                file.get_mut(at).into_iter().for_each(|b| *b ^= 1 << bit);
            }
            Self::Word(at, which) => {
                let word: u32 =
                    [0, 1, u32::MAX, 1 << 31, (1 << 31) - 1, 100_000, 1 << 24, 0xff00_0000, 0x0100_0000, 65536]
                        [usize::from(*which)];
                let at = place(*at);
                for (b, byte) in file[at..].iter_mut().zip(word.to_le_bytes()) {
                    *b = byte;
                }
            }
            Self::Cut(at) => file.truncate(place(*at)),
            Self::Remove(at, count) => {
                let at = place(*at);
                file.drain(at..(at + count).min(file.len()));
            }
            Self::Repeat(at, count) => {
                let at = place(*at);
                let piece = file[at..(at + count).min(file.len())].to_vec();
                file.splice(at..at, piece);
            }
            Self::Insert(at, bytes) => {
                let at = place(*at);
                file.splice(at..at, bytes.iter().copied());
            }
            Self::Splice(at, seed) => {
                let other = &seeds[seed % seeds.len()];
                let at = place(*at);
                file.truncate(at);
                file.extend_from_slice(other.get(at..).unwrap_or_default());
            }
        }
    }
}

/// Gives mutated seeds to a parser. What panics is shown with the changes that led to it.
fn fuzz(name: &str, seeds: &[Vec<u8>], parse: impl Fn(&[u8]) -> Result<(), Error>) {
    let cases = std::env::var("RELIEFRTL_FUZZ").ok().map_or(2000, |text| text.parse().expect("a number of inputs"));
    let runs = Runs { cases, failure_persistence: None, max_shrink_iters: 2000, ..Runs::default() };
    let mut seed = [7u8; 32];
    seed.iter_mut().zip(name.bytes()).for_each(|(s, b)| *s = b);
    let mut runner = TestRunner::new_with_rng(runs, TestRng::from_seed(RngAlgorithm::ChaCha, &seed));
    seeds.iter().for_each(|whole| parse(whole).unwrap_or_else(|e| panic!("{name}: a seed is refused: {e}")));
    let changes = proptest::collection::vec(change(), 1..6);
    let run = runner.run(&(any::<usize>(), changes), |(which, changes)| {
        let mut file = seeds[which % seeds.len()].clone();
        changes.iter().for_each(|change| change.apply(&mut file, seeds));
        let (answer, bytes) = peak(|| parse(&file));
        prop_assert!(bytes < MEMORY, "{} bytes for an input of {}", bytes, file.len());
        if let Err(error) = answer {
            let text = error.to_string();
            prop_assert!((1..=7).contains(&error.exit_code()) && !text.is_empty(), "{}", text);
            // What libraries say of themselves tells a user nothing.
            for word in ["fill whole buffer", "limits are exceeded", "ChunkType {", "ormat error", "os error"] {
                prop_assert!(!text.contains(word), "{}", text);
            }
        }
        Ok(())
    });
    run.unwrap_or_else(|found| panic!("{name}: {found}"));
}

/// A kind of map file, with choices that let it through as far as it goes.
fn map(name: &str, sets: &[&str], seeds: &[Vec<u8>]) {
    let all = [&["map.range=auto", "map.nodata=3", "map.lossy=true", "map.max_texels=4096"], sets].concat();
    let free: MapConfig = keys(&all);
    let strict = MapConfig { max_texels: 4096, ..MapConfig::default() };
    fuzz(name, seeds, |file| {
        // The default choices, whose refusals are sentences too.
        let _ = decode_codes(file, name, &strict, 3, 8, true);
        // No data everywhere is the one thing that the choices don't heal: so a height is filled in by a second call.
        match decode_codes(file, name, &free, 3, 8, true) {
            Ok((codes, taken)) => {
                assert_eq!(codes.len(), 64);
                assert!(codes.iter().all(|code| *code < 256) && !taken.to_string().is_empty());
                Ok(())
            }
            Err(error) => Err(error),
        }
    });
}

fn ramp(bits: u32) -> Vec<u64> {
    (0..64).map(|at| (at * 37 + 4) & (u64::MAX >> (64 - bits))).map(|w| if w == 3 { 4 } else { w }).collect()
}

#[test]
fn png_files() {
    let grey = |depth, bits: usize| {
        let rows: Vec<u8> = (0..bits as u8 * 8).map(|at| at.wrapping_mul(37) | 0x44).collect();
        png(8, depth, png::ColorType::Grayscale, &rows, |_| ())
    };
    let palette = png(8, png::BitDepth::Four, png::ColorType::Indexed, &[0x12; 32], |e| {
        e.set_palette((0..16u8).flat_map(|g| [g; 3]).map(|g| g + 9).collect::<Vec<u8>>());
    });
    let alpha = png(8, png::BitDepth::Eight, png::ColorType::Rgba, &[255; 256], |_| ());
    map(
        "m.png",
        &[],
        &[grey(png::BitDepth::One, 1), grey(png::BitDepth::Eight, 8), grey(png::BitDepth::Sixteen, 16), palette, alpha],
    );
}

#[test]
fn tiff_files() {
    let grey = Tiff::grey(8, 12, &ramp(12));
    let floats: Vec<u64> = ramp(8).iter().map(|w| u64::from((*w as f32).to_bits())).collect();
    let seeds = [
        grey.bytes(),
        Tiff { compression: 5, big_endian: true, ..Tiff::grey(8, 16, &ramp(16)) }.bytes(),
        Tiff { compression: 8, predictor: 2, tile: Some((16, 16)), ..Tiff::grey(8, 8, &ramp(8)) }.bytes(),
        Tiff { compression: 32773, big_tiff: true, orientation: 6, ..Tiff::grey(8, 8, &ramp(8)) }.bytes(),
        Tiff { compression: 50000, predictor: 3, format: 3, nodata: Some("-9999"), ..Tiff::grey(8, 32, &floats) }
            .bytes(),
        Tiff {
            photometric: 3,
            palette: Some((0..48u16).map(|g| g % 16 * 257 + 2570).collect()),
            ..Tiff::grey(8, 4, &ramp(4))
        }
        .bytes(),
        Tiff {
            samples: 2,
            extra: Some(2),
            planar: true,
            height: 8,
            ..Tiff::grey(8, 8, &ramp(8).iter().flat_map(|w| [*w, 255]).collect::<Vec<_>>())
        }
        .bytes(),
    ];
    map("m.tif", &[], &seeds);
}

#[test]
fn exr_files() {
    let values: Vec<f32> = ramp(8).iter().map(|w| *w as f32).collect();
    let three = exr(&[("R", &values), ("G", &values), ("B", &values)], 8);
    map("m.exr", &[], &[exr(&[("Y", &values)], 8), three, plain_exr(7)]);
}

#[test]
fn portable_maps() {
    let bytes: Vec<u8> = ramp(8).iter().map(|w| *w as u8).collect();
    let text = |per: usize| ramp(8).iter().flat_map(|w| vec![*w; per]).map(|w| format!("{w} ")).collect::<String>();
    let seeds = [
        format!("P2 8 8 # a comment\n1000\n{}", text(1)).into_bytes(),
        format!("P3 8 8 255\n{}", text(3)).into_bytes(),
        format!("P1 8 8\n{}", "10".repeat(32)).into_bytes(),
        [b"P4 8 8\n".as_slice(), &[0x5a; 8]].concat(),
        [b"P5 8 8 255\n".as_slice(), &bytes].concat(),
        [b"P7\nWIDTH 8\nHEIGHT 8\nDEPTH 1\nMAXVAL 255\nTUPLTYPE GRAYSCALE\nENDHDR\n".as_slice(), &bytes].concat(),
        [b"Pf 8 8 -1\n".as_slice(), &[0x40; 256]].concat(),
    ];
    map("m.pgm", &[], &seeds);
}

#[test]
fn files_without_a_header() {
    let bytes: Vec<u8> = ramp(16).iter().flat_map(|w| (*w as u16).to_le_bytes()).collect();
    map("m.r16", &[], std::slice::from_ref(&bytes));
    map("m.hgt", &[], std::slice::from_ref(&bytes));
    map("m.raw", &["map.size=8,8"], &[bytes.clone(), ramp(8).iter().map(|w| *w as u8).collect(), vec![0x41; 256]]);
}

#[test]
fn esri_grids() {
    let rows = "1 2.5 -4 4e2 5 6 7 8\n".repeat(8);
    let seeds = [
        format!("ncols 8\nnrows 8\nxllcorner 0\nyllcorner 0\ncellsize 30\nNODATA_value -9999\n{rows}").into_bytes(),
        format!("NROWS 8\r\nNCOLS 8\r\n{rows}").into_bytes(),
    ];
    map("m.asc", &[], &seeds);
}

#[test]
fn pictures_of_bytes() {
    use image::{ExtendedColorType as Kind, ImageEncoder};
    let bytes: Vec<u8> = ramp(8).iter().map(|w| *w as u8).collect();
    let (mut bmp, mut tga, mut webp, mut jpeg) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    image::codecs::bmp::BmpEncoder::new(&mut bmp).encode(&bytes, 8, 8, Kind::L8).unwrap();
    image::codecs::tga::TgaEncoder::new(&mut tga).write_image(&bytes, 8, 8, Kind::L8).unwrap();
    image::codecs::webp::WebPEncoder::new_lossless(&mut webp).write_image(&bytes, 8, 8, Kind::L8).unwrap();
    image::codecs::jpeg::JpegEncoder::new(&mut jpeg).write_image(&bytes, 8, 8, Kind::L8).unwrap();
    for (name, file) in [("m.bmp", bmp), ("m.tga", tga), ("m.webp", webp), ("m.jpg", jpeg)] {
        map(name, &[], &[file]);
    }
}

#[test]
fn dds_files() {
    use ddsfile::DxgiFormat::{BC4_UNorm, R16_UNorm};
    let bytes: Vec<u8> = ramp(16).iter().flat_map(|w| (*w as u16).to_le_bytes()).collect();
    map("m.dds", &[], &[dds(8, 8, R16_UNorm, &bytes), dds(8, 8, BC4_UNorm, &bytes[..32])]);
}

#[test]
fn configurations() {
    let seeds = [
        Config::default().to_commented_toml(),
        "[map]\nkind = \"file\"\nfile = \"m.png\"\nrange = [0, 10]\nsize = [4, 4]\n[emit]\nunits = [\"fp_sqrt\"]\n"
            .to_owned(),
        "format.exp = 8\nformat = {man = 10}\n".replace("format = {man = 10}\n", "format.man = 10\nlatency.div = 4\n"),
    ];
    fuzz("c.toml", &seeds.map(String::into_bytes), |bytes| {
        let text = String::from_utf8_lossy(bytes);
        let config = Config::from_toml(&text, "c.toml")?;
        let _ = (config.hash(), config.to_commented_toml());
        config.validate()
    });
}

#[test]
fn settings() {
    let seeds =
        ["traverse.levels=10", "map.range=[0, 1]", "map.file=a b.png", "view.names=front,grazing", "map.size=1,2"];
    fuzz("--set", &seeds.map(|s| s.as_bytes().to_vec()), |bytes| {
        let mut config = Config::default();
        config.apply_set(&String::from_utf8_lossy(bytes))?;
        let _ = config.validate();
        Ok(())
    });
}

#[test]
fn cameras() {
    let seeds = [
        "elevation = 22.0\nazimuth = 36.4\ndistance = 200.0\nfov = 45.0\nwidth = 4\nheight = 3\n",
        "width = 9\nheight = 2",
    ];
    fuzz("camera.toml", &seeds.map(|s| s.as_bytes().to_vec()), |bytes| {
        let camera = Camera::from_toml(&String::from_utf8_lossy(bytes), "camera.toml")?;
        camera.validate()?;
        camera
            .rays(20.0, 1, camera.width.max(camera.height))
            .iter()
            .for_each(|ray| assert!(ray.u >= 0.0 && ray.u < 1.0));
        Ok(())
    });
}

#[test]
fn ray_lists() {
    let seeds = [
        "u,v,du,dv\n0.5,0.25,1e-3,-4\n1,2,3,4\n",
        "dv,du,v,u,lod,name\r\n1,2,3,4,5,\"a, \"\"b\"\"\"\r\n0,0,0,0,0,x\r\n",
    ];
    fuzz("r.csv", &seeds.map(|s| s.as_bytes().to_vec()), |bytes| {
        let _ = parse_table(bytes, "r.csv", true);
        let table = parse_table(bytes, "r.csv", false)?;
        assert!(table.rays.iter().flatten().all(|number| number.is_finite()));
        assert!(table.lods.is_none_or(|lods| lods.len() == table.rays.len()));
        Ok(())
    });
}

#[test]
fn vector_files() {
    use reliefrtl::vectors::{Column, VectorSet, read_csv, read_json, read_set, set_files};
    let column = |name: &str, width| Column { name: name.into(), width };
    let mut set = VectorSet {
        unit: "fp_add".into(),
        inputs: vec![column("a", 24), column("b", 24)],
        outputs: vec![column("y", 24), column("lost", 1)],
        stimulus: (0..6).map(|row| vec![row, row * 9]).collect(),
        expected: (0..6).map(|row| vec![row * 77, row % 2]).collect(),
        ..VectorSet::default()
    };
    set.counts.random = 6;
    let dir = tempfile::tempdir().unwrap();
    let files = set_files(&set);
    for (name, text) in &files {
        std::fs::write(dir.path().join(name), text).unwrap();
    }
    assert!(read_set(dir.path()).unwrap().1);
    for name in ["vectors.json", "stimulus.hex", "expected.hex"] {
        let path = dir.path().join(name);
        fuzz(name, &[files[name].clone().into_bytes()], |bytes| {
            std::fs::write(&path, bytes).unwrap();
            let (read, _) = read_set(dir.path())?;
            let fits = |rows: &[Vec<u64>], columns: &[Column]| rows.iter().all(|row| row.len() == columns.len());
            assert!(fits(&read.stimulus, &read.inputs) && fits(&read.expected, &read.outputs));
            Ok(())
        });
        std::fs::write(&path, &files[name]).unwrap();
    }
    type Read = fn(&str, &[Column], &[Column]) -> Result<reliefrtl::vectors::Rows, Error>;
    for (name, read) in [("vectors.csv", read_csv as Read), ("rows.json", read_json)] {
        fuzz(name, &[files[name].clone().into_bytes()], |bytes| {
            read(&String::from_utf8_lossy(bytes), &set.inputs, &set.outputs).map(drop)
        });
    }
}

#[test]
fn manifests() {
    let config = Config::default();
    let manifest = reliefrtl::emit::manifest(&config, &[], &reliefrtl::emit::Files::new());
    let seed = serde_json::to_string_pretty(&manifest).unwrap();
    let dir = tempfile::tempdir().unwrap();
    fuzz("manifest.json", &[seed.into_bytes()], |bytes| {
        std::fs::write(dir.path().join("manifest.json"), bytes).unwrap();
        reliefrtl::project::same_config(&config, dir.path())
    });
}

#[test]
fn stored_measurements() {
    use reliefrtl::report::{Extent, Plan, Selection, measurements};
    let mut config = Config::default();
    (config.traverse.levels, config.view.width, config.view.height, config.view.stride) = (3, 64, 48, 16);
    let mut plan = Plan::new(&config, &Selection { extent: Extent::Tiny, ..Selection::default() }).unwrap();
    plan.jobs.truncate(1);
    let dir = tempfile::tempdir().unwrap();
    let (whole, _) = measurements(&plan, dir.path(), &|_, _| ()).unwrap();
    let path = std::fs::read_dir(dir.path().join("cells")).unwrap().next().unwrap().unwrap().path();
    let seed = std::fs::read(&path).unwrap();
    fuzz("cell.json", &[seed], |bytes| {
        // What is no measurement is measured again.
        std::fs::write(&path, bytes).unwrap();
        let (found, work) = measurements(&plan, dir.path(), &|_, _| ())?;
        assert!(found == whole && work.measured + work.taken == 1, "what was edited counts as measured");
        Ok(())
    });
}
