use super::{Fault, Layer, Overlay, RayView, WalkContext};
use freepath_estimators::{Cells, Extinction, FreePath, Majorants};

/// The medium as a subject with faulty look-ups sees it. It stands between the subject and the audit, which sees what the
/// medium really answers.
pub(crate) struct FaultyMedium<'a> {
    medium: &'a dyn Extinction,
    ray: RayView,
    /// Outermost first.
    overlays: Vec<Box<dyn Overlay + 'a>>,
}

impl<'a> FaultyMedium<'a> {
    /// The medium of `context` behind those of `faults` that concern look-ups or walks.
    pub(crate) fn new(context: WalkContext<'a>, faults: &'a [Fault]) -> Self {
        let medium = context.medium;
        let mut ray = RayView {
            length: medium.length(),
            majorants: medium.majorants().clone(),
            breaks: medium.breaks().to_vec(),
        };
        faults.iter().for_each(|fault| fault.injection().alter_ray(&mut ray));
        Self {
            medium,
            ray,
            overlays: faults.iter().filter_map(|fault| fault.injection().overlay(context)).collect(),
        }
    }

    /// Begins another walk.
    pub(crate) fn begin(&self) {
        self.overlays.iter().for_each(|overlay| overlay.begin());
    }

    /// The draw as the faults leave it; none if it is drawn again.
    pub(crate) fn finish(&self, path: FreePath) -> Option<FreePath> {
        self.overlays.iter().try_fold(path, |path, overlay| overlay.finish(path))
    }

    /// The overlays before the stream.
    pub(crate) fn overlays(&self) -> &[Box<dyn Overlay + 'a>] {
        &self.overlays
    }
}

impl Extinction for FaultyMedium<'_> {
    fn length(&self) -> f64 {
        self.ray.length
    }
    fn mu(&self, t: f64) -> f64 {
        let place = self.overlays.iter().fold(t, |t, overlay| overlay.place(t));
        let mu = self.medium.mu(place);
        self.overlays.iter().rev().fold(mu, |mu, overlay| overlay.answer(place, mu))
    }
    fn majorants(&self) -> &Majorants {
        &self.ray.majorants
    }
    fn breaks(&self) -> &[f64] {
        &self.ray.breaks
    }
    fn cells(&self) -> Cells {
        self.medium.cells()
    }
}

impl Fault {
    /// True if any of `faults` stands between the subject and its look-ups.
    pub(crate) fn alters_lookups(faults: &[Self]) -> bool {
        faults.iter().any(|fault| match fault.layer() {
            Layer::LookUps | Layer::Walk | Layer::Uniforms => true,
            Layer::Majorants
            | Layer::Numbers
            | Layer::Tables
            | Layer::Densities
            | Layer::Draws
            | Layer::Channels => false,
        })
    }

    /// True if any of `faults` can only be laid over one walk at a time.
    pub(crate) fn need_scalar(faults: &[Self]) -> bool {
        faults.iter().any(|fault| match fault.layer() {
            Layer::Walk | Layer::Uniforms | Layer::Numbers => true,
            Layer::Majorants
            | Layer::LookUps
            | Layer::Tables
            | Layer::Densities
            | Layer::Draws
            | Layer::Channels => false,
        })
    }
}
