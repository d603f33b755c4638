//! The maps of windows: every word is the highest code of its texels, taken one by one.
use super::super::scenes::map;
use super::designs::SETS;
use reliefrtl::config::WindowSet;
use reliefrtl::golden::Pyramid;

#[test]
fn every_word_is_the_highest_code_of_its_window() {
    let (mut words, mut larger) = (0u64, 0u64);
    for n in 2..=6u32 {
        let side = 1usize << n;
        let texels = map(0, n, 8, u64::from(n));
        let pyramid = Pyramid::build(n, 8, &texels).unwrap();
        for set in SETS.map(|s| s.parse::<WindowSet>().unwrap()).into_iter().filter(|set| set.misfit(n).is_none()) {
            let maps = pyramid.windows(&set);
            assert_eq!(maps.maps().len(), set.sizes().len());
            let all: usize = maps.maps().iter().map(|m| m.memory().len()).sum();
            assert_eq!(all as u64, set.memory_words(n), "{set}");
            for (of, w) in maps.maps().iter().zip(set.sizes()) {
                assert_eq!(of.window(), *w);
                let (cells, g) = (side / w.grid as usize, w.grid as usize);
                assert_eq!(of.memory().len(), cells * cells);
                // Beyond the map's side the texels come again.
                let span = (w.side as usize).min(side);
                larger += u64::from(w.side as usize > side);
                for (at, word) in of.memory().iter().enumerate() {
                    let (i, j) = (at % cells, at / cells);
                    let code = |a: usize, b: usize| texels[(g * j + b) % side * side + (g * i + a) % side];
                    let most = (0..span * span).map(|k| code(k % span, k / span)).max().unwrap();
                    assert_eq!((*word, of.word(i as i64 - cells as i64, j as i64)), (most, most), "{set} {w} {i} {j}");
                    words += 1;
                }
            }
        }
    }
    println!("{words} words; {larger} windows larger than their map");
    assert!(words > 10_000 && larger > 5);
}

/// Words of all maps a texel, as `docs/windows.md` has them.
#[test]
fn sets_take_the_memory_that_is_said_of_them() {
    for (set, codes) in
        [("1 4@2 16@4", 1.31), ("1 4@2 12@4 40@8", 1.33), ("1 4@2 8@4 16@8 32@16", 1.33), ("1 4 16", 3.0)]
    {
        let set: WindowSet = set.parse().unwrap();
        let texel = set.memory_words(8) as f64 / f64::from(1u32 << 16);
        assert!((texel - codes).abs() < 0.005, "{set}: {texel}");
    }
}
