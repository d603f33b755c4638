//! The maps of windows: the highest code of every window of a size (`docs/windows.md`, Memory).
use reliefrtl_config::{Window, WindowSet};
use std::sync::{Arc, RwLock};

/// One map: the windows of one size, row by row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WindowMap {
    window: Window,
    /// Windows a side.
    side: u32,
    words: Vec<u32>,
}

impl WindowMap {
    /// The map of `window` over 2^`levels` texels a side; `node` has the maximum codes of the pyramid's nodes by level, i, j.
    fn build(levels: u32, window: Window, node: &impl Fn(u32, u32, u32) -> u32) -> Self {
        let lg = window.grid_bits();
        let side = 1u32 << (levels - lg);
        let mut words: Vec<u32> = (0..side * side).map(|at| node(lg, at % side, at / side)).collect();
        let (row, column) = (side as usize, 1);
        for step in [column, row] {
            let cell = |at: usize, far: u32| {
                let i = (at / step) as u32 % side;
                at - i as usize * step + ((i + far) % side) as usize * step
            };
            let widest = |words: &[u32], far: u32| -> Vec<u32> {
                (0..words.len()).map(|at| words[at].max(words[cell(at, far)])).collect()
            };
            // Runs of 1, 2, 4 ... cells, and at last two runs that overlap.
            let mut run = 1;
            while 2 * run <= window.cells() {
                words = widest(&words, run);
                run *= 2;
            }
            words = widest(&words, window.cells() - run);
        }
        Self { window, side, words }
    }

    /// The windows' size.
    pub fn window(&self) -> Window {
        self.window
    }

    /// The highest code of the texels \[g i, g i + S) x \[g j, g j + S); the map repeats, so i and j may be anything.
    pub fn word(&self, i: i64, j: i64) -> u32 {
        let at = |index: i64| index.rem_euclid(i64::from(self.side)) as usize;
        self.words[at(j) * self.side as usize + at(i)]
    }

    /// The memory image, by address.
    pub fn memory(&self) -> &[u32] {
        &self.words
    }
}

/// The maps of a set, fine to coarse.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WindowMaps(Vec<WindowMap>);

impl WindowMaps {
    pub(super) fn build(levels: u32, set: &WindowSet, node: impl Fn(u32, u32, u32) -> u32) -> Self {
        Self(set.sizes().iter().map(|window| WindowMap::build(levels, *window, &node)).collect())
    }

    /// A map a size; the first is that of the texels.
    pub fn maps(&self) -> &[WindowMap] {
        &self.0
    }
}

/// What was made of a pyramid already: a set's maps are made when the first ray asks for them.
#[derive(Debug, Default)]
pub(super) struct Made(RwLock<Vec<(WindowSet, Arc<WindowMaps>)>>);

impl Made {
    pub(super) fn get(&self, set: &WindowSet, make: impl FnOnce() -> WindowMaps) -> Arc<WindowMaps> {
        let find = |made: &[(WindowSet, Arc<WindowMaps>)]| made.iter().find(|m| m.0 == *set).map(|m| m.1.clone());
        // A thread that panicked left no half-made maps: they are pushed whole.
        if let Some(maps) = find(&self.0.read().unwrap_or_else(|e| e.into_inner())) {
            return maps;
        }
        let mut made = self.0.write().unwrap_or_else(|e| e.into_inner());
        find(&made).unwrap_or_else(|| {
            let maps = Arc::new(make());
            made.push((*set, maps.clone()));
            maps
        })
    }
}

/// Made anew where they are asked for.
impl Clone for Made {
    fn clone(&self) -> Self {
        Self::default()
    }
}

/// They follow from the pyramid.
impl PartialEq for Made {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Eq for Made {}
