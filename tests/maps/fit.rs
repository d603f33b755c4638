//! Maps of other sizes: cut, continued, filtered row by row, or refused with what would do.
use super::make::Tiff;
use super::{keys, sentence};
use reliefrtl::scene::{Depth, HeightMap, decode_codes, to_codes};

/// A map whose texel (i, j) has code 16 j + i.
fn file(width: u64, height: u64) -> Vec<u8> {
    let words: Vec<u64> = (0..height).flat_map(|j| (0..width).map(move |i| 16 * j + i)).collect();
    Tiff::grey(width as usize, 8, &words).bytes()
}

fn codes(file: &[u8], sets: &[&str], levels: u32, resample: bool) -> Vec<u32> {
    decode_codes(file, "m.tif", &keys(sets), levels, 8, resample).unwrap_or_else(|e| panic!("{e}")).0
}

#[test]
fn cut_to_the_first_columns_and_rows() {
    let all: Vec<u32> = (0..4).flat_map(|j| (0..4).map(move |i| 16 * j + i)).collect();
    for (width, height) in [(5, 5), (4, 9), (7, 4), (4, 4)] {
        assert_eq!(codes(&file(width, height), &["map.crop=true"], 2, false), all, "{width} x {height}");
    }
    let told = sentence(decode_codes(&file(3, 9), "m.tif", &keys(&["map.crop=true"]), 2, 8, false));
    assert!(told.contains("the map is 3 x 4, not square, and traverse.levels = 2 needs 4 x 4"), "{told}");
    // What is cut away need not be a height.
    let mut words = vec![0u64; 25];
    words[24] = 255;
    let holes = Tiff { nodata: Some("255"), ..Tiff::grey(5, 8, &words) }.bytes();
    assert_eq!(codes(&holes, &["map.crop=true"], 2, false), [0; 16]);
}

#[test]
fn continued_by_the_last_column_and_row() {
    let continued = |width: u32, height: u32| -> Vec<u32> {
        (0..4).flat_map(|j| (0..4).map(move |i| 16 * j.min(height - 1) + i.min(width - 1))).collect()
    };
    for (width, height) in [(3, 3), (4, 1), (1, 4), (1, 1), (3, 2)] {
        let file = file(width.into(), height.into());
        assert_eq!(codes(&file, &["map.pad=true"], 2, false), continued(width, height), "{width} x {height}");
    }
    // Cut one way, continued the other.
    assert_eq!(codes(&file(9, 3), &["map.pad=true", "map.crop=true"], 2, false), continued(4, 3));
    let (_, taken) =
        decode_codes(&file(9, 3), "m.tif", &keys(&["map.pad=true", "map.crop=true"]), 2, 8, false).unwrap();
    assert_eq!((taken.kept, taken.fit.as_deref()), ([4, 3], Some("continued to 4 x 4")));
}

#[test]
fn rows_are_filtered_as_the_whole_was() {
    // Against the mean over areas, and the line between centres, taken of the whole map at once.
    let height = |i: usize, j: usize| ((i * 37 + j * 101) % 256) as f64 / 255.0;
    for (width, rows, levels) in [(13, 9, 2), (5, 11, 3), (3, 2, 3), (16, 5, 4), (100, 3, 2), (8, 8, 3)] {
        let samples: Vec<f64> = (0..rows).flat_map(|j| (0..width).map(move |i| height(i, j))).collect();
        let map = HeightMap::new(width, rows, samples, Depth::Bits(8)).unwrap();
        let side = 1usize << levels;
        let taps = |at: usize, from: usize| -> Vec<(usize, f64)> {
            if side <= from {
                let (low, high) = (at as f64 * from as f64 / side as f64, (at + 1) as f64 * from as f64 / side as f64);
                let part = |s: usize| (high.min(s as f64 + 1.0) - low.max(s as f64)).max(0.0) / (high - low);
                return (0..from).map(|s| (s, part(s))).collect();
            }
            let centre = (at as f64 + 0.5) * from as f64 / side as f64 - 0.5;
            let low = centre.floor();
            let wrapped = |s: f64| s.rem_euclid(from as f64) as usize;
            vec![(wrapped(low), 1.0 - (centre - low)), (wrapped(low + 1.0), centre - low)]
        };
        let exact = (0..side).flat_map(|j| (0..side).map(move |i| (i, j))).map(|(i, j)| {
            let sum = |s: &(usize, f64)| taps(i, width).iter().map(|t| map.at(t.0, s.0) * t.1).sum::<f64>() * s.1;
            taps(j, rows).iter().map(sum).sum::<f64>() * 65535.0
        });
        let codes = to_codes(&map, levels, 16, true).unwrap();
        for (code, exact) in codes.iter().zip(exact) {
            assert!((f64::from(*code) - exact).abs() < 0.5001, "{width} x {rows}: {code} beside {exact}");
        }
    }
}

#[test]
fn the_sentence_names_what_would_do() {
    let told = |width, height, border: &str| {
        let map = keys(&[&format!("map.border={border}")]);
        sentence(decode_codes(&file(width, height), "m.tif", &map, 3, 8, false))
    };
    for (width, height, what) in [
        (
            9,
            9,
            "no power of two, and traverse.levels = 3 needs 8 x 8: use --crop (its first 8 x 8), --set traverse.levels=4 --pad (continued to 16 x 16), or --resample (filtered to 8 x 8)",
        ),
        (5, 5, "use --set traverse.levels=2 --crop (its first 4 x 4), --pad (continued to 8 x 8), or --resample"),
        (
            9,
            5,
            "not square, and traverse.levels = 3 needs 8 x 8: use --set traverse.levels=2 --crop (its first 4 x 4), --set traverse.levels=4 --pad",
        ),
    ] {
        let told = told(width, height, "wrap");
        assert!(told.contains(what), "{told}");
    }
    let told = told(5, 5, "mirror");
    assert!(
        told.contains("needs 4 x 4: use --crop (its first 4 x 4), --set traverse.levels=4 --pad (continued to 8 x 8)"),
        "{told}"
    );
}
