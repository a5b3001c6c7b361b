use crate::fault::walk_progress::depth_of;
use crate::fault::{Injection, Overlay, WalkContext};
use freepath_estimators::{Capability, Extinction};
use std::cell::Cell;

/// The same uniform gives the flight in each segment along the path (pbrt-v4, issue 221).
///
/// ```text
/// right: a fresh u after each boundary, or the leftover depth;   wrong: the same u in the next segment
/// ```
///
/// Shows in: the escape atom over two segments; each alone is exact.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RepeatedFlight {}

struct Repeat<'a> {
    medium: &'a dyn Extinction,
    /// The place of the walk.
    t: Cell<f64>,
    /// The flight's word, and the segment whose end it crossed.
    crossing: Cell<Option<(u64, usize)>>,
    /// The next word is a flight's.
    flight: Cell<bool>,
}

impl Repeat<'_> {
    /// Notes whether a flight of `word` from `from` crosses the end of segment `k`, if another follows.
    fn fly(&self, word: u64, from: f64, k: usize) -> u64 {
        let majorants = self.medium.majorants();
        let (end, rate) = (majorants.ends()[k], majorants.mu_bar()[k]);
        let crosses = !(from + depth_of(word) / rate < end) && k + 1 < majorants.ends().len();
        self.crossing.set(crosses.then_some((word, k)));
        word
    }
}

impl Overlay for Repeat<'_> {
    fn begin(&self) {
        self.t.set(0.0);
        self.crossing.set(None);
        self.flight.set(true);
    }
    fn word(&self, stream: &mut dyn FnMut() -> u64) -> u64 {
        if let Some((word, k)) = self.crossing.take() {
            return self.fly(word, self.medium.majorants().ends()[k], k + 1);
        }
        let word = stream();
        if !self.flight.replace(false) {
            return word;
        }
        let k = self.medium.majorants().ends().partition_point(|&end| end <= self.t.get());
        self.fly(word, self.t.get(), k)
    }
    fn answer(&self, t: f64, mu: f64) -> f64 {
        self.t.set(t);
        self.flight.set(true);
        mu
    }
}

impl Injection for RepeatedFlight {
    fn needs(&self) -> Vec<Capability> {
        vec![Capability::TentativeCollisions, Capability::FreshFlights]
    }
    fn overlay<'a>(&'a self, context: WalkContext<'a>) -> Option<Box<dyn Overlay + 'a>> {
        let (t, crossing, flight) = (Cell::default(), Cell::default(), Cell::new(true));
        Some(Box::new(Repeat { medium: context.medium, t, crossing, flight }))
    }
}
