//! Identities without noise: what must hold exactly, and so fails without a p-value.
//!
//! [`facts`] runs the cheap ones on every subject; [`medium`], [`reversal`], [`stretch`], [`parts`] and [`roulette`] also stand
//! alone, for the tests of a medium or of a roulette.
//!
//! | check | identity |
//! |---|---|
//! | `identity_reproducible` | the same seed gives the same draws, one after the other and at once on 4 threads |
//! | `identity_history` | a draw does not depend on the draws before it: forwards, backwards, fresh and used |
//! | `identity_streams` | two seeds give two blocks of draws |
//! | `identity_medium` | tau is the integral of mu, split anywhere; its inverse, extrema, tiles and breaks fit |
//! | `identity_composition` | T(0, d) = T(0, s) T(s, d) for an estimator without noise |
//! | `identity_roulette` | the mean weight after a roulette is the weight before |
//! | `identity_zero_variance` | no noise where the claims say that there is none |
//! | `identity_counts` | one tentative collision for each real one where every one is real |
//! | `identity_pdf` | the density that a sampler returns is that of its claims |
//! | `identity_table` | the table that a sampler keeps holds the probabilities of the scene |
//! | `identity_envelope` | the envelope of a rejection lies nowhere below the density |
//! | `identity_inverse` | a sampler gives back the uniforms that a draw was made of |
//!
//! Cost: some 2,500 draws, and some 1,000 evaluations of the medium.

use crate::experiment::Probe;
use crate::subject::Subject;
use freepath_statistics::Fact;

pub(crate) mod composition;
pub(crate) mod counts;
pub(crate) mod density;
pub(crate) mod envelope;
mod excess;
pub(crate) mod history;
pub(crate) mod inverse;
pub(crate) mod medium;
mod rays;
pub(crate) mod reproducible;
pub(crate) mod roulette;
mod rows;
pub(crate) mod table;
pub(crate) mod zero_variance;

pub(crate) use composition::composition;
pub(crate) use counts::counts;
pub(crate) use density::density;
pub(crate) use envelope::envelope;
pub(crate) use inverse::{inverse, quantile};
pub use medium::medium;
pub use rays::{parts, reversal, stretch};
pub(crate) use roulette::roulette;
pub(crate) use roulette::roulette_of;
pub(crate) use table::table;
pub(crate) use zero_variance::zero_variance;

/// Every identity that `subject` violates: those of its scene, those that hold for all, those of its kind.
#[must_use]
pub(crate) fn facts(subject: &Subject, seed: u64) -> Vec<Fact> {
    let probe = Probe { terms: subject.terms(), block: &|block, rows| rows::draw(subject, seed, block, rows) };
    let mut facts = subject.experiment.scene_facts();
    facts.extend(reproducible::fact(subject, seed));
    facts.extend(history::fact(subject, seed));
    facts.extend(subject.experiment.facts(&probe));
    facts
}
