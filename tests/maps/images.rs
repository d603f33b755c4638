//! Height maps from image files: exact where they can be, one clear sentence where they can't.
use image::{ExtendedColorType as Kind, ImageEncoder, ImageFormat};
use reliefrtl::error::Error;
use reliefrtl::scene::{Depth, HeightMap, decode, load, to_codes};
use std::io::Cursor;

const READ: &str = "PNG, PGM (PBM, PPM, PAM), PFM, TIFF (BigTIFF, GeoTIFF), OpenEXR, BMP, TGA, lossless WebP, DDS (R8, R16, R32F, BC4), SRTM HGT, ESRI ASC, and R16 / RAW with map.size";

fn sentence<T: std::fmt::Debug>(result: Result<T, Error>) -> String {
    let error = result.expect_err("it must be refused");
    assert_eq!(error.exit_code(), 2);
    let text = error.to_string();
    assert!(!text.contains('\n'), "one sentence: {text}");
    text
}

fn png(pixels: &[u8], width: u32, height: u32, kind: Kind) -> Vec<u8> {
    let mut bytes = Vec::new();
    image::codecs::png::PngEncoder::new(&mut bytes).write_image(pixels, width, height, kind).unwrap();
    bytes
}

fn tiff(pixels: &[u8], width: u32, height: u32, kind: Kind) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    image::codecs::tiff::TiffEncoder::new(&mut bytes).write_image(pixels, width, height, kind).unwrap();
    bytes.into_inner()
}

fn grey_float_tiff(pixels: &[f32], width: u32, height: u32) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    let mut encoder = tiff::encoder::TiffEncoder::new(&mut bytes).unwrap();
    encoder.write_image::<tiff::encoder::colortype::Gray32Float>(width, height, pixels).unwrap();
    bytes.into_inner()
}

fn rgb_exr(pixels: Vec<f32>, width: u32, height: u32) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    image::DynamicImage::ImageRgb32F(image::ImageBuffer::from_raw(width, height, pixels).unwrap())
        .write_to(&mut bytes, ImageFormat::OpenExr)
        .unwrap();
    bytes.into_inner()
}

fn one_channel_exr(name: &str, pixels: &[f32], width: usize) -> Vec<u8> {
    use exr::prelude::{AnyChannel, AnyChannels, FlatSamples, Image, WritableImage};
    let channel = AnyChannel::new(name, FlatSamples::F32(pixels.to_vec()));
    let size = (width, pixels.len() / width);
    let image = Image::from_channels(size, AnyChannels::sort([channel].into_iter().collect()));
    let mut bytes = Cursor::new(Vec::new());
    image.write().to_buffered(&mut bytes).unwrap();
    bytes.into_inner()
}

fn bytes16(values: &[u16]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_ne_bytes()).collect()
}

fn map(bytes: &[u8]) -> HeightMap {
    decode(bytes, "map").unwrap()
}

fn refused(bytes: &[u8]) -> String {
    sentence(decode(bytes, "map"))
}

#[test]
fn every_code_of_8_and_16_bits_survives() {
    let all8: Vec<u8> = (0..=255).collect();
    let codes8: Vec<u32> = (0..256).collect();
    let rgb: Vec<u8> = all8.iter().flat_map(|&grey| [grey; 3]).collect();
    let rgba: Vec<u8> = all8.iter().flat_map(|&grey| [grey, grey, grey, 255]).collect();
    let mut p5 = b"P5 16 16 255\n".to_vec();
    p5.extend(&all8);
    for bytes in [
        png(&all8, 16, 16, Kind::L8),
        png(&rgb, 16, 16, Kind::Rgb8),
        png(&rgba, 16, 16, Kind::Rgba8),
        tiff(&all8, 16, 16, Kind::L8),
        tiff(&rgb, 16, 16, Kind::Rgb8),
        p5,
    ] {
        let map = map(&bytes);
        assert_eq!((map.width, map.height, map.depth), (16, 16, Depth::Bits(8)));
        assert_eq!(to_codes(&map, 4, 8, false).unwrap(), codes8);
        let wide: Vec<u32> = codes8.iter().map(|code| code * 257).collect();
        assert_eq!(to_codes(&map, 4, 16, false).unwrap(), wide, "more bits lose nothing");
    }
    let all16: Vec<u16> = (0..=65535).collect();
    let codes16: Vec<u32> = (0..65536).collect();
    let rgb: Vec<u16> = all16.iter().flat_map(|&grey| [grey; 3]).collect();
    let mut p5 = b"P5\n# a comment\n256 256\n65535\n".to_vec();
    p5.extend(all16.iter().flat_map(|grey| grey.to_be_bytes()));
    let mut p2 = String::from("P2\n256 256 # size\n65535\n");
    p2.extend(all16.iter().map(|grey| format!("{grey}\n")));
    for bytes in [
        png(&bytes16(&all16), 256, 256, Kind::L16),
        png(&bytes16(&rgb), 256, 256, Kind::Rgb16),
        tiff(&bytes16(&all16), 256, 256, Kind::L16),
        p5,
        p2.into_bytes(),
    ] {
        let map = map(&bytes);
        assert_eq!(map.depth, Depth::Bits(16));
        assert_eq!(to_codes(&map, 8, 16, false).unwrap(), codes16);
    }
}

#[test]
fn other_depths() {
    let ten = map(b"P2 2 2 1023\n0 1 1022 1023");
    assert_eq!(ten.depth, Depth::Bits(10));
    let codes = to_codes(&HeightMap { width: 1, height: 4, ..ten }, 2, 10, true).unwrap();
    assert_eq!((codes[0], codes[15]), (0, 1023));
    assert_eq!(map(b"P5 1 1 1\n\x01").depth, Depth::Bits(1));
}

#[test]
fn floats_count_as_they_are() {
    let values = [0.0, 0.25, 0.1, 1.0];
    let exact: Vec<f64> = values.iter().map(|&value| f64::from(value)).collect();
    let rgb: Vec<f32> = values.iter().flat_map(|&grey| [grey; 3]).collect();
    let rgb_bytes: Vec<u8> = rgb.iter().flat_map(|value| value.to_ne_bytes()).collect();
    for bytes in [
        grey_float_tiff(&values, 2, 2),
        tiff(&rgb_bytes, 2, 2, Kind::Rgb32F),
        rgb_exr(rgb, 2, 2),
        one_channel_exr("Y", &values, 2),
        one_channel_exr("height", &values, 2),
    ] {
        let map = map(&bytes);
        assert_eq!(map.depth, Depth::Float);
        assert_eq!(map.samples, exact);
    }
}

#[test]
fn colour_is_no_height() {
    let told = refused(&png(&[9, 9, 9, 0, 255, 0], 2, 1, Kind::Rgb8));
    assert!(told.contains("in colour (pixel (1, 0) has red, green and blue 0, 255, 0)"), "{told}");
    assert!(refused(b"P3 1 1 255 0 0 255").contains("a height map has one channel"));
    assert!(refused(&rgb_exr(vec![0.5, 0.5, 0.25], 1, 1)).contains("0.5, 0.5, 0.25"));
    // Alpha is no colour, but where it is not opaque there is a hole.
    assert_eq!(map(&png(&[255; 4], 1, 1, Kind::Rgba8)).samples, [1.0]);
    let told = refused(&png(&[255, 255, 255, 7], 1, 1, Kind::Rgba8));
    assert!(told.contains("pixel (0, 0) is not opaque (alpha 7 of 255)"), "{told}");
}

#[test]
fn floats_out_of_range_name_the_pixel() {
    assert_eq!(
        refused(&grey_float_tiff(&[0.0, 1.0, 0.5, f32::NAN], 2, 2)),
        "map: 1 of 4 texels have no data (not a number), the first is pixel (1, 1): give the height that they take, in the file's units, as --set map.fill=0"
    );
    assert_eq!(
        refused(&grey_float_tiff(&[0.0, f32::INFINITY], 2, 1)),
        "map: pixel (1, 0) is inf, as 1 of 2 heights are infinite: if that stands for no data, say so and give the height that they take, in the file's units, as --set map.nodata=inf --set map.fill=0"
    );
    assert_eq!(
        refused(&one_channel_exr("Y", &[0.0, 0.0, 1.5, 0.0], 2)),
        "map: pixel (0, 1) is 1.5: heights must be in 0 to 1; 1 of 4 texels lie outside, and the file's heights go from 0 to 1.5: use --set map.range=0,1.5 or --set map.range=auto"
    );
    assert!(
        refused(&rgb_exr(vec![-0.5; 3], 1, 1)).starts_with("map: pixel (0, 0) is -0.5: heights must be in 0 to 1;")
    );
    assert!(refused(&rgb_exr(vec![0.2, f32::NAN, 0.2], 1, 1)).starts_with("map: 1 of 1 texels have no data"));
    assert!(refused(&rgb_exr(vec![1.2; 3], 1, 1)).starts_with("map: pixel (0, 0) is 1.2000000476837158: heights"));
}

#[test]
fn broken_files() {
    assert_eq!(refused(b""), format!("map: the file is empty: {READ} are read"));
    assert_eq!(refused(b"GIF89a..."), format!("map: not a file of a known kind: {READ} are read"));
    assert_eq!(refused(b"hello"), format!("map: not a file of a known kind: {READ} are read"));
    let whole = png(&[0; 1024], 32, 32, Kind::L8);
    assert!(refused(&whole[..whole.len() / 2]).starts_with("map: not a readable PNG: "));
    let whole = grey_float_tiff(&[0.0; 64], 8, 8);
    assert!(refused(&whole[..40]).starts_with("map: not a readable TIFF: "));
    let whole = one_channel_exr("Y", &[0.0; 64], 8);
    assert!(refused(&whole[..whole.len() - 30]).starts_with("map: not a readable OpenEXR: "));
    assert_eq!(
        refused(b"P5 4 4 255\nabc"),
        "map: not a readable PGM: 4 x 4 pixels of 4 bytes a row are announced, but only 3 bytes follow"
    );
    assert_eq!(refused(b"P5 0 4 255\n"), "map: an empty image (0 x 4): at least one pixel is needed");
    assert_eq!(
        refused(b"P5 99999999999 99999999999 255\n"),
        "map: 99999999999 x 99999999999 are 9999999999800000000001 texels, more than map.max_texels may be (1099511627776)"
    );
    assert_eq!(refused(b"P5 4 4"), "map: not a readable portable map: it ends before the maximum");
    assert_eq!(refused(b"P5 4 4 70000\n"), "map: not a readable PGM: its maximum is 70000, 1 to 65535 are legal");
    assert_eq!(
        refused(b"P2 2 1 9\n1 x9 9"),
        "map: not a readable portable map: \"x9\" is not a number where pixel (1, 0) should stand"
    );
    assert_eq!(refused(b"P2 2 1 9\n1 10"), "map: not a readable PGM: pixel (1, 0) is 10, above its maximum 9");
    let missing = sentence(load("no/such/map.png"));
    assert!(missing.starts_with("cannot read no/such/map.png: "), "{missing}");
}

#[test]
fn cut_and_changed_files_never_panic() {
    let files = [
        png(&(0..=255).collect::<Vec<u8>>(), 16, 16, Kind::L8),
        grey_float_tiff(&[0.5; 64], 8, 8),
        one_channel_exr("Y", &[0.5; 64], 8),
        b"P2 2 2 255 1 2 3 4".to_vec(),
    ];
    for file in files {
        for at in 0..file.len().min(400) {
            let _ = decode(&file[..at], "cut");
            let mut changed = file.clone();
            changed[at] ^= 0xff;
            let _ = decode(&changed, "changed");
        }
    }
}

#[test]
fn another_size_or_depth_is_refused_with_the_fix() {
    let flat =
        |width: usize, height: usize, depth| HeightMap::new(width, height, vec![0.5; width * height], depth).unwrap();
    let codes = |map: HeightMap, levels, bits| sentence(to_codes(&map, levels, bits, false));
    let eight = Depth::Bits(8);
    assert_eq!(
        codes(flat(16, 16, Depth::Bits(16)), 4, 8),
        "16-bit map into traverse.height_bits = 8: set height_bits = 16 or ask for it with --resample"
    );
    assert_eq!(
        codes(flat(64, 64, eight), 8, 8),
        "the map is 64 x 64, but traverse.levels = 8 needs 256 x 256: use --set traverse.levels=6, or --resample"
    );
    assert_eq!(
        codes(flat(64, 32, eight), 6, 8),
        "the map is 64 x 32, not square, and traverse.levels = 6 needs 64 x 64: use --set traverse.levels=5 --crop (its first 32 x 32), --pad (continued to 64 x 64), or --resample (filtered to 64 x 64)"
    );
    assert_eq!(
        codes(flat(100, 100, eight), 6, 8),
        "the map is 100 x 100, no power of two, and traverse.levels = 6 needs 64 x 64: use --crop (its first 64 x 64), --set traverse.levels=7 --pad (continued to 128 x 128), or --resample (filtered to 64 x 64)"
    );
    let told = codes(flat(1025, 1025, eight), 8, 8);
    assert!(
        told.contains("use --set traverse.levels=10 --crop (its first 1024 x 1024), --set traverse.levels=11 --pad"),
        "{told}"
    );
    assert_eq!(
        codes(flat(1, 1, eight), 2, 8),
        "the map is 1 x 1, not 4 to 4096 texels wide, and traverse.levels = 2 needs 4 x 4: use --resample (filtered to 4 x 4)"
    );
    assert_eq!(
        codes(flat(8, 8, Depth::Bits(16)), 2, 8),
        "the map is 8 x 8, but traverse.levels = 2 needs 4 x 4: use --set traverse.levels=3, or --resample; 16-bit map into traverse.height_bits = 8: set height_bits = 16 or ask for it with --resample"
    );
}

#[test]
fn resampling_keeps_the_mean_and_the_constant() {
    let checker: Vec<f64> = (0..64).map(|at| f64::from((at + at / 8) % 2)).collect();
    let map = HeightMap::new(8, 8, checker, Depth::Bits(8)).unwrap();
    assert_eq!(to_codes(&map, 2, 8, true).unwrap(), [128; 16], "each texel is the mean of four");
    // 3 texels to 4: a quarter of the way in, the neighbours share.
    let ramp = HeightMap::new(3, 1, vec![0.0, 0.5, 1.0], Depth::Float).unwrap();
    assert_eq!(to_codes(&ramp, 2, 8, true).unwrap()[..4], [32, 80, 175, 223]);
    // 6 to 4: a texel and a half each.
    let ramp = HeightMap::new(6, 1, vec![0.0, 0.2, 0.4, 0.6, 0.8, 1.0], Depth::Float).unwrap();
    assert_eq!(to_codes(&ramp, 2, 8, true).unwrap()[..4], [17, 85, 170, 238]);
    for (width, height) in [(5, 7), (100, 3), (1, 1), (64, 16)] {
        for value in [0.0, 0.3, 1.0] {
            let map = HeightMap::new(width, height, vec![value; width * height], Depth::Bits(16)).unwrap();
            let code = (value * 255.0_f64).round() as u32;
            assert_eq!(to_codes(&map, 4, 8, true).unwrap(), [code; 256]);
        }
    }
}

#[test]
fn a_floating_point_map_becomes_codes_only_when_asked_for() {
    let map = HeightMap::new(4, 4, vec![0.3; 16], Depth::Float).unwrap();
    let refused = to_codes(&map, 2, 8, false).unwrap_err().to_string();
    assert!(refused.contains("floating-point map into traverse.height_bits = 8"), "{refused}");
    assert_eq!(to_codes(&map, 2, 8, true).unwrap(), [77; 16]);
    let made = HeightMap::new(4, 4, vec![0.3; 16], Depth::Formula).unwrap();
    assert_eq!(to_codes(&made, 2, 8, false).unwrap(), [77; 16]);
}
