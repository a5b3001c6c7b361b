use freepath_estimators::Medium;
use freepath_estimators::medium::ChromaticMedium;

/// The reason why a scene cannot be that of a subject.
pub enum Refusal {
    /// The kind needs another scene.
    Scene(String),
    /// The majorant of the subject does not bound, or is none.
    Majorant(String),
}

/// The outline of a scene where draws are made elsewhere, and where a fault is to be laid.
#[derive(Clone, Copy, Default)]
pub struct Outline<'a> {
    /// The one extinction, if there is one.
    pub medium: Option<&'a dyn Medium>,
    /// The channels, if there are several.
    pub channels: Option<&'a ChromaticMedium>,
    /// The length of the ray.
    pub length: f64,
    /// Weights in a row of samples.
    pub weights: usize,
}
