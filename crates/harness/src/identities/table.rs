use freepath_estimators::DiscreteSampler;
use freepath_estimators::discrete::Categories;
use freepath_results::Reason;
use freepath_statistics::Fact;
use freepath_statistics::check::Check;

/// The record of the check.
pub(crate) const CHECK: Check = Check {
    name: "identity_table",
    words: "A fact: the table that a sampler of categories keeps, read back without noise, must hold the probabilities of the scene.",
    details: "\
```text
alias:       mass of i = (keep_i + sum over j with alias_j = i of (1 - keep_j)) / n
cumulative:  mass of i = c_i - c_(i-1)
```
To 4 ulp of 1, all categories; one of weight 0 must have none at all. A sampler that keeps no table has nothing to be read.
Gives wrong_law; out_of_support of a category of weight 0.",
    section: "identity_table",
};

/// The most by which a mass may be off: 4 ulp of 1, the steps of the uniforms that look for it.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The masses that the sampler's table gives against the probabilities.
pub(crate) fn table(sampler: &dyn DiscreteSampler, categories: &Categories) -> Option<Fact> {
    let (masses, due) = (sampler.masses(categories)?, categories.probabilities());
    if masses.len() != due.len() {
        let words = format!("the table has {} categories, the scene {}", masses.len(), due.len());
        return Some(Fact::new(CHECK.name, Reason::WrongLaw, words));
    }
    let off = |(index, (&mass, &due)): (usize, (&f64, &f64))| {
        let words = || format!("the table gives category {index} the probability {mass:e}, its weight {due:e}");
        if due <= 0.0 && !(mass == 0.0) {
            Some(Fact::new(CHECK.name, Reason::OutOfSupport, words()))
        } else {
            (!((mass - due).abs() <= ROUNDING)).then(|| Fact::new(CHECK.name, Reason::WrongLaw, words()))
        }
    };
    masses.iter().zip(due).enumerate().find_map(off)
}
