//! Height maps from files: exact to the code, within limits, and one clear sentence for what is not a map.
mod damaged;
mod exr_blocks;
mod fit;
mod formats;
mod fuzz;
mod images;
mod intake;
mod limits;
mod make;
mod memory;
mod tiffs;

use reliefrtl::config::{Config, MapConfig};
use reliefrtl::error::Error;

#[global_allocator]
static COUNTED: memory::Counting = memory::Counting;

/// The map section after these `--set`s.
fn keys(sets: &[&str]) -> MapConfig {
    let mut config = Config::default();
    sets.iter().for_each(|set| config.apply_set(set).unwrap());
    config.map
}

/// What a refusal says: one sentence, exit code 2.
fn sentence<T: std::fmt::Debug>(result: Result<T, Error>) -> String {
    let error = result.expect_err("it must be refused");
    assert_eq!(error.exit_code(), 2);
    let text = error.to_string();
    assert!(!text.contains('\n'), "one sentence: {text}");
    text
}
