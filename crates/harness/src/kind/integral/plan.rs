use super::truth::{Known, moments};
use super::{Integral, Integration};
use crate::experiment::{Plan, Terms};
use crate::kind::Source;
use crate::kind::column_order::OrderedColumn;
use crate::kind::stated::{StatedMean, spread};
use freepath_draws::column::WEIGHT;
use freepath_draws::quadrature::Panels;
use freepath_estimators::Integrator;
use freepath_statistics::claim::{Claims, Moments, PdfIntegral, SecondMomentClaim, Withdrawal};
use freepath_statistics::hypothesis::{MeanClaim, PdfMass, SecondMoment};

/// Estimates are finite and have the integral as their mean, and the second moment that follows from the density of their draws, which
/// is a density.
pub(super) fn plan<'a>(scene: &'a Integration, source: &Source<'a, Integral>, terms: &Terms) -> Plan<'a> {
    let (mut claims, mean) = (Claims::default(), mean(scene, source, terms));
    let weights = mean.weights(&mut claims);
    mean.support(weights, source.is_external(), terms, &mut claims);
    mean.means(weights, None, terms, &mut claims);
    if let Some(integrator) = source.sampler() {
        second_moment(scene, integrator, Moments::Column(weights), terms, &mut claims);
        if let Some(mass) = mass(scene, integrator) {
            claims.push(PdfIntegral { mass, over: "the domain" });
        }
    }
    OrderedColumn::only(WEIGHT).claim(source.is_external(), terms, &mut claims);
    Plan { claims, beside: Vec::new() }
}

/// The integral, and what is known of its estimates.
pub(super) fn mean(scene: &Integration, source: &Source<Integral>, terms: &Terms) -> StatedMean {
    let (variance, skewness) = match source {
        Source::Control => (Some(0.0), None),
        Source::Sampler(integrator) => of_density(scene, *integrator),
        Source::External(_) => (None, None),
    };
    let known = MeanClaim {
        expected: scene.truth.value,
        slack: terms.tolerance + scene.truth.error,
        binary: false,
        range: None,
        variance,
        skewness,
    };
    StatedMean::new(known, None, terms)
}

/// Variance and skewness of an estimate, where they exist and the density of its draws is told.
fn of_density(scene: &Integration, integrator: &dyn Integrator) -> (Option<f64>, Option<f64>) {
    let value = |known: Option<Known>| known.map_or(f64::INFINITY, |known| known.value);
    let Some(moments) = moments(integrator, &scene.seen) else { return (None, None) };
    let draws = f64::from(integrator.draws());
    match spread(&moments.map(value)) {
        (Some(variance), skewness) => (Some(variance / draws), skewness.map(|skewness| skewness / draws.sqrt())),
        (None, _) => (None, Some(f64::INFINITY)), // without a second moment there is no third
    }
}

/// The second moment of an estimate of one draw.
fn second_moment(
    scene: &Integration,
    integrator: &dyn Integrator,
    sums: Moments,
    terms: &Terms,
    claims: &mut Claims,
) {
    let stands = terms.stands(Withdrawal::SecondMoment) && integrator.draws() == 1;
    let [_, Some(m2), _, Some(m4), _, m6] =
        moments(integrator, &scene.seen).filter(|_| stands).unwrap_or_default()
    else {
        return;
    };
    let error = m2.error / m2.value;
    let moments = [m2.value, m4.value, m6.map_or(f64::INFINITY, |m6| m6.value)];
    let moment = SecondMoment { moments, error, slack: terms.tolerance };
    claims.push(SecondMomentClaim { name: "second_moment".into(), sums, moment });
}

/// The integral of the density that the estimator tells, if it tells one.
fn mass(scene: &Integration, integrator: &dyn Integrator) -> Option<PdfMass> {
    let [a, b] = scene.seen.domain();
    integrator.pdf(&scene.seen, 0.5 * (a + b))?;
    let pdf = |x: f64| integrator.pdf(&scene.seen, x).unwrap_or(f64::NAN);
    let panels = Panels::new(a, b, scene.seen.breaks());
    let (first, finer) = (panels.integrate(&pdf), panels.finer(4).integrate(&pdf));
    Some(PdfMass { integral: first.value, error: first.error, finer: finer.value })
}
