use super::laws::{Counting, counting, lengths, mean_length, weighs_1};
use super::moments::{moments, second_radius};
use freepath_estimators::walk::{Method, Scoring, System, Walks};
use std::sync::{Arc, OnceLock};

/// A system as it is, the same as a walk sees it, and what is known of its walks.
pub struct InSystem {
    truth: System,
    /// Behind the faults that concern tables.
    pub(crate) seen: System,
    /// <h, x>; none if the system is too large to be solved.
    pub(super) mean: Option<f64>,
    known: [OnceLock<Arc<Known>>; 6],
}

/// What is known of the walks of one method.
pub(super) struct Known {
    /// E[X^k] for k = 1 to 6; some may be infinite.
    pub(super) moments: [f64; 6],
    /// The spectral radius of H^2 / P, where the second moment is infinite.
    pub(super) radius: Option<f64>,
    /// The least and greatest score, where weights are all 1.
    pub(super) range: Option<(f64, f64)>,
    /// The expected number of states.
    pub(super) length: Option<f64>,
    /// The law of the number of states.
    pub(super) lengths: Vec<f64>,
    /// The law of a score that counts.
    pub(super) counting: Option<Counting>,
}

impl InSystem {
    /// A system that is seen as it is.
    pub(super) fn new(system: System) -> Self {
        let solution = system.coefficients().solved(system.source());
        let mean = solution.map(|x| x.iter().zip(system.detector()).map(|(x, h)| x * h).sum());
        Self { seen: system.clone(), truth: system, mean, known: Default::default() }
    }

    /// The same, seen otherwise.
    pub(super) fn seen_as(self, seen: System) -> Self {
        Self { seen, ..self }
    }

    /// The system as it is.
    pub(super) fn truth(&self) -> &System {
        &self.truth
    }

    /// What is known of a method; none if the system has no such walk.
    pub(super) fn known(&self, method: Method) -> Option<Arc<Known>> {
        let mean = self.mean?;
        let slot = &self.known[place(method)];
        if let Some(known) = slot.get() {
            return Some(known.clone());
        }
        let known = Arc::new(Known::of(&self.truth, method, mean)?);
        Some(slot.get_or_init(|| known).clone())
    }
}

fn place(method: Method) -> usize {
    let walks = match method.walks {
        Walks::Forward => 0,
        Walks::Adjoint => 1,
        Walks::Guided => 2,
    };
    match method.scoring {
        Scoring::End => 2 * walks,
        Scoring::Visits => 2 * walks + 1,
    }
}

impl Known {
    fn of(system: &System, method: Method, mean: f64) -> Option<Self> {
        let walker = system.walker(method.walks).ok()?;
        let moments = match method {
            // every score is the mean, which a sum over states would blur
            Method { walks: Walks::Guided, scoring: Scoring::End } => {
                std::array::from_fn(|k| (0..=k).fold(1.0, |power, _| power * mean))
            }
            Method { walks: Walks::Guided | Walks::Forward | Walks::Adjoint, .. } => moments(system, method)?,
        };
        let radius = if moments[1].is_finite() { None } else { second_radius(system, method) };
        let ends = match method.scoring {
            Scoring::End if weighs_1(walker) => range(&walker.end),
            Scoring::End | Scoring::Visits => None,
        };
        let (length, lengths) = (mean_length(walker), lengths(walker));
        Some(Self { moments, radius, range: ends, length, lengths, counting: counting(system, method, mean) })
    }
}

/// The least and greatest number, 0 among them; none if all are 0.
fn range(numbers: &[f64]) -> Option<(f64, f64)> {
    let low = numbers.iter().fold(0.0, |low, &x| if x < low { x } else { low });
    let high = numbers.iter().fold(0.0, |high, &x| if x > high { x } else { high });
    (low < high).then_some((low, high))
}
