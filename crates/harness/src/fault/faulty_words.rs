use super::{Fault, FaultyRng, Overlay};
use freepath_draws::random::StreamRng;

/// The uniforms of one draw at a time, behind the faults that concern them where there is no ray.
pub(crate) struct FaultyWords<'a> {
    overlays: Vec<Box<dyn Overlay + 'a>>,
}

impl<'a> FaultyWords<'a> {
    /// The uniforms behind `faults`.
    pub(crate) fn new(faults: &'a [Fault]) -> Self {
        Self { overlays: faults.iter().filter_map(|fault| fault.injection().words()).collect() }
    }

    /// The generator of the next draw.
    pub(crate) fn begin<'b, 's>(&'b self, stream: &'b mut StreamRng<'s>) -> FaultyRng<'s, 'b> {
        self.overlays.iter().for_each(|overlay| overlay.begin());
        FaultyRng::new(stream, &self.overlays)
    }
}
