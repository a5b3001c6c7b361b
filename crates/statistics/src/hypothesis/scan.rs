use super::record::Test;
use crate::evidence::{Alone, Evidence, Null, NullClass};
use crate::law::Law;
use crate::tally::CellTally;
use freepath_results::Reason;

mod place;
mod windows;

use windows::{Window, Windows};

/// The test's record.
pub(super) const TEST: Test = Test {
    name: "scan",
    words: "Every window of 1, 2, 4, .. 64 neighbouring fine cells, wherever it begins, against the binomial law of its count: gaps \
and spikes that are too narrow for any other test. The note names the place.",
    details: "\
```text
p_w = 2 min(P(Bin(n, P + e) >= O), P(Bin(n, P - e) <= O)),   p = min(1, windows min p_w)
```
O draws in a window of probability P, of which e is not known: twice the slack of F, the step of the uniforms, and the mass within
half a step of the values at both ends.
Gate:    none: exact tails. Windows overlap, so that Bonferroni makes p 2 to 4 times too large.
Rejects: as wrong_law; as biased against the truth of a method that is biased by design.
Sees:    a gap or a hot spot of 1e-4 of the ray that holds some 25 draws or lacks them. Blind to broad errors.
Source:  scan statistics: Naus (1965); tails by Loader (2000).",
    nulls: &[NullClass::Conservative],
    alone: Alone::Exact,
    section: "scan",
};

/// Bonferroni over the exact binomial p-values of all windows of the fine cells.
///
/// The statistic is the largest n KL(O / n || P +- e); its window is the place that is told.
#[must_use]
pub fn scan(law: &Law, tally: &CellTally, reason: Reason) -> Evidence {
    let windows = Windows::of(law, tally);
    if windows.draws() == 0 {
        return Evidence::withheld(TEST.name, f64::NAN, reason, "nothing was drawn").alone();
    }
    let outcome =
        |statistic, p| Evidence::new(TEST.name, statistic, None, p, reason).under(Null::Conservative).alone();
    let off = windows.off();
    if off.iter().any(|window| window.off.ratio().is_nan()) {
        return outcome(f64::NAN, f64::NAN);
    }
    let Some(best) = off.iter().reduce(|a, b| if b.off.ratio() <= a.off.ratio() { a } else { b }) else {
        return outcome(0.0, 1.0);
    };
    let p = windows.count() as f64 * smallest(best, &off);
    let (place, n) = (place::around(best, &off, windows.count()), windows.draws() as f64);
    let [from, to] = [place.from, place.to].map(|k| law.edge(k));
    let (seen, due) = (windows.seen(place.from, place.to), n * law.mass_between(place.from, place.to));
    outcome(best.off.ratio(), if p > 1.0 { 1.0 } else { p })
        .noted(format!("from {from:.6} to {to:.6} there are {seen} draws, {due:.1} should be"))
}

/// The p-value of a window may be the smallest though its likelihood ratio is by so much below the largest.
const NEAR: f64 = 12.0;

/// The smallest p-value.
fn smallest(best: &Window, off: &[Window]) -> f64 {
    let near = off.iter().filter(|window| window.off.ratio() >= best.off.ratio() - NEAR);
    near.map(|window| window.off.p()).fold(f64::INFINITY, |a, b| if b < a { b } else { a })
}

#[cfg(test)]
mod tests;
