//! Iterations per ray, beside the published table (PIDM-HW table 4).
use crate::golden::RayHit;
use serde::Serialize;

/// Mean and largest number of iterations.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Steps {
    /// Rays counted (those given up are left out).
    pub rays: usize,
    /// Rays given up.
    pub limits: usize,
    /// Mean.
    pub mean: f64,
    /// Largest.
    pub max: u32,
    /// The ray that has it.
    pub witness: usize,
}

/// The same of a view, as figures: what `--json` prints.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct StepFigures {
    /// View.
    pub view: &'static str,
    /// Rays counted.
    pub rays: usize,
    /// Mean.
    pub mean_steps: f64,
    /// Largest.
    pub max_steps: u32,
    /// The ray that has it.
    pub max_ray: usize,
    /// Rays given up.
    pub given_up: usize,
}

impl StepFigures {
    /// The iterations of a view.
    pub const fn new(view: &'static str, s: &Steps) -> Self {
        let Steps { rays, limits, mean, max, witness } = *s;
        Self { view, rays, mean_steps: mean, max_steps: max, max_ray: witness, given_up: limits }
    }
}

/// Counts the iterations of `hits`.
pub fn steps(hits: &[RayHit]) -> Steps {
    let mut s = Steps::default();
    let mut sum = 0u64;
    for (i, h) in hits.iter().enumerate() {
        if h.limit {
            s.limits += 1;
            continue;
        }
        s.rays += 1;
        sum += u64::from(h.steps);
        if h.steps > s.max {
            (s.max, s.witness) = (h.steps, i);
        }
    }
    s.mean = if s.rays == 0 { 0.0 } else { sum as f64 / s.rays as f64 };
    s
}

/// One scene of the published table.
#[derive(Clone, Copy, Debug)]
pub struct Published {
    /// File stem of the map.
    pub scene: &'static str,
    /// Height scale in world units.
    pub scale: f64,
    /// Repeats of the map along the quad.
    pub repeat: u32,
    /// Mean iterations by row of [`crate::config::modes::PUBLISHED_ROWS`], then front, oblique, grazing; `None` where our copy is not legible.
    pub means: [[Option<f64>; 3]; 7],
}

const fn row(f: f64, o: f64, g: f64) -> [Option<f64>; 3] {
    [Some(f), Some(o), Some(g)]
}

/// The scenes of PIDM-HW table 4 that are 256 x 256 maps with a published camera.
pub const PUBLISHED: [Published; 4] = [
    Published {
        scene: "rocks",
        scale: 10.0,
        repeat: 4,
        means: [
            row(11.6, 19.7, 37.9),
            row(12.6, 19.6, 30.2),
            row(9.5, 19.3, 37.9),
            row(8.9, 18.3, 37.8),
            row(11.6, 18.4, 29.2),
            row(12.1, 19.8, 31.6),
            row(8.0, 16.4, 28.3),
        ],
    },
    Published {
        scene: "stones",
        scale: 5.0,
        repeat: 1,
        means: [
            row(9.3, 10.9, 18.4),
            row(9.5, 11.5, 19.2),
            row(4.4, 8.4, 18.0),
            row(5.6, 7.8, 16.4),
            row(9.3, 11.0, 18.2),
            row(9.3, 11.3, 19.3),
            [Some(3.2), Some(6.6), None],
        ],
    },
    Published {
        scene: "four",
        scale: 30.0,
        repeat: 1,
        means: [
            row(9.8, 14.9, 21.3),
            row(10.2, 15.0, 20.0),
            row(7.4, 14.3, 21.3),
            row(6.9, 13.8, 21.6),
            row(9.8, 14.4, 19.7),
            row(10.0, 15.4, 20.6),
            [Some(5.6), Some(12.6), None],
        ],
    },
    Published {
        scene: "saints",
        scale: 20.0,
        repeat: 1,
        means: [
            row(9.5, 12.4, 23.6),
            row(9.8, 13.2, 20.7),
            row(6.6, 11.4, 23.3),
            row(6.1, 10.1, 23.2),
            row(9.5, 12.3, 20.0),
            row(9.6, 12.9, 21.4),
            row(4.7, 9.5, 18.8),
        ],
    },
];
