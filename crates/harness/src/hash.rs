//! A hash that is part of the format: keys of random streams come from it.

/// FNV-1a (Fowler, Noll and Vo), 64 bits.
pub(crate) fn hash(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}
