//! Iterations that a simulator saw, beside the golden model's.
use super::diagnose::{Shown, display};
use crate::config::Design;
use crate::error::{Error, Result};
use crate::golden::{Iteration, Pyramid, RayInput, prepare};

/// Values as a ray enters the loop: level, x, y, t.
type Entry = [u64; 4];

/// Names and looks of an [`Entry`]'s values.
const SIGNALS: [(&str, Shown); 4] =
    [("level", Shown::Integer), ("x", Shown::Integer), ("y", Shown::Integer), ("t", Shown::Time)];

/// Says which iteration of ray `number` is the first wrong one in `text`, which the traverse bench wrote with `+iterations`.
///
/// # Errors
/// A line that is not one of the bench's, or illegal parameters.
pub fn wrong_iteration(d: &Design, pyramid: &Pyramid, ray: &RayInput, number: usize, text: &str) -> Result<String> {
    let mut seen = entries(number, text)?;
    // The trip that finds the start level comes first, and is no iteration.
    seen.drain(..seen.len().min(d.datapath.kind.start_trips(&d.mode) as usize));
    let mut model = Vec::new();
    prepare(d)?.trace_with(pyramid, ray, Some(&mut |i| model.push(*i)));
    for (n, (want, got)) in model.iter().zip(&seen).enumerate() {
        if let Some(told) = difference(d, want, got) {
            return Ok(format!("first wrong iteration: {n}, {told}{}", before(n, &model)));
        }
    }
    Ok(match model.len().cmp(&seen.len()) {
        std::cmp::Ordering::Equal => {
            format!(
                "all {} iterations are right: the fault is in what follows the loop, or in the expected row",
                seen.len()
            )
        }
        std::cmp::Ordering::Greater => {
            format!("the ray leaves the loop after {} of {} iterations", seen.len(), model.len())
        }
        std::cmp::Ordering::Less => {
            format!("the ray goes on after its {} iterations{}", model.len(), before(model.len(), &model))
        }
    })
}

/// What the iteration before the `n`th, the one at fault, should have decided.
fn before(n: usize, model: &[Iteration]) -> String {
    match n.checked_sub(1).and_then(|k| model.get(k)) {
        Some(i) => format!(" (iteration {}, at level {}, should have decided {:?})", n - 1, i.level, i.decision),
        None => " (the setup went wrong)".into(),
    }
}

fn difference(d: &Design, want: &Iteration, got: &Entry) -> Option<String> {
    let idx = d.traverse.idx_bits();
    let index = |v: i64| v as u64 & crate::bits::mask(idx);
    let want = [u64::from(want.level), index(want.x), index(want.y), want.t];
    let k = (0..4).find(|k| want[*k] != got[*k])?;
    let (name, shown) = SIGNALS[k];
    let show = |v: u64| display(d, shown, v, if k == 0 { 8 } else { idx });
    Some(format!("{name} where it enters the loop: expected {}, got {}", show(want[k]), show(got[k])))
}

fn entries(number: usize, text: &str) -> Result<Vec<Entry>> {
    let mine = text.lines().enumerate().filter(|(_, l)| l.split(' ').next().is_some_and(|w| w == number.to_string()));
    let entry = |(at, line): (usize, &str)| {
        // An undefined value is as wrong as can be: no model has it.
        let words = line.split(' ').skip(1).map(|w| u64::from_str_radix(w, 16).unwrap_or(u64::MAX));
        let words: Vec<u64> = words.collect();
        Entry::try_from(words).map_err(|_| Error::ToolFailed(format!("line {} of the iterations is {line:?}", at + 1)))
    };
    mine.map(entry).collect()
}
