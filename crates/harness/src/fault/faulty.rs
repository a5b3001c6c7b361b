use super::overlay::{Overlay, Shape, Site};
use super::{Fault, Layer};
use freepath_estimators::{Cells, Extinction, FreePath, Majorants};

/// A medium as a subject with faulty look-ups sees it. It stands between the subject and the audit, which sees what the
/// medium really answers.
pub struct Faulty<'a> {
    medium: &'a dyn Extinction,
    shape: Shape,
    /// Outermost first.
    overlays: Vec<Box<dyn Overlay + 'a>>,
}

impl<'a> Faulty<'a> {
    /// The medium of `site` behind those of `faults` that concern look-ups or walks.
    #[must_use]
    pub fn new(site: Site<'a>, faults: &'a [Fault]) -> Self {
        let medium = site.medium;
        let mut shape = Shape {
            length: medium.length(),
            majorants: medium.majorants().clone(),
            breaks: medium.breaks().to_vec(),
        };
        faults.iter().for_each(|fault| fault.reshape(&mut shape));
        Self { medium, shape, overlays: faults.iter().filter_map(|fault| fault.lay(site)).collect() }
    }

    /// Begins another walk.
    pub fn begin(&self) {
        self.overlays.iter().for_each(|overlay| overlay.begin());
    }

    /// What becomes of a draw; none if it is drawn again.
    #[must_use]
    pub fn finish(&self, path: FreePath) -> Option<FreePath> {
        self.overlays.iter().try_fold(path, |path, overlay| overlay.finish(path))
    }

    /// What stands before the stream.
    #[must_use]
    pub fn overlays(&self) -> &[Box<dyn Overlay + 'a>] {
        &self.overlays
    }
}

impl Extinction for Faulty<'_> {
    fn length(&self) -> f64 {
        self.shape.length
    }
    fn mu(&self, t: f64) -> f64 {
        let place = self.overlays.iter().fold(t, |t, overlay| overlay.place(t));
        let mu = self.medium.mu(place);
        self.overlays.iter().rev().fold(mu, |mu, overlay| overlay.answer(place, mu))
    }
    fn majorants(&self) -> &Majorants {
        &self.shape.majorants
    }
    fn breaks(&self) -> &[f64] {
        &self.shape.breaks
    }
    fn cells(&self) -> Cells {
        self.medium.cells()
    }
}

impl Fault {
    /// Whether any of `faults` stands between the subject and its look-ups.
    #[must_use]
    pub fn spoil_lookups(faults: &[Self]) -> bool {
        faults.iter().any(|fault| matches!(fault.layer(), Layer::LookUps | Layer::Walk))
    }

    /// Whether any of `faults` can only be laid over one walk at a time.
    #[must_use]
    pub fn need_scalar(faults: &[Self]) -> bool {
        faults.iter().any(|fault| fault.layer() == Layer::Walk)
    }
}
