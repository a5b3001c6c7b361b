use crate::experiment::{Plan, Terms};
use crate::kind::column_order::OrderedColumn;
use crate::kind::Ray;
use crate::kind::escaping;
use crate::kind::events::{BINS, EventMean, Events, weights};
use freepath_draws::column::{T, channel};
use freepath_statistics::claim::{Claims, EnoughRows, Escaping, InsideRay, Withdrawal};
use freepath_statistics::fold::{Event, Lookups};
use freepath_statistics::Law;

/// Weighted free paths, as a file may hold them: a single channel without absorption.
pub(super) fn plan<'a>(ray: Ray<'a>, terms: &Terms) -> Plan<'a> {
    let mut claims = Claims::default();
    let lookups = claims.folds.add(Lookups);
    claims.push(InsideRay { lookups });
    claims.push(EnoughRows);
    let known = terms.stands(Withdrawal::Truth);
    let events = known.then(|| Events::tally(means(ray, terms), &mut claims));
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

fn means(ray: Ray, terms: &Terms) -> Vec<EventMean> {
    let (truth, length) = (ray.truth, ray.truth.length());
    let survival = |t: f64| libm::exp(-truth.tau(t));
    let slack = terms.tolerance * (1.0 + Law::new(length, 0.0, survival).steepness()) + truth.tau_error();
    let mean = |event, name, expected| EventMean {
        channel: 0,
        event,
        name,
        mean: weights(expected, None, None, slack, terms.declared),
        moments: None,
        moments_error: 0.0,
        keeps_tail: true,
    };
    let bin = |bin: usize| {
        let [from, to] = [bin, bin + 1].map(|bin| length * bin as f64 / BINS as f64);
        mean(Event::Between(from, to), format!("scatter_0_bin_{bin}"), survival(from) - survival(to))
    };
    let mut means = vec![
        mean(Event::Scatter, "scatter_0".into(), -libm::expm1(-truth.tau(length))),
        mean(Event::Surface, "surface_0".into(), survival(length)),
    ];
    means.extend((0..BINS).map(bin));
    means
}
