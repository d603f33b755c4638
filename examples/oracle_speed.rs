//! Rays per second of the exact walk on the rays of the default scenes.
//!
//! `cargo run --release --example oracle_speed -- [STRIDE]`
use rayon::prelude::*;
use reliefrtl::config::{Config, MapKind, View};
use reliefrtl::measure::exact_ray;
use reliefrtl::oracle::{ExactMap, ExactRay};
use reliefrtl::project::{Scene, encode};
use std::time::Instant;

fn main() {
    let mut c = Config::default();
    c.view.stride = std::env::args().nth(1).and_then(|s| s.parse().ok()).unwrap_or(2);
    let (mut rays, mut one, mut all, mut texels) = (0, 0.0, 0.0, 0);
    for kind in [MapKind::Rocks, MapKind::Bricks, MapKind::Dunes, MapKind::Spikes, MapKind::Stairs] {
        c.map.kind = kind;
        let scene = Scene::new(&c, None, false).expect("a procedural map");
        let map = ExactMap { levels: c.traverse.levels, height_bits: c.traverse.height_bits, texels: &scene.texels };
        let design = c.design();
        let exact = |r: &_| exact_ray(&design, &encode(&c, r)).expect("a number");
        let list: Vec<ExactRay> = View::ALL
            .iter()
            .flat_map(|view| scene.view(&c, *view, c.view.stride).unwrap())
            .map(|r| exact(&r))
            .collect();
        let trace = |r: &ExactRay| map.trace(r).expect("a legal ray").texels;
        let start = processor_seconds();
        let visited: u64 = list.iter().map(trace).sum();
        one += processor_seconds() - start;
        let start = Instant::now();
        assert_eq!(visited, list.par_iter().map(trace).sum::<u64>());
        all += start.elapsed().as_secs_f64();
        rays += list.len();
        texels += visited;
    }
    let rate = |seconds: f64| rays as f64 / seconds / 1e6;
    println!(
        "{rays} rays, {:.1} texels a ray: {:.3} M rays per processor second, {:.3} M rays/s on {} threads",
        texels as f64 / rays as f64,
        rate(one),
        rate(all),
        rayon::current_num_threads()
    );
}

/// Time that the main thread has had a processor: tells the speed on a machine that does other work, too.
fn processor_seconds() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/schedstat").unwrap_or_default();
    stat.split_whitespace().next().and_then(|s| s.parse::<f64>().ok()).map_or(f64::NAN, |ns| ns / 1e9)
}
