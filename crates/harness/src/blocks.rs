//! Numbers of blocks: each use has a range of its own, so that no two share a stream.

/// Rows of a block: part of the format, since streams belong to blocks. Those of stage 1 are numbered from 0, those of
/// stage 2 from where stage 1 ends.
pub const BLOCK: usize = 16_384;

/// Growth is numbered from here,
pub(crate) const GROWTH: u64 = 1 << 40;
/// and in stage 2 from here.
pub(crate) const GROWTH_OF_STAGE_TWO: u64 = 1 << 41;
/// Scripted generators.
pub(crate) const SCRIPTS: u64 = 1 << 44;
/// Identities.
pub(crate) const IDENTITIES: u64 = 1 << 45;
/// Nets of the microscope.
pub(crate) const NETS: u64 = 1 << 46;
/// Short starts of a program.
pub(crate) const REHEARSAL: u64 = 1 << 47;
/// A second start of a program that passes.
pub(crate) const SECOND_START: u64 = 1 << 48;

/// The stage of a range of blocks, by the first of them.
pub(crate) fn stage_of(first: u64) -> u32 {
    let grown = (GROWTH..GROWTH_OF_STAGE_TWO).contains(&first);
    if first == 0 || grown { 1 } else { 2 }
}
