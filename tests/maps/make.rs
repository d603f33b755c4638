//! Files made byte by byte, of what encoders of crates don't write.
use std::io::{Cursor, Write};

/// Where a TIFF's samples lie and how they are packed.
#[derive(Clone, Debug)]
pub struct Tiff {
    pub width: usize,
    pub height: usize,
    /// Bits of a sample.
    pub bits: u32,
    /// 1 whole numbers, 2 signed, 3 floats.
    pub format: u16,
    pub samples: usize,
    pub photometric: u16,
    pub extra: Option<u16>,
    pub big_endian: bool,
    pub big_tiff: bool,
    pub planar: bool,
    pub tile: Option<(usize, usize)>,
    pub rows_per_strip: usize,
    /// 1 none, 5 LZW, 8 deflate, 32773 PackBits, 50000 zstd.
    pub compression: u16,
    pub predictor: u16,
    pub orientation: u16,
    /// 2: the lowest bit of a byte comes first.
    pub fill_order: u16,
    pub nodata: Option<&'static str>,
    /// What GDAL says besides, as XML.
    pub metadata: Option<&'static str>,
    /// Width and height of a pixel in the world, and the depth that GeoTIFF has there.
    pub cells: Option<[f64; 3]>,
    pub palette: Option<Vec<u16>>,
    /// Sample words, pixel after pixel.
    pub words: Vec<u64>,
}

/// Kind, bytes of a value, values.
type Field = (u16, usize, Vec<u64>);

impl Tiff {
    pub fn grey(width: usize, bits: u32, words: &[u64]) -> Self {
        Self {
            width,
            height: words.len() / width,
            bits,
            format: 1,
            samples: 1,
            photometric: 1,
            extra: None,
            big_endian: false,
            big_tiff: false,
            planar: false,
            tile: None,
            rows_per_strip: 3,
            compression: 1,
            predictor: 1,
            orientation: 1,
            fill_order: 1,
            nodata: None,
            metadata: None,
            cells: None,
            palette: None,
            words: words.to_vec(),
        }
    }

    fn int(&self, value: u64, bytes: usize) -> Vec<u8> {
        let little = value.to_le_bytes();
        let mut out = little[..bytes].to_vec();
        if self.big_endian {
            out.reverse();
        }
        out
    }

    /// One row of a chunk.
    fn row(&self, words: &[u64], together: usize) -> Vec<u8> {
        let mask = u64::MAX >> (64 - self.bits);
        let mut words = words.to_vec();
        if self.predictor == 2 {
            for at in (together..words.len()).rev() {
                words[at] = words[at].wrapping_sub(words[at - together]) & mask;
            }
        }
        if self.predictor == 3 {
            let width = self.bits as usize / 8;
            let mut row: Vec<u8> =
                (0..width).flat_map(|b| words.iter().map(move |w| (w >> (8 * (width - 1 - b))) as u8)).collect();
            for at in (together..row.len()).rev() {
                row[at] = row[at].wrapping_sub(row[at - together]);
            }
            return row;
        }
        if self.bits.is_multiple_of(8) {
            return words.iter().flat_map(|w| self.int(*w, self.bits as usize / 8)).collect();
        }
        let mut row = vec![0u8; (words.len() * self.bits as usize).div_ceil(8)];
        for (at, word) in words.iter().enumerate() {
            for bit in 0..self.bits as usize {
                let place = at * self.bits as usize + bit;
                row[place / 8] |= ((word >> (self.bits as usize - 1 - bit) & 1) as u8) << (7 - place % 8);
            }
        }
        row
    }

    fn pack(&self, bytes: &[u8]) -> Vec<u8> {
        match self.compression {
            5 => weezl::encode::Encoder::with_tiff_size_switch(weezl::BitOrder::Msb, 8).encode(bytes).unwrap(),
            8 => {
                let mut out = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
                out.write_all(bytes).unwrap();
                out.finish().unwrap()
            }
            50000 => zstd::encode_all(bytes, 1).unwrap(),
            // A literal piece, and where there are four equal bytes a run.
            32773 => {
                let mut out = Vec::new();
                let mut rest = bytes;
                while let Some(first) = rest.first() {
                    let run = rest.iter().take(128).take_while(|b| *b == first).count();
                    if run >= 4 {
                        out.extend([(1 - run as i16) as i8 as u8, *first]);
                        rest = &rest[run..];
                    } else {
                        let run = run.min(rest.len());
                        out.push(run as u8 - 1);
                        out.extend(&rest[..run]);
                        rest = &rest[run..];
                    }
                }
                out
            }
            _ => bytes.to_vec(),
        }
    }

    /// The chunks, in their order.
    fn chunks(&self) -> Vec<Vec<u8>> {
        let (columns, rows) = self.tile.unwrap_or((self.width, self.rows_per_strip));
        let (planes, together) = if self.planar { (self.samples, 1) } else { (1, self.samples) };
        let mut out = Vec::new();
        for plane in 0..planes {
            for y in (0..self.height).step_by(rows) {
                for x in (0..self.width).step_by(columns) {
                    let mut bytes = Vec::new();
                    let last = if self.tile.is_some() { y + rows } else { (y + rows).min(self.height) };
                    for j in y..last {
                        let word = |i: usize, c: usize| {
                            let at = (j * self.width + i) * self.samples + plane + c;
                            // What tiles are filled up with is anything.
                            if i < self.width && j < self.height { self.words[at] } else { 1 }
                        };
                        let words: Vec<u64> = (x..x + columns)
                            .flat_map(|i| (0..together).map(move |c| (i, c)))
                            .map(|(i, c)| word(i, c))
                            .collect();
                        bytes.extend(self.row(&words, together));
                    }
                    let mut packed = self.pack(&bytes);
                    if self.fill_order == 2 {
                        packed.iter_mut().for_each(|byte| *byte = byte.reverse_bits());
                    }
                    out.push(packed);
                }
            }
        }
        out
    }

    pub fn bytes(&self) -> Vec<u8> {
        self.pages(&[])
    }

    /// This page and others after it.
    pub fn pages(&self, more: &[(&Self, u32)]) -> Vec<u8> {
        let mut out = if self.big_endian { b"MM".to_vec() } else { b"II".to_vec() };
        if self.big_tiff {
            out.extend([self.int(43, 2), self.int(8, 2), self.int(0, 2), self.int(0, 8)].concat());
        } else {
            out.extend([self.int(42, 2), self.int(0, 4)].concat());
        }
        let mut link = if self.big_tiff { 8 } else { 4 };
        for (page, kind) in std::iter::once((self, 0)).chain(more.iter().copied()) {
            link = page.page(&mut out, link, kind);
        }
        out
    }

    /// Appends a page whose place goes to `link`; returns where the next one's goes.
    fn page(&self, out: &mut Vec<u8>, link: usize, kind: u32) -> usize {
        let word = if self.big_tiff { 8 } else { 4 };
        let mut places = Vec::new();
        for chunk in self.chunks() {
            places.push((out.len() as u64, chunk.len() as u64));
            out.extend(chunk);
        }
        let short = |values: &[u64]| (3u16, 2usize, values.to_vec());
        let long = |values: &[u64]| (4u16, 4usize, values.to_vec());
        let offsets: Vec<u64> = places.iter().map(|p| p.0).collect();
        let counts: Vec<u64> = places.iter().map(|p| p.1).collect();
        let mut tags: Vec<(u16, Field)> = vec![
            (254, long(&[kind.into()])),
            (256, long(&[self.width as u64])),
            (257, long(&[self.height as u64])),
            (258, short(&vec![self.bits.into(); self.samples])),
            (259, short(&[self.compression.into()])),
            (262, short(&[self.photometric.into()])),
            (266, short(&[self.fill_order.into()])),
            (274, short(&[self.orientation.into()])),
            (277, short(&[self.samples as u64])),
            (284, short(&[if self.planar { 2 } else { 1 }])),
            (317, short(&[self.predictor.into()])),
            (339, short(&vec![self.format.into(); self.samples])),
        ];
        match self.tile {
            Some((columns, rows)) => tags.extend([
                (322, long(&[columns as u64])),
                (323, long(&[rows as u64])),
                (324, long(&offsets)),
                (325, long(&counts)),
            ]),
            None => {
                tags.extend([(273, long(&offsets)), (278, long(&[self.rows_per_strip as u64])), (279, long(&counts))]);
            }
        }
        tags.extend(self.extra.map(|kind| (338, short(&[kind.into()]))));
        tags.extend(self.palette.as_ref().map(|p| (320, short(&p.iter().map(|w| u64::from(*w)).collect::<Vec<_>>()))));
        let text = |t: &str| (2u16, 1usize, t.bytes().chain([0]).map(u64::from).collect::<Vec<_>>());
        tags.extend(self.nodata.map(|t| (42113, text(t))));
        tags.extend(self.metadata.map(|t| (42112, text(t))));
        tags.extend(self.cells.map(|c| (33550, (12, 8, c.map(f64::to_bits).to_vec()))));
        tags.sort_by_key(|t| t.0);
        let mut entries = Vec::new();
        for (tag, (kind, bytes, values)) in &tags {
            let data: Vec<u8> = values.iter().flat_map(|v| self.int(*v, *bytes)).collect();
            let mut field = data.clone();
            if data.len() > word {
                field = self.int(out.len() as u64, word);
                out.extend(data);
            }
            field.resize(word, 0);
            entries.extend([self.int((*tag).into(), 2), self.int((*kind).into(), 2)].concat());
            entries.extend(self.int(values.len() as u64, word));
            entries.extend(field);
        }
        let here = self.int(out.len() as u64, word);
        out[link..link + word].copy_from_slice(&here);
        out.extend(self.int(tags.len() as u64, if self.big_tiff { 8 } else { 2 }));
        out.extend(entries);
        out.extend(self.int(0, word));
        out.len() - word
    }
}

/// A PNG of grey samples packed as the depth asks, and what else stands before the rows.
pub fn png(
    width: u32,
    depth: png::BitDepth,
    colour: png::ColorType,
    rows: &[u8],
    more: impl Fn(&mut png::Encoder<'_, &mut Vec<u8>>),
) -> Vec<u8> {
    let bits = depth as usize * colour.samples();
    let height = rows.len() / (width as usize * bits).div_ceil(8);
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, width, height as u32);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    more(&mut encoder);
    encoder.write_header().unwrap().write_image_data(rows).unwrap();
    out
}

/// An OpenEXR of one part of single-precision channels.
pub fn exr(channels: &[(&str, &[f32])], width: usize) -> Vec<u8> {
    use exr::prelude::{AnyChannel, AnyChannels, FlatSamples, Image, WritableImage};
    let size = (width, channels[0].1.len() / width);
    let list =
        channels.iter().map(|(name, values)| AnyChannel::new(*name, FlatSamples::F32(values.to_vec()))).collect();
    let mut out = Cursor::new(Vec::new());
    Image::from_channels(size, AnyChannels::sort(list)).write().to_buffered(&mut out).unwrap();
    out.into_inner()
}

/// An OpenEXR of `side` x `side` single-precision heights as its header says, with the few of 7 x 7, one row a block.
pub fn plain_exr(side: u32) -> Vec<u8> {
    let mut out = vec![0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0];
    let mut attribute = |name: &str, kind: &str, value: &[u8]| {
        out.extend(
            [name.as_bytes(), b"\0", kind.as_bytes(), b"\0", &(value.len() as u32).to_le_bytes(), value].concat(),
        );
    };
    let window = [0, 0, side - 1, side - 1].map(u32::to_le_bytes).concat();
    let channel = [b"Y\0".as_slice(), &[2, 0, 0, 0], &[0; 4], &[1, 0, 0, 0], &[1, 0, 0, 0], b"\0"].concat();
    attribute("channels", "chlist", &channel);
    attribute("compression", "compression", &[0]);
    attribute("dataWindow", "box2i", &window);
    attribute("displayWindow", "box2i", &window);
    attribute("lineOrder", "lineOrder", &[0]);
    attribute("pixelAspectRatio", "float", &1f32.to_le_bytes());
    attribute("screenWindowCenter", "v2f", &[0; 8]);
    attribute("screenWindowWidth", "float", &1f32.to_le_bytes());
    out.push(0);
    let first = out.len() as u64 + 7 * 8;
    (0..7u64).for_each(|y| out.extend((first + y * (8 + 28)).to_le_bytes()));
    for y in 0..7u32 {
        out.extend([y.to_le_bytes(), 28u32.to_le_bytes()].concat());
        (0..7).for_each(|x| out.extend((x as f32 / 6.0).to_le_bytes()));
    }
    out
}

/// A DDS header for a kind of pixels, and its bytes.
pub fn dds(width: u32, height: u32, format: ddsfile::DxgiFormat, data: &[u8]) -> Vec<u8> {
    let mut dds = ddsfile::Dds::new_dxgi(ddsfile::NewDxgiParams {
        height,
        width,
        depth: None,
        format,
        mipmap_levels: None,
        array_layers: None,
        caps2: None,
        is_cubemap: false,
        resource_dimension: ddsfile::D3D10ResourceDimension::Texture2D,
        alpha_mode: ddsfile::AlphaMode::Opaque,
    })
    .unwrap();
    dds.data = data.to_vec();
    let mut out = Vec::new();
    dds.write(&mut out).unwrap();
    out
}
