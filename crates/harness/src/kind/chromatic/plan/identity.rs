use crate::experiment::Terms;
use freepath_draws::column::{T, channel};
use freepath_estimators::claims::Channel;
use freepath_estimators::medium::ChromaticMedium;
use freepath_statistics::claim::{Claims, WeightIdentityClaim};
use freepath_statistics::fold::WeightIdentity;
use std::sync::Arc;

/// One channel, as far as a weight needs it.
struct Share {
    sigma: f64,
    albedo: f64,
    probability: f64,
}

/// Rounding of a weight, relative to it, of double precision and of single.
const ROUNDING: [f64; 2] = [1e-9, 1e-6];
/// Weights so faint that they may as well be 0: an exponential loses its digits below 1e-304, and stands beside an extinction over a density.
const FAINT: f64 = 1e-280;
/// Most bits of single precision.
const SINGLE: u32 = 24;

/// Weights are those of the balance heuristic: f_k(t) / sum of q_c p_c(t).
pub(super) fn claim(medium: &ChromaticMedium, mixture: &[f64], terms: &Terms, claims: &mut Claims) {
    let channels = medium.channels();
    let share = |(channel, &probability): (&Channel, &f64)| Share {
        sigma: channel.extinction.mu(0.0),
        albedo: channel.albedo,
        probability,
    };
    let shares: Vec<Share> = channels.iter().zip(mixture).map(share).collect();
    let length = medium.length();
    let rows = claims.folds.add(WeightIdentity {
        columns: (0..shares.len()).map(channel).collect(),
        distance: T,
        weights: Arc::new(move |t, weights| weigh(&shares, t, length, weights)),
        relative: ROUNDING[usize::from(terms.bits <= SINGLE)],
        absolute: terms.tolerance + FAINT,
    });
    claims.push(WeightIdentityClaim { rows });
}

fn weigh(shares: &[Share], t: f64, length: f64, weights: &mut [f64]) {
    let mut pdf = 0.0;
    for (share, weight) in shares.iter().zip(&mut *weights) {
        let scatters = t < f64::INFINITY;
        let reached = libm::exp(-share.sigma * if scatters { t } else { length });
        let density = if scatters { share.sigma * reached } else { reached };
        pdf += if share.probability > 0.0 { share.probability * density } else { 0.0 };
        *weight = if scatters { share.albedo * density } else { density };
    }
    weights.iter_mut().for_each(|weight| *weight /= pdf);
}
