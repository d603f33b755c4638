//! Every kind of file that is read, from known codes to the same codes.
use super::make::{dds, png};
use super::{keys, sentence};
use image::{ExtendedColorType as Kind, ImageEncoder, ImageFormat};
use png::{BitDepth, ColorType};
use reliefrtl::scene::{decode_as, decode_codes};
use std::io::Cursor;

/// Sixteen codes of this many bits, the ends among them.
pub fn ramp(bits: u32) -> Vec<u64> {
    let max = u64::MAX >> (64 - bits);
    (0..16).map(|at| if at == 15 { max } else { at * 7919 * (max / 16 + 1) % (max + 1) }).collect()
}

/// The codes of a 4 x 4 map of at most 16 bits.
pub fn codes(bytes: &[u8], name: &str, bits: u32, sets: &[&str]) -> Vec<u64> {
    let read = decode_codes(bytes, name, &keys(sets), 2, bits, false);
    read.unwrap_or_else(|e| panic!("{e}")).0.iter().map(|code| u64::from(*code)).collect()
}

/// Samples in the file's units, whatever their number.
pub fn units(bytes: &[u8], name: &str, low: f64, high: f64, sets: &[&str]) -> Vec<f64> {
    let range = format!("map.range={low},{high}");
    let map = keys(&[sets, &[range.as_str()]].concat());
    let (map, _) = decode_as(bytes, name, &map).unwrap_or_else(|e| panic!("{e}"));
    map.samples.iter().map(|height| (height * (high - low) + low).round()).collect()
}

/// Big-endian bits of samples, rows of four filled up to bytes.
fn packed(words: &[u64], bits: u32) -> Vec<u8> {
    let row = |row: &[u64]| {
        let mut out = vec![0u8; (4 * bits as usize).div_ceil(8)];
        for (at, word) in row.iter().enumerate() {
            for bit in 0..bits as usize {
                let place = at * bits as usize + bit;
                out[place / 8] |= ((word >> (bits as usize - 1 - bit) & 1) as u8) << (7 - place % 8);
            }
        }
        out
    };
    words.chunks(4).flat_map(row).collect()
}

#[test]
fn png_at_its_own_depth() {
    for (depth, bits) in
        [(BitDepth::One, 1), (BitDepth::Two, 2), (BitDepth::Four, 4), (BitDepth::Eight, 8), (BitDepth::Sixteen, 16)]
    {
        let words = ramp(bits);
        let file = png(4, depth, ColorType::Grayscale, &packed(&words, bits), |_| ());
        if bits > 1 {
            assert_eq!(codes(&file, "m.png", bits, &[]), words, "{bits} bits");
        }
        assert_eq!(
            codes(&file, "m.png", 16, &[]),
            words.iter().map(|w| w * 65535 / ((1 << bits) - 1)).collect::<Vec<_>>()
        );
    }
    // A grey palette, whose numbers are not the heights.
    let palette: Vec<u8> = (0..16u8).flat_map(|grey| [255 - 3 * grey; 3]).collect();
    let words: Vec<u64> = (0..16).collect();
    let file = png(4, BitDepth::Four, ColorType::Indexed, &packed(&words, 4), |e| e.set_palette(palette.clone()));
    assert_eq!(codes(&file, "m.png", 8, &[]), (0..16).map(|at| 255 - 3 * at).collect::<Vec<u64>>());
    // A transparent colour is a hole where it occurs.
    let keyed = |grey: u16| {
        let trns = grey.to_be_bytes().to_vec();
        png(4, BitDepth::Eight, ColorType::Grayscale, &packed(&ramp(8), 8), move |e| e.set_trns(trns.clone()))
    };
    assert_eq!(codes(&keyed(3), "m.png", 8, &[]), ramp(8));
    let told = sentence(decode_codes(&keyed(255), "m.png", &keys(&[]), 2, 8, false));
    assert!(told.starts_with("m.png: pixel (3, 3) is not opaque (alpha 0 of 255)"), "{told}");
    assert_eq!(codes(&keyed(255), "m.png", 8, &["map.channel=Y"]), ramp(8));
}

#[test]
fn interlaced_png() {
    // 8 x 1 of 1 bit in Adam7: passes of columns 0, 4, (2, 6), (1, 3, 5, 7), each a row with its filter byte.
    let mut raw = Vec::new();
    for pass in [[1u8, 0, 0, 0].as_slice(), &[0], &[1, 1], &[0, 1, 0, 1]] {
        let pass = if pass.len() == 4 && raw.is_empty() { &pass[..1] } else { pass };
        let byte = pass.iter().enumerate().fold(0u8, |byte, (at, bit)| byte | bit << (7 - at));
        raw.extend([0, byte]);
    }
    let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
    let mut deflate = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
    std::io::Write::write_all(&mut deflate, &raw).unwrap();
    let header = [0, 0, 0, 8, 0, 0, 0, 1, 1, 0, 0, 0, 1];
    for (kind, data) in [(b"IHDR", header.to_vec()), (b"IDAT", deflate.finish().unwrap()), (b"IEND", Vec::new())] {
        file.extend((data.len() as u32).to_be_bytes());
        let chunk = [kind.as_slice(), &data].concat();
        let mut crc = flate2::Crc::new();
        crc.update(&chunk);
        file.extend(chunk);
        file.extend(crc.sum().to_be_bytes());
    }
    let (map, _) = decode_as(&file, "m.png", &keys(&[])).unwrap();
    assert_eq!(map.samples, [1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0]);
}

/// EXIF data of a PNG, whose orientation is 6 or none.
#[test]
fn an_orientation_in_exif_data() {
    let exif = |orientation: u8| {
        let data =
            [b"MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0".as_slice(), &[orientation, 0, 0, 0, 0, 0, 0]].concat();
        let file = png(2, BitDepth::Eight, ColorType::Grayscale, &[1, 2, 3, 4, 5, 6], |_| ());
        // After the header, 8 + 25 bytes.
        let mut crc = flate2::Crc::new();
        crc.update(&[b"eXIf".as_slice(), &data].concat());
        let chunk = [&(data.len() as u32).to_be_bytes()[..], b"eXIf", &data, &crc.sum().to_be_bytes()].concat();
        [&file[..33], &chunk, &file[33..]].concat()
    };
    let read = |orientation| {
        let map = decode_as(&exif(orientation), "m.png", &keys(&[]));
        map.map(|(map, _)| map.samples.iter().map(|h| (h * 255.0).round() as u64).collect::<Vec<_>>())
    };
    assert_eq!(read(1).unwrap(), [1, 2, 3, 4, 5, 6]);
    assert_eq!(read(6).unwrap(), [5, 3, 1, 6, 4, 2]);
    assert!(sentence(read(9)).contains("its orientation is 9, and 1 (upright) to 8 are legal"));
}

#[test]
fn portable_maps() {
    let words = ramp(8);
    let text = |words: &[u64]| words.iter().map(|w| format!(" {w}")).collect::<String>();
    let bytes: Vec<u8> = words.iter().map(|w| *w as u8).collect();
    let wide: Vec<u8> = ramp(10).iter().flat_map(|w| (*w as u16).to_be_bytes()).collect();
    let colour: Vec<u8> = bytes.iter().flat_map(|b| [*b; 3]).collect();
    let opaque: Vec<u8> = bytes.iter().flat_map(|b| [*b, 255]).collect();
    let p2 = format!("P2\n# ten bits\n4 4\n1023{}\n", text(&ramp(10)));
    let p3: String = words.iter().map(|w| format!("{w} {w} {w}\n")).collect();
    let pam = |depth: u32, max: u32, kind: &str| {
        format!("P7\nWIDTH 4\nHEIGHT 4\nDEPTH {depth}\nMAXVAL {max}\nTUPLTYPE {kind}\nENDHDR\n").into_bytes()
    };
    assert_eq!(codes(p2.as_bytes(), "m", 10, &[]), ramp(10));
    assert_eq!(codes(&[b"P5 4 4 1023\n".as_slice(), &wide].concat(), "m", 10, &[]), ramp(10));
    assert_eq!(codes(&[pam(1, 1023, "GRAYSCALE"), wide].concat(), "m", 10, &[]), ramp(10));
    for file in [
        [b"P5 4 4 255\n".as_slice(), &bytes].concat(),
        format!("P3 4 4 255\n{p3}").into_bytes(),
        [b"P6 4 4 255\n".as_slice(), &colour].concat(),
        [pam(1, 255, "GRAYSCALE"), bytes].concat(),
        [pam(3, 255, "RGB"), colour].concat(),
        [pam(2, 255, "GRAYSCALE_ALPHA"), opaque].concat(),
    ] {
        assert_eq!(codes(&file, "m", 8, &[]), words);
    }
    // A map is one picture; what stands after it was meant to be something, but for the end of a line.
    let bytes: Vec<u8> = words.iter().map(|w| *w as u8).collect();
    let p5 = |head: &str, tail: &[u8]| [head.as_bytes(), &bytes, tail].concat();
    for whole in [p5("P5 4 4 255\n", b"\n"), p5("P5\r\n4 4\r\n255\r\n", b"")] {
        assert_eq!(codes(&whole, "m", 8, &[]), words);
    }
    let pfm = [b"Pf\r\n4 4\r\n-1\r\n".as_slice(), &[0.5f32.to_le_bytes(); 16].concat()].concat();
    assert_eq!(codes(&pfm, "m", 8, &["map.range=0,1"]), [128; 16]);
    for (file, what) in [
        (p5("P5 4 4 255\n", b"x"), "1 byte stands after its last pixel, and a map is one picture"),
        (p5("P5 4 4 255\n", &p5("P5 4 4 255\n", b"")), "27 bytes stand after its last pixel"),
        (p5("P5\r\n4 4\r\n255\r\n", b"\n"), "2 bytes stand after its last pixel"),
        (format!("P2 4 4 255{} 7", text(&words)).into_bytes(), "\"7\" stands after its last pixel"),
        ([b"P7\nWIDTH 4\nWIDTH 4\nENDHDR\n".as_slice(), &bytes].concat(), "WIDTH stands there twice"),
    ] {
        let told = sentence(decode_as(&file, "m", &keys(&[])));
        assert!(told.contains(what), "{told}");
    }
    // In a bitmap 1 is black; digits need no space between them.
    let bits: Vec<u64> = [0, 3, 3, 0, 3, 0, 0, 0, 3, 3, 3, 3, 0, 0, 0, 3].to_vec();
    for file in [b"P1 4 4 1001 0111\n0000 1110".to_vec(), b"P4 4 4\n\x90\x70\x00\xe0".to_vec()] {
        assert_eq!(codes(&file, "m", 2, &[]), bits);
    }
}

#[test]
fn pfm_from_the_bottom_in_both_orders() {
    let values: Vec<f32> = (0..16).map(|at| at as f32 * 3.5 - 20.0).collect();
    let upward: Vec<f32> = values.chunks(4).rev().flatten().copied().collect();
    let exact: Vec<f64> = values.iter().map(|v| f64::from(*v)).collect();
    let little: Vec<u8> = upward.iter().flat_map(|v| v.to_le_bytes()).collect();
    let big: Vec<u8> = upward.iter().flat_map(|v| v.to_be_bytes()).collect();
    let colour: Vec<u8> = upward.iter().flat_map(|v| [v.to_le_bytes(); 3]).flatten().collect();
    for file in [
        [b"Pf\n4 4\n-1.0\n".as_slice(), &little].concat(),
        [b"Pf\n4 4\n1.0\n".as_slice(), &big].concat(),
        [b"PF 4 4 -1\n".as_slice(), &colour].concat(),
    ] {
        let (map, _) = decode_as(&file, "m.pfm", &keys(&["map.range=-20,44"])).unwrap();
        assert_eq!(map.samples.iter().map(|h| h * 64.0 - 20.0).collect::<Vec<f64>>(), exact);
    }
}

#[test]
fn files_without_a_header() {
    let words = ramp(16);
    let little: Vec<u8> = words.iter().flat_map(|w| (*w as u16).to_le_bytes()).collect();
    let big: Vec<u8> = words.iter().flat_map(|w| (*w as u16).to_be_bytes()).collect();
    assert_eq!(codes(&little, "m.r16", 16, &[]), words, "a square tells its size");
    assert_eq!(codes(&little, "m.raw", 16, &["map.size=4,4"]), words);
    assert_eq!(codes(&big, "m.RAW", 16, &["map.size=4,4", "map.byte_order=big"]), words);
    assert_eq!(codes(&big, "m.bin", 16, &["map.size=4,4", "map.byte_order=big"]), words);
    let bytes: Vec<u8> = ramp(8).iter().map(|w| *w as u8).collect();
    assert_eq!(codes(&bytes, "m.raw", 8, &["map.size=4,4"]), ramp(8));
    let floats: Vec<u8> = (0..16).flat_map(|at| (at as f32).to_le_bytes()).collect();
    assert_eq!(codes(&floats, "m.r32", 4, &["map.range=0,15"]), (0..16).collect::<Vec<u64>>());
    let told = sentence(decode_codes(&little, "m.raw", &keys(&[]), 2, 16, false));
    assert!(
        told.starts_with("m.raw: a RAW file has no header (32 bytes): give its size with --set map.size="),
        "{told}"
    );
    let told = sentence(decode_codes(&little, "m.raw", &keys(&["map.size=5,4"]), 2, 16, false));
    assert!(told.contains("32 bytes, which are no 5 x 4 heights (map.size)"), "{told}");
    let told = sentence(decode_codes(&little[..30], "m.r16", &keys(&[]), 2, 16, false));
    assert!(told.contains("30 bytes are no square of heights of 2 bytes"), "{told}");
}

#[test]
fn srtm_tiles() {
    let values: Vec<i16> = (0..16).map(|at| at * 300 - 430).collect();
    let file: Vec<u8> = values.iter().flat_map(|v| v.to_be_bytes()).collect();
    let exact: Vec<f64> = values.iter().map(|v| f64::from(*v)).collect();
    assert_eq!(units(&file, "N47E011.hgt", -1000.0, 9000.0, &[]), exact);
    let mut holes = file;
    holes[2..4].copy_from_slice(&(-32768i16).to_be_bytes());
    let told = sentence(decode_as(&holes, "a.hgt", &keys(&["map.range=-1000,9000"])));
    assert!(
        told.starts_with("a.hgt: 1 of 16 texels have no data (-32768, or not a number), the first is pixel (1, 0)"),
        "{told}"
    );
    assert_eq!(units(&holes, "a.hgt", -1000.0, 9000.0, &["map.fill=12"])[1], 12.0);
    let told = sentence(decode_as(&holes[..20], "a.hgt", &keys(&[])));
    assert!(told.contains("20 bytes are no square of 16-bit heights (1201 x 1201 or 3601 x 3601"), "{told}");
}

#[test]
fn esri_grids() {
    let file = "NCOLS 4\r\nnrows 4\nxllcorner 1.5\nyllcorner -2\ncellsize 30\nNODATA_value -9999\n0 1 2 3\n4.0 5 6e0 7\n8 9 10 11\n12 13 14 -9999\n";
    let mut exact: Vec<f64> = (0..16).map(f64::from).collect();
    assert!(sentence(decode_as(file.as_bytes(), "m.asc", &keys(&["map.range=0,15"]))).contains("pixel (3, 3)"));
    exact[15] = 2.0;
    assert_eq!(units(file.as_bytes(), "m.asc", 0.0, 15.0, &["map.fill=2"]), exact);
    for (text, what) in [
        ("ncols 4\nnrows 4\n1 2 3", "16 heights"),
        ("ncols 1\nnrows 2\n1 2 3", "\"3\" stands after its last pixel"),
        ("ncols 1\nnrows 2\ncolour red\n1 2", "\"colour\" is no key of its header"),
        ("ncols 1\nncols 2\n1 2", "ncols stands there twice"),
        ("ncols 2\n1 2", "its header lacks nrows"),
        ("ncols 1\nnrows 2\n0,5 1", "\"0,5\" has a comma where a number has a point"),
        ("\u{feff}ncols 1\nnrows 2\n1 x", "\"x\" is not a number where pixel (0, 1) should stand"),
        ("ncols 1\nnrows 2\n1 x", "\"x\" is not a number where pixel (0, 1) should stand"),
    ] {
        let told = sentence(decode_as(text.as_bytes(), "m", &keys(&[])));
        assert!(
            told.contains(what) || (what == "16 heights" && told.contains("4 x 4 heights are announced in")),
            "{told}"
        );
    }
}

#[test]
fn dds_of_one_channel() {
    use ddsfile::DxgiFormat::{BC1_UNorm, BC4_UNorm, R8_UNorm, R16_UNorm, R32_Float};
    let words = ramp(16);
    let two: Vec<u8> = words.iter().flat_map(|w| (*w as u16).to_le_bytes()).collect();
    assert_eq!(codes(&dds(4, 4, R16_UNorm, &two), "m.dds", 16, &[]), words);
    let one: Vec<u8> = ramp(8).iter().map(|w| *w as u8).collect();
    assert_eq!(codes(&dds(4, 4, R8_UNorm, &one), "m.dds", 8, &[]), ramp(8));
    let floats: Vec<u8> = (0..16).flat_map(|at| (at as f32).to_le_bytes()).collect();
    assert_eq!(codes(&dds(4, 4, R32_Float, &floats), "m.dds", 4, &["map.range=0,15"]), (0..16).collect::<Vec<u64>>());
    // Eight values between two ends: texel k has place k % 8.
    let places = |k: u64| (0..16u64).fold(0, |word, at| word | (at * k % 8) << (3 * at)).to_le_bytes();
    let block = |first: u8, last: u8, k: u64| [&[first, last], &places(k)[..6]].concat();
    let six = [210, 0, 180, 150, 120, 90, 60, 30];
    let expected: Vec<u64> = (0..16).map(|at| six[at % 8]).collect();
    assert_eq!(codes(&dds(4, 4, BC4_UNorm, &block(210, 0, 1)), "m.dds", 8, &[]), expected);
    let four = [50, 200, 80, 110, 140, 170, 0, 255];
    let expected: Vec<u64> = (0..16).map(|at| four[at * 3 % 8]).collect();
    assert_eq!(codes(&dds(4, 4, BC4_UNorm, &block(50, 200, 3)), "m.dds", 8, &[]), expected);
    let told = sentence(decode_as(&dds(4, 4, BC1_UNorm, &[0; 8]), "m.dds", &keys(&[])));
    assert!(told.contains("its pixels are BC1_UNorm: of one channel, R8, R16"), "{told}");
}

#[test]
fn pictures_of_bytes() {
    let bytes: Vec<u8> = ramp(8).iter().map(|w| *w as u8).collect();
    let colour: Vec<u8> = bytes.iter().flat_map(|b| [*b; 3]).collect();
    let mut bmp = Vec::new();
    image::codecs::bmp::BmpEncoder::new(&mut bmp).encode(&bytes, 4, 4, Kind::L8).unwrap();
    let mut colours = Vec::new();
    image::codecs::bmp::BmpEncoder::new(&mut colours).encode(&colour, 4, 4, Kind::Rgb8).unwrap();
    let mut tga = Vec::new();
    image::codecs::tga::TgaEncoder::new(&mut tga).write_image(&bytes, 4, 4, Kind::L8).unwrap();
    let mut webp = Vec::new();
    image::codecs::webp::WebPEncoder::new_lossless(&mut webp).write_image(&bytes, 4, 4, Kind::L8).unwrap();
    for (file, name) in [(bmp, "m.bmp"), (colours, "m"), (tga, "m.tga"), (webp, "m.webp")] {
        assert_eq!(codes(&file, name, 8, &[]), ramp(8), "{name}");
    }
}

#[test]
fn what_is_compressed_with_loss_is_read_only_when_asked_for() {
    let grey = image::GrayImage::from_pixel(8, 8, image::Luma([128]));
    let mut jpeg = Cursor::new(Vec::new());
    image::DynamicImage::ImageLuma8(grey).write_to(&mut jpeg, ImageFormat::Jpeg).unwrap();
    let jpeg = jpeg.into_inner();
    let told = sentence(decode_as(&jpeg, "m.jpg", &keys(&[])));
    assert!(
        told.starts_with("m.jpg: a JPEG is compressed with loss: its heights are not those that were stored"),
        "{told}"
    );
    assert!(told.contains("--set map.lossy=true"), "{told}");
    let (map, taken) = decode_as(&jpeg, "m.jpg", &keys(&["map.lossy=true"])).unwrap();
    assert_eq!((map.samples[0], taken.format.as_str()), (128.0 / 255.0, "JPEG"));
    // The head of a lossy WebP is enough to refuse it.
    let webp = [b"RIFF\x1a\0\0\0WEBPVP8 ".as_slice(), &[14, 0, 0, 0], &[0; 14]].concat();
    assert!(sentence(decode_as(&webp, "m.webp", &keys(&[]))).contains("this WebP is compressed with loss"));
}
