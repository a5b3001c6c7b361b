use super::Overlay;
use freepath_draws::random::StreamRng;
use rand::{Rng, TryRng};
use std::convert::Infallible;

/// The generator of the scalar method behind faults that concern uniforms.
pub(crate) struct FaultyRng<'a, 'b> {
    stream: &'b mut StreamRng<'a>,
    overlays: &'b [Box<dyn Overlay + 'b>],
}

impl<'a, 'b> FaultyRng<'a, 'b> {
    /// `stream` behind `overlays`.
    pub(crate) fn new(stream: &'b mut StreamRng<'a>, overlays: &'b [Box<dyn Overlay + 'b>]) -> Self {
        Self { stream, overlays }
    }
}

/// The next word of `stream` through all of `overlays`.
fn word(stream: &mut StreamRng, overlays: &[Box<dyn Overlay + '_>]) -> u64 {
    match overlays.split_last() {
        Some((last, others)) => last.word(&mut || word(stream, others)),
        None => stream.next_u64(),
    }
}

impl TryRng for FaultyRng<'_, '_> {
    type Error = Infallible;

    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        self.try_next_u64().map(|word| (word >> 32) as u32)
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        Ok(word(self.stream, self.overlays))
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        for chunk in bytes.chunks_mut(8) {
            let word = self.try_next_u64()?.to_le_bytes();
            chunk.copy_from_slice(&word[..chunk.len()]);
        }
        Ok(())
    }
}
