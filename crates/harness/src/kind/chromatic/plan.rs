use super::Chromatic;
use crate::experiment::{Plan, Terms};
use crate::kind::column_order::OrderedColumn;
use crate::kind::{Source, batches};
use freepath_draws::column::{T, channel};
use crate::kind::escaping;
use crate::kind::events::{BINS, EventMean, Events, weights};
use freepath_draws::quadrature::{Integral, Panels, decays};
use freepath_estimators::claims::{Channel, ChromaticClaims};
use freepath_estimators::medium::ChromaticMedium;
use freepath_estimators::ChromaticSampler;
use freepath_results::Reason;
use freepath_statistics::claim::{
    BerkJonesClaim, BreaksClaim, Claims, EnoughRows, Escaping, Evenness, InsideRay, LawClaim, ObservedOrder, Order, Path, PdfIntegral, TiesClaim, Written,
    Withdrawal,
};
use freepath_statistics::fold::{Breaks, Cells, Ends, Event, Lags, Lookups, Strays, Ties, Values};
use freepath_statistics::hypothesis::{PdfMass, pair_probability};
use freepath_statistics::{Grain, Law};
use freepath_statistics::tally::{Flanks, Scores};
use std::sync::Arc;

/// The most that quadrature may leave of the moments, relative to each, for a variance by formula to be one.
const MOST_LEFT: f64 = 1e-9;

pub(super) fn plan<'a>(medium: &'a ChromaticMedium, source: &Source<'a, Chromatic>, terms: &Terms) -> Plan<'a> {
    let said = source.sampler().map(|sampler| sampler.claims(&medium.channels())).unwrap_or_default();
    let mut claims = Claims::default();
    let lookups = claims.folds.add(Lookups);
    claims.push(InsideRay { lookups });
    let known = terms.stands(Withdrawal::Truth);
    let events = known.then(|| Events::tally(means(medium, &said, terms), &mut claims));
    if let Some(events) = &events {
        events.finite(terms, &mut claims);
    }
    if source.is_external() {
        claims.push(EnoughRows);
    }
    match &said.mixture {
        Some(mixture) => law(medium, mixture, terms, &mut claims),
        None => Events::path(medium.length(), Escaping { share: f64::NAN, remedy: escaping::of_sampler }, &mut claims),
    }
    Events::rows(medium.media().len(), &mut claims);
    if let Some(mass) = source.sampler().filter(|_| known).and_then(|sampler| mass(sampler, medium)) {
        claims.push(PdfIntegral { mass, over: "the ray and its end" });
    }
    if let Some(events) = events {
        events.means(terms, &mut claims);
    }
    if said.mixture.is_none() {
        OrderedColumn::distances(T).claim(source.is_external(), terms, &mut claims);
    }
    for k in 0..medium.media().len() {
        OrderedColumn::weights(channel(k)).claim(source.is_external(), terms, &mut claims);
    }
    Plan { claims, beside: Vec::new() }
}

/// The integral of the pdf over the ray plus the probability of the surface, if the sampler offers its pdf: from panels that
/// follow the decay of every channel, and from panels a quarter as long.
fn mass(sampler: &dyn ChromaticSampler, medium: &ChromaticMedium) -> Option<PdfMass> {
    let channels = medium.channels();
    let inside = |t: f64| sampler.pdf(&channels, t).unwrap_or(f64::NAN);
    let surface = sampler.pdf(&channels, f64::INFINITY)?;
    let rates: Vec<f64> = channels.iter().map(|channel| channel.extinction.mu(0.0)).collect();
    let panels = Panels::new(0.0, medium.length(), &decays(medium.length(), &rates));
    let (Integral { value, error }, finer) = (panels.integrate(&inside), panels.finer(4).integrate(&inside));
    Some(PdfMass { integral: surface + value, error, finer: surface + finer.value })
}

/// The mixture that the distance follows, whatever its weights.
fn law<'a>(medium: &'a ChromaticMedium, mixture: &[f64], terms: &Terms, claims: &mut Claims<'a>) {
    let survival = survival(medium, mixture.to_vec());
    let law = Arc::new(Law::new(medium.length(), terms.tolerance, &survival).grained(Grain::of_bits(terms.bits)));
    let (length, known, reason) = (medium.length(), terms.stands(Withdrawal::Truth), Reason::WrongLaw);
    let index = claims.folds.cell_index();
    let cells = claims.folds.add(Cells { values: Values::Column(T), law: law.clone(), index });
    let strays = claims.folds.add(Strays { column: T, length });
    let escapes = Escaping { share: law.atom(), remedy: escaping::of_sampler };
    claims.push(Path { column: T, length, cells, strays, escapes });
    if known {
        let (breaks, own, order, grows) = (Vec::new(), None, None, false);
        claims.push(LawClaim { law: law.clone(), cells, reason, own, breaks, order, grows });
        if let Some(flanks) = Flanks::new(&law, &survival, &[]).map(Arc::new) {
            let near = claims.folds.add(Breaks { column: T, flanks: flanks.clone(), index });
            claims.push(BreaksClaim { prefix: "", flanks, near, cells, reason });
        }
        let shares = batches::shares(&law, index, reason, terms, claims);
        batches::push(shares, claims);
        let ends = claims.folds.add(Ends { column: T, length });
        let (law, survival, bits) = (law.clone(), Box::new(survival), terms.bits);
        claims.push(BerkJonesClaim { prefix: "", law, survival, cells, ends, bits, reason });
    }
    if !terms.stands(Withdrawal::Independent) {
        return;
    }
    let scores = Arc::new(Scores::new(&law));
    let lags = claims.folds.add(Lags { scores: scores.clone(), index, rows: terms.ordered_rows(false) });
    if !known {
        claims.push(ObservedOrder { scores, lags, cells });
        return;
    }
    if law.collided() > 0.0 {
        let (pair, ties) = (pair_probability(&law, terms.bits), claims.folds.add(Ties { column: T }));
        claims.push(TiesClaim { pair, ties, cells, written: Written::Here });
    }
    claims.push(Order { scores, lags, cells });
    claims.push(Evenness { prefix: "", law, cells });
}

fn survival(medium: &ChromaticMedium, mixture: Vec<f64>) -> impl Fn(f64) -> f64 + Send + Sync + use<> {
    let rates: Vec<f64> = medium.channels().iter().map(|channel| channel.extinction.mu(0.0)).collect();
    move |t| mixture.iter().zip(&rates).map(|(q, mu)| q * libm::exp(-mu * t)).sum()
}

/// The means that any unbiased sampler of these channels must give, and what the claims add: channel by channel
/// scatter, surface, then bins of t.
fn means(medium: &ChromaticMedium, said: &ChromaticClaims, terms: &Terms) -> Vec<EventMean> {
    let (channels, length) = (medium.channels(), medium.length());
    (0..channels.len()).flat_map(|k| of_channel(k, &channels, length, said, terms)).collect()
}

fn of_channel(
    k: usize,
    channels: &[Channel],
    length: f64,
    said: &ChromaticClaims,
    terms: &Terms,
) -> Vec<EventMean> {
    let (mu, albedo) = (channels[k].extinction.mu(0.0), channels[k].albedo);
    let between = |a: f64, b: f64| albedo * (libm::exp(-mu * a) - libm::exp(-mu * b));
    let edge = |bin: usize| length * bin as f64 / BINS as f64;
    let mean = |event: Event, name: String, expected: f64, moments: Option<[f64; 3]>| {
        let likely = said.mixture.as_ref().map(|q| probability(event, channels, q));
        EventMean {
            channel: k,
            event,
            name,
            mean: weights(expected, moments.filter(|_| said.moments_error <= MOST_LEFT), likely, terms.tolerance, terms.declared),
            moments,
            moments_error: said.moments_error,
            keeps_tail: moments.is_none() && (event == Event::Surface || said.scatter_moments.is_none()),
        }
    };
    let own = |moments: &Option<Vec<[f64; 3]>>| moments.as_ref().and_then(|m| m.get(k).copied());
    let (scatter, surface) = (own(&said.scatter_moments), own(&said.surface_moments));
    let (scattered, through) = (between(0.0, length), libm::exp(-mu * length));
    let mut means = vec![
        mean(Event::Scatter, format!("scatter_{k}"), scattered, scatter),
        mean(Event::Surface, format!("surface_{k}"), through, surface),
    ];
    means.extend((0..BINS).map(|bin| {
        let (from, to) = (edge(bin), edge(bin + 1));
        mean(Event::Between(from, to), format!("scatter_{k}_bin_{bin}"), between(from, to), None)
    }));
    means
}

/// The probability of an event, if `mixture` are those of the channels.
fn probability(event: Event, channels: &[Channel], mixture: &[f64]) -> f64 {
    let in_channel = |channel: &Channel| {
        let (mu, length) = (channel.extinction.mu(0.0), channel.extinction.length());
        match event {
            Event::Scatter => -libm::expm1(-mu * length),
            Event::Surface => libm::exp(-mu * length),
            Event::Between(from, to) => -libm::exp(-mu * from) * libm::expm1(-mu * (to - from)),
        }
    };
    channels.iter().zip(mixture).map(|(channel, q)| q * in_channel(channel)).sum()
}
