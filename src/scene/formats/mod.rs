//! The files that height maps come in: what each is known by, and its rows in the file's own numbers, top to bottom.
//!
//! Every reader tells the dimensions first, from the header alone; nothing is allocated before [`sized`] has agreed to them.
mod asc;
mod bc4;
mod dds;
mod exr;
mod image;
mod netpbm;
mod opened;
mod orient;
mod packed;
mod pick;
mod plain;
mod png;
mod raw;
mod tiff;
mod tiff_chunks;
mod tiff_packed;

pub(super) use opened::{Samples, filled};

use super::source::{Handle, Source};
use opened::{Opened, broken};
use reliefrtl_base::error::{Error, Result};
use reliefrtl_config::{ByteOrder, MapConfig};
use std::io::Read;

/// What is read, for the sentences about files that are not.
pub(super) const READ: &str = "PNG, PGM (PBM, PPM, PAM), PFM, TIFF (BigTIFF, GeoTIFF), OpenEXR, BMP, TGA, lossless WebP, DDS (R8, R16, R32F, BC4), SRTM HGT, ESRI ASC, and R16 / RAW with map.size";

/// Opens the file, by its content where that tells, else by its name or because `map.size` is given.
pub(super) fn open<'a>(source: &'a Source, map: &'a MapConfig) -> Result<Opened<'a>> {
    if source.len() == 0 {
        return Err(Error::input(format!("the file is empty: {READ} are read")));
    }
    let mut head = Vec::new();
    source.open()?.take(64).read_to_end(&mut head).map_err(|error| broken("file", error))?;
    let opened = known(source, map, &head)?;
    let format = opened.info.format;
    if let (Some(asked), None) = (map.part.as_ref().filter(|asked| *asked != "0"), &opened.info.part) {
        return Err(Error::input(format!("there is no part {asked:?} (map.part): the {format} is one picture")));
    }
    if map.byte_order != ByteOrder::Little && format != raw::RAW && format != raw::HGT {
        return Err(Error::input(format!(
            "the {format} says itself in which order its bytes are: leave out map.byte_order = \"{}\", for only files without a header need it",
            map.byte_order
        )));
    }
    if let (Some([width, height]), true) = (map.size, opened.info.format != raw::RAW && opened.info.format != raw::HGT)
    {
        let there = (opened.info.width, opened.info.height);
        if there != (width as usize, height as usize) {
            return Err(Error::input(format!(
                "the {} is {} x {}, but map.size = [{width}, {height}]: leave it out, for only files without a header need it",
                opened.info.format, there.0, there.1
            )));
        }
    }
    Ok(opened)
}

fn known<'a>(source: &'a Source, map: &'a MapConfig, head: &[u8]) -> Result<Opened<'a>> {
    let handle = || -> Result<Handle<'a>> { source.open() };
    let webp = head.len() >= 12 && head.starts_with(b"RIFF") && &head[8..12] == b"WEBP";
    match head {
        [0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1a, b'\n', ..] => return png::open(handle()?, map),
        [b'I', b'I', 42 | 43, 0, ..] | [b'M', b'M', 0, 42 | 43, ..] => return tiff::open(handle()?, source.len(), map),
        [0x76, 0x2f, 0x31, 0x01, ..] => return exr::open(handle()?, source.len(), map),
        [b'D', b'D', b'S', b' ', ..] => return dds::open(source, map),
        _ if webp => return image::webp(source, map),
        _ => {}
    }
    let named = |endings: &[&str]| endings.iter().any(|ending| source.name().to_ascii_lowercase().ends_with(ending));
    // What has no header is known by its name; its first texels may look like anything.
    if named(&[".hgt"]) {
        return raw::hgt(source, map);
    }
    if named(&[".r16", ".r8", ".r32", ".raw"]) {
        return raw::open(source, map);
    }
    match head {
        [b'P', b'1'..=b'7', next, ..] if next.is_ascii_whitespace() || *next == b'#' => {
            return netpbm::open(source, map);
        }
        [b'P', b'f' | b'F', next, ..] if next.is_ascii_whitespace() => return netpbm::open_pfm(source, map),
        [b'B', b'M', ..] => return image::open(source, map, ::image::ImageFormat::Bmp, "BMP"),
        [0xff, 0xd8, 0xff, ..] => return image::jpeg(source, map),
        _ if asc::is_asc(head) => return asc::open(source, map),
        _ if named(&[".tga"]) || image::has_tga_footer(source)? => {
            return image::open(source, map, ::image::ImageFormat::Tga, "TGA");
        }
        _ if map.size.is_some() => return raw::open(source, map),
        _ => {}
    }
    let wide = head.starts_with(b"\xff\xfe") || head.starts_with(b"\xfe\xff");
    let hint = if wide { " (it looks like UTF-16 text: text is read as ASCII or UTF-8)" } else { "" };
    Err(Error::input(format!("not a file of a known kind{hint}: {READ} are read")))
}
