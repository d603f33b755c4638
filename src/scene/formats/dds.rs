//! DirectDraw surfaces of one channel; of mipmaps, the largest.
use super::bc4::Bc4;
use super::opened::{Info, Opened, Samples, broken, sized};
use super::packed::{Layout, Packed, Stored};
use super::pick::Pick;
use crate::source::Source;
use ddsfile::{Caps2, D3DFormat, Dds, DxgiFormat};
use reliefrtl_base::error::Result;
use reliefrtl_config::MapConfig;
use std::io::Read;

const KIND: &str = "DDS";

pub(super) fn open<'a>(source: &'a Source, map: &'a MapConfig) -> Result<Opened<'a>> {
    // Magic number, header, and the second header of newer files.
    let dds = Dds::read(source.open()?.take(148)).map_err(|error| broken(KIND, error))?;
    let (header, second) = (&dds.header, &dds.header10);
    let (width, height) = sized(header.width.into(), header.height.into(), map)?;
    let several = header.caps2.intersects(Caps2::CUBEMAP | Caps2::VOLUME)
        || header.depth.is_some_and(|depth| depth > 1)
        || second.as_ref().is_some_and(|second| second.array_size > 1);
    if several {
        return Err(broken(KIND, "it is a cube, a volume or an array, and a map is one picture"));
    }
    let (samples, stored) = match (dds.get_dxgi_format(), dds.get_d3d_format()) {
        (Some(DxgiFormat::R8_UNorm | DxgiFormat::R8_UInt), _) | (_, Some(D3DFormat::L8)) => {
            (Samples::bits(8), Some(Stored::U8))
        }
        (Some(DxgiFormat::R16_UNorm | DxgiFormat::R16_UInt), _) | (_, Some(D3DFormat::L16)) => {
            (Samples::bits(16), Some(Stored::U16))
        }
        (Some(DxgiFormat::R16_SInt | DxgiFormat::R16_SNorm), _) => (Samples::Signed(16), Some(Stored::I16)),
        (Some(DxgiFormat::R16_Float), _) | (_, Some(D3DFormat::R16F)) => (Samples::Float(16), Some(Stored::F16)),
        (Some(DxgiFormat::R32_Float), _) | (_, Some(D3DFormat::R32F)) => (Samples::Float(32), Some(Stored::F32)),
        (Some(DxgiFormat::BC4_UNorm | DxgiFormat::BC4_Typeless), _) => (Samples::bits(8), None),
        (dxgi, d3d) => {
            let there = match (dxgi, d3d) {
                (Some(format), _) => format!("{format:?}"),
                (_, Some(format)) => format!("{format:?}"),
                _ => "of an unknown kind".to_owned(),
            };
            let read = "of one channel, R8, R16, R16 float, R32 float and BC4 are read";
            return Err(broken(KIND, format!("its pixels are {there}: {read}")));
        }
    };
    let pick = Pick::new(&["Y"], samples.full(), map)?;
    let info = Info { channel: pick.label(), ..Info::new(KIND, width, height, samples) };
    let offset = if second.is_some() { 148 } else { 128 };
    let Some(stored) = stored else {
        return Ok(Opened { info, rows: Box::new(Bc4::new(source, offset, width, height)?) });
    };
    let layout = Layout { offset, width, height, stored, big: false, upward: false, max: f64::INFINITY };
    Ok(Opened { info, rows: Box::new(Packed::new(source, layout, pick, KIND)?) })
}
