//! The harness that `bench` compares with: every output of every ray is held against what is expected.
use crate::simulators::skip;
use reliefrtl::bench::{Harness, Load};
use reliefrtl::config::{Config, Profile, View};
use reliefrtl::golden::{RayInput, prepare};
use reliefrtl::ir::Binding;
use reliefrtl::project::{Scene, encode, hardware};
use reliefrtl::trace::{Pipeline, hit_row};

#[test]
fn one_wrong_bit_of_one_output_ends_the_harness_with_a_mismatch() {
    if skip() {
        return;
    }
    let mut c = Config::default();
    c.traverse.levels = 4;
    c.latency = Profile::Published.latency(c.datapath.kind);
    (c.view.width, c.view.height, c.view.stride) = (32, 24, 1);
    let d = c.design();
    let scene = Scene::new(&c, None, false).unwrap();
    let seen = scene.view(&c, View::Oblique, 1).unwrap();
    let rays: Vec<RayInput> = seen.iter().map(|r| encode(&c, r)).collect();
    let golden = prepare(&d).unwrap();
    let mut expected: Vec<Vec<u64>> = rays.iter().map(|r| hit_row(&d, &golden.trace(&scene.pyramid, r))).collect();
    let (_, items) = Pipeline::new(&d, &Binding::new()).unwrap().words(&scene.pyramid, &rays);
    let memory: Vec<u64> = scene.pyramid.memory().iter().map(|w| u64::from(*w)).collect();
    let h = hardware(&c).unwrap();
    let top = format!("{}traverse", c.emit.prefix);
    let harness = Harness::new("g++", &h.files, (&d, &h.traverse.module), &top).unwrap();
    harness.load(&Load { memory: &memory, rays: &items, expected: &expected }).unwrap();
    let run = harness.run().unwrap();
    assert!(rays.len() > 100 && run.compared == rays.len() as u64 && run.wrong == 0, "{run:?}");
    // Times of the traversal alone: the loading stands apart, and a ray takes at least a clock.
    assert!(run.run_s > 0.0 && run.load_s > 0.0 && run.clocks >= run.compared, "{run:?}");
    for port in 0..expected[0].len() {
        expected[77][port] ^= 1;
        harness.load(&Load { memory: &memory, rays: &items, expected: &expected }).unwrap();
        let error = harness.run().unwrap_err();
        assert_eq!(error.exit_code(), 1, "output {port}: {error}");
        assert!(error.to_string().contains("ray 77 first"), "output {port}: {error}");
        expected[77][port] ^= 1;
    }
    // A wrong texel of the map is seen, too.
    let other = vec![0; memory.len()];
    harness.load(&Load { memory: &other, rays: &items, expected: &expected }).unwrap();
    assert_eq!(harness.run().unwrap_err().exit_code(), 1);
}
