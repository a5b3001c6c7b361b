use freepath_estimators::ChromaticSampler;
use freepath_estimators::medium::ChromaticMedium;
use freepath_results::Reason;
use freepath_statistics::Fact;
use freepath_statistics::check::Check;

/// The record of the check.
pub(crate) const CHECK: Check = Check {
    name: "identity_pdf",
    words: "A fact: the density that a sampler returns must be finite, not negative, and that of the law which it should draw from: of a \
chromatic sampler the mixture that it claims, at every distance and at the surface.",
    details: "\
```text
pdf(t) = sum_c q_c mu_c exp(-mu_c t),   pdf(inf) = sum_c q_c exp(-mu_c length)   of channels
```
To 1e-9 at 64 distances, at 1024 draws from a density or of a category, and at 1024 directions drawn and as many others, outside the support, too.
Gives wrong_law.",
    section: "identity_pdf",
};

/// Distances at which the densities are compared.
const POINTS: u32 = 64;

/// Relative error of a density.
const ROUNDING: f64 = 1e-9;

/// The pdf against the claimed mixture.
///
/// ```text
/// pdf(t) = sum_c q_c mu_c exp(-mu_c t),   pdf(inf) = sum_c q_c exp(-mu_c length)
/// ```
pub(crate) fn density(sampler: &dyn ChromaticSampler, medium: &ChromaticMedium, tolerance: f64) -> Option<Fact> {
    let (channels, length) = (medium.channels(), medium.length());
    let mixture = sampler.claims(&channels).mixture;
    let claimed = |t: f64| {
        let density = |mu: f64| if t < f64::INFINITY { mu * libm::exp(-mu * t) } else { libm::exp(-mu * length) };
        let terms = mixture.iter().flatten().zip(&channels);
        mixture.as_ref().map(|_| terms.map(|(q, channel)| q * density(channel.extinction.mu(0.0))).sum::<f64>())
    };
    let places = (0..POINTS).map(|i| length * (f64::from(i) + 0.5) / f64::from(POINTS)).chain([f64::INFINITY]);
    places.into_iter().find_map(|t| {
        let pdf = sampler.pdf(&channels, t)?;
        let due = claimed(t).unwrap_or(pdf);
        let holds = pdf >= 0.0 && pdf < f64::INFINITY && (pdf - due).abs() <= ROUNDING * due + tolerance;
        let words = format!("the pdf at t = {t} is {pdf:e}, that of the claimed mixture {due:e}");
        (!holds).then(|| Fact::new(CHECK.name, Reason::WrongLaw, words))
    })
}

/// The fact against the density, or the probability, that was told of `what`, if it is not the one that is `due`.
pub(crate) fn told(what: &str, pdf: f64, due: f64, tolerance: f64) -> Option<Fact> {
    let holds = pdf >= 0.0 && pdf < f64::INFINITY && (pdf - due).abs() <= ROUNDING * due + tolerance;
    let words = || format!("the pdf at {what} is {pdf:e}, that of the scene {due:e}");
    (!holds).then(|| Fact::new(CHECK.name, Reason::WrongLaw, words()))
}
