use crate::capability::Capability;
use crate::claims::TransmittanceClaims;
use crate::extinction::{Cells, Extinction, Medium};
use crate::transmittance::TransmittanceEstimator;
use crate::woodcock::{Collision, CollisionRule, Form, Rates, walk, walks};
use freepath_draws::{Draws, Streams};

/// Ratio tracking whose small weights play Russian roulette (pbrt's `Tr` and shadow rays; Pharr, Jakob and Humphreys).
///
/// ```text
/// w *= 1 - mu(t_i) / mu_bar;   if w < threshold: w /= p with probability p, else stop with 0
/// ```
///
/// Target: mean T; under the rule of pbrt-v3 only if mu <= mu_bar, since it kills every weight below 0.
/// Range:  [0, 1] if mu <= mu_bar.
/// Cost:   fewer look-ups than the integral of mu_bar.
/// Needs:  `mu`, `majorants`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RatioRoulette {
    /// The rule of the game: which weights play, and their odds.
    pub rule: RouletteRule,
}

/// A rule of roulette: which weights play, and how they survive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RouletteRule {
    /// Below 0.1, with the weight itself as probability: a survivor weighs 1, and the walk starts anew.
    PbrtV3,
    /// Below 0.05, with probability 1/4.
    PbrtV4,
}

/// The stake of a weight.
struct Odds {
    plays: bool,
    /// The probability of survival if it plays.
    survival: f64,
}

impl RouletteRule {
    /// The odds of `weight`: a survival of min(0.95, w), which below 0.1 is w, or of 1/4.
    #[inline(always)]
    fn odds(self, weight: f64) -> Odds {
        match self {
            Self::PbrtV3 => Odds { plays: weight < 0.1, survival: weight },
            Self::PbrtV4 => Odds { plays: weight < 0.05, survival: 0.25 },
        }
    }
}

impl CollisionRule for RatioRoulette {
    type State = f64;
    const DRAWS: bool = true;

    #[inline(always)]
    fn start(&self) -> f64 {
        1.0
    }

    #[inline(always)]
    fn collide(&self, weight: f64, at: Collision) -> (f64, bool) {
        let weight = weight * (1.0 - at.mu * at.mfp);
        let Odds { plays, survival } = self.rule.odds(weight);
        let stop = plays & !(at.u < survival);
        let survivor = if plays { weight / survival } else { weight };
        (if stop { 0.0 } else { survivor }, stop)
    }

    #[inline(always)]
    fn weight(&self, weight: f64, _escaped: bool) -> f64 {
        weight
    }
}

impl TransmittanceEstimator for RatioRoulette {
    fn estimate(&self, medium: &dyn Extinction, rng: &mut dyn rand::Rng) -> f64 {
        walk(self, &Rates::of(medium.majorants()), Form::Carry, medium, rng).weight
    }

    fn estimate_block(&self, medium: &dyn Extinction, streams: &Streams, out: &mut Draws) {
        let rates = Rates::of(medium.majorants());
        walks(self, &rates, Form::Carry, medium, streams, out);
    }

    fn roulette(&self, weight: f64, u: f64) -> Option<f64> {
        let nowhere = Collision { t: 0.0, mu: 0.0, mfp: 0.0, control: 0.0, u };
        Some(self.collide(weight, nowhere).0)
    }

    fn claims(&self, truth: &dyn Medium) -> TransmittanceClaims {
        let within = truth.majorants().shortfall(truth).is_none();
        let chain = self.chain(truth);
        TransmittanceClaims {
            bounded: self.rule == RouletteRule::PbrtV3,
            moments: chain.as_ref().map(|chain| chain.moments),
            range: within.then_some((0.0, 1.0)),
            lookups: chain.map(|chain| chain.lookups),
            ..TransmittanceClaims::default()
        }
    }

    fn capabilities(&self) -> Vec<Capability> {
        use Capability::{Collisions, Flights, LookUps, Majorants, TentativeCollisions};
        vec![LookUps, Majorants, Flights, TentativeCollisions, Collisions]
    }
}

/// The exact account of all walks.
struct Chain {
    /// E[X^k] for k = 1 to 6.
    moments: [f64; 6],
    /// The expected look-ups of one.
    lookups: f64,
}

/// Walks after some collisions, of which all that live weigh the same.
struct Walks {
    /// The probability of being alive.
    alive: f64,
    weight: f64,
}

impl RatioRoulette {
    /// E[X^k] for k = 1 to 6 and the expected look-ups, in a constant medium under a constant majorant of integral up to
    /// 700: there the walk after n collisions is alive with a known probability, and all living walks weigh the same.
    ///
    /// ```text
    /// E[X^k] = sum_n Poisson(n; L) alive_n w_n^k,   look-ups = sum_n Poisson(n; L) sum_{m < n} alive_m
    /// ```
    fn chain(&self, truth: &dyn Medium) -> Option<Chain> {
        let &[mu_bar] = truth.majorants().mu_bar() else {
            return None;
        };
        let homogeneous = truth.cells() == Cells::Constant && truth.breaks().is_empty();
        let mean = mu_bar * truth.length();
        if !homogeneous || mu_bar <= 0.0 || !(mean <= 700.0) {
            return None;
        }
        let ratio = 1.0 - truth.mu(0.5 * truth.length()) / mu_bar;
        let mut walks = Walks { alive: 1.0, weight: 1.0 };
        let (mut probability, mut paid) = (libm::exp(-mean), 0.0);
        let (mut moments, mut lookups) = ([0.0; 6], 0.0);
        for n in 1..=(mean + 15.0 * mean.sqrt() + 60.0) as u32 {
            let mut mass = probability * walks.alive;
            for moment in &mut moments {
                mass *= walks.weight;
                *moment += mass;
            }
            lookups += probability * paid;
            (probability, paid) = (probability * mean / f64::from(n), paid + walks.alive);
            walks = self.play(Walks { weight: walks.weight * ratio, ..walks });
        }
        Some(Chain { moments, lookups })
    }

    /// The walks after a roulette.
    fn play(&self, Walks { alive, weight }: Walks) -> Walks {
        let Odds { plays, survival } = self.rule.odds(weight);
        if !plays {
            Walks { alive, weight }
        } else if survival > 0.0 {
            Walks { alive: alive * survival, weight: weight / survival }
        } else {
            Walks { alive: 0.0, weight: 0.0 }
        }
    }
}
