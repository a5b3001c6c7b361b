use freepath_draws::{Key, Streams};
use freepath_estimators::medium::segment;
use freepath_estimators::{Medium, TransmittanceEstimator};
use freepath_results::Reason;
use freepath_statistics::Fact;
use freepath_statistics::check::Check;

/// The record of the check.
pub(crate) const CHECK: Check = Check {
    name: "identity_composition",
    words: "A fact: the transmittance of a ray is that of its two parts multiplied, T(0, d) = T(0, s) T(s, d), for an estimator without \
noise, up to the bias that it declares.",
    details: "\
```text
T(0, d) = T(0, s) T(s, d),   s = 0.18 d, 0.41 d, 0.77 d
```
To 1e-9 and the error of tau, for an estimator that takes no random number. Gives biased: a segment that is cut short, an
offset of the ray.",
    section: "identity_composition",
};

/// The places where the ray is cut, as a share of its length.
const CUTS: [f64; 3] = [0.18, 0.41, 0.77];

/// Relative error of an estimate without noise.
const ROUNDING: f64 = 1e-9;

/// An estimator that takes no random number, on the ray and on its parts.
pub(crate) fn composition(
    estimator: &dyn TransmittanceEstimator,
    truth: &dyn Medium,
    tolerance: f64,
) -> Option<Fact> {
    let whole = without_noise(estimator, truth)?;
    CUTS.iter().find_map(|share| cut(estimator, truth, share * truth.length(), whole, tolerance))
}

fn cut(
    estimator: &dyn TransmittanceEstimator,
    truth: &dyn Medium,
    at: f64,
    whole: f64,
    tolerance: f64,
) -> Option<Fact> {
    let (before, after) = (segment(truth, 0.0, at).ok()?, segment(truth, at, truth.length()).ok()?);
    estimator.accepts(&before).and(estimator.accepts(&after)).ok()?;
    let parts = without_noise(estimator, &before)? * without_noise(estimator, &after)?;
    let declared = bias(estimator, truth) - bias(estimator, &before) - bias(estimator, &after);
    let slack = ROUNDING + truth.tau_error() + 3.0 * tolerance / whole;
    let excess = libm::log(whole / parts) - declared;
    let holds = excess.abs() <= slack || (whole == 0.0 && parts == 0.0);
    let words = format!("T(0, d) = {whole:e} where T(0, s) T(s, d) = {parts:e} at s = {at}");
    (!holds).then(|| Fact::new(CHECK.name, Reason::Biased, words))
}

/// The estimate, if it takes no random number.
fn without_noise(estimator: &dyn TransmittanceEstimator, medium: &dyn Medium) -> Option<f64> {
    let streams = Streams::new(Key::default());
    let mut rng = streams.rng();
    let estimate = estimator.estimate(&medium, &mut rng);
    (rng.drawn() == 0).then_some(estimate)
}

/// ln of the mean that the estimator declares over T.
fn bias(estimator: &dyn TransmittanceEstimator, medium: &dyn Medium) -> f64 {
    let depth = medium.tau(medium.length());
    estimator.claims(medium).own_mean.map_or(0.0, |mean| libm::log(mean) + depth)
}
