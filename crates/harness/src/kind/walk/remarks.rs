//! What the formulas of a chain say of its estimators: state by state which of two has the smaller variance.

use super::in_system::InSystem;
use super::laws::{only, weighs_1};
use freepath_estimators::walk::{Walker, Walks};
use freepath_results::{FormulaSeries, PanelSeries, Real};
use freepath_statistics::claim::{Claims, Panel, Remark, Shows};

/// Most states that are told one by one.
const MOST: usize = 32;

/// Two estimators of the visits to one state.
pub(super) struct Compared {
    /// The state.
    pub(super) state: usize,
    /// Expected visits.
    pub(super) visits: f64,
    /// The probability to return.
    pub(super) returns: f64,
    /// The greatest probability to return at which counting every visit beats absorption, (1 - p*) / (1 + p*).
    pub(super) limit: f64,
    /// x / p* - x^2, infinite of a state that never absorbs.
    pub(super) absorption: f64,
    /// x (2 G - 1) - x^2.
    pub(super) collision: f64,
}

/// Tells of each state of a small chain which estimator is better.
pub(super) fn push(scene: &InSystem, claims: &mut Claims) {
    let Ok(walker) = scene.truth().walker(Walks::Forward) else { return };
    if walker.states() > MOST || !weighs_1(walker) {
        return;
    }
    let (states, place) = (states(walker), only(&walker.last));
    let words: Vec<String> = states.iter().map(Compared::words).collect();
    let panels = vec![
        Panel { series: visits(&states), place, shows: Shows::Mean },
        Panel { series: variances(&states), place, shows: Shows::Variance },
    ];
    claims.push(Remark { name: "collision_or_absorption", words: words.join("; "), panels });
}

fn visits(states: &[Compared]) -> PanelSeries {
    PanelSeries {
        title: "Visits to each state".into(),
        words: "The expected number of visits to each state, and the mean of the draws, with its interval, in the state that is asked for.".into(),
        places: "state".into(),
        quantity: "expected visits".into(),
        formulas: vec![formula("by formula", states, |state| state.visits)],
        ..PanelSeries::default()
    }
}

fn variances(states: &[Compared]) -> PanelSeries {
    PanelSeries {
        title: "Variance of two estimators of the visits to each state".into(),
        words: "Counting every visit beats scoring where a walk ends where the probability to return is below (1 - p*) / (1 + p*), in the shaded \
                states; a state that never absorbs has no variance by absorption to be drawn. The variance of the draws, of whatever estimator, \
                stands in the state that is asked for."
            .into(),
        places: "state".into(),
        quantity: "variance of one walk".into(),
        formulas: vec![
            formula("absorption", states, |state| state.absorption),
            formula("collision", states, |state| state.collision),
        ],
        shaded: states.iter().filter(|state| state.returns < state.limit).map(|state| state.state).collect(),
        shade: "collision wins".into(),
        ..PanelSeries::default()
    }
}

fn formula(name: &str, states: &[Compared], of: fn(&Compared) -> f64) -> FormulaSeries {
    FormulaSeries { name: name.into(), values: states.iter().map(|state| Real(of(state))).collect() }
}

/// Every state of a chain.
pub(super) fn states(walker: &Walker) -> Vec<Compared> {
    (0..walker.states()).filter_map(|state| compared(walker, state)).collect()
}

fn compared(walker: &Walker, state: usize) -> Option<Compared> {
    let mut at_state = vec![0.0; walker.states()];
    at_state[state] = 1.0;
    let column = walker.probability.solved(&at_state)?;
    let starts = walker.start.states.iter().zip(&walker.start.probabilities);
    let (x, g, end) = (starts.map(|(&i, q)| q * column[i]).sum::<f64>(), column[state], walker.kill[state]);
    Some(Compared {
        state,
        visits: x,
        returns: 1.0 - 1.0 / g,
        limit: (1.0 - end) / (1.0 + end),
        absorption: if end > 0.0 { x / end - x * x } else { f64::INFINITY },
        collision: x * (2.0 * g - 1.0) - x * x,
    })
}

impl Compared {
    fn words(&self) -> String {
        let Self { state, visits, returns, limit, absorption, collision } = self;
        let (wins, sign) = if returns < limit { ("collision", "<") } else { ("absorption", ">=") };
        format!(
            "state {state}: {visits:.6} visits, variance {collision:.6} by collision and {absorption:.6} by absorption: {wins}, as \
             f = {returns:.4} {sign} {limit:.4}"
        )
    }
}
