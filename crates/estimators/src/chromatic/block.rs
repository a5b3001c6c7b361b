//! A block of chromatic draws, a row of lanes at a time: what the samplers differ in is the divisor of the weights.

use super::mixture;
use crate::claims::Channel;
use freepath_draws::random::{LANES, ScriptedLanes, Uniforms};
use freepath_draws::{ChannelColumns, Draws, Streams, math, simd};

type Row = [f64; LANES];

/// The channel that was drawn: its probability q_i and its density p_i(t).
#[derive(Clone, Copy, Debug)]
pub(super) struct Own {
    pub(super) probability: f64,
    pub(super) density: f64,
}

/// The divisor that makes a weight of a channel's contribution. Every method must be `#[inline(always)]` and free of
/// branches: they run once for each lane.
pub(super) trait Heuristic {
    /// The sum after one more channel's `share` q_j p_j(t).
    fn add(&self, sum: f64, share: f64, own: Own) -> f64;
    /// The divisor, from the sum over all channels.
    fn divisor(&self, sum: f64, own: Own) -> f64;
}

/// One channel, as far as a draw needs it.
struct Term {
    sigma: f64,
    mfp: f64,
    albedo: f64,
    probability: f64,
    /// The sum of the probabilities up to this one.
    up_to: f64,
}

/// As many draws as `out` has rows, the channel drawn with the probabilities `mixture`: the law of the scalar method,
/// other draws.
pub(super) fn draws<H: Heuristic>(
    heuristic: &H,
    channels: &[Channel],
    mixture: &[f64],
    streams: &Streams,
    out: &mut Draws,
) {
    let terms = terms(channels, mixture);
    let length = mixture::length(channels);
    let Ok(mut columns) = ChannelColumns::of(out) else { return };
    match streams.script() {
        None => {
            let mut lanes = streams.key().lanes();
            simd::dispatch(
                #[inline(always)]
                || Block::new(heuristic, &terms, length).fill(&mut lanes, &mut columns),
            );
        }
        Some(script) => {
            let mut lanes = ScriptedLanes::new(streams.key(), script);
            Block::new(heuristic, &terms, length).fill(&mut lanes, &mut columns);
        }
    }
}

fn terms(channels: &[Channel], mixture: &[f64]) -> Vec<Term> {
    let mut up_to = 0.0;
    let term = |(channel, &probability): (&Channel, &f64)| {
        up_to += probability;
        let sigma = mixture::sigma(channel);
        Term { sigma, mfp: 1.0 / sigma, albedo: channel.albedo, probability, up_to }
    };
    channels.iter().zip(mixture).map(term).collect()
}

/// The channel drawn in each lane.
struct Drawn {
    probability: Row,
    density: Row,
}

impl Drawn {
    #[inline(always)]
    fn at(&self, l: usize) -> Own {
        Own { probability: self.probability[l], density: self.density[l] }
    }
}

struct Block<'a, H> {
    heuristic: &'a H,
    terms: &'a [Term],
    length: f64,
    /// The last channel that can be drawn: it takes what the probabilities lack of 1 by rounding.
    last: usize,
    /// The density of each channel at the distances of the row.
    densities: Vec<Row>,
}

impl<'a, H: Heuristic> Block<'a, H> {
    #[inline(always)]
    fn new(heuristic: &'a H, terms: &'a [Term], length: f64) -> Self {
        Self {
            heuristic,
            terms,
            length,
            last: terms.iter().rposition(|term| term.probability > 0.0).unwrap_or(0),
            densities: vec![[0.0; LANES]; terms.len()],
        }
    }

    #[inline(always)]
    fn fill(&mut self, uniforms: &mut impl Uniforms, out: &mut ChannelColumns) {
        let drawable = self.terms.iter().filter(|term| term.probability > 0.0).count();
        let (mut choice, mut u) = ([0.0; LANES], [0.0; LANES]);
        for from in (0..out.t.len()).step_by(LANES) {
            if drawable > 1 {
                uniforms.fill(&mut choice);
            }
            uniforms.fill(&mut u);
            let t = self.distances(&choice, &u);
            self.look_up(&t);
            let divisor = self.divisors(&choice);
            write(out.t, from, &t);
            for (k, column) in out.channels.iter_mut().enumerate() {
                write(column, from, &self.weights(k, &t, &divisor));
            }
        }
    }

    /// For each lane, the value of the channel that `choice` draws.
    #[inline(always)]
    fn of_drawn(&self, choice: &Row, value: impl Fn(usize) -> Row) -> Row {
        let mut drawn = value(self.last);
        for (k, term) in self.terms[..self.last].iter().enumerate().rev() {
            let own = value(k);
            for l in 0..LANES {
                drawn[l] = if choice[l] < term.up_to { own[l] } else { drawn[l] };
            }
        }
        drawn
    }

    #[inline(always)]
    fn distances(&self, choice: &Row, u: &Row) -> Row {
        let mut t = self.of_drawn(
            choice,
            #[inline(always)]
            |k| [self.terms[k].mfp; LANES],
        );
        for l in 0..LANES {
            let here = -math::ln(1.0 - u[l]) * t[l];
            t[l] = if here < self.length { here } else { f64::INFINITY };
        }
        t
    }

    /// The density of every channel at `t`, or its probability of reaching the end.
    #[inline(always)]
    fn look_up(&mut self, t: &Row) {
        for (term, density) in self.terms.iter().zip(&mut self.densities) {
            for l in 0..LANES {
                let scattered = t[l] < f64::INFINITY;
                let reach = if scattered { t[l] } else { self.length };
                let survival = math::exp(-term.sigma * reach);
                density[l] = if scattered { term.sigma * survival } else { survival };
            }
        }
    }

    #[inline(always)]
    fn divisors(&self, choice: &Row) -> Row {
        let probability = self.of_drawn(
            choice,
            #[inline(always)]
            |k| [self.terms[k].probability; LANES],
        );
        let density = self.of_drawn(
            choice,
            #[inline(always)]
            |k| self.densities[k],
        );
        let drawn = Drawn { probability, density };
        let mut sum = [0.0; LANES];
        for (term, density) in self.terms.iter().zip(&self.densities) {
            for l in 0..LANES {
                sum[l] = self.heuristic.add(sum[l], term.probability * density[l], drawn.at(l));
            }
        }
        for (l, sum) in sum.iter_mut().enumerate() {
            *sum = self.heuristic.divisor(*sum, drawn.at(l));
        }
        sum
    }

    #[inline(always)]
    fn weights(&self, k: usize, t: &Row, divisor: &Row) -> Row {
        let (albedo, density) = (self.terms[k].albedo, &self.densities[k]);
        let mut weights = [0.0; LANES];
        for l in 0..LANES {
            let event = if t[l] < f64::INFINITY { albedo } else { 1.0 };
            weights[l] = event * density[l] / divisor[l];
        }
        weights
    }
}

/// Puts a row into a column from `from` on, as far as the column goes.
#[inline(always)]
fn write(column: &mut [f64], from: usize, row: &Row) {
    let places = column.iter_mut().skip(from);
    for (place, x) in places.zip(row) {
        *place = *x;
    }
}
