use crate::experiment::Terms;
use crate::kind::free_path::FreePathKind;
use crate::kind::{Ray, Source};
use freepath_estimators::Medium;
use freepath_statistics::claim::Withdrawal;
use freepath_statistics::{Grain, Law};
use std::sync::Arc;

/// The medium's law, and the law that the sampler has by design.
pub(in crate::kind::free_path) struct Laws {
    pub(in crate::kind::free_path) truth: Arc<Law>,
    /// If that is another; on the same cells.
    pub(in crate::kind::free_path) own: Option<Arc<Law>>,
}

impl Laws {
    pub(in crate::kind::free_path) fn of(ray: Ray, source: &Source<FreePathKind>, terms: &Terms) -> Self {
        let truth = ray.truth;
        let collided = collided_alone(ray, source, terms);
        let slack = terms.tolerance + truth.tau_error() / collided.unwrap_or(1.0);
        let law = Law::new(truth.length(), slack, survival(truth, collided));
        let law = law.grained(Grain::of_bits(terms.bits));
        let law = if source.is_external() {
            let rounding = terms.tolerance * law.steepness(); // each t may be off by that share of it
            law.loosened(rounding)
        } else {
            law
        };
        let survival = source.sampler().and_then(|sampler| sampler.claims(truth).own_law);
        let own = survival.map(|survival| Arc::new(law.with_survival(terms.tolerance + 1e-9, survival)));
        Self { truth: Arc::new(law), own }
    }

    /// The law that the draws should follow.
    pub(super) fn followed(&self) -> &Arc<Law> {
        self.own.as_ref().unwrap_or(&self.truth)
    }
}

/// The share of draws that collide, if rows are those alone: a file or a program may leave escapes out.
pub(super) fn collided_alone(ray: Ray, source: &Source<FreePathKind>, terms: &Terms) -> Option<f64> {
    let withdrawn = source.is_external() && !terms.stands(Withdrawal::Escapes);
    withdrawn.then(|| -libm::expm1(-ray.truth.tau(ray.truth.length())))
}

/// P(t > x) = exp(-tau(x)) or, of rows that are collisions alone, (exp(-tau(x)) - T) / (1 - T).
pub(super) fn survival(truth: &dyn Medium, collided: Option<f64>) -> impl Fn(f64) -> f64 + Send + Sync + '_ {
    move |x| match collided {
        Some(collided) => (libm::expm1(-truth.tau(x)) + collided) / collided,
        None => libm::exp(-truth.tau(x)),
    }
}
