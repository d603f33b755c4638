//! The portable maps: PBM, PGM, PPM in text and in bytes, PAM, and their floating-point sister PFM.
//!
//! Read here because a maximum other than 255 or 65535 must not be rescaled on the way: 10-bit data stays 10-bit.
use super::opened::{Info, Opened, Rows, Samples, broken, sized};
use super::packed::{Layout, Packed, Stored, above};
use super::pick::Pick;
use super::plain::Words;
use crate::source::Source;
use reliefrtl_base::error::Result;
use reliefrtl_config::MapConfig;
use std::io::{Read, Seek, SeekFrom};

const GREY: [&str; 1] = ["Y"];
const COLOURS: [&str; 3] = ["R", "G", "B"];

/// What a header says of its pixels.
struct Header {
    kind: &'static str,
    width: u64,
    height: u64,
    max: u64,
    names: Vec<&'static str>,
}

/// PBM, PGM, PPM or PAM.
pub(super) fn open<'a>(source: &'a Source, map: &'a MapConfig) -> Result<Opened<'a>> {
    let mut words = Words::new(source.open()?, "portable map", true);
    // The magic number is two bytes; a comment may follow at once.
    let (_, digit) = (words.byte()?, words.byte()?);
    let header = match digit {
        Some(b'7') => pam(&mut words)?,
        _ => pnm(&mut words, digit)?,
    };
    let Header { kind, max, names, .. } = header;
    if !(1..=65535).contains(&max) {
        return Err(broken(kind, format!("its maximum is {max}, 1 to 65535 are legal")));
    }
    let (width, height) = sized(header.width, header.height, map)?;
    let samples = Samples::Unsigned(max);
    let pick = Pick::new(&names, samples.full(), map)?;
    let info = Info { channel: pick.label(), ..Info::new(kind, width, height, samples) };
    if let Some(digit @ b'1'..=b'3') = digit {
        // A plain number takes a byte and one before the next, a plain bit one byte.
        let numbers = width as u64 * height as u64 * names.len() as u64;
        let least = if digit == b'1' { numbers } else { 2 * numbers - 1 };
        let there = source.len().saturating_sub(words.place()?);
        if least > there {
            return Err(announced(kind, width, height, there));
        }
        let bits = digit == b'1';
        return Ok(Opened { info, rows: Box::new(Plain { words, pick, kind, max, bits, rows: height, at: 0 }) });
    }
    // One byte of white space ends the header.
    let offset = words.place()? + u64::from(digit != Some(b'7'));
    let stored = match (digit, max) {
        (Some(b'4'), _) => Stored::Ink,
        (_, 0..=255) => Stored::U8,
        _ => Stored::U16,
    };
    let mut layout = Layout { offset, width, height, stored, big: true, upward: false, max: max as f64 };
    one_picture(source, &mut layout, pick.channels(), kind)?;
    Ok(Opened { info, rows: Box::new(Packed::new(source, layout, pick, kind)?) })
}

/// Refuses what stands after the last pixel, but for the end of a line. Where that is one byte, and the header ends in CR LF, the LF is no pixel.
fn one_picture(source: &Source, layout: &mut Layout, channels: usize, kind: &str) -> Result<()> {
    let needed = u128::from(layout.stored.row(layout.width as u64 * channels as u64)) * layout.height as u128;
    let there = u128::from(source.len().saturating_sub(layout.offset));
    let Some(surplus) = there.checked_sub(needed).filter(|surplus| *surplus > 0) else { return Ok(()) };
    let byte = |at: u64| -> Result<u8> {
        let (mut handle, mut byte) = (source.open()?, [0]);
        let read = handle.seek(SeekFrom::Start(at)).and_then(|_| handle.read_exact(&mut byte));
        read.map_err(|error| broken(kind, error))?;
        Ok(byte[0])
    };
    if surplus == 1 && (byte(layout.offset - 1)?, byte(layout.offset)?) == (b'\r', b'\n') {
        layout.offset += 1;
        return Ok(());
    }
    if surplus == 1 && byte(source.len() - 1)? == b'\n' {
        return Ok(());
    }
    let bytes = if surplus == 1 { "1 byte stands" } else { &format!("{surplus} bytes stand") };
    Err(broken(kind, format!("{bytes} after its last pixel, and a map is one picture")))
}

fn announced(kind: &str, width: usize, height: usize, there: u64) -> reliefrtl_base::error::Error {
    broken(kind, format!("{width} x {height} pixels are announced, but only {there} bytes follow"))
}

fn pnm(words: &mut Words<'_>, digit: Option<u8>) -> Result<Header> {
    let (kind, names) = match digit {
        Some(b'1' | b'4') => ("PBM", GREY.to_vec()),
        Some(b'2' | b'5') => ("PGM", GREY.to_vec()),
        _ => ("PPM", COLOURS.to_vec()),
    };
    let (width, height) = (words.whole("the width")?, words.whole("the height")?);
    let max = if kind == "PBM" { 1 } else { words.whole("the maximum")? };
    Ok(Header { kind, width, height, max, names })
}

/// The lines of a PAM's header, up to ENDHDR.
fn pam(words: &mut Words<'_>) -> Result<Header> {
    let (mut width, mut height, mut depth, mut max) = (None, None, None, None);
    loop {
        let key = words.next()?.ok_or_else(|| broken("PAM", "it ends in its header"))?;
        let place = match key.as_str() {
            "WIDTH" => &mut width,
            "HEIGHT" => &mut height,
            "DEPTH" => &mut depth,
            "MAXVAL" => &mut max,
            // What the channels are is told by their number; the line is for programs that draw.
            "TUPLTYPE" => {
                words.line()?;
                continue;
            }
            "ENDHDR" => {
                words.line()?;
                break;
            }
            _ => {
                return Err(broken(
                    "PAM",
                    format!("{:?} is no key of its header", key.chars().take(20).collect::<String>()),
                ));
            }
        };
        if place.replace(words.whole(&key)?).is_some() {
            return Err(broken("PAM", format!("{key} stands there twice")));
        }
    }
    let there = |value: Option<u64>, key: &str| value.ok_or_else(|| broken("PAM", format!("its header lacks {key}")));
    let names = match there(depth, "DEPTH")? {
        1 => GREY.to_vec(),
        2 => vec!["Y", "A"],
        3 => COLOURS.to_vec(),
        4 => vec!["R", "G", "B", "A"],
        other => return Err(broken("PAM", format!("its DEPTH is {other}, 1 to 4 are read"))),
    };
    let (width, height) = (there(width, "WIDTH")?, there(height, "HEIGHT")?);
    Ok(Header { kind: "PAM", width, height, max: there(max, "MAXVAL")?, names })
}

/// Numbers, or bits, in text.
struct Plain<'a> {
    words: Words<'a>,
    pick: Pick,
    kind: &'static str,
    max: u64,
    bits: bool,
    rows: usize,
    at: usize,
}

impl Rows for Plain<'_> {
    fn next(&mut self, row: &mut [f64]) -> Result<()> {
        let y = self.at;
        let mut pixel = vec![0.0; self.pick.channels()];
        for (x, height) in row.iter_mut().enumerate() {
            for sample in &mut pixel {
                *sample = if self.bits {
                    match self.words.byte()? {
                        // 1 is black.
                        Some(bit @ (b'0' | b'1')) => f64::from(b'1' - bit),
                        _ => return Err(broken(self.kind, format!("no 0 or 1 where pixel ({x}, {y}) should stand"))),
                    }
                } else {
                    self.words.whole_at(x, y)? as f64
                };
                if *sample > self.max as f64 {
                    return Err(above(self.kind, x, y, *sample, self.max as f64));
                }
            }
            *height = self.pick.take(&pixel, x, y)?;
        }
        self.at += 1;
        if self.at == self.rows { self.words.end() } else { Ok(()) }
    }
}

/// PFM: floats, rows from the bottom; the sign of the scale tells the order of the bytes, its magnitude nothing about them.
pub(super) fn open_pfm<'a>(source: &'a Source, map: &'a MapConfig) -> Result<Opened<'a>> {
    const KIND: &str = "PFM";
    let mut words = Words::new(source.open()?, KIND, false);
    let names: &[&str] = if words.next()?.as_deref() == Some("PF") { &COLOURS } else { &GREY };
    let (width, height) = (words.whole("the width")?, words.whole("the height")?);
    let scale =
        words.next()?.and_then(|word| word.parse::<f64>().ok()).filter(|scale| scale.is_finite() && *scale != 0.0);
    let scale = scale.ok_or_else(|| broken(KIND, "its scale is no number other than 0"))?;
    let (width, height) = sized(width, height, map)?;
    let samples = Samples::Float(32);
    let pick = Pick::new(names, 1.0, map)?;
    let (offset, big) = (words.place()? + 1, scale > 0.0);
    let mut layout = Layout { offset, width, height, stored: Stored::F32, big, upward: true, max: f64::INFINITY };
    one_picture(source, &mut layout, pick.channels(), KIND)?;
    let info = Info { channel: pick.label(), ..Info::new(KIND, width, height, samples) };
    Ok(Opened { info, rows: Box::new(Packed::new(source, layout, pick, KIND)?) })
}
