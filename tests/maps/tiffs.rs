//! TIFFs of every kind that is read, from known codes to the same codes.
use super::formats::{codes, ramp, units};
use super::make::Tiff;
use super::{keys, sentence};
use reliefrtl::scene::{decode_as, decode_codes};

#[test]
fn tiff_of_every_depth() {
    for bits in 1..=16 {
        let words = ramp(bits);
        for big_endian in [false, true] {
            let file = Tiff { big_endian, ..Tiff::grey(4, bits, &words) }.bytes();
            if bits > 1 {
                assert_eq!(codes(&file, "m.tif", bits, &[]), words, "{bits} bits");
            }
            let inverted: Vec<u64> = words.iter().map(|w| (1 << bits) - 1 - w).collect();
            let white = Tiff { big_endian, photometric: 0, ..Tiff::grey(4, bits, &inverted) }.bytes();
            assert_eq!(codes(&white, "m.tif", 16, &[]), codes(&file, "m.tif", 16, &[]), "{bits} bits, 0 is white");
        }
    }
    let words = ramp(32);
    let exact: Vec<f64> = words.iter().map(|w| *w as f64).collect();
    let file = Tiff::grey(4, 32, &words).bytes();
    assert_eq!(units(&file, "m.tif", 0.0, f64::from(u32::MAX), &[]), exact);
}

#[test]
fn tiff_of_signed_numbers_and_floats() {
    for bits in [8, 16, 32] {
        let values: Vec<i64> = (0..16).map(|at| at * 7 - 60 + if at == 3 { 120 - 21 } else { 0 }).collect();
        let words: Vec<u64> = values.iter().map(|v| *v as u64 & (u64::MAX >> (64 - bits))).collect();
        let file = Tiff { format: 2, ..Tiff::grey(4, bits, &words) }.bytes();
        let exact: Vec<f64> = values.iter().map(|v| *v as f64).collect();
        assert_eq!(units(&file, "m.tif", -100.0, 155.0, &[]), exact);
        let shifted: Vec<u64> = values.iter().map(|v| (v + 100) as u64).collect();
        assert_eq!(codes(&file, "m.tif", 8, &["map.range=-100,155"]), shifted, "a range of 255 steps is 8 bits");
    }
    let values: Vec<f64> = (0..16).map(|at| f64::from(at) * 64.0 - 300.0).collect();
    let half = |v: f64| u64::from(half_bits(v));
    let single = |v: f64| u64::from((v as f32).to_bits());
    for (bits, words) in [
        (16, values.iter().map(|v| half(*v)).collect::<Vec<u64>>()),
        (32, values.iter().map(|v| single(*v)).collect()),
        (64, values.iter().map(|v| v.to_bits()).collect()),
    ] {
        for predictor in [1, 3] {
            for big_endian in [false, true] {
                let compression = if predictor == 3 { 8 } else { 1 };
                let grey = Tiff::grey(4, bits, &words);
                let file = Tiff { format: 3, predictor, compression, big_endian, ..grey }.bytes();
                assert_eq!(units(&file, "m.tif", -300.0, 660.0, &[]), values, "{bits} bits, predictor {predictor}");
            }
        }
    }
}

/// A half-precision number of few bits.
fn half_bits(v: f64) -> u16 {
    let bits = v.to_bits();
    let exponent = (bits >> 52 & 2047) as i32 - 1023;
    if v == 0.0 { 0 } else { (bits >> 63 << 15) as u16 | ((exponent + 15) as u16) << 10 | (bits >> 42 & 1023) as u16 }
}

#[test]
fn tiff_however_it_is_cut_and_packed() {
    let words = ramp(12);
    let wide: Vec<u64> = words.iter().map(|w| w * 5 % 65536).collect();
    for compression in [1, 5, 8, 32773, 50000] {
        for (bits, words) in [(12, &words), (16, &wide), (8, &ramp(8))] {
            for predictor in [1, 2] {
                for tile in [None, Some((16, 16)), Some((3, 2))] {
                    for big_tiff in [false, true] {
                        let grey = Tiff::grey(4, bits, words);
                        let file = Tiff { compression, predictor, tile, big_tiff, ..grey };
                        assert_eq!(codes(&file.bytes(), "m.tif", bits, &[]), *words, "{file:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn tiff_of_several_samples() {
    let words = ramp(16);
    for planar in [false, true] {
        for tile in [None, Some((3, 2))] {
            let mixed = |alpha: u64| words.iter().flat_map(|w| [*w, alpha]).collect::<Vec<u64>>();
            let grey = |words: &[u64]| Tiff { samples: 2, planar, tile, height: 4, ..Tiff::grey(4, 16, words) };
            let opaque = Tiff { extra: Some(2), ..grey(&mixed(65535)) }.bytes();
            assert_eq!(codes(&opaque, "m.tif", 16, &[]), words);
            let holes = Tiff { extra: Some(2), ..grey(&mixed(65534)) }.bytes();
            let told = sentence(decode_codes(&holes, "m.tif", &keys(&[]), 2, 16, false));
            assert!(told.contains("pixel (0, 0) is not opaque (alpha 65534 of 65535)"), "{told}");
            assert_eq!(codes(&holes, "m.tif", 16, &["map.channel=Y"]), words);
            // Two bands that are not explained.
            let bands = Tiff { extra: Some(0), ..grey(&mixed(7)) }.bytes();
            let told = sentence(decode_codes(&bands, "m.tif", &keys(&[]), 2, 16, false));
            assert!(told.contains("the file has the channels Y, 2, and which one"), "{told}");
            assert_eq!(codes(&bands, "m.tif", 16, &["map.channel=2"]), [7; 16]);
            for first in ["map.channel=Y", "map.channel=1"] {
                assert_eq!(codes(&bands, "m.tif", 16, &[first]), words);
            }
            let told = sentence(decode_codes(&bands, "m.tif", &keys(&["map.channel=3"]), 2, 16, false));
            assert!(told.contains("there is no channel \"3\" (map.channel): the file has Y, 2"), "{told}");
            let three: Vec<u64> = words.iter().flat_map(|w| [*w; 3]).collect();
            let rgb = Tiff { samples: 3, photometric: 2, planar, tile, height: 4, ..Tiff::grey(4, 16, &three) };
            assert_eq!(codes(&rgb.bytes(), "m.tif", 16, &[]), words);
        }
    }
}

#[test]
fn tiff_palettes() {
    let numbers: Vec<u64> = (0..16).collect();
    for bits in [4, 8] {
        let entry = |at: u16| 65535 - 257 * 3 * (at % 16);
        let palette: Vec<u16> = (0..3).flat_map(|_| (0..1u16 << bits).map(entry)).collect();
        let grey = Tiff::grey(4, bits, &numbers);
        let file = Tiff { photometric: 3, palette: Some(palette), ..grey }.bytes();
        assert_eq!(codes(&file, "m.tif", 8, &[]), (0..16).map(|at| 255 - 3 * at).collect::<Vec<u64>>());
    }
}

#[test]
fn tiff_turned_and_mirrored() {
    // 3 columns, 2 rows: a b c / d e f as it shall be seen.
    let seen = [10u64, 20, 30, 40, 50, 60];
    for (orientation, stored, width) in [
        (1, [10, 20, 30, 40, 50, 60], 3),
        (2, [30, 20, 10, 60, 50, 40], 3),
        (3, [60, 50, 40, 30, 20, 10], 3),
        (4, [40, 50, 60, 10, 20, 30], 3),
        (5, [10, 40, 20, 50, 30, 60], 2),
        (6, [30, 60, 20, 50, 10, 40], 2),
        (7, [60, 30, 50, 20, 40, 10], 2),
        (8, [40, 10, 50, 20, 60, 30], 2),
    ] {
        let file = Tiff { orientation, ..Tiff::grey(width, 8, &stored) }.bytes();
        let (map, taken) = decode_as(&file, "m.tif", &keys(&[])).unwrap();
        assert_eq!((taken.width, taken.height), (3, 2), "orientation {orientation}");
        let there: Vec<u64> = map.samples.iter().map(|h| (h * 255.0).round() as u64).collect();
        assert_eq!(there, seen, "orientation {orientation}");
    }
}

/// What a tag says and no reader may pass over: read as it says, or refused.
#[test]
fn tiff_tags_that_change_what_the_bytes_mean() {
    for bits in [1, 4, 8, 12, 16] {
        for compression in [1, 5, 8, 32773, 50000] {
            let words = ramp(bits);
            let file = Tiff { fill_order: 2, compression, ..Tiff::grey(4, bits, &words) };
            let range = format!("map.range=0,{}", (1u64 << bits) - 1);
            let read = |file: &Tiff| decode_as(&file.bytes(), "m.tif", &keys(&[&range])).unwrap().0.samples;
            assert_eq!(read(&file), read(&Tiff { fill_order: 1, ..file.clone() }), "{bits} bits, {compression}");
        }
    }
    let grey = Tiff::grey(4, 8, &ramp(8));
    let tag = |file: &Tiff, tag: u16, from: u16, to: u16| {
        let mut bytes = file.bytes();
        let entry = |value: u16| [tag, 3, 1, 0, value].map(u16::to_le_bytes).concat();
        let at = bytes.windows(10).position(|w| w == entry(from)).unwrap();
        bytes[at + 8..at + 10].copy_from_slice(&to.to_le_bytes());
        sentence(decode_as(&bytes, "m.tif", &keys(&[])))
    };
    for wrong in [0, 9, 99, 65535] {
        let told = tag(&grey, 274, 1, wrong);
        assert_eq!(told, format!("m.tif: its orientation is {wrong}, and 1 (upright) to 8 are legal: save it upright"));
    }
    assert!(tag(&grey, 266, 1, 3).contains("its order of bits (FillOrder) is 3, and 1 or 2 are legal"));
    let told = tag(&grey, 284, 1, 3);
    assert!(told.contains("planar configuration"), "{told}");
    let fax = Tiff { fill_order: 2, compression: 4, ..Tiff::grey(4, 1, &ramp(1)) };
    assert!(
        sentence(decode_as(&fax.bytes(), "m.tif", &keys(&[]))).contains("(FillOrder 2), which is not read of Fax4")
    );
    // Samples of two sizes in a pixel.
    let two = Tiff { samples: 2, extra: Some(2), height: 4, ..Tiff::grey(4, 8, &[7; 32]) };
    let mut bytes = two.bytes();
    let sizes = [258u16, 3, 2, 0, 8, 8].map(u16::to_le_bytes).concat();
    let at = bytes.windows(12).position(|w| w == sizes).unwrap();
    bytes[at + 10] = 16;
    let told = sentence(decode_as(&bytes, "m.tif", &keys(&[])));
    assert!(told.ends_with("inconsistent bits per sample: [8, 16]"), "{told}");
}

#[test]
fn tiff_pages() {
    let (first, second) = (Tiff::grey(4, 8, &ramp(8)), Tiff::grey(4, 8, &[9; 16]));
    // A reduced copy is no page to choose from.
    let overview = first.pages(&[(&Tiff::grey(2, 8, &[1; 4]), 1)]);
    assert_eq!(codes(&overview, "m.tif", 8, &[]), ramp(8));
    let two = first.pages(&[(&second, 0)]);
    let told = sentence(decode_codes(&two, "m.tif", &keys(&[]), 2, 8, false));
    assert!(told.contains("the file has the pages 0 (4 x 4), 1 (4 x 4), and which one"), "{told}");
    assert_eq!(codes(&two, "m.tif", 8, &["map.part=1"]), [9; 16]);
    let told = sentence(decode_codes(&two, "m.tif", &keys(&["map.part=2"]), 2, 8, false));
    assert!(told.contains("there is no page \"2\" (map.part): the file has 0 (4 x 4), 1 (4 x 4)"), "{told}");
}

/// What the library calls inconsistent sizes, by the tag that is wrong.
#[test]
fn a_strip_or_tile_without_rows_is_named() {
    let replaced = |file: Vec<u8>, tag: u16, from: u32| {
        // Tag, kind, one value of four bytes.
        let entry = [&tag.to_le_bytes()[..], &4u16.to_le_bytes(), &1u32.to_le_bytes(), &from.to_le_bytes()].concat();
        let at = file.windows(12).position(|w| w == entry).expect("the tag is there");
        let mut file = file;
        file[at + 8..at + 12].fill(0);
        file
    };
    let words: Vec<u64> = (0..16).collect();
    let strips = Tiff { rows_per_strip: 3, ..Tiff::grey(4, 8, &words) }.bytes();
    let tiles = Tiff { tile: Some((16, 32)), ..Tiff::grey(4, 8, &words) }.bytes();
    for (file, tag, from, name) in
        [(&strips, 278, 3, "RowsPerStrip"), (&tiles, 322, 16, "TileWidth"), (&tiles, 323, 32, "TileLength")]
    {
        let told = sentence(decode_as(&replaced(file.clone(), tag, from), "m.tif", &keys(&[])));
        assert_eq!(told, format!("m.tif: not a readable TIFF: its {name} (tag {tag}) is 0, and at least 1 is legal"));
    }
    // Four rows in strips of one, of which there are too few.
    let at = strips.windows(12).position(|w| w[..8] == [22, 1, 4, 0, 1, 0, 0, 0]).unwrap();
    let mut few = strips;
    few[at + 8] = 1;
    let told = sentence(decode_as(&few, "m.tif", &keys(&[])));
    assert!(told.contains("its tags contradict each other") && told.contains("RowsPerStrip"), "{told}");
}
