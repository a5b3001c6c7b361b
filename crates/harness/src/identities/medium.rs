use super::excess::{Excess, Excesses};
use freepath_estimators::Medium;
use freepath_results::Reason;
use freepath_statistics::Fact;
use freepath_statistics::check::Check;

/// The record of the check.
pub(crate) const CHECK: Check = Check {
    name: "identity_medium",
    words: "A fact: the medium contradicts itself. tau must be the integral of mu over every part of the ray, its inverse its inverse, \
mu within the extrema, a tile of look-ups the look-ups, breaks in order: else no verdict in it means anything.",
    details: "\
```text
tau(b) - tau(a) = int_a^b mu,   tau(tau^-1(x)) = x,   least <= mu <= greatest
```
To 1e-9 on each of 24 parts. Gives subject_error: nothing that is judged in such a medium means anything.",
    section: "identity_medium",
};

/// Parts into which the ray is split.
const PARTS: usize = 24;

/// Breaks that one part may hold: of a finer medium, parts are looked at that hold so many.
const MOST_BREAKS: usize = 64;

/// Relative error of tau, of mu and of their inverses.
pub(super) const ROUNDING: f64 = 1e-9;

/// The first identity that `medium` violates.
///
/// Any medium may be asked: one's own, a view of another, a ray through a grid.
#[must_use]
pub fn medium(medium: &dyn Medium) -> Option<Fact> {
    let identities: [fn(&dyn Medium) -> Option<String>; 5] = [order, depth, inverse, extrema, tile];
    let why = identities.iter().find_map(|identity| identity(medium))?;
    Some(Fact::new(CHECK.name, Reason::SubjectError, format!("the medium contradicts itself: {why}")))
}

/// Length and breaks.
fn order(medium: &dyn Medium) -> Option<String> {
    let length = medium.length();
    if !(length > 0.0 && length < f64::INFINITY) {
        return Some(format!("its length is {length}"));
    }
    let ends = [0.0]
        .into_iter()
        .chain(medium.breaks().iter().copied())
        .zip(medium.breaks().iter().copied().chain([length]));
    let (_, wrong) = ends.into_iter().find(|(before, after)| !(before < after))?;
    Some(format!("its breaks do not increase inside the ray up to {wrong}"))
}

/// The places where the ray is split: not at equal steps, which periods may hide, nor at breaks.
fn splits(medium: &dyn Medium) -> Vec<f64> {
    let place = |i: usize| (i as f64 + 0.37 * (i % 3) as f64) / PARTS as f64;
    let inner = (1..PARTS).map(|i| medium.length() * place(i)).filter(|&t| t < medium.length());
    [0.0].into_iter().chain(inner).chain([medium.length()]).collect()
}

/// A part of the ray, shortened so that it holds few breaks.
fn shortened(breaks: &[f64], (from, to): (f64, f64)) -> (f64, f64) {
    let first = breaks.partition_point(|&at| at <= from);
    let last = breaks.partition_point(|&at| at < to);
    (from, if last - first <= MOST_BREAKS { to } else { breaks[first + MOST_BREAKS] })
}

/// tau(b) - tau(a) = int_a^b mu, tau(0) = 0.
fn depth(medium: &dyn Medium) -> Option<String> {
    let (splits, total) = (splits(medium), medium.tau(medium.length()));
    if !(medium.tau(0.0).abs() <= ROUNDING * total && total >= 0.0 && total < f64::INFINITY) {
        return Some(format!("tau is {} at 0 and {total} at the end", medium.tau(0.0)));
    }
    let (features, slack) = (medium.features(), ROUNDING * total + 2.0 * medium.tau_error());
    splits.windows(2).find_map(|w| {
        let (from, to) = shortened(medium.breaks(), (w[0], w[1]));
        let Excess { seen, due } = Excesses { medium, features: &features, slack }.settled(from, to)?;
        Some(format!("tau grows by {seen:e} from {from} to {to}, where mu has the integral {due:e}"))
    })
}

/// tau(tau^-1(x)) = x, and infinity beyond the end.
fn inverse(medium: &dyn Medium) -> Option<String> {
    let total = medium.tau(medium.length());
    let parts = if total > 0.0 { PARTS } else { 0 }; // an empty medium reaches no depth
    let slack = ROUNDING * total + 2.0 * medium.tau_error();
    let wrong = (0..parts).map(|i| total * (i as f64 + 0.5) / PARTS as f64).find_map(|depth| {
        let t = medium.inverse_tau(depth);
        let back = if t >= 0.0 && t <= medium.length() { medium.tau(t) } else { f64::NAN };
        (!((back - depth).abs() <= slack)).then(|| format!("tau reaches {depth:e} at {t}, where it is {back:e}"))
    });
    let beyond = medium.inverse_tau(1.1 * total + 1.0);
    let ends = beyond == f64::INFINITY;
    wrong.or_else(|| (!ends).then(|| format!("a depth beyond the whole is reached at {beyond}")))
}

/// mu is finite, not negative, and within its extrema on each part.
fn extrema(medium: &dyn Medium) -> Option<String> {
    splits(medium).windows(2).find_map(|w| {
        let (least, greatest) = medium.extrema(w[0], w[1]);
        let rounding = ROUNDING * greatest.abs();
        let within =
            |mu: f64| mu >= 0.0 && mu < f64::INFINITY && mu >= least - rounding && mu <= greatest + rounding;
        let places = (0..=8).map(|i| w[0] + (w[1] - w[0]) * (f64::from(i) + 0.01) / 8.2);
        let t = places.into_iter().find(|&t| !within(medium.mu(t)))?;
        Some(format!("mu is {} at {t}, where its extrema are {least} and {greatest}", medium.mu(t)))
    })
}

/// Many look-ups at once are those one by one.
fn tile(medium: &dyn Medium) -> Option<String> {
    let places: Vec<f64> = (0..251).map(|i| medium.length() * (f64::from(i) + 0.21) / 251.3).collect();
    let mut mu = vec![f64::NAN; places.len()];
    medium.mu_tile(&places, &mut mu);
    let (_, greatest) = medium.extrema(0.0, medium.length());
    let (t, together) =
        places.iter().zip(&mu).find(|&(&t, &mu)| !((mu - medium.mu(t)).abs() <= ROUNDING * greatest))?;
    Some(format!("mu is {} at {t}, and {together} in a tile", medium.mu(*t)))
}
