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
    /// The places where mu or its slope jumps.
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

    /// The place of the look-up that the subject means to make at `t`.
    fn place(&self, t: f64) -> f64 {
        t
    }

    /// The value that the subject takes for mu at the place `t`.
    fn answer(&self, _t: f64, mu: f64) -> f64 {
        mu
    }

    /// The draw as the fault leaves it; none if it is drawn again.
    fn finish(&self, path: FreePath) -> Option<FreePath> {
        Some(path)
    }
}
