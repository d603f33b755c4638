//! The golden model as an engine: what all others are compared with.
use super::run::{Checked, Engine, Replay, Traced};
use crate::config::Config;
use crate::error::{Error, Result};
use crate::golden::{Pyramid, RayInput};
use crate::trace::trace_golden;
use std::time::{Duration, Instant};

/// The golden model, on all threads.
pub(super) struct Golden;

impl Engine for Golden {
    fn name(&self) -> &'static str {
        "golden"
    }

    fn needs(&self) -> Vec<String> {
        Vec::new()
    }

    fn reads_text(&self) -> bool {
        false
    }

    fn replay(&self, _: &Replay<'_>) -> Result<Checked> {
        Err(Error::input(
            "check --engine golden would compare the golden model with itself: use interp, icarus or verilator",
        ))
    }

    fn trace(&self, c: &Config, pyramid: &Pyramid, rays: &[RayInput]) -> Result<Traced> {
        let start = Instant::now();
        let hits = trace_golden(&c.design(), pyramid, rays)?;
        Ok(Traced { hits, build: Duration::ZERO, run: start.elapsed() })
    }
}
