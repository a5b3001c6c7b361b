use crate::experiment::{Plan, Terms};
use crate::kind::Ray;
use crate::kind::column_order::OrderedColumn;
use crate::kind::escaping;
use crate::kind::events::{EventMean, Events, weights};
use crate::kind::weighing::{Weighing, bins};
use freepath_draws::column::{T, channel};
use freepath_statistics::Law;
use freepath_statistics::claim::{Claims, EnoughRows, Escaping, InsideRay, Withdrawal};
use freepath_statistics::fold::{Event, Lookups};
use freepath_statistics::tally::Bins;

/// Weighted free paths, as a file may hold them: a single channel without absorption.
pub(super) fn plan<'a>(ray: Ray<'a>, terms: &Terms) -> Plan<'a> {
    let mut claims = Claims::default();
    let lookups = claims.folds.add(Lookups);
    claims.push(InsideRay { lookups });
    claims.push(EnoughRows);
    let known = terms.stands(Withdrawal::Truth);
    let survival = |t: f64| libm::exp(-ray.truth.tau(t));
    let weighing = Weighing { survival: &survival, albedo: 1.0, length: ray.truth.length() };
    let bins = if terms.stands(Withdrawal::Independent) { bins(std::slice::from_ref(&weighing)) } else { None };
    let means = known.then(|| means(ray, &weighing, bins.as_ref(), terms));
    let events = means.map(|means| Events::tally(means, 1, bins, &mut claims));
    if let Some(events) = &events {
        events.finite(terms, &mut claims);
    }
    let escapes = Escaping { share: ray.transmittance(), remedy: escaping::of_file };
    Events::path(ray.truth.length(), escapes, &mut claims);
    if let Some(events) = events {
        events.means(terms, &mut claims);
    }
    OrderedColumn::distances(T).claim(true, terms, &mut claims);
    OrderedColumn::weights(channel(0)).claim(true, terms, &mut claims);
    Plan { claims, beside: Vec::new() }
}

fn means(ray: Ray, weighing: &Weighing, bins: Option<&Bins>, terms: &Terms) -> Vec<EventMean> {
    let (truth, length) = (ray.truth, ray.truth.length());
    let steepness = Law::new(length, 0.0, weighing.survival).steepness();
    let slack = terms.tolerance * (1.0 + steepness) + truth.tau_error();
    let mean = |event, name, expected| EventMean {
        channel: 0,
        event,
        name,
        mean: weights(expected, None, None, slack, terms.declared),
        moments: None,
        moments_error: 0.0,
        keeps_tail: true,
        whole: 1.0,
        law: bins.filter(|_| event == Event::Scatter).and_then(|bins| weighing.law(bins, slack)),
    };
    let part = |(part, edges): (usize, &[f64])| {
        let (from, to) = (edges[0], edges[1]);
        mean(Event::Between(from, to), format!("scatter_0_bin_{part}"), weighing.between(from, to))
    };
    let parts = if terms.stands(Withdrawal::Independent) { Vec::new() } else { weighing.parts() };
    let mut means = vec![
        mean(Event::Scatter, "scatter_0".into(), -libm::expm1(-truth.tau(length))),
        mean(Event::Surface, "surface_0".into(), (weighing.survival)(length)),
    ];
    means.extend(parts.windows(2).enumerate().map(part));
    means
}
