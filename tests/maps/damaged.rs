//! Files of which one byte was damaged: where a format has checksums, none of them is a map of other heights.
use super::make::png;
use png::{BitDepth, ColorType};
use reliefrtl::config::MapConfig;
use reliefrtl::scene::decode_as;

#[test]
fn a_png_with_any_damaged_byte_is_refused() {
    let heights: Vec<u8> = (0..64 * 64u32).flat_map(|k| (k.wrapping_mul(2_654_435_761) as u16).to_be_bytes()).collect();
    for (depth, bytes) in [(BitDepth::Sixteen, &heights[..]), (BitDepth::Eight, &heights[..64 * 64])] {
        let whole = png(64, depth, ColorType::Grayscale, bytes, |_| ());
        let read = |file: &[u8]| decode_as(file, "m.png", &MapConfig::default());
        read(&whole).unwrap();
        // After the signature; every byte near both ends, and a spread of those between.
        let between = (100..whole.len() - 100).step_by(37);
        for at in (8..100).chain(between).chain(whole.len() - 100..whole.len()) {
            let mut file = whole.clone();
            file[at] ^= 0x10;
            let said = read(&file).map(|_| ()).expect_err(&format!("byte {at} of {} was damaged", whole.len()));
            assert_eq!(said.exit_code(), 2, "{said}");
        }
        for cut in [1, 4, 12, 16, 200] {
            assert!(read(&whole[..whole.len() - cut]).is_err(), "{cut} bytes are missing");
        }
    }
}
