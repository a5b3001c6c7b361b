//! Chunks of Blosc 1, packed by LZ4: a header of 16 bytes, where each block starts, the blocks.

use super::corrupt::corrupt;
use crate::error::Refusal;

const HEADER: usize = 16;
const SHUFFLED: u8 = 1;
const PLAIN: u8 = 2;
const BITS_SHUFFLED: u8 = 4;
const WHOLE: u8 = 16;
const LZ4: u8 = 1;
/// The most parts of a block, and the fewest values of one.
const MOST_PARTS: usize = 16;
const FEWEST_VALUES: usize = 128;

/// The bytes of a chunk, which fill `plain`.
pub(super) fn unpack(chunk: &[u8], plain: &mut [u8]) -> Result<(), Refusal> {
    unpacked(chunk, plain)?.ok_or_else(|| corrupt("blosc compression"))
}

fn unpacked(chunk: &[u8], plain: &mut [u8]) -> Result<Option<()>, Refusal> {
    let (Some(length), Some(size), Some(packed)) = (word(chunk, 4), word(chunk, 8), word(chunk, 12)) else {
        return Ok(None);
    };
    let (flags, width) = (chunk[2], usize::from(chunk[3]));
    if chunk[0] != 2 || length != plain.len() || packed != chunk.len() || size == 0 || width == 0 {
        return Ok(None);
    }
    if flags & PLAIN != 0 {
        return Ok(chunk.get(HEADER..HEADER + length).map(|bytes| plain.copy_from_slice(bytes)));
    }
    if flags >> 5 != LZ4 || flags & BITS_SHUFFLED != 0 {
        let cause = format!("it is packed by blosc with {}", codec(flags));
        return Err(Refusal::new(cause, "blosc with LZ4, shuffled by bytes or not at all"));
    }
    let blocks = plain.chunks_mut(size).enumerate();
    Ok(blocks.map(|(k, block)| unpack_block(chunk, k, size, block)).collect())
}

fn codec(flags: u8) -> &'static str {
    match flags >> 5 {
        LZ4 => "a shuffle by bits",
        0 => "BloscLZ",
        2 => "Snappy",
        3 => "Zlib",
        4 => "Zstd",
        _ => "an unknown codec",
    }
}

/// The `k`-th block, which may be split into one part for each byte of a value.
fn unpack_block(chunk: &[u8], k: usize, size: usize, block: &mut [u8]) -> Option<()> {
    let (flags, width) = (chunk[2], usize::from(chunk[3]));
    let split = flags & WHOLE == 0 && width <= MOST_PARTS && size / width >= FEWEST_VALUES && block.len() == size;
    let parts = if split { width } else { 1 };
    if !block.len().is_multiple_of(parts) {
        return None;
    }
    let mut shuffled = vec![0; block.len()];
    let mut start = word(chunk, HEADER + 4 * k)?;
    for part in shuffled.chunks_mut(block.len() / parts) {
        let packed = word(chunk, start)?;
        start = start.checked_add(4)?;
        let end = start.checked_add(packed)?;
        unpack_part(chunk.get(start..end)?, part)?;
        start = end;
    }
    match flags & SHUFFLED != 0 && width > 1 {
        true => unshuffle(&shuffled, width, block),
        false => block.copy_from_slice(&shuffled),
    }
    Some(())
}

fn unpack_part(packed: &[u8], part: &mut [u8]) -> Option<()> {
    if packed.len() == part.len() {
        part.copy_from_slice(packed);
        return Some(());
    }
    let length = lz4_flex::block::decompress_into(packed, part).ok()?;
    (length == part.len()).then_some(())
}

/// From all first bytes, all second bytes and so on to value by value; what is left over stays.
fn unshuffle(shuffled: &[u8], width: usize, block: &mut [u8]) {
    let count = block.len() / width;
    for (i, byte) in block.iter_mut().enumerate() {
        *byte = if i < count * width { shuffled[i % width * count + i / width] } else { shuffled[i] };
    }
}

fn word(bytes: &[u8], at: usize) -> Option<usize> {
    let word = bytes.get(at..at.checked_add(4)?)?;
    u32::from_le_bytes(word.try_into().ok()?).try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A chunk of one block, whose parts are stored as they are.
    fn chunk(flags: u8, width: u8, parts: &[&[u8]]) -> Vec<u8> {
        let length: usize = parts.iter().map(|part| part.len()).sum();
        let packed = HEADER + 4 + parts.len() * 4 + length;
        let words = [length, length, packed, HEADER + 4].map(|word| (word as u32).to_le_bytes());
        let parts = parts.iter().flat_map(|part| [&(part.len() as u32).to_le_bytes(), *part].concat());
        [&[2, 1, flags, width], words.as_flattened()].concat().into_iter().chain(parts).collect()
    }

    fn unpacked(chunk: &[u8], length: usize) -> Result<Vec<u8>, String> {
        let mut plain = vec![0; length];
        unpack(chunk, &mut plain).map(|()| plain).map_err(|refusal| refusal.to_string())
    }

    #[test]
    fn parts_are_put_together_byte_by_byte() {
        let (low, high) = ([7; 128], [9; 128]);
        let split = unpacked(&chunk(LZ4 << 5 | SHUFFLED, 2, &[&low, &high]), 256).unwrap();
        assert!(split.chunks_exact(2).all(|pair| pair == [7, 9]));
        let whole = unpacked(&chunk(LZ4 << 5 | SHUFFLED | WHOLE, 2, &[&[1, 2, 3, 4, 5, 6, 7]]), 7);
        assert_eq!(whole, Ok(vec![1, 4, 2, 5, 3, 6, 7]));
        let unshuffled = unpacked(&chunk(LZ4 << 5 | WHOLE, 4, &[&[1, 2, 3, 4, 5, 6, 7, 8]]), 8);
        assert_eq!(unshuffled, Ok(vec![1, 2, 3, 4, 5, 6, 7, 8]));
    }

    #[test]
    fn blocks_lie_where_the_chunk_says_and_the_last_may_be_short() {
        let (last, first) = ([3, 0, 0, 0, 5, 6, 7], [4, 0, 0, 0, 1, 2, 3, 4]);
        let words = [7, 4, 39, 31, 24].map(u32::to_le_bytes); // length, size of a block, packed length, two places
        let chunk = [&[2, 1, LZ4 << 5 | WHOLE, 1], words.as_flattened(), &last, &first].concat();
        assert_eq!(unpacked(&chunk, 7), Ok(vec![1, 2, 3, 4, 5, 6, 7]));
    }

    #[test]
    fn other_codecs_are_refused_by_name() {
        for (bits, name) in [(0, "BloscLZ"), (2, "Snappy"), (3, "Zlib"), (4, "Zstd"), (7, "an unknown codec")] {
            let refused = unpacked(&chunk(bits << 5, 4, &[&[0; 8]]), 8).unwrap_err();
            assert!(refused.starts_with(&format!("it is packed by blosc with {name} (")), "{refused}");
        }
        let bits = unpacked(&chunk(LZ4 << 5 | BITS_SHUFFLED, 4, &[&[0; 8]]), 8).unwrap_err();
        assert!(bits.contains("with a shuffle by bits"), "{bits}");
    }

    #[test]
    fn lengths_that_do_not_fit_are_refused() {
        let good = chunk(LZ4 << 5 | WHOLE, 4, &[&[1; 8]]);
        assert!(unpacked(&good, 8).is_ok() && unpacked(&good, 9).is_err() && unpacked(&good, 0).is_err());
        for end in 0..good.len() {
            assert!(unpacked(&good[..end], 8).is_err(), "{end}");
        }
        for at in [0, 3, 4, 8, 12, 16, 20] {
            for byte in [0, 255] {
                let mut bad = good.clone();
                bad[at + 3 * usize::from(at > 3)] = byte;
                bad[at] = byte;
                assert!(unpacked(&bad, 8).is_err() || at == 3 || at == 8, "{at}");
            }
        }
    }
}
