//! The bytes of a TIFF's chunks: order of bits, run lengths, LZW, samples of any number of bits.
use std::io::Read;
use tiff::tags::CompressionMethod;

/// Sample `at` of a row of `bits` bits each: whole bytes in the file's order, others with the first in the high end.
pub(super) fn word(row: &[u8], at: usize, bits: u32, little: bool) -> u64 {
    if bits.is_multiple_of(8) {
        let width = bits as usize / 8;
        let bytes = &row[at * width..(at + 1) * width];
        let push = |word: u64, byte: &u8| word << 8 | u64::from(*byte);
        return if little { bytes.iter().rev().fold(0, push) } else { bytes.iter().fold(0, push) };
    }
    let from = at * bits as usize;
    let (first, last) = (from / 8, (from + bits as usize - 1) / 8);
    let wide = row[first..=last].iter().fold(0u64, |word, byte| word << 8 | u64::from(*byte));
    let after = (last + 1) * 8 - from - bits as usize;
    wide >> after & (u64::MAX >> (64 - bits))
}

/// Whether a compression is one of those that are unpacked here.
pub(super) const fn unpacked_here(compression: CompressionMethod) -> bool {
    use CompressionMethod as C;
    matches!(compression, C::None | C::Deflate | C::OldDeflate | C::ZSTD | C::LZW | C::PackBits)
}

/// Bytes whose bits may have to be turned round.
pub(super) struct Turned<R> {
    pub(super) from: R,
    pub(super) reversed: bool,
}

impl<R: Read> Read for Turned<R> {
    fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
        let count = self.from.read(into)?;
        if self.reversed {
            into[..count].iter_mut().for_each(|byte| *byte = byte.reverse_bits());
        }
        Ok(count)
    }
}

/// As much LZW as fits.
pub(super) fn lzw(
    decoder: &mut weezl::decode::Decoder,
    mut from: &[u8],
    mut to: &mut [u8],
) -> std::result::Result<(), String> {
    while !to.is_empty() {
        let step = decoder.decode_bytes(from, to);
        from = &from[step.consumed_in..];
        to = &mut to[step.consumed_out..];
        match step.status {
            Ok(weezl::LzwStatus::Ok) if step.consumed_in + step.consumed_out > 0 => {}
            Ok(_) if to.is_empty() => {}
            Ok(_) => return Err("its data end early".into()),
            Err(error) => return Err(error.to_string()),
        }
    }
    Ok(())
}

/// Runs and literal bytes, as Macintosh programs packed them.
pub(super) fn pack_bits(mut from: &[u8], mut to: &mut [u8]) -> std::result::Result<(), String> {
    while !to.is_empty() {
        let early = || "its data end early".to_owned();
        let (&head, rest) = from.split_first().ok_or_else(early)?;
        from = rest;
        let count = match head as i8 {
            -128 => continue,
            negative @ ..0 => 1 + usize::from(negative.unsigned_abs()),
            literal => 1 + literal as usize,
        };
        let fits = count.min(to.len());
        let (part, later) = to.split_at_mut(fits);
        if (head as i8) < 0 {
            part.fill(*from.first().ok_or_else(early)?);
            from = &from[1..];
        } else {
            part.copy_from_slice(from.get(..fits).ok_or_else(early)?);
            from = from.get(count..).unwrap_or_default();
        }
        to = later;
    }
    Ok(())
}
