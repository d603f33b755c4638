//! Which channel of a pixel is the height.
use reliefrtl_base::error::{Error, Result};
use reliefrtl_config::MapConfig;

/// The choice among the channels of a file.
pub(super) struct Pick {
    /// The channel, or three that must be equal.
    heights: Heights,
    /// A channel that must be opaque everywhere.
    alpha: Option<usize>,
    /// The value of an opaque pixel.
    opaque: f64,
    /// Number of channels of a pixel.
    channels: usize,
    /// What is taken, in words.
    label: String,
}

enum Heights {
    One(usize),
    Equal([usize; 3]),
}

/// The name of a channel whatever its case; grey goes by three.
fn same(name: &str, asked: &str) -> bool {
    let grey = |text: &str| ["y", "grey", "gray"].iter().any(|word| text.eq_ignore_ascii_case(word));
    name.eq_ignore_ascii_case(asked) || (grey(name) && grey(asked))
}

impl Pick {
    /// The channels of a file, in the order in which a pixel has them: what `map.channel` names, a single one, `Y`, or `R`, `G`, `B` that
    /// must be equal; with `A` beside them, that is `opaque`.
    ///
    /// # Errors
    /// No such channel, or several from which one must be chosen.
    pub(super) fn new(names: &[&str], opaque: f64, map: &MapConfig) -> Result<Self> {
        let listed = || names.join(", ");
        let place = |asked: &str| names.iter().position(|name| same(name, asked));
        let channels = names.len();
        if let Some(asked) = &map.channel {
            let at = names.iter().position(|name| name == asked).or_else(|| place(asked)).ok_or_else(|| {
                Error::input(format!("there is no channel {asked:?} (map.channel): the file has {}", listed()))
            })?;
            let of = if channels > 1 { format!(" of {}", listed()) } else { String::new() };
            let label = format!("{}{of}", names[at]);
            return Ok(Self { heights: Heights::One(at), alpha: None, opaque, channels, label });
        }
        let alpha = place("A").filter(|_| channels > 1);
        let others: Vec<usize> = (0..channels).filter(|&at| Some(at) != alpha).collect();
        let grey = if alpha.is_none() { true } else { others.len() == 1 && same(names[others[0]], "Y") };
        let heights = match (others.as_slice(), place("R"), place("G"), place("B")) {
            ([only], ..) if grey => Heights::One(*only),
            (three, Some(red), Some(green), Some(blue)) if three.len() == 3 => Heights::Equal([red, green, blue]),
            _ => {
                return Err(Error::input(format!(
                    "the file has the channels {}, and which one holds the heights is not ours to guess: choose it with --set map.channel={}",
                    listed(),
                    // A channel of another name than colours have is the likelier one.
                    others.iter().map(|&at| names[at]).find(|name| !["R", "G", "B"].contains(name)).unwrap_or(names[0])
                )));
            }
        };
        let mut label = match heights {
            Heights::One(at) => names[at].to_owned(),
            Heights::Equal(_) => "R = G = B".to_owned(),
        };
        if alpha.is_some() {
            label += ", A opaque";
        }
        Ok(Self { heights, alpha, opaque, channels, label })
    }

    /// Channels of a pixel.
    pub(super) const fn channels(&self) -> usize {
        self.channels
    }

    /// Whether this channel is looked at.
    pub(super) fn needs(&self, channel: usize) -> bool {
        self.alpha == Some(channel)
            || match &self.heights {
                Heights::One(at) => *at == channel,
                Heights::Equal(at) => at.contains(&channel),
            }
    }

    /// What is taken, in words.
    pub(super) fn label(&self) -> String {
        self.label.clone()
    }

    /// The height of one pixel, at column `x` of row `y`.
    ///
    /// # Errors
    /// It is coloured, or not opaque.
    pub(super) fn take(&self, pixel: &[f64], x: usize, y: usize) -> Result<f64> {
        if let Some(alpha) = self.alpha {
            let there = pixel[alpha];
            if there != self.opaque {
                return Err(Error::input(format!(
                    "pixel ({x}, {y}) is not opaque (alpha {there} of {}): a height map has no holes; --set map.channel={} takes the heights whatever alpha says",
                    self.opaque,
                    if matches!(self.heights, Heights::One(_)) { "Y" } else { "R" }
                )));
            }
        }
        match self.heights {
            Heights::One(at) => Ok(pixel[at]),
            Heights::Equal(at) => {
                let [red, green, blue] = at.map(|at| pixel[at]);
                if red.is_nan() || green.is_nan() || blue.is_nan() {
                    return Ok(f64::NAN);
                }
                if red == green && green == blue {
                    return Ok(red);
                }
                Err(Error::input(format!(
                    "a picture in colour (pixel ({x}, {y}) has red, green and blue {red}, {green}, {blue}): a height map has one channel, or three that are equal; --set map.channel=R takes red alone"
                )))
            }
        }
    }
}
