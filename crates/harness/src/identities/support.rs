use freepath_estimators::Integrator;
use freepath_estimators::integral::Integrand;
use freepath_results::Reason;
use freepath_statistics::Fact;
use freepath_statistics::check::Check;

/// The record of the check.
pub(crate) const CHECK: Check = Check {
    name: "identity_pdf_support",
    words: "A fact: the density that an estimator of an integral tells must be above 0 wherever the integrand is not 0.",
    details: "\
```text
p(x) > 0   where f(x) != 0, at 65,536 places inside the domain
```
What is never drawn is left out of the mean: x/2 on [0, 1.5] alone loses int_1.5^2 f. Gives biased; an estimator that tells no density is
not asked.",
    section: "identity_pdf_support",
};

/// Places inside the domain.
const PLACES: u32 = 1 << 16;

/// The first place that is never drawn and counts.
pub(crate) fn support(integrator: &dyn Integrator, integrand: &Integrand) -> Option<Fact> {
    let [a, b] = integrand.domain();
    let mut places = (0..PLACES).map(|i| a + (b - a) * (f64::from(i) + 0.5) / f64::from(PLACES));
    places.find_map(|x| {
        let (f, pdf) = (integrand.f(x), integrator.pdf(integrand, x)?);
        let holds = f.abs() <= 0.0 || (pdf > 0.0 && pdf < f64::INFINITY);
        let words = || format!("the density at x = {x} is {pdf:e}, where the integrand is {f:e}");
        (!holds).then(|| Fact::new(CHECK.name, Reason::Biased, words()))
    })
}
