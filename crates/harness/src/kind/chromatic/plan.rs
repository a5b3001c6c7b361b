use super::Chromatic;
use crate::experiment::{Plan, Terms};
use crate::kind::column_order::OrderedColumn;
use crate::kind::escaping;
use crate::kind::events::{EventMean, Events, weights};
use crate::kind::weighing::{Weighing, bins};
use crate::kind::{Source, batches};
use freepath_draws::column::{T, channel};
use freepath_draws::quadrature::{Integral, Panels, decays};
use freepath_estimators::ChromaticSampler;
use freepath_estimators::claims::{Channel, ChromaticClaims};
use freepath_estimators::medium::ChromaticMedium;
use freepath_results::Reason;
use freepath_statistics::claim::{
    BerkJonesClaim, BreaksClaim, Claims, EnoughRows, Escaping, Evenness, InsideRay, LawClaim, ObservedOrder,
    Order, Path, PdfIntegral, TiesClaim, Withdrawal, Written,
};
use freepath_statistics::fold::{Breaks, Cells, Ends, Event, Lags, Lookups, Strays, Ties, Values};
use freepath_statistics::hypothesis::{PdfMass, pair_probability};
use freepath_statistics::tally::{Bins, Flanks, Scores};
use freepath_statistics::{Grain, Law};
use std::sync::Arc;

mod identity;

/// The most that quadrature may leave of the moments, relative to each, for a variance by formula to be one.
const MOST_LEFT: f64 = 1e-9;

pub(super) fn plan<'a>(medium: &'a ChromaticMedium, source: &Source<'a, Chromatic>, terms: &Terms) -> Plan<'a> {
    let said = source.sampler().map(|sampler| sampler.claims(&medium.channels())).unwrap_or_default();
    let mut claims = Claims::default();
    let lookups = claims.folds.add(Lookups);
    claims.push(InsideRay { lookups });
    let known = terms.stands(Withdrawal::Truth);
    let events = known.then(|| events(medium, &said, terms, &mut claims));
    if let Some(events) = &events {
        events.finite(terms, &mut claims);
    }
    if source.is_external() {
        claims.push(EnoughRows);
    }
    match &said.mixture {
        Some(mixture) => law(medium, mixture, terms, &mut claims),
        None => {
            Events::path(medium.length(), Escaping { share: f64::NAN, remedy: escaping::of_sampler }, &mut claims)
        }
    }
    Events::rows(medium.media().len(), &mut claims);
    if let Some(mass) = source.sampler().filter(|_| known).and_then(|sampler| mass(sampler, medium)) {
        claims.push(PdfIntegral { mass, over: "the ray and its end" });
    }
    if let Some(mixture) = said.mixture.as_deref().filter(|_| known && said.balanced) {
        identity::claim(medium, mixture, terms, &mut claims);
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
        claims.push(LawClaim { law: law.clone(), cells, reason, own, breaks, order, grows, distances: true });
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

/// The means that any unbiased sampler of these channels must give, and what the claims add, channel by channel: scatter, surface and, where
/// rows may depend, parts of t; else the law of t under the weights.
fn events(medium: &ChromaticMedium, said: &ChromaticClaims, terms: &Terms, claims: &mut Claims) -> Events {
    let (channels, length) = (medium.channels(), medium.length());
    let survivals: Vec<_> = channels.iter().map(|channel| alone(channel.extinction.mu(0.0))).collect();
    let weighings = channels.iter().zip(&survivals);
    let weighings: Vec<Weighing> =
        weighings.map(|(channel, survival)| Weighing { survival, albedo: channel.albedo, length }).collect();
    let bins = if terms.stands(Withdrawal::Independent) { bins(&weighings) } else { None };
    let of_channel = |(k, weighing)| Means { k, channels: &channels, weighing, said, terms }.all(bins.as_ref());
    let means = weighings.iter().enumerate().flat_map(of_channel).collect();
    Events::tally(means, channels.len(), bins, claims)
}

/// P(t > x) in a channel of this extinction.
fn alone(mu: f64) -> impl Fn(f64) -> f64 {
    move |t| libm::exp(-mu * t)
}

/// The means of one channel.
struct Means<'a> {
    k: usize,
    channels: &'a [Channel<'a>],
    weighing: &'a Weighing<'a>,
    said: &'a ChromaticClaims,
    terms: &'a Terms<'a>,
}

impl Means<'_> {
    fn all(&self, bins: Option<&Bins>) -> Vec<EventMean> {
        let (k, length, said, terms) = (self.k, self.weighing.length, self.said, self.terms);
        let own = |moments: &Option<Vec<[f64; 3]>>| moments.as_ref().and_then(|m| m.get(k).copied());
        let scattered = self.weighing.between(0.0, length);
        let scatter = self.mean(Event::Scatter, format!("scatter_{k}"), scattered, own(&said.scatter_moments));
        let law = bins.and_then(|bins| self.weighing.law(bins, terms.tolerance));
        let through = (self.weighing.survival)(length);
        let surface = self.mean(Event::Surface, format!("surface_{k}"), through, own(&said.surface_moments));
        let parts = if terms.stands(Withdrawal::Independent) { Vec::new() } else { self.weighing.parts() };
        let part = |(part, edges): (usize, &[f64])| {
            let (event, name) = (Event::Between(edges[0], edges[1]), format!("scatter_{k}_bin_{part}"));
            self.mean(event, name, self.weighing.between(edges[0], edges[1]), None)
        };
        let mut means = vec![EventMean { law, ..scatter }, surface];
        means.extend(parts.windows(2).enumerate().map(part));
        means
    }

    fn mean(&self, event: Event, name: String, expected: f64, moments: Option<[f64; 3]>) -> EventMean {
        let Self { k, channels, weighing, said, terms } = *self;
        let likely = said.mixture.as_ref().map(|q| probability(event, channels, q));
        let known = moments.filter(|_| said.moments_error <= MOST_LEFT);
        EventMean {
            channel: k,
            event,
            name,
            mean: weights(expected, known, likely, terms.tolerance, terms.declared),
            moments,
            moments_error: said.moments_error,
            keeps_tail: moments.is_none() && (event == Event::Surface || said.scatter_moments.is_none()),
            whole: weighing.between(0.0, weighing.length) + (weighing.survival)(weighing.length),
            law: None,
        }
    }
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
