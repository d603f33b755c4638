//! OpenEXR by channel, part and window, in every order of blocks, and no more of it in memory than is in work.
use super::formats::codes;
use super::make::exr;
use super::memory::peak;
use super::{keys, sentence};
use exr::prelude::{AnyChannel, AnyChannels, Blocks, Compression, Encoding, FlatSamples, LineOrder, f16};
use exr::prelude::{Image, Layer, LayerAttributes, Vec2, WritableImage};
use reliefrtl::scene::{decode_as, decode_codes};
use std::io::Cursor;

#[test]
fn exr_by_channel() {
    let values: Vec<f32> = (0..16).map(|at| at as f32 / 15.0).collect();
    let zero = [0.0f32; 16];
    let grey = |file: &[u8], sets: &[&str]| {
        let sets = [sets, &["map.range=0,1"]].concat();
        codes(file, "m.exr", 4, &sets)
    };
    let ramp: Vec<u64> = (0..16).collect();
    assert_eq!(grey(&exr(&[("Y", &values)], 4), &[]), ramp);
    assert_eq!(grey(&exr(&[("depth", &values)], 4), &[]), ramp);
    assert_eq!(grey(&exr(&[("R", &values), ("G", &values), ("B", &values)], 4), &[]), ramp);
    let both = exr(&[("R", &zero), ("G", &zero), ("B", &zero), ("height", &values)], 4);
    let told = sentence(decode_as(&both, "m.exr", &keys(&[])));
    let asked = "m.exr: the file has the channels B, G, R, height, and which one holds the heights is not ours to guess: choose it with --set map.channel=height";
    assert_eq!(told, asked);
    assert_eq!(grey(&both, &["map.channel=height"]), ramp);
    assert_eq!(grey(&both, &["map.channel=R"]), [0; 16]);
    let told = sentence(decode_as(&both, "m.exr", &keys(&["map.channel=Z"])));
    assert_eq!(told, "m.exr: there is no channel \"Z\" (map.channel): the file has B, G, R, height");
}

/// An OpenEXR of parts of 2 x 2 heights, each at its place in the display window.
fn parts(list: &[(&str, &[f32], (i32, i32))], display: (usize, usize), encoding: exr::prelude::Encoding) -> Vec<u8> {
    use exr::prelude::*;
    let layer = |(name, values, place): &(&str, &[f32], (i32, i32))| {
        let channel = AnyChannel::new("Y", FlatSamples::F32(values.to_vec()));
        let named = LayerAttributes::named(*name).with_position(Vec2(place.0, place.1));
        Layer::new((2, 2), named, encoding, AnyChannels::sort([channel].into_iter().collect()))
    };
    let window = IntegerBounds::new((0, 0), display);
    let image = Image::from_layers(ImageAttributes::new(window), list.iter().map(layer).collect::<Vec<_>>());
    let mut out = Cursor::new(Vec::new());
    image.write().to_buffered(&mut out).unwrap();
    out.into_inner()
}

#[test]
fn exr_by_part_and_window() {
    use exr::prelude::Encoding;
    let (values, other) = ([0.25f32, 0.5, 0.75, 1.0], [0.0f32; 4]);
    let read = |file: &[u8], sets: &[&str]| decode_as(file, "m.exr", &keys(sets));
    for encoding in [Encoding::UNCOMPRESSED, Encoding::FAST_LOSSLESS, Encoding::SMALL_LOSSLESS] {
        let two = parts(&[("mask", &other, (0, 0)), ("height", &values, (0, 0))], (2, 2), encoding);
        let told = sentence(read(&two, &[]));
        assert!(told.contains("the file has the parts 0 (mask), 1 (height), and which one"), "{told}");
        for part in ["map.part=height", "map.part=1"] {
            let (map, taken) = read(&two, &[part]).unwrap();
            assert_eq!((map.samples, taken.part.as_deref()), (vec![0.25, 0.5, 0.75, 1.0], Some("1 (height)")));
        }
        assert!(sentence(read(&two, &["map.part=2"])).contains("there is no part \"2\" (map.part)"));
        // The data window is a part of the display window, or reaches beyond it.
        let small = parts(&[("height", &values, (1, 0))], (3, 3), encoding);
        let told = sentence(read(&small, &[]));
        let why = "5 of 9 texels have no data (not a number), the first is pixel (0, 0); the file has a data window of 2 x 2 at (1, 0) of a display window of 3 x 3";
        assert!(told.contains(why), "{told}");
        let (map, _) = read(&small, &["map.fill=0.125"]).unwrap();
        assert_eq!(map.samples, [0.125, 0.25, 0.5, 0.125, 0.75, 1.0, 0.125, 0.125, 0.125]);
        let large = parts(&[("height", &values, (-1, -1))], (1, 1), encoding);
        assert_eq!(read(&large, &[]).unwrap().0.samples, [1.0]);
    }
}

/// `side` x `side` heights in the channel `height` (half or single precision), between two channels of other numbers.
fn three(side: usize, half: bool, encoding: Encoding) -> Vec<u8> {
    let heights: Vec<f32> = (0..side * side).map(|at| (at * 7919 % 2048) as f32 / 2048.0).collect();
    let heights = if half {
        FlatSamples::F16(heights.iter().map(|height| f16::from_f32(*height)).collect())
    } else {
        FlatSamples::F32(heights)
    };
    let list = [
        AnyChannel::new("another", FlatSamples::U32((0..side * side).map(|at| at as u32).collect())),
        AnyChannel::new("height", heights),
        AnyChannel::new("mask", FlatSamples::F32(vec![7.0; side * side])),
    ];
    let layer = Layer::new(
        (side, side),
        LayerAttributes::named("map"),
        encoding,
        AnyChannels::sort(list.into_iter().collect()),
    );
    let mut out = Cursor::new(Vec::new());
    Image::from_layer(layer).write().to_buffered(&mut out).unwrap();
    out.into_inner()
}

/// Compressions and orders of blocks.
fn encodings() -> Vec<(&'static str, Encoding)> {
    let tiles = Blocks::Tiles(Vec2(48, 32));
    let one = |compression, blocks, line_order| Encoding { compression, blocks, line_order };
    vec![
        ("lines", one(Compression::Uncompressed, Blocks::ScanLines, LineOrder::Increasing)),
        ("zip", one(Compression::ZIP16, Blocks::ScanLines, LineOrder::Increasing)),
        ("piz", one(Compression::PIZ, Blocks::ScanLines, LineOrder::Increasing)),
        ("zip tiles", one(Compression::ZIP16, tiles, LineOrder::Increasing)),
        ("rle tiles", one(Compression::RLE, tiles, LineOrder::Decreasing)),
        ("piz tiles", one(Compression::PIZ, tiles, LineOrder::Unspecified)),
        ("backwards", one(Compression::ZIP1, Blocks::ScanLines, LineOrder::Decreasing)),
    ]
}

#[test]
fn exr_in_every_order_of_blocks() {
    const SIDE: usize = 128;
    let expected: Vec<u32> = (0..SIDE * SIDE).map(|at| (at * 7919 % 2048) as u32).collect();
    for (name, encoding) in encodings() {
        for half in [false, true] {
            let file = three(SIDE, half, encoding);
            let map = keys(&["map.channel=height", "map.range=[0, 0.99951171875]"]);
            let (codes, taken) = decode_codes(&file, "m.exr", &map, 7, 11, false).unwrap();
            assert!(codes == expected, "{name}, half {half}");
            assert!(taken.to_string().contains(if half { "16-bit float" } else { "32-bit float" }), "{taken}");
            // Cut in its last block: the sentence names the row whose heights are not there.
            let told = sentence(decode_codes(&file[..file.len() - 9], "m.exr", &map, 7, 11, false));
            assert!(told.starts_with("m.exr: not a readable OpenEXR: "), "{name}: {told}");
        }
    }
}

#[test]
fn exr_takes_the_memory_of_what_is_kept() {
    const SIDE: usize = 512;
    for (name, encoding) in encodings() {
        for half in [false, true] {
            let file = three(SIDE, half, encoding);
            let auto = keys(&["map.channel=height", "map.range=auto"]);
            let (_, bytes) = peak(|| decode_codes(&file, "m.exr", &auto, 9, 16, false).unwrap());
            assert!(bytes <= 24 * SIDE * SIDE, "{name}, half {half}: {bytes} bytes for {SIDE} x {SIDE} texels");
            // Filtered to 64 x 64, row of blocks by row of blocks, where the file has them in the order of rows. A decoder has tables.
            let (_, bytes) = peak(|| decode_codes(&file, "m.exr", &keys(&["map.channel=height"]), 6, 8, true).unwrap());
            let tables = if encoding.compression == Compression::PIZ { 7 << 18 } else { 1 << 20 };
            let waiting = if encoding.line_order == LineOrder::Increasing { 0 } else { 8 * SIDE * SIDE };
            assert!(bytes <= 24 * 64 * 64 + tables + waiting, "{name}, half {half}: {bytes} bytes for 64 x 64 texels");
        }
    }
}

#[test]
#[ignore = "a minute; part of sh tools/test.sh --full"]
fn exr_of_16_million_texels_takes_24_bytes_each() {
    const SIDE: usize = 4096;
    for (name, encoding) in encodings() {
        for half in [false, true] {
            let file = three(SIDE, half, encoding);
            let auto = keys(&["map.channel=height", "map.range=auto"]);
            let (_, bytes) = peak(|| decode_codes(&file, "m.exr", &auto, 12, 16, false).unwrap());
            let each = bytes as f64 / (SIDE * SIDE) as f64;
            println!("{name}, half {half}: {each:.1} bytes a texel");
            assert!(each <= 24.0, "{name}, half {half}: {each:.1} bytes a texel");
            let (_, bytes) = peak(|| decode_codes(&file, "m.exr", &keys(&["map.channel=height"]), 8, 8, true).unwrap());
            println!("    filtered to 256 x 256: {} kB", bytes >> 10);
        }
    }
}
