//! How much memory is asked for: counted by the allocator of this test program, thread by thread.
use super::make::{Tiff, exr, png};
use super::{keys, sentence};
use reliefrtl::scene::decode_codes;
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

thread_local! {
    static LIVE: Cell<usize> = const { Cell::new(0) };
    static PEAK: Cell<usize> = const { Cell::new(0) };
}

/// Counts what a thread has and had at most.
pub struct Counting;

// SAFETY: every call goes on to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let live = LIVE.get().wrapping_add(layout.size());
        LIVE.set(live);
        if live < usize::MAX / 2 {
            PEAK.set(PEAK.get().max(live));
        }
        // SAFETY: as the caller's.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        LIVE.set(LIVE.get().wrapping_sub(layout.size()));
        // SAFETY: as the caller's.
        unsafe { System.dealloc(memory, layout) }
    }
}

/// The most bytes that this thread had at once during `work`, besides what it had before.
pub fn peak<T>(work: impl FnOnce() -> T) -> (T, usize) {
    let before = LIVE.get();
    PEAK.set(before);
    let done = work();
    (done, PEAK.get().saturating_sub(before))
}

#[test]
fn a_texel_that_is_kept_costs_at_most_24_bytes() {
    const SIDE: usize = 512;
    let texels = SIDE * SIDE;
    let words: Vec<u64> = (0..texels as u64).map(|at| at * 2654435761 % 65536).collect();
    let floats: Vec<u64> = words.iter().map(|w| (*w as f64 / 65535.0).to_bits()).collect();
    let singles: Vec<f32> = words.iter().map(|w| *w as f32 / 65535.0).collect();
    let rows: Vec<u8> = words.iter().flat_map(|w| (*w as u16).to_be_bytes()).collect();
    let grey = |bits, words: &[u64]| Tiff { rows_per_strip: 16, compression: 8, ..Tiff::grey(SIDE, bits, words) };
    let one = Tiff { format: 3, rows_per_strip: SIDE, ..grey(64, &floats) };
    let files = [
        ("strips.tif", grey(16, &words).bytes()),
        ("whole.tif", one.bytes()),
        ("turned.tif", Tiff { orientation: 6, ..grey(16, &words) }.bytes()),
        ("m.exr", exr(&[("Y", &singles)], SIDE)),
        ("m.png", png(SIDE as u32, png::BitDepth::Sixteen, png::ColorType::Grayscale, &rows, |_| ())),
        ("m.r16", rows),
    ];
    for (name, file) in &files {
        let floats = ["m.exr", "whole.tif"].contains(name);
        for range in if floats { &["map.range=auto"][..] } else { &["map.range=none", "map.range=auto"] } {
            let read = || decode_codes(file, name, &keys(&[*range]), 9, 16, false).unwrap();
            let (_, bytes) = peak(read);
            assert!(bytes <= 24 * texels, "{name}, {range}: {bytes} bytes for {texels} texels");
        }
    }
    // Filtered to 64 x 64, row by row.
    for (name, file) in files.iter().filter(|f| ["strips.tif", "m.png", "m.r16"].contains(&f.0)) {
        let (_, bytes) = peak(|| decode_codes(file, name, &keys(&[]), 6, 8, true).unwrap());
        assert!(bytes <= 24 * 64 * 64 + (1 << 19), "{name}: {bytes} bytes for 64 x 64 texels");
    }
}

/// Headers of an uncompressed BMP and of a TGA in run lengths, of 8192 x 8192 pixels.
#[test]
fn a_header_alone_takes_no_memory() {
    let bmp = [
        b"BM".as_slice(),
        &[54, 0, 0, 0, 0, 0, 0, 0, 54, 0, 0, 0, 40, 0, 0, 0, 0, 32, 0, 0, 0, 32, 0, 0, 1, 0, 24, 0],
        &[0; 24],
    ];
    let tga = [&[0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 32, 0, 32, 24, 0][..], &[255, 1, 1, 1]];
    for (name, file) in [("a.bmp", bmp.concat()), ("a.tga", tga.concat())] {
        let (told, bytes) = peak(|| sentence(decode_codes(&file, name, &keys(&[]), 3, 8, true)));
        assert!(told.contains(&format!("8192 x 8192 pixels are announced in {} bytes", file.len())), "{told}");
        assert!(bytes < 1 << 16, "{bytes} bytes for {name}");
    }
}
