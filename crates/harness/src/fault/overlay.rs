use freepath_draws::Key;
use freepath_estimators::{Extinction, FreePath, Majorants};

/// The walk that a fault is laid over: the medium below it, and the key of the block.
#[derive(Clone, Copy)]
pub(crate) struct WalkContext<'a> {
    /// The audited medium.
    pub(crate) medium: &'a dyn Extinction,
    /// The block's key; faults draw from a lane beyond those of the subject.
    pub(crate) key: Key,
}

/// The ray as a subject sees it, beside mu.
#[derive(Clone, Debug)]
pub(crate) struct RayView {
    /// Length of the ray.
    pub(crate) length: f64,
    /// Majorants by segment.
    pub(crate) majorants: Majorants,
    /// Where mu or its slope jumps.
    pub(crate) breaks: Vec<f64>,
}

/// A fault at work in one block, on one thread, between a subject and its medium or its uniforms; provided: no change.
pub(crate) trait Overlay {
    /// Another walk begins.
    fn begin(&self) {}

    /// The word that the subject gets; `stream` is the next one of the real stream.
    fn word(&self, stream: &mut dyn FnMut() -> u64) -> u64 {
        stream()
    }

    /// Where the subject looks up when it means to look up at `t`.
    fn place(&self, t: f64) -> f64 {
        t
    }

    /// What the subject makes of mu at the place `t`.
    fn answer(&self, _t: f64, mu: f64) -> f64 {
        mu
    }

    /// What becomes of the draw; none if it is drawn again.
    fn finish(&self, path: FreePath) -> Option<FreePath> {
        Some(path)
    }
}
