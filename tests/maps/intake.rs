//! From a file's numbers to heights: range, texels without data, channels, and what is said about it.
use super::make::{Tiff, exr};
use super::{keys, sentence};
use reliefrtl::scene::{Depth, decode_as, decode_codes};

fn float_tiff(values: &[f32], nodata: Option<&'static str>) -> Vec<u8> {
    let words: Vec<u64> = values.iter().map(|v| u64::from(v.to_bits())).collect();
    Tiff { format: 3, nodata, ..Tiff::grey(4, 32, &words) }.bytes()
}

const METRES: [f32; 16] =
    [100.0, 200.0, 300.0, 400.0, 500.0, 600.0, 700.0, 800.0, 850.0, 150.0, 250.0, 350.0, 450.0, 550.0, 650.0, 100.0];

#[test]
fn a_range_in_the_file_s_units() {
    let file = float_tiff(&METRES, None);
    let told = sentence(decode_as(&file, "m.tif", &keys(&[])));
    assert!(told.ends_with("16 of 16 texels lie outside, and the file's heights go from 100 to 850: use --set map.range=100,850 or --set map.range=auto"), "{told}");
    for range in ["map.range=auto", "map.range=100,850"] {
        let (codes, taken) = decode_codes(&file, "m.tif", &keys(&[range]), 2, 8, false).unwrap();
        let exact: Vec<u32> = METRES.iter().map(|m| ((f64::from(*m) - 100.0) / 750.0 * 255.0).round() as u32).collect();
        assert_eq!(codes, exact, "floats in a range are rounded to the bits that there are");
        assert_eq!((taken.lowest, taken.highest, taken.range), (Some(100.0), Some(850.0), [100.0, 850.0]));
    }
    // The same steps for every file.
    let (codes, _) = decode_codes(&file, "m.tif", &keys(&["map.range=0,1000"]), 2, 10, false).unwrap();
    assert_eq!(codes[1], (0.2f64 * 1023.0).round() as u32);
    let told = sentence(decode_as(&file, "m.tif", &keys(&["map.range=150,850"])));
    assert!(told.contains("pixel (0, 0) is 100: map.range = [150, 850]; 2 of 16 texels lie outside"), "{told}");
    let (map, _) = decode_as(&float_tiff(&[7.0; 16], None), "m.tif", &keys(&["map.range=auto"])).unwrap();
    assert_eq!(map.samples, [0.0; 16], "one height is the bottom");
    let told = sentence(decode_as(&float_tiff(&[f32::INFINITY; 16], None), "m.tif", &keys(&["map.range=auto"])));
    assert!(told.starts_with("m.tif: pixel (0, 0) is inf, as 16 of 16 heights are infinite"), "{told}");
}

/// What the sentence advises is read; no range is advised that holds no infinity either.
#[test]
fn infinite_heights_stand_for_no_data_where_that_is_said() {
    let mut metres = METRES;
    (metres[15], metres[6]) = (f32::INFINITY, f32::NEG_INFINITY);
    let file = float_tiff(&metres, None);
    for range in [&[][..], &["map.range=auto"], &["map.range=100,850"]] {
        let told = sentence(decode_as(&file, "m.tif", &keys(range)));
        assert!(told.contains("is -inf, as 2 of 16 heights are infinite") && told.contains("pixel (2, 1)"), "{told}");
        let advice = "--set map.nodata=inf --set map.fill=";
        let (_, fill) = told.split_once(advice).unwrap_or_else(|| panic!("{told}"));
        let fill = format!("map.fill={fill}");
        let set = ["map.nodata=inf", &fill, "map.range=auto"];
        let (map, taken) = decode_as(&file, "m.tif", &keys(&set)).unwrap();
        assert_eq!((taken.nodata_texels, map.samples[15], map.samples[6]), (2, 0.0, 0.0));
    }
    // A height is not taken for one.
    let (_, taken) =
        decode_as(&float_tiff(&METRES, None), "m.tif", &keys(&["map.nodata=-inf", "map.range=auto"])).unwrap();
    assert_eq!(taken.nodata_texels, 0);
}

#[test]
fn whole_numbers_in_a_range_keep_their_steps() {
    let words: Vec<u64> = (0..16).map(|at| at * 60).collect();
    let file = Tiff::grey(4, 16, &words).bytes();
    let (map, _) = decode_as(&file, "m.tif", &keys(&["map.range=auto"])).unwrap();
    assert_eq!(map.depth, Depth::Bits(10), "900 steps");
    let told = sentence(decode_codes(&file, "m.tif", &keys(&["map.range=auto"]), 2, 8, false));
    assert_eq!(
        told,
        "m.tif: 10-bit map into traverse.height_bits = 8: set height_bits = 10 or ask for it with --resample"
    );
    let (codes, _) = decode_codes(&file, "m.tif", &keys(&["map.range=0,1023"]), 2, 10, false).unwrap();
    assert_eq!(codes.iter().map(|c| u64::from(*c)).collect::<Vec<_>>(), words);
    let signed = Tiff { format: 2, ..Tiff::grey(4, 16, &[65535, 5, 6, 7]) }.bytes();
    let told = sentence(decode_as(&signed, "m.tif", &keys(&[])));
    assert_eq!(
        told,
        "m.tif: its heights are signed 16-bit numbers from -1 to 7, and which become 0 and full height is not ours to guess: say it with --set map.range=-1,7 or --set map.range=auto"
    );
}

#[test]
fn texels_without_data_are_never_heights() {
    let mut values = METRES;
    (values[5], values[9]) = (-9999.0, f32::NAN);
    let (named, unnamed) = (float_tiff(&values, Some("-9999 ")), float_tiff(&values, None));
    let told = sentence(decode_as(&named, "m.tif", &keys(&["map.range=auto"])));
    assert_eq!(
        told,
        "m.tif: 2 of 16 texels have no data (-9999, or not a number), the first is pixel (1, 1): give the height that they take, in the file's units, as --set map.fill=100"
    );
    assert!(sentence(decode_as(&unnamed, "m.tif", &keys(&["map.range=0,1000"]))).contains("pixel (1, 1) is -9999"));
    for (file, sets) in [
        (&named, &["map.range=auto", "map.fill=100"][..]),
        (&unnamed, &["map.range=auto", "map.fill=100", "map.nodata=-9999"]),
    ] {
        let (map, taken) = decode_as(file, "m.tif", &keys(sets)).unwrap();
        assert_eq!((map.samples[5], map.samples[9], map.samples[8]), (0.0, 0.0, 1.0));
        assert_eq!((taken.nodata_texels, taken.fill, taken.nodata), (2, Some(100.0), Some(-9999.0)));
        let said = taken.to_string();
        assert!(said.contains("2 texels without data filled with 100"), "{said}");
    }
    let told = sentence(decode_as(&named, "m.tif", &keys(&["map.range=auto", "map.fill=0"])));
    assert!(told.starts_with("m.tif: map.fill = 0 is no height from 100 to 850"), "{told}");
    // GDAL writes fewer digits than a float has.
    let low = float_tiff(&[f32::MIN, 0.5, 0.5, 0.5], Some("-3.40282346638529e+38"));
    assert_eq!(decode_as(&low, "m.tif", &keys(&["map.fill=0.25"])).unwrap().0.samples[0], 0.25);
    let codes = Tiff { nodata: Some("255"), ..Tiff::grey(4, 8, &[1, 2, 255, 4]) }.bytes();
    assert!(sentence(decode_as(&codes, "m.tif", &keys(&[]))).contains("1 of 4 texels have no data (255"));
    let (codes, _) = decode_as(&codes, "m.tif", &keys(&["map.fill=3"])).unwrap();
    assert_eq!(codes.samples[2], 3.0 / 255.0);
    let none = float_tiff(&[f32::NAN; 16], None);
    assert_eq!(
        sentence(decode_as(&none, "m.tif", &keys(&["map.range=auto", "map.fill=1"]))),
        "m.tif: no texel has data"
    );
}

#[test]
fn what_was_taken_is_said() {
    let file = Tiff::grey(4, 12, &(0..16).collect::<Vec<u64>>()).bytes();
    let (_, taken) = decode_as(&file, "dem.tif", &keys(&[])).unwrap();
    assert_eq!(
        taken.to_string(),
        "dem.tif: TIFF, 4 x 4, 12-bit, channel Y, heights 0 to 15 (range 0 to 4095), 0 texels without data"
    );
    let values = [0.5f32; 16];
    let three = exr(&[("R", &values), ("G", &values), ("B", &values)], 4);
    let (_, taken) = decode_codes(&three, "m.exr", &keys(&["map.crop=true"]), 1, 8, true).unwrap();
    assert_eq!(
        taken.to_string(),
        "m.exr: OpenEXR, 4 x 4, 32-bit float, channel R = G = B, heights 0.5 to 0.5 (range 0 to 1), 0 texels without data; cut to 2 x 2"
    );
    let json = serde_json::to_value(&taken).unwrap();
    assert_eq!((&json["format"], &json["width"], &json["nodata_texels"]), (&"OpenEXR".into(), &4.into(), &0.into()));
}

#[test]
fn choices_that_a_file_does_not_have() {
    let file = Tiff::grey(4, 8, &[1; 16]).bytes();
    let read = |set: &str| decode_as(&file, "m.tif", &keys(&[set]));
    read("map.part=0").unwrap();
    assert!(sentence(read("map.part=1")).contains("there is no page \"1\" (map.part): the file has 0 (4 x 4)"));
    let pgm = |set: &str| decode_as(b"P5 2 1 255\nab", "m", &keys(&[set]));
    pgm("map.part=0").unwrap();
    assert_eq!(sentence(pgm("map.part=1")), "m: there is no part \"1\" (map.part): the PGM is one picture");
    let told = sentence(pgm("map.byte_order=big"));
    assert!(told.contains("the PGM says itself in which order its bytes are: leave out map.byte_order"), "{told}");
}

#[test]
fn a_size_that_a_header_contradicts() {
    let file = Tiff::grey(4, 8, &[0; 16]).bytes();
    let told = sentence(decode_as(&file, "m.tif", &keys(&["map.size=4,8"])));
    assert!(told.contains("the TIFF is 4 x 4, but map.size = [4, 8]: leave it out"), "{told}");
}

/// Scale, offset and the shape of cells change no height: that they are there is said, in the summary and where a height is refused.
#[test]
fn what_is_not_applied_is_said() {
    let gdal = "<GDALMetadata>\n<Item name=\"DESCRIPTION\" sample=\"0\" role=\"description\">dem</Item>\n\
        <Item name=\"SCALE\" sample=\"1\" role=\"scale\">7</Item>\n<Item name=\"OFFSET\" sample=\"0\" role=\"offset\">-100</Item>\n\
        <Item name=\"SCALE\" sample=\"0\" role=\"scale\">0.01</Item>\n</GDALMetadata>";
    let grey = Tiff::grey(4, 8, &(0..16).collect::<Vec<u64>>());
    let read = |tiff: Tiff, sets: &[&str]| decode_as(&tiff.bytes(), "m.tif", &keys(sets));
    let scaled = Tiff { metadata: Some(gdal), ..grey.clone() };
    let said = "not applied: GDAL's scale 0.01 and offset -100 (tag 42112), so range, nodata and fill are in the numbers as stored";
    let (map, taken) = read(scaled.clone(), &["map.range=0,15"]).unwrap();
    assert_eq!((map.samples[15], taken.note.as_deref()), (1.0, Some(said)));
    assert!(taken.to_string().ends_with(&format!("; {said}")), "{taken}");
    // Where heights are asked for in metres and the file holds other numbers.
    for (sets, what) in [(&["map.range=-100,-99"][..], "pixel (0, 0) is 0"), (&["map.nodata=3"], "have no data")] {
        let told = sentence(read(scaled.clone(), sets));
        assert!(told.contains(what) && told.contains(said), "{told}");
    }
    // What changes nothing, what is another sample's, and what is no number.
    for text in [
        "<Item role=\"scale\" sample=\"0\">1</Item><Item role=\"offset\" sample=\"0\">0.0</Item>",
        "<Item role=\"scale\" sample=\"1\">3</Item>",
        "<Item role=\"scale\" sample=\"0\">x</Item><Item role=\"scale",
        "",
    ] {
        assert_eq!(read(Tiff { metadata: Some(text), ..grey.clone() }, &[]).unwrap().1.note, None, "{text}");
    }
    let said = "its cells are 10 x 20, and each is taken as a square texel";
    let (_, taken) = read(Tiff { cells: Some([10.0, 20.0, 0.0]), ..grey.clone() }, &[]).unwrap();
    assert_eq!(taken.note.as_deref(), Some(said));
    assert_eq!(read(Tiff { cells: Some([10.0, 10.0, 0.0]), ..grey }, &[]).unwrap().1.note, None);
    let asc = |cells: &str| {
        let text = format!("ncols 2\nnrows 1\n{cells}\n0.25 0.5\n");
        decode_as(text.as_bytes(), "m.asc", &keys(&[]))
    };
    assert_eq!(asc("dx 10\ndy 20").unwrap().1.note.as_deref(), Some(said));
    for square in ["dx 10\ndy 10", "dx 0.1\ndy 0.10000001", "cellsize 30", "dx 10"] {
        assert_eq!(asc(square).unwrap().1.note, None, "{square}");
    }
    assert!(sentence(asc("dx ten\ndy 20")).contains("dx is not a finite number"));
    assert!(sentence(asc("dx 10\ndx 20")).contains("dx stands there twice"));
}
