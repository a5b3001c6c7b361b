use freepath_estimators::DensitySampler;
use freepath_estimators::density::Target;
use freepath_results::Reason;
use freepath_statistics::Fact;
use freepath_statistics::check::Check;

/// The record of the check.
pub(crate) const CHECK: Check = Check {
    name: "identity_envelope",
    words: "A fact: the envelope of a sampler by rejection must lie nowhere below the density.",
    details: "\
```text
p(x) <= C g(x)   at 65,537 places across the domain, to 1e-12
```
Where it lies below, the law that is drawn is min(p, C g) over its mass, which draws may take long to tell from p.
Gives bound_violated; a sampler that tells no envelope is not asked.",
    section: "identity_envelope",
};

/// Places across the domain: sixteen times as many as a sampler of the list is refused by.
const PLACES: u32 = 1 << 16;
/// Relative rounding of an envelope.
const ROUNDING: f64 = 1e-12;

/// The first place where the density lies above the envelope.
pub(crate) fn envelope(sampler: &dyn DensitySampler, target: &Target) -> Option<Fact> {
    let [a, b] = target.domain();
    let atom = |x: f64| target.atoms().iter().any(|atom| x.total_cmp(&atom.at).is_eq());
    let mut places = (0..=PLACES).map(|i| a + (b - a) * f64::from(i) / f64::from(PLACES)).filter(|x| !atom(*x));
    places.find_map(|x| {
        let (envelope, pdf) = (sampler.envelope(target, x)?, target.pdf(x)?);
        let holds = pdf <= envelope * (1.0 + ROUNDING);
        let words = || format!("the density at x = {x} is {pdf:e}, above the envelope of {envelope:e}");
        (!holds).then(|| Fact::new(CHECK.name, Reason::BoundViolated, words()))
    })
}
